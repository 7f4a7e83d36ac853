// VTP files, read by a child process.

#include <cstring>
#include <filesystem>

#include "core/io/decoder/decoder_process.h"
#include "core/io/meshes/mesh_files.h"

namespace handlebody {

MeshFile readVtp(const std::string& path, const DecoderSettings& settings) {
  DecoderProcess decoder(path, settings);
  // Points and faces of packed data, VTK's own arrays of them and ours.
  constexpr std::uint64_t kForReading = 512u << 20, kTimesPacked = 64;
  decoder.allowMemory(kForReading + kTimesPacked * std::filesystem::file_size(path));
  decoder.send({{"mesh", path}});
  const Message answer = decoder.receive({}, 0, 1);
  MeshFile file;
  std::uint64_t points = 0, triangles = 0;
  try {
    points = answer.at("points").get<std::uint32_t>();
    triangles = answer.at("triangles").get<std::uint32_t>();
    file.space = answer.at("ras").get<bool>() ? CoordinateSpace::ras : CoordinateSpace::lps;
  } catch (const Message::exception&) {
    refuseInput(path, FindingKind::decoderAnswer);
  }
  const std::uint64_t bytes = points * sizeof(Vec3) + triangles * sizeof(Triangle);
  const std::shared_ptr<void> memory = decoder.takeMemory(bytes + 1);
  file.mesh.points.resize(points);
  file.mesh.triangles.resize(triangles);
  std::memcpy(static_cast<void*>(file.mesh.points.data()), memory.get(), points * sizeof(Vec3));
  std::memcpy(static_cast<void*>(file.mesh.triangles.data()),
              static_cast<char*>(memory.get()) + points * sizeof(Vec3), triangles * sizeof(Triangle));
  return file;
}

}  // namespace handlebody
