// GIPL (Guy's Image Processing Lab), plain or gzipped: 256 bytes of header, everything big-endian.

#include "core/io/formats/gipl_source.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "core/io/formats/byte_stream.h"

namespace handlebody {
namespace {

constexpr std::size_t kHeaderBytes = 256;
// Where what we need stands in it.
constexpr std::size_t kSizes = 0, kType = 8, kSpacing = 10, kOrigin = 204;

class Header {
 public:
  Header(const std::string& path, ByteStream& stream) {
    if (stream.read(bytes_.data(), bytes_.size()) != bytes_.size())
      refuseInput(path, {FindingKind::headerTruncated, {{"format", std::string("GIPL")}}});
  }
  template <typename T>
  T at(std::size_t place) const {
    T value{};
    std::memcpy(&value, bytes_.data() + place, sizeof value);
    if (std::endian::native == std::endian::little) swapBytes(&value, 1, sizeof value);
    return value;
  }

 private:
  std::array<unsigned char, kHeaderBytes> bytes_{};
};

Component componentOf(int type, const std::string& path) {
  switch (type) {
    case 7:
      return Component::int8;
    case 1:
    case 8:
      return Component::uint8;
    case 15:
      return Component::int16;
    case 16:
      return Component::uint16;
    case 31:
      return Component::uint32;
    case 32:
      return Component::int32;
    case 64:
      return Component::float32;
    case 65:
      return Component::float64;
    default:
      refuseInput(path, {FindingKind::voxelType, {{"type", std::to_string(type)}}});
  }
}

class GiplSource : public VolumeSource {
 public:
  explicit GiplSource(const std::string& path) : path_(path), isCompressed_(isGzip(path)) {
    ByteStream stream = open();
    const Header header(path, stream);
    header_.format = "GIPL";
    header_.component = componentOf(header.at<std::uint16_t>(kType), path);
    for (std::size_t a = 0; a < 3; ++a) {
      header_.grid.size[a] = header.at<std::uint16_t>(kSizes + 2 * a);
      const auto i = static_cast<Eigen::Index>(a);
      header_.grid.spacing[i] = static_cast<double>(header.at<float>(kSpacing + 4 * a));
      header_.grid.origin[i] = header.at<double>(kOrigin + 8 * a);
    }
    header_.frames = std::max<int>(1, header.at<std::uint16_t>(kSizes + 6));
    if (header_.grid.size[2] <= 1) refuseInput(path, FindingKind::flatImage);
    header_.sources = {"sizes", {"pixdim", "pixdim", "pixdim"}, "origin", "assumed"};
    checkHeader(header_, path);
    checkDataSize(path, path, isCompressed_ ? 0 : kHeaderBytes, header_.bytesPerFrame() * frames(),
                  isCompressed_);
  }

 protected:
  void readFrame(int frame, void* to, const ReadProgress& progress) override {
    ByteStream stream = open();
    stream.skip(kHeaderBytes + header_.bytesPerFrame() * static_cast<std::uint64_t>(frame), progress);
    stream.readAll(to, static_cast<std::size_t>(header_.bytesPerFrame()), progress);
    stream.checkEnd(frame + 1 < header_.frames);
    if (std::endian::native == std::endian::little)
      swapBytes(to, header_.grid.voxelCount(), bytesOf(header_.component));
  }

 private:
  ByteStream open() const {
    return ByteStream(path_, 0, isCompressed_ ? ByteStream::Coding::deflate : ByteStream::Coding::raw);
  }
  std::uint64_t frames() const { return static_cast<std::uint64_t>(header_.frames); }

  std::string path_;
  bool isCompressed_;
};

}  // namespace

SourcePointer openGipl(const std::string& path) { return std::make_unique<GiplSource>(path); }

}  // namespace handlebody
