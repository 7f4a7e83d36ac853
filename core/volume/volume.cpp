#include "core/volume/volume.h"

#include <cstring>

namespace handlebody {

std::size_t bytesPerVoxel(VoxelType type) {
  switch (type) {
    case VoxelType::uint8:
    case VoxelType::int8:
      return 1;
    case VoxelType::uint16:
    case VoxelType::int16:
      return 2;
    case VoxelType::float64:
      return 8;
    default:
      return 4;
  }
}

const char* voxelTypeName(VoxelType type) {
  static constexpr const char* kNames[] = {"uint8",  "int8",  "uint16",  "int16",
                                           "uint32", "int32", "float32", "float64"};
  return kNames[static_cast<int>(type)];
}

Volume makeVolume(const Grid& grid, VoxelType type, void** buffer) {
  const std::size_t bytes = grid.voxelCount() * bytesPerVoxel(type);
  // double as the unit: aligned for every voxel type.
  std::shared_ptr<double[]> memory(new double[bytes / sizeof(double) + 1]());
  *buffer = memory.get();
  return Volume{grid, type, std::shared_ptr<const void>(memory, memory.get())};
}

}  // namespace handlebody
