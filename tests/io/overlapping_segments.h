#pragma once
// Segmentations whose segments overlap, which we do not write ourselves.

#include <algorithm>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/io/dicom/dicom_writer.h"
#include "core/volume/volume.h"

namespace handlebody::test {

//! A segment, and which voxels it holds.
struct Segment {
  std::string name;
  std::string colour;  //!< red, green and blue, 0 … 1; of a .seg.nrrd
  std::function<bool(const Vec3& index)> holds;
  std::optional<int> layer{};  //!< of a .seg.nrrd; none: its own, by its place in the list
  int value = 1;               //!< in that layer; DICOM numbers them as they come
};

inline std::function<bool(const Vec3&)> inBall(const Vec3& centre, double radius) {
  return [=](const Vec3& p) { return (p - centre).norm() < radius; };
}

template <typename F>
void forEachVoxel(const Grid& grid, F&& f) {
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) f(Vec3(i, j, k));
}

//! As 3D Slicer writes them, of voxels of 1 mm with the origin at voxel 0; an older one, `isOld`, says
//! neither value nor layer of a segment.
inline void writeLayers(std::vector<Segment> segments, const Grid& grid, const std::string& path,
                        bool isOld = false) {
  int layers = 1;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    if (!segments[s].layer) segments[s].layer = static_cast<int>(s);
    layers = std::max(layers, *segments[s].layer + 1);
  }
  std::ofstream file(path, std::ios::binary);
  file << "NRRD0004\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\nsizes: " << layers;
  for (const int n : grid.size) file << ' ' << n;
  file
      << "\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: list domain domain domain\nencoding: raw\n"
         "space origin: (0,0,0)\n";
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::string key = "Segment" + std::to_string(s) + '_';
    if (isOld)
      file << key << "ID:=Segment_" << s + 1 << '\n';
    else
      file << key << "LabelValue:=" << segments[s].value << '\n'
           << key << "Layer:=" << *segments[s].layer << '\n';
    file << key << "Name:=" << segments[s].name << '\n' << key << "Color:=" << segments[s].colour << '\n';
  }
  file << '\n';
  forEachVoxel(grid, [&](const Vec3& index) {
    std::string values(static_cast<std::size_t>(layers), '\0');
    for (const Segment& s : segments)
      if (s.holds(index)) values[*s.layer] = static_cast<char>(s.value);
    file << values;
  });
}

//! Ours writes stripes, which have a frame of each segment in every slice; their bits are the last of the
//! file.
inline void writeOverlappingDicom(const std::vector<Segment>& segments, const Grid& grid,
                                  const std::string& path) {
  std::vector<ExportedObject> objects;
  for (const Segment& s : segments)
    objects.push_back({{s.name, {10, 200, 30}, static_cast<int>(objects.size()) + 1, "tissue"}, {}});
  DicomOrigin origin;
  origin.straight = false;
  origin.studyUid = "1.2.3";
  origin.values = {{0x10, 0x10, "Doe^Jane"}};
  void* buffer = nullptr;
  const Volume stripes = makeVolume(grid, VoxelType::uint8, &buffer);
  for (std::size_t v = 0; v < grid.voxelCount(); ++v)
    static_cast<std::uint8_t*>(buffer)[v] = static_cast<std::uint8_t>(1 + v % segments.size());
  writeDicomSegmentation(stripes, objects, origin, {}, path);
  std::vector<bool> bits;
  for (const Segment& s : segments)
    forEachVoxel(grid, [&](const Vec3& index) { bits.push_back(s.holds(index)); });
  std::string packed((bits.size() + 15) / 16 * 2, '\0');
  for (std::size_t b = 0; b < bits.size(); ++b)
    if (bits[b]) packed[b / 8] = static_cast<char>(packed[b / 8] | 1 << b % 8);
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(-static_cast<std::streamoff>(packed.size()), std::ios::end);
  file << packed;
}

}  // namespace handlebody::test
