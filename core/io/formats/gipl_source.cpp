// GIPL (Guy's Image Processing Lab), plain or gzipped: 256 bytes of header, everything big-endian.

#include "core/io/formats/gipl_source.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "core/io/formats/byte_stream.h"
#include "core/io/formats/stored_voxels.h"

namespace handlebody {
namespace {

constexpr std::size_t kHeaderBytes = 256;
// Where what we need stands in it.
constexpr std::size_t kSizes = 0, kVoxelType = 8, kSpacing = 10, kOrigin = 204;

class Header {
 public:
  Header(const std::string& path, bool isPacked) {
    ByteStream stream(path, 0, isPacked ? ByteStream::Coding::deflate : ByteStream::Coding::raw);
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

Component componentOfGipl(int type, const std::string& path) {
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

}  // namespace

SourcePointer openGipl(const std::string& path) {
  const bool isPacked = isGzip(path);
  const Header fields(path, isPacked);
  VolumeHeader header;
  header.format = "GIPL";
  header.component = componentOfGipl(fields.at<std::uint16_t>(kVoxelType), path);
  for (std::size_t a = 0; a < 3; ++a) {
    header.grid.size[a] = fields.at<std::uint16_t>(kSizes + 2 * a);
    const auto i = static_cast<Eigen::Index>(a);
    header.grid.spacing[i] = static_cast<double>(fields.at<float>(kSpacing + 4 * a));
    header.grid.origin[i] = fields.at<double>(kOrigin + 8 * a);
  }
  header.frames = std::max<int>(1, fields.at<std::uint16_t>(kSizes + 6));
  if (header.grid.size[2] <= 1) refuseInput(path, FindingKind::flatImage);
  header.sources = {"sizes", {"pixdim", "pixdim", "pixdim"}, "origin", "assumed"};
  checkHeader(header, path);
  return storedSource(header, {path, 0, kHeaderBytes, isPacked, std::endian::native == std::endian::little},
                      path);
}

}  // namespace handlebody
