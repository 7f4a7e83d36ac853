#include <unistd.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "core/io/formats/volume_source.h"

namespace handlebody {
namespace {

//! Headers with six digits are off by 1e-6 and single precision quaternions by 1e-7; a shear of 5e-4 moves a
//! voxel at the end of a 200 mm volume by 0.1 mm, which is where it begins to matter.
constexpr double kOrthonormalTolerance = 5e-4;

double gigabytes(double bytes) { return std::round(bytes / 1e8) / 10; }

//! The nearest orthonormal matrix (polar decomposition), so that its transpose is its inverse.
Eigen::Matrix3d polished(const Eigen::Matrix3d& direction) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(direction, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

void checkSize(const Grid& grid, const std::string& path) {
  for (int n : grid.size)
    if (n <= 0) refuseInput(path, FindingKind::noVoxels);
  for (int n : grid.size)
    if (n < 2) refuseInput(path, FindingKind::thinImage);
}

void checkGeometry(Grid& grid, const std::string& path) {
  if (!grid.spacing.allFinite() || grid.spacing.minCoeff() <= 0) refuseInput(path, FindingKind::badSpacing);
  if (!grid.origin.allFinite() || !grid.direction.allFinite()) refuseInput(path, FindingKind::badPlace);
  const Eigen::Matrix3d product = grid.direction.transpose() * grid.direction;
  const double error = (product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (error > kOrthonormalTolerance) refuseInput(path, FindingKind::sheared);
  // Exact ones (identity, permutations) stay as they are, bit for bit.
  if (error > 1e-15) grid.direction = polished(grid.direction);
}

double physicalMemory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

}  // namespace

std::shared_ptr<void> allocate(std::uint64_t bytes, const std::string& path) {
  try {
    // Linux promises more than there is, and kills who then uses it.
    if (static_cast<double>(bytes) > physicalMemory()) throw std::bad_alloc();
    // double: aligned for every voxel type
    const std::shared_ptr<double[]> memory(new double[static_cast<std::size_t>(bytes) / sizeof(double) + 1]);
    return {memory, memory.get()};
  } catch (const std::bad_alloc&) {
    refuseInput(path, FindingKind::notEnoughMemory);
  }
}

bool isLaterFrame(const std::string& field) {
  const std::string prefix = "Seq_Frame";
  return field.rfind(prefix, 0) == 0 && std::atoi(field.c_str() + prefix.size()) > 0;
}

std::size_t bytesOf(Component component) {
  switch (component) {
    case Component::uint8:
    case Component::int8:
      return 1;
    case Component::uint16:
    case Component::int16:
      return 2;
    case Component::uint32:
    case Component::int32:
    case Component::float32:
      return 4;
    default:
      return 8;
  }
}

void checkHeader(VolumeHeader& header, const std::string& path) {
  checkSize(header.grid, path);
  checkGeometry(header.grid, path);
  if (header.frames < 1) refuseInput(path, FindingKind::noTimePoints);
  // In double: a product of hostile sizes may exceed 64 bits.
  double bytes = static_cast<double>(bytesOf(header.component)) * header.components;
  for (int n : header.grid.size) bytes *= n;
  const double memory = physicalMemory();
  if (bytes > memory)
    refuseInput(
        path, {FindingKind::tooLarge, {{"declared_gb", gigabytes(bytes)}, {"memory_gb", gigabytes(memory)}}});
  if (bytes * header.frames > std::ldexp(1.0, 60))
    refuseInput(path, {FindingKind::tooManyTimePoints, {{"frames", header.frames}}});
}

void checkDataSize(const std::string& path, const std::string& file, std::uint64_t offset,
                   std::uint64_t bytes, bool compressed) {
  std::error_code failed;
  const std::uint64_t size = std::filesystem::file_size(file, failed);
  if (failed) refuseInput(path, {FindingKind::dataFileMissing, {{"data", file}}});
  const std::uint64_t held = size > offset ? size - offset : 0;
  constexpr std::uint64_t kDeflateRatio = 1032;
  const std::uint64_t possible = compressed ? held * kDeflateRatio : held;
  if (bytes > possible)
    refuseInput(path, {compressed ? FindingKind::packedDataCutOff : FindingKind::dataCutOff,
                       {{"declared", bytes}, {"held", held}}});
}

void refuseHeader(const std::string& path, const std::string& format, const std::string& field) {
  refuseInput(path, {FindingKind::headerDamaged, {{"format", format}, {"field", field}}});
}

void swapBytes(void* values, std::size_t count, std::size_t size) {
  auto* at = static_cast<unsigned char*>(values);
  if (size < 2) return;
  for (std::size_t i = 0; i < count; ++i, at += size) std::reverse(at, at + size);
}

void swapVoxels(const VolumeHeader& header, void* voxels) {
  swapBytes(voxels, header.grid.voxelCount() * static_cast<std::size_t>(header.components),
            bytesOf(header.component));
}

}  // namespace handlebody
