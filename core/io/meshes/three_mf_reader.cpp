// 3MF is a package of the Open Packaging Conventions: a ZIP archive in which a relationship names the part
// that holds the model, in XML. Core specification 1.3 of the 3MF Consortium, and of its production extension
// the objects in other parts.

#include <algorithm>
#include <cstddef>
#include <optional>

#include "core/io/lowered.h"
#include "core/io/meshes/mesh_files.h"
#include "core/io/meshes/three_mf.h"
#include "core/io/meshes/three_mf_model.h"
#include "core/io/meshes/xml_parser.h"
#include "core/io/meshes/zip_archive.h"
#include "core/io/refuse_input.h"
#include "core/io/shown.h"
#include "core/io/trimmed.h"

namespace handlebody {
namespace {

constexpr const char* kRelationships = "_rels/.rels";
constexpr const char* kUsualModel = "3D/3dmodel.model";
constexpr std::size_t kDeepestComponent = 32;  // components in components

//! The first relationship of the package to a model.
class RelationshipReader : public XmlHandler {
 public:
  void start(std::string_view name, const XmlAttributes& attributes) override {
    const char *type = attributes.find("Type"), *to = attributes.find("Target");
    if (!name.ends_with(" Relationship") || !type || !to || !target.empty()) return;
    if (std::string_view(type).ends_with("/3dmodel")) target = trimmed(to, "/ \t\r\n");
  }
  std::string target{};  //!< name in the archive
};

struct Pose {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  bool isMirrored = false;
};

Pose inside(const Pose& outer, const Eigen::Affine3d& transform) {
  return {outer.transform * transform, outer.isMirrored != (transform.linear().determinant() < 0)};
}

class Package {
 public:
  explicit Package(const std::string& path) : path_(path), archive_(path, kThreeMf), read_(path) {}

  MeshFile mesh() {
    const ThreeMfModel& root = part(modelPart());
    MeshFile file;
    file.space = root.space;
    // Once to count, so that memory is taken for what there is, and not at all for too much.
    ThreeMfCount count(path_);
    std::size_t points = 0, triangles = 0;
    forEachBody([&](const TriangleSoup& mesh, const Pose&) {
      count.add(mesh.points.size(), mesh.triangles.size());
      points += mesh.points.size();
      triangles += mesh.triangles.size();
    });
    file.mesh.points.reserve(points);
    file.mesh.triangles.reserve(triangles);
    forEachBody([&](const TriangleSoup& mesh, const Pose& pose) { append(mesh, pose, file.mesh); });
    return file;
  }

 private:
  struct Place {
    std::uint64_t part = 0;
    int object = 0;
    bool operator==(const Place&) const = default;
  };

  std::uint64_t modelPart() {
    RelationshipReader relationships;
    if (const std::optional<std::uint64_t> entry = archive_.find(kRelationships)) {
      XmlParser parser(relationships, path_, kThreeMf, kRelationships);
      archive_.read(*entry, [&](std::string_view piece) { parser.take(piece); });
      parser.finish();
    }
    root_ = relationships.target.empty() ? kUsualModel : relationships.target;
    // An archive of something else has neither.
    if (relationships.target.empty() && !archive_.find(root_))
      refuseInput(path_, {FindingKind::notOfFormat, {{"format", std::string(kThreeMf)}}});
    return partCalled(root_);
  }

  std::uint64_t partCalled(const std::string& name) const {
    const std::optional<std::uint64_t> entry = archive_.find(name);
    if (!entry) refuseThreeMf(path_, {FindingKind::partMissing, {{"part", shown(name)}}});
    return *entry;
  }

  //! Read when it is first asked for.
  const ThreeMfModel& part(std::uint64_t entry) {
    const auto found = parts_.find(entry);
    if (found != parts_.end()) return found->second;
    const std::string name = parts_.empty() ? root_ : "part " + std::to_string(entry);
    return parts_.emplace(entry, readThreeMfModel(archive_, entry, name, path_, read_)).first->second;
  }

  //! visit(mesh, pose) for all that is built, in the order of the file.
  template <typename Visit>
  void forEachBody(const Visit& visit) {
    const std::uint64_t root = partCalled(root_);
    ThreeMfCount visited(path_);
    for (const ThreeMfPlacement& item : part(root).items) {
      std::vector<Place> within;
      walk(root, item, {}, within, visited, visit);
    }
  }

  template <typename Visit>
  void walk(std::uint64_t from, const ThreeMfPlacement& placement, const Pose& outer,
            std::vector<Place>& within, ThreeMfCount& visited, const Visit& visit) {
    visited.add(0, 0, 1);
    const Place place{placement.part.empty() ? from : partCalled(placement.part), placement.object};
    const auto& objects = part(place.part).objects;
    const auto object = objects.find(place.object);
    if (object == objects.end())
      refuseThreeMf(path_, {FindingKind::objectMissing, {{"object", place.object}}});
    if (std::find(within.begin(), within.end(), place) != within.end())
      refuseThreeMf(path_, {FindingKind::objectHoldsItself, {{"object", place.object}}});
    if (within.size() == kDeepestComponent) refuseThreeMf(path_, FindingKind::objectsNested);
    const Pose pose = inside(outer, placement.transform);
    if (object->second.isBody) visit(object->second.mesh, pose);
    within.push_back(place);
    for (const ThreeMfPlacement& component : object->second.components)
      walk(place.part, component, pose, within, visited, visit);
    within.pop_back();
  }

  static void append(const TriangleSoup& mesh, const Pose& pose, TriangleSoup& to) {
    const int first = static_cast<int>(to.points.size());
    for (const Vec3& p : mesh.points) to.points.push_back(pose.transform * p);
    for (Triangle t : mesh.triangles) {
      if (pose.isMirrored) std::swap(t[1], t[2]);  // a mirrored body keeps its outside
      to.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }

  std::string path_, root_{};
  ZipReader archive_;
  ThreeMfCount read_;
  std::unordered_map<std::uint64_t, ThreeMfModel> parts_{};
};

}  // namespace

bool isThreeMfPath(const std::string& path) { return lowered(path).ends_with(".3mf"); }

MeshFile readThreeMf(const std::string& path) { return Package(path).mesh(); }

}  // namespace handlebody
