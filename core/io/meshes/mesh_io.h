#pragma once
// Meshes from and to files, through VTK. No VTK type appears here.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/io/decoder_settings.h"
#include "core/mesh/mesh.h"
#include "core/solid/rasterize.h"
#include "core/volume/volume.h"

namespace handlebody {

class FileSet;

//! Coordinates in a mesh file; RAS turns x and y. Written into the file where the format has a place for it.
enum class CoordinateSpace { lps, ras };

//! True for .stl .vtp .ply .obj (any case): what writeMesh writes.
bool isMeshPath(const std::string& path);
//! What readMesh reads. The same, .3mf, and .stl.dcm, the STL within DICOM, by the name, whether there is
//! such a file or not; and a file that is there and holds an STL within DICOM, by a look at its first few kB.
bool isMeshInputPath(const std::string& path);
//! True for .nii .nii.gz .nrrd .mha (any case).
bool isLabelMapPath(const std::string& path);

//! One of several objects whose triangles lie in a mesh one behind the other.
struct MeshPart {
  std::string name{};
  int label = 0;
  std::array<std::uint8_t, 3> colour{};  //!< sRGB
  std::size_t triangles = 0;             //!< number
};

//! Writes by extension (.stl binary, .vtp, .ply binary, .obj), whole or not at all (temporary name, then
//! rename). .vtp and .obj keep every digit; .stl and .ply hold single precision, which near 200 mm is 1.5e-5
//! mm. Throws OutputError; UsageError for an unknown extension.
//!
//! `parts`: the objects of the mesh, if there are several. .obj holds each as a group, .vtp its label per
//! face (and names and labels as field data), .ply its colour per face; .stl has no place for them.
//! With `set` the file gets its name by FileSet::commit (atomic_file.h).
void writeMesh(const TriangleSoup& mesh, const std::string& path,
               CoordinateSpace space = CoordinateSpace::lps, const std::vector<MeshPart>& parts = {},
               FileSet* set = nullptr);

//! Writes .vtp alone, with a value per point in an array of that name (single precision, the active scalars).
//! Throws as writeMesh.
void writeMeshWithValues(const TriangleSoup& mesh, const std::vector<double>& values, const std::string& name,
                         const std::string& path);

//! Reads what isMeshInputPath knows; STL vertices with equal coordinates are merged, the objects of a .3mf
//! become one mesh in mm (single precision where nothing is scaled or turned). RAS files that say so come
//! back as LPS. `decoder` reads .vtp. Throws InputError.
TriangleSoup readMesh(const std::string& path, const DecoderSettings& decoder = {});

}  // namespace handlebody
