#include "core/io/report/start_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "core/cancellation.h"
#include "core/collision/certify.h"
#include "core/errors.h"
#include "core/io/dicom/dicom_segments.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/compared.h"
#include "core/io/report/result.h"
#include "core/io/report/session_files.h"
#include "core/measure/inscribed_balls.h"
#include "core/solid/label_mesh.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

using K = FindingKind;

constexpr std::size_t kPlacesTried = 200;  // on a surface, for one deep inside
constexpr double kJustInside = 1e-3;       // of the square root of a face's area

[[noreturn]] void refuseStart(const std::string& path, const Finding& why) {
  throw Told<InputError>(Finding(K::notAStart, {{"file", path}}, why));
}

//! Why a mesh does not bound a body; none if it does.
Finding faultOf(const Certificate& c) {
  if (!c.closed) return K::isNotClosed;
  if (!c.manifold) return K::isNotManifold;
  if (!c.oriented) return K::isNotOriented;
  if (c.selfIntersections > 0) return {K::intersectsItself, {{"pairs", c.selfIntersections}}};
  if (c.misplaced > 0) return K::isMisplaced;
  return c.boundsBody() ? K::none : K::enclosesNoVolume;
}

//! Turned if it is inside out. Throws InputError.
TriangleSoup certified(const std::string& path, TriangleSoup mesh) {
  if (mesh.triangles.empty()) refuseStart(path, K::hasNoTriangles);
  Certificate found = certify(mesh);
  if (found.closed && found.oriented && found.volume < 0) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
    found = certify(mesh);
  }
  if (const Finding fault = faultOf(found); fault.any()) refuseStart(path, fault);
  try {
    return certifiedForExport(mesh).mesh;
  } catch (const std::runtime_error&) {
    refuseStart(path, K::intersectsRounded);
  }
}

//! The middle of the largest of the balls that touch the surface at some of its faces from within.
Vec3 deepInside(const TriangleSoup& mesh) {
  InscribedBalls balls(mesh);
  Vec3 deepest = mesh.points[0];
  double depth = -1;
  const std::size_t every = mesh.triangles.size() / kPlacesTried + 1;
  for (std::size_t f = 0; f < mesh.triangles.size(); f += every) {
    const Triangle& t = mesh.triangles[f];
    const auto corner = [&](int c) { return mesh.points[t[c]]; };
    const Vec3 across = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const double twice = across.norm();
    if (!(twice > 0)) continue;
    const Vec3 start =
        (corner(0) + corner(1) + corner(2)) / 3 - kJustInside * std::sqrt(twice) * across / twice;
    if (!balls.isInside(start)) continue;
    const Vec3 centre = balls.medialCentre(start);
    const double radius = balls.isInside(centre) ? balls.radius(centre) : -1;
    if (radius <= depth) continue;
    depth = radius;
    deepest = centre;
  }
  return deepest;
}

//! A surface that was read, for all starts that mean it.
struct ReadStart {
  std::string sha256;
  std::shared_ptr<const TriangleSoup> mesh;
  Vec3 inside{0, 0, 0};
};

//! What a file was asked for.
struct FileKey {
  std::string path;
  std::vector<int> among;
  bool operator<(const FileKey& other) const {
    return std::tie(path, among) < std::tie(other.path, other.among);
  }
};

ReadStart readStart(const std::string& path, const std::string& sha256, TriangleSoup mesh) {
  ReadStart read{sha256, std::make_shared<const TriangleSoup>(certified(path, std::move(mesh))), {}};
  read.inside = deepInside(*read.mesh);
  return read;
}

Mask maskIn(const std::string& path, const Volume& labels, std::optional<int> label) {
  Mask mask = maskOf(labels, label);
  if (mask.inside.empty())
    refuseStart(path, label ? Finding(K::hasNoLabel, {{"label", *label}}) : K::hasNoVoxel);
  return mask;
}

//! What is wrong with masks is told without a subject.
std::vector<LabelMesh> meshesIn(const std::string& path, const std::vector<Mask>& masks) try {
  return meshesOf(masks, {});
} catch (const InputError& error) {
  const Finding why = findingOf(error);
  refuseStart(path, why.any() ? why : Finding(K::other, {{"text", std::string(error.what())}}));
}

//! By label; 0: all together.
std::map<int, ReadStart> readFile(const FileKey& key, const std::optional<int>& label,
                                  const DecoderSettings& decoder) {
  const std::string hash = sha256OfPath(key.path);
  if (isMeshInputPath(key.path)) {
    if (label) refuseStart(key.path, K::meshWithoutLabels);
    return {{0, readStart(key.path, hash, readMesh(key.path, decoder))}};
  }
  std::vector<Finding> warnings;
  const Volume labels = readLabels(key.path, warnings, decoder).volume;
  std::vector<int> values = key.among;
  if (values.empty()) values.push_back(label.value_or(0));
  std::vector<Mask> masks;
  for (const int value : values)
    masks.push_back(maskIn(key.path, labels, value == 0 ? std::nullopt : std::optional(value)));
  std::map<int, ReadStart> read;
  std::vector<LabelMesh> meshes = meshesIn(key.path, masks);
  for (std::size_t i = 0; i < values.size(); ++i)
    read.emplace(values[i], readStart(key.path, hash, std::move(meshes[i].mesh)));
  return read;
}

//! Labels of one map that several objects name.
void chooseAmong(const std::vector<Session*>& sessions) {
  std::map<std::string, std::set<int>> labels;
  for (Session* session : sessions)
    forEachStart(*session, [&](StartSurface& s) {
      if (s.label && s.among.empty() && !s.mesh) labels[s.path].insert(*s.label);
    });
  for (Session* session : sessions)
    forEachStart(*session, [&](StartSurface& s) {
      if (!s.label || !s.among.empty() || s.mesh) return;
      if (const std::set<int>& all = labels[s.path]; all.size() > 1) s.among.assign(all.begin(), all.end());
    });
}

void take(StartSurface& start, const std::map<int, ReadStart>& file) {
  const auto at = file.find(start.label.value_or(0));
  if (at == file.end()) refuseStart(start.path, {K::lostLabel, {{"label", *start.label}}});
  const ReadStart& read = at->second;
  if (!start.sha256.empty() && start.sha256 != read.sha256)
    throw Told<InputError>(Finding(K::startChanged, {{"file", start.path}}));
  start.sha256 = read.sha256;
  start.mesh = read.mesh;
  start.inside = read.inside;
}

}  // namespace

void loadStarts(const std::vector<Session*>& sessions) {
  chooseAmong(sessions);
  std::map<std::pair<FileKey, int>, std::map<int, ReadStart>> known;
  for (Session* session : sessions)
    forEachStart(*session, [&](StartSurface& start) {
      if (start.mesh) return;
      giveUpIfCancelled();
      const FileKey file{start.path, start.among};
      const int alone = start.among.empty() ? start.label.value_or(0) : 0;
      auto at = known.find({file, alone});
      if (at == known.end()) {
        auto read = readFile(file, start.label, session->volume.selection.decoder);
        at = known.emplace(std::pair(file, alone), std::move(read)).first;
      }
      take(start, at->second);
    });
}

void loadStarts(Session& session) { loadStarts(std::vector<Session*>{&session}); }

bool isMeshAsItIs(const Constraints& constraints) {
  return constraints.start && constraints.start->isDone && isMeshInputPath(constraints.start->path);
}

namespace {

FileLabels saidIn(const std::string& path) {
  FileLabels labels = readSlicerLabels(path);
  return labels.empty() ? readDicomLabels(path) : labels;
}

}  // namespace

FileLabel labelIn(const std::string& path, std::optional<int> value) {
  const FileLabels labels = saidIn(path);
  const auto found = value ? labels.find(*value) : labels.size() == 1 ? labels.begin() : labels.end();
  return found == labels.end() ? FileLabel() : found->second;
}

std::vector<NamedLabel> labelsIn(const std::string& path) {
  std::vector<Finding> warnings;
  const Volume labels = readLabels(path, warnings).volume;
  std::set<int> values;
  visitVoxels(labels, [&](const auto* value) {
    double last = 0;
    for (std::size_t i = 0; i < labels.grid.voxelCount() && values.size() <= kMaxLabels; ++i) {
      const auto v = static_cast<double>(value[i]);
      if (v == last || v == 0) continue;
      values.insert(static_cast<int>(std::lround(v)));
      last = v;
    }
  });
  if (values.empty()) throw Told<InputError>(Finding(K::labelsEmpty, {{"file", path}}));
  if (values.size() > kMaxLabels)
    throw Told<InputError>(Finding(K::tooManyLabels, {{"file", path}, {"most", kMaxLabels}}));
  const FileLabels said = saidIn(path);
  std::vector<NamedLabel> out;
  for (const int value : values) {
    const auto label = said.find(value);
    out.push_back({label == said.end() ? FileLabel() : label->second, value});
  }
  return out;
}

}  // namespace handlebody
