#pragma once
// What the tests of core/io share: a folder that goes away, volumes with known values, damaged copies of
// files.

#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "core/io/formats/volume_io.h"
#include "core/told_error.h"
#include "tests/support/catch.h"

namespace handlebody::test {

namespace fs = std::filesystem;

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "handlebody-io-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::permissions(path_, fs::perms::owner_all, ignored);
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string path() const { return path_.string(); }
  std::size_t fileCount() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator{}));
  }

 private:
  fs::path path_;
};

inline std::string readBytes(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void writeBytes(const std::string& path, const std::string& bytes) {
  fs::remove(path);  // file systems flush a file that is emptied and written again, at length
  std::ofstream stream(path, std::ios::binary);
  stream << bytes;
}

template <typename T>
void patch(std::string& bytes, std::size_t offset, T value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
}

inline Grid obliqueGrid() {
  Grid grid;
  grid.size = {7, 5, 4};
  grid.spacing = Vec3(0.5, 1.25, 2.75);
  grid.origin = Vec3(-17.375, 33.0625, 121.5);
  grid.direction = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  return grid;
}

//! Random bytes; for float types random finite numbers.
inline Volume randomVolume(const Grid& grid, VoxelType type, unsigned seed = 1) {
  void* buffer = nullptr;
  Volume volume = makeVolume(grid, type, &buffer);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> real(-1000, 1000);
  const std::size_t n = grid.voxelCount();
  if (type == VoxelType::float32)
    for (std::size_t i = 0; i < n; ++i) static_cast<float*>(buffer)[i] = static_cast<float>(real(random));
  else if (type == VoxelType::float64)
    for (std::size_t i = 0; i < n; ++i) static_cast<double*>(buffer)[i] = real(random);
  else
    for (std::size_t i = 0; i < n * bytesPerVoxel(type); ++i)
      static_cast<unsigned char*>(buffer)[i] = static_cast<unsigned char>(random());
  return volume;
}

inline std::string voxelBytes(const Volume& volume) {
  return {static_cast<const char*>(volume.voxels.get()),
          volume.grid.voxelCount() * bytesPerVoxel(volume.type)};
}

//! True if no part of it is words that have no kind.
inline bool hasKinds(const Finding& finding) {
  return finding.any() && finding.kind != FindingKind::other &&
         std::all_of(finding.causes.begin(), finding.causes.end(), hasKinds);
}

//! It is of this kind, with every value that its words name, and tells `text`.
inline void expectWarning(const Finding& warning, FindingKind kind, const std::string& text) {
  INFO(sentence(warning));
  CHECK(warning.kind == kind);
  CHECK(hasKinds(warning));
  CHECK(sentence(warning) == text);
}

//! The only one of its volume.
inline void expectWarning(const VolumeInfo& info, FindingKind kind, const std::string& text) {
  REQUIRE(info.warnings.size() == 1);
  expectWarning(info.warnings.front(), kind, text);
}

//! One of this kind tells `text`.
inline void expectAmong(const VolumeInfo& info, FindingKind kind, const std::string& text) {
  const auto at = std::find_if(info.warnings.begin(), info.warnings.end(),
                               [kind](const Finding& w) { return w.kind == kind; });
  INFO(sentence(info.warnings));
  REQUIRE(at != info.warnings.end());
  expectWarning(*at, kind, text);
}

//! Reading and inspecting are refused alike (`onlyReading`: what only the voxels show), in one line that
//! begins with the path and holds `cause`.
inline void expectInputError(const std::string& path, const std::string& cause, bool onlyReading = false,
                             const DecoderSettings& decoder = {}) {
  INFO(path);
  std::string message;
  Finding finding;
  try {
    readVolume(path, {.decoder = decoder});
  } catch (const InputError& e) {
    message = e.what();
    finding = findingOf(e);
  }
  CHECK_THAT(message, Contains(cause));
  CHECK(message.rfind(path, 0) == 0);
  CHECK(message.find('\n') == std::string::npos);
  CHECK(hasKinds(finding));
  CHECK(sentence(finding) == message);
  if (!onlyReading) CHECK_THROWS_AS(inspectVolume(path, {.decoder = decoder}), InputError);
}

//! A GIPL file of 16-bit voxels: everything in it is big-endian.
inline std::string giplBytes(const std::array<int, 3>& size, const Vec3& spacing, const Vec3& origin,
                             const std::vector<std::int16_t>& voxels) {
  std::string bytes(256, '\0');
  const auto put = [&bytes](std::size_t at, auto value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                 bytes.begin() + static_cast<std::ptrdiff_t>(at + sizeof value));
  };
  for (std::size_t a = 0; a < 3; ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    put(2 * a, static_cast<std::uint16_t>(size[a]));
    put(10 + 4 * a, static_cast<float>(spacing[i]));
    put(204 + 8 * a, origin[i]);
  }
  put(6, std::uint16_t{1});
  put(8, std::uint16_t{15});
  put(252, std::uint32_t{719555000});
  for (const std::int16_t v : voxels) {
    const std::size_t at = bytes.size();
    bytes.resize(at + 2);
    put(at, v);
  }
  return bytes;
}

}  // namespace handlebody::test
