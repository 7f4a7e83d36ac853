#include "core/io/formats/label_map.h"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>

#include "core/cancellation.h"
#include "core/io/formats/volume_keys.h"
#include "core/io/lowered.h"
#include "core/io/meshes/mesh_io.h"
#include "core/phase.h"

namespace handlebody {

namespace {

template <typename T>
void drawInto(const std::vector<ExportedObject>& objects, const Grid& grid, T* labels) {
  for (const ExportedObject& object : objects) {
    giveUpIfCancelled();
    const Volume mask = rasterize(object.mesh, grid);
    const auto* inside = mask.data<std::uint8_t>();
    for (std::size_t i = 0, n = grid.voxelCount(); i < n; ++i)
      if (inside[i] != 0) labels[i] = static_cast<T>(object.label.value);
  }
}

//! First and last index along each axis of the voxels that are not 0; last below first if there are none.
struct Extent {
  std::array<int, 3> first{}, last{-1, -1, -1};
};

Extent extentOf(const Volume& labels) {
  Extent e;
  const auto [nx, ny, nz] = labels.grid.size;
  visitVoxels(labels, [&](const auto* voxel) {
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
          if (*voxel++ == 0) continue;
          const std::array<int, 3> at{i, j, k};
          const bool none = e.last[0] < 0;
          for (std::size_t a = 0; a < 3; ++a) {
            e.first[a] = none ? at[a] : std::min(e.first[a], at[a]);
            e.last[a] = none ? at[a] : std::max(e.last[a], at[a]);
          }
        }
  });
  return e;
}

std::string text(const Extent& e) {
  std::string s;
  for (std::size_t a = 0; a < 3; ++a)
    s += (a ? " " : "") + std::to_string(e.first[a]) + " " + std::to_string(e.last[a]);
  return s;
}

//! With six digits, as 3D Slicer writes it.
std::string text(const Colour& colour) {
  std::ostringstream s;
  s << colour[0] / 255.0 << ' ' << colour[1] / 255.0 << ' ' << colour[2] / 255.0;
  return s.str();
}

std::string text(const CodedTerm& code) { return code.scheme + "^" + code.value + "^" + code.meaning; }

//! The entry has room for one.
std::string firstOf(const std::vector<CodedTerm>& modifiers) {
  return text(modifiers.empty() ? CodedTerm() : modifiers.front());
}

//! A terminology entry of vtkSlicerTerminologyEntry: context, category, type, its modifier, region context,
//! region, its modifier.
std::string terminologyEntry(const Terminology& t) {
  return "Segmentation category and type - DICOM master list~" + text(t.category) + "~" + text(t.type.term) +
         "~" + firstOf(t.type.modifiers) + "~Anatomic codes - DICOM master list~" + text(t.region.term) +
         "~" + firstOf(t.region.modifiers);
}

//! In alphabetical order, as 3D Slicer has them.
std::string tagsOf(const ObjectLabel& label) {
  std::string tags;
  const auto add = [&tags](const char* key, const std::string& value) {
    tags += std::string(key) + ":" + value + "|";
  };
  if (label.source.algorithm) {
    const SegmentAlgorithm algorithm = writtenAlgorithm(label.source.algorithm);
    if (!algorithm.name.empty()) add(slicer::kAlgorithmNameTag, algorithm.name);
    add(slicer::kAlgorithmTypeTag, algorithmTypeName(algorithm.type));
  }
  add(slicer::kTerminologyTag, terminologyEntry(terminologyOf(label)));
  return tags;
}

//! The grid as 3D Slicer keeps it: the rows of the matrix from voxel to RAS, then the extent.
std::string referenceGeometry(const Grid& grid) {
  std::ostringstream s;
  s << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (int row = 0; row < 3; ++row) {
    const double sign = row < 2 ? -1 : 1;
    for (int a = 0; a < 3; ++a) s << sign * grid.direction(row, a) * grid.spacing[a] << ';';
    s << sign * grid.origin[row] << ';';
  }
  s << "0;0;0;1;";
  for (const int n : grid.size) s << "0;" << n - 1 << ';';
  return s.str();
}

}  // namespace

bool isSlicerSegmentationPath(const std::string& path) { return lowered(path).ends_with(".seg.nrrd"); }

bool isLabelDescriptionPath(const std::string& path) { return lowered(path).ends_with(".label"); }

Volume labelMap(const std::vector<ExportedObject>& objects, const Grid& grid) {
  const Phase phase("label map");
  const bool wide = std::any_of(objects.begin(), objects.end(),
                                [](const ExportedObject& o) { return o.label.value > 255; });
  void* buffer = nullptr;
  Volume labels = makeVolume(grid, wide ? VoxelType::uint16 : VoxelType::uint8, &buffer);
  if (wide)
    drawInto(objects, grid, static_cast<std::uint16_t*>(buffer));
  else
    drawInto(objects, grid, static_cast<std::uint8_t*>(buffer));
  return labels;
}

void writeSlicerSegmentation(const Volume& labels, const std::vector<ExportedObject>& objects,
                             const std::string& path) {
  std::map<std::string, std::string> keys{
      {"Segmentation_MasterRepresentation", "Binary labelmap"},
      {"Segmentation_ContainedRepresentationNames", "Binary labelmap|"},
      // Name, value and description; where that is empty 3D Slicer keeps its own.
      {"Segmentation_ConversionParameters",
       "Reference image geometry|" + referenceGeometry(labels.grid) + "|&"},
      {"Segmentation_ReferenceImageExtentOffset", "0 0 0"}};
  // All segments are in one layer, and 3D Slicer crops a layer to the extent of its first segment (later
  // versions: to that of all of them).
  const std::string extent = text(extentOf(labels));
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const ObjectLabel& label = objects[i].label;
    const auto set = [&](const char* key, const std::string& value) {
      keys["Segment" + std::to_string(i) + "_" + key] = value;
    };
    set("ID", "Segment_" + std::to_string(i + 1));
    set("Name", label.name);
    set("NameAutoGenerated", "0");
    set("Color", text(label.colour));
    set("ColorAutoGenerated", "0");
    set("Extent", extent);
    set("LabelValue", std::to_string(label.value));
    set("Layer", "0");
    set("Tags", tagsOf(label));
  }
  writeVolumeWithKeys(labels, path, keys);
}

std::string labelDescription(const std::vector<ExportedObject>& objects) {
  std::ostringstream s;
  s << "################################################\n"
       "# ITK-SnAP Label Description File\n"
       "# File format:\n"
       "# IDX   -R-  -G-  -B-  -A--  VIS MSH  LABEL\n"
       "################################################\n";
  const auto line = [&s](int index, const Colour& c, int shown, const std::string& name) {
    s << std::setw(5) << index;
    for (const std::uint8_t part : c) s << ' ' << std::setw(5) << static_cast<int>(part);
    s << ' ' << std::setw(8) << shown << ' ' << std::setw(2) << shown << ' ' << std::setw(2) << shown
      << "    \"" << name << "\"\n";
  };
  line(0, {0, 0, 0}, 0, "Clear Label");
  for (const ExportedObject& o : objects) line(o.label.value, o.label.colour, 1, o.label.name);
  return s.str();
}

}  // namespace handlebody
