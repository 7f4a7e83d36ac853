#include "core/io/formats/byte_stream.h"

#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "core/cancellation.h"

namespace handlebody {

struct ByteStream::State {
  std::string path;
  std::FILE* file = nullptr;
  Coding coding = Coding::raw;
  z_stream z{};
  bool started = false;  // z needs inflateEnd
  bool ended = false;    // the last member is complete
  bool damaged = false;
  std::vector<unsigned char> input = std::vector<unsigned char>(1 << 16);

  ~State() {
    if (started) inflateEnd(&z);
    if (file) std::fclose(file);
  }
  //! More compressed bytes; false at the end of the file.
  bool refill() {
    if (z.avail_in > 0) return true;
    z.next_in = input.data();
    z.avail_in = static_cast<uInt>(std::fread(input.data(), 1, input.size(), file));
    return z.avail_in > 0;
  }
  //! A gzip file may hold several members; whatever else follows is padding.
  void nextMember() { ended = !refill() || *z.next_in != 0x1f || inflateReset(&z) != Z_OK; }
};

ByteStream::ByteStream(const std::string& path, std::uint64_t offset, Coding coding)
    : state_(std::make_unique<State>()) {
  state_->path = path;
  state_->coding = coding;
  state_->file = std::fopen(path.c_str(), "rb");
  if (!state_->file || fseeko(state_->file, static_cast<off_t>(offset), SEEK_SET) != 0)
    refuseInput(path, FindingKind::cannotBeOpened);
  if (coding == Coding::deflate) {
    constexpr int kGzipOrZlib = 15 + 32;
    state_->started = inflateInit2(&state_->z, kGzipOrZlib) == Z_OK;
    if (!state_->started) refuseInput(path, FindingKind::noMemoryToUnpack);
  }
}

ByteStream::~ByteStream() = default;

std::size_t ByteStream::inflateSome(void* to, std::size_t n) {
  State& s = *state_;
  constexpr std::size_t kLargest = 1u << 30;  // avail_out has 32 bits
  const auto wanted = static_cast<uInt>(std::min(n, kLargest));
  s.z.next_out = static_cast<Bytef*>(to);
  s.z.avail_out = wanted;
  while (s.z.avail_out > 0 && !s.ended && !s.damaged) {
    if (!s.refill()) {
      s.damaged = true;  // the file ends inside a member
      break;
    }
    const int result = inflate(&s.z, Z_NO_FLUSH);
    if (result == Z_STREAM_END)
      s.nextMember();
    else if (result != Z_OK)
      s.damaged = true;
  }
  return wanted - s.z.avail_out;
}

std::size_t ByteStream::read(void* to, std::size_t n) {
  if (state_->coding == Coding::raw) return std::fread(to, 1, n, state_->file);
  std::size_t done = 0;
  while (done < n) {
    const std::size_t got = inflateSome(static_cast<char*>(to) + done, n - done);
    if (got == 0) break;
    done += got;
  }
  return done;
}

void ByteStream::readAll(void* to, std::size_t n, const ReadProgress& progress) {
  constexpr std::size_t kPart = 4u << 20;  // a few milliseconds, also where it is inflated
  for (std::size_t done = 0; done < n;) {
    handlebody::tellProgress(progress, static_cast<double>(done) / static_cast<double>(n));
    const std::size_t part = std::min(kPart, n - done);
    if (read(static_cast<char*>(to) + done, part) != part)
      refuseInput(state_->path, FindingKind::voxelDataTruncated);
    done += part;
  }
}

void ByteStream::skip(std::uint64_t n, const ReadProgress& progress) {
  std::vector<char> sink(1 << 16);
  while (n > 0) {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(n, sink.size()));
    handlebody::tellProgress(progress, 0);
    readAll(sink.data(), part);
    n -= part;
  }
}

void ByteStream::checkEnd(bool moreIsWanted) {
  if (state_->coding == Coding::raw) return;
  std::vector<char> sink(moreIsWanted ? 1 : 1 << 16);
  while (read(sink.data(), sink.size()) == sink.size() && !moreIsWanted) giveUpIfCancelled();
  if (state_->damaged) refuseInput(state_->path, FindingKind::checksumDiffers);
}

bool isGzip(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file) return false;
  unsigned char magic[2] = {0, 0};
  const bool two = std::fread(magic, 1, 2, file) == 2;
  std::fclose(file);
  return two && magic[0] == 0x1f && magic[1] == 0x8b;
}

}  // namespace handlebody
