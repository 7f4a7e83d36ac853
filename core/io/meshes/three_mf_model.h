#pragma once
// Internal: what a model part of a 3MF package says.

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/finding.h"
#include "core/io/meshes/mesh_io.h"

namespace handlebody {

inline constexpr const char* kThreeMf = "3MF";  //!< in sentences
//! Of elements, core specification of the 3MF Consortium.
inline constexpr const char* kThreeMfCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
//! Of what we write besides: the metadata "Space", LPS or RAS.
inline constexpr const char* kThreeMfOurs = "http://handlebody.example.org/3mf";

//! Throws InputError: the file is damaged, and why.
[[noreturn]] void refuseThreeMf(const std::string& path, const Finding& cause);

//! What a file may hold in all: a few kB of components of components would fill any memory.
class ThreeMfCount {
 public:
  explicit ThreeMfCount(std::string path) : path_(std::move(path)) {}
  //! Throws InputError where it becomes too much. `entries`: objects, components, items.
  void add(std::size_t points, std::size_t triangles, std::size_t entries = 0);

 private:
  std::string path_;
  std::size_t points_ = 0, triangles_ = 0, entries_ = 0;
};

//! An object that is put into another one (component) or into what is built (item).
struct ThreeMfPlacement {
  int object = 0;
  std::string part{};  //!< name in the archive; empty: the part that it stands in
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();  //!< mm
};

struct ThreeMfObject {
  bool isBody = true;   //!< its mesh is a part of what is meant
  TriangleSoup mesh{};  //!< mm
  std::vector<ThreeMfPlacement> components{};
};

struct ThreeMfModel {
  CoordinateSpace space = CoordinateSpace::lps;
  std::unordered_map<int, ThreeMfObject> objects{};
  std::vector<ThreeMfPlacement> items{};
};

class ZipReader;

//! Reads a part as it is unpacked. Throws InputError.
ThreeMfModel readThreeMfModel(ZipReader& archive, std::uint64_t entry, const std::string& name,
                              const std::string& path, ThreeMfCount& count);

}  // namespace handlebody
