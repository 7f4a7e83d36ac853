#include <unistd.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "core/errors.h"
#include "core/io/volume_source.h"

namespace handlebody {
namespace {

//! Headers with six digits are off by 1e-6 and single precision quaternions by 1e-7; a shear of 5e-4 moves a
//! voxel at the end of a 200 mm volume by 0.1 mm, which is where it begins to matter.
constexpr double kOrthonormalTolerance = 5e-4;

std::string gigabytes(double bytes) {
  const double tenths = std::round(bytes / 1e8);
  return std::to_string(static_cast<long long>(tenths / 10)) + "." +
         std::to_string(static_cast<long long>(tenths) % 10) + " GB";
}

//! The nearest orthonormal matrix (polar decomposition), so that its transpose is its inverse.
Eigen::Matrix3d polished(const Eigen::Matrix3d& direction) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(direction, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

void checkSize(const Grid& grid, const std::string& path) {
  for (int n : grid.size)
    if (n <= 0) refuseInput(path, "the volume has no voxels (a size of 0)");
  for (int n : grid.size)
    if (n < 2) refuseInput(path, "this is a 2D image, a volume needs at least two slices along each axis");
}

void checkGeometry(Grid& grid, const std::string& path) {
  if (!grid.spacing.allFinite() || grid.spacing.minCoeff() <= 0)
    refuseInput(path, "its voxel spacing is zero, negative or not a number");
  if (!grid.origin.allFinite() || !grid.direction.allFinite())
    refuseInput(path, "its position or its direction is not a number");
  const Eigen::Matrix3d product = grid.direction.transpose() * grid.direction;
  const double error = (product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (error > kOrthonormalTolerance)
    refuseInput(path, "its axes are not at right angles (sheared or tilted), which is not supported");
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
    refuseInput(path, "there is not enough memory to read it");
  }
}

void refuseInput(const std::string& path, const std::string& cause) {
  throw InputError(path + ": " + cause + ".");
}

std::string millimetres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g mm", value);
  return text;
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
  if (header.frames < 1) refuseInput(path, "it has no time points");
  // In double: a product of hostile sizes may exceed 64 bits.
  double bytes = static_cast<double>(bytesOf(header.component)) * header.components;
  for (int n : header.grid.size) bytes *= n;
  const double memory = physicalMemory();
  if (bytes > memory)
    refuseInput(path, "it declares " + gigabytes(bytes) + " of voxels, more than the " + gigabytes(memory) +
                          " of memory of this computer");
  if (bytes * header.frames > std::ldexp(1.0, 60))
    refuseInput(path, "the number of its time points is implausible (" + std::to_string(header.frames) + ")");
}

void checkDataSize(const std::string& path, const std::string& file, std::uint64_t offset,
                   std::uint64_t bytes, bool compressed) {
  std::error_code failed;
  const std::uint64_t size = std::filesystem::file_size(file, failed);
  if (failed) refuseInput(path, "its data file " + file + " is missing");
  const std::uint64_t held = size > offset ? size - offset : 0;
  constexpr std::uint64_t kDeflateRatio = 1032;
  const std::uint64_t possible = compressed ? held * kDeflateRatio : held;
  if (bytes > possible)
    refuseInput(path, "it is truncated or damaged: the header declares " + std::to_string(bytes) +
                          " bytes of voxels, the file holds " + std::to_string(held) +
                          (compressed ? " compressed" : ""));
}

void swapBytes(void* values, std::size_t count, std::size_t size) {
  auto* at = static_cast<unsigned char*>(values);
  if (size < 2) return;
  for (std::size_t i = 0; i < count; ++i, at += size) std::reverse(at, at + size);
}

}  // namespace handlebody
