// DICOM pixels that are not compressed.

#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstring>

#include "core/io/dicom/dicom_codecs.h"
#include "core/io/formats/volume_source.h"

namespace handlebody {
namespace {

class PlainPixels : public DicomPixels {
 public:
  PlainPixels(const DicomFile& file, std::string path)
      : file_(file), path_(std::move(path)), handle_(::open(file.file.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (handle_ < 0) refuseInput(path_, {FindingKind::sliceNotOpened, {{"slice", file.file}}});
  }
  ~PlainPixels() override { ::close(handle_); }
  void read(int frame, StoredFrame& to) override;

 private:
  void readBytes(std::uint64_t at, std::uint64_t bytes, std::vector<char>& to) const;
  void readBits(int frame, StoredFrame& to) const;
  const DicomFile& file_;
  std::string path_;
  int handle_;
};

void PlainPixels::readBytes(std::uint64_t at, std::uint64_t bytes, std::vector<char>& to) const {
  to.resize(bytes);
  for (std::uint64_t done = 0; done < bytes;) {
    const ssize_t got = ::pread(handle_, to.data() + done, bytes - done,
                                static_cast<off_t>(file_.structure.pixelOffset + at + done));
    if (got <= 0) refuseInput(path_, {FindingKind::sliceNotReadToEnd, {{"slice", file_.file}}});
    done += static_cast<std::uint64_t>(got);
  }
}

//! One bit per pixel, the first in the lowest bit; frames need not begin with a byte.
void PlainPixels::readBits(int frame, StoredFrame& to) const {
  const std::uint64_t n = file_.pixelsPerFrame(), first = n * static_cast<std::uint64_t>(frame);
  std::vector<char> packed;
  readBytes(first / 8, (first + n + 7) / 8 - first / 8, packed);
  to.type = Component::uint8;
  to.bytes.resize(n);
  for (std::uint64_t i = 0, bit = first % 8; i < n; ++i, ++bit)
    to.bytes[i] = static_cast<char>(packed[bit / 8] >> (bit % 8) & 1);
}

void PlainPixels::read(int frame, StoredFrame& to) {
  if (file_.bitsAllocated == 1) return readBits(frame, to);
  const std::uint64_t bytes = file_.pixelsPerFrame() * static_cast<std::uint64_t>(file_.samples) *
                              static_cast<std::uint64_t>(file_.bitsAllocated / 8);
  to.type = storedType(file_.bitsAllocated, file_.isSigned);
  readBytes(bytes * static_cast<std::uint64_t>(frame), bytes, to.bytes);
  cleanBits(file_, to);
  if (file_.samples == 3) toLuminance(to, file_.planar, file_.photometric == "RGB");
}

template <typename T>
void luminance(std::vector<char>& bytes, bool planar, bool rgb) {
  const std::size_t n = bytes.size() / (3 * sizeof(T)), step = planar ? 1 : 3, sample = planar ? n : 1;
  std::vector<char> result(n * sizeof(T));
  const T* in = reinterpret_cast<const T*>(bytes.data());
  T* out = reinterpret_cast<T*>(result.data());
  for (std::size_t i = 0; i < n; ++i, in += step)
    out[i] = rgb ? static_cast<T>(std::lround(0.2125 * in[0] + 0.7154 * in[sample] + 0.0721 * in[2 * sample]))
                 : in[0];
  bytes.swap(result);
}

template <typename T>
void clean(std::vector<char>& bytes, int up, int down) {
  T* values = reinterpret_cast<T*>(bytes.data());
  using Unsigned = std::make_unsigned_t<T>;
  for (std::size_t i = 0, n = bytes.size() / sizeof(T); i < n; ++i)
    values[i] =
        static_cast<T>(static_cast<T>(static_cast<Unsigned>(static_cast<Unsigned>(values[i]) << up)) >> down);
}

}  // namespace

Component storedType(int bits, bool isSigned) {
  if (bits <= 8) return isSigned ? Component::int8 : Component::uint8;
  if (bits <= 16) return isSigned ? Component::int16 : Component::uint16;
  return isSigned ? Component::int32 : Component::uint32;
}

void cleanBits(const DicomFile& file, StoredFrame& frame) {
  const int bits = static_cast<int>(8 * bytesOf(frame.type));
  if (file.bitsStored >= bits) return;
  const int up = bits - 1 - file.highBit, down = bits - file.bitsStored;
  switch (frame.type) {
    case Component::uint8:
      return clean<std::uint8_t>(frame.bytes, up, down);
    case Component::int8:
      return clean<std::int8_t>(frame.bytes, up, down);
    case Component::uint16:
      return clean<std::uint16_t>(frame.bytes, up, down);
    case Component::int16:
      return clean<std::int16_t>(frame.bytes, up, down);
    case Component::uint32:
      return clean<std::uint32_t>(frame.bytes, up, down);
    default:
      return clean<std::int32_t>(frame.bytes, up, down);
  }
}

void toLuminance(StoredFrame& frame, bool planar, bool rgb) {
  if (bytesOf(frame.type) == 1)
    luminance<std::uint8_t>(frame.bytes, planar, rgb);
  else
    luminance<std::uint16_t>(frame.bytes, planar, rgb);
  frame.type = bytesOf(frame.type) == 1 ? Component::uint8 : Component::uint16;
}

std::unique_ptr<DicomPixels> openPlainPixels(const DicomFile& file, const std::string& path) {
  return std::make_unique<PlainPixels>(file, path);
}

}  // namespace handlebody
