#include "core/io/report/start_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/cancellation.h"
#include "core/collision/certify.h"
#include "core/errors.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/label_file.h"
#include "core/io/report/result.h"
#include "core/io/report/session_files.h"
#include "core/measure/inscribed_balls.h"
#include "core/solid/label_mesh.h"
#include "core/solid/simplify.h"
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
  // One that is inside out does not count as oriented.
  if (found.closed && found.manifold && found.volume < 0) {
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
  std::size_t shared = 0;
  bool isMesh = false;
  std::vector<Finding> warnings{};
};

//! What a file was asked for.
struct FileKey {
  std::string path;
  std::vector<int> among;
  LabelShape shape;
  auto operator<=>(const FileKey&) const = default;  // NOLINT(modernize-use-nullptr): the compiler's own 0
};

ReadStart readStart(const std::string& path, const std::string& sha256, TriangleSoup mesh) {
  ReadStart read{sha256, std::make_shared<const TriangleSoup>(certified(path, std::move(mesh))), {}};
  read.inside = deepInside(*read.mesh);
  return read;
}

[[noreturn]] void refuseTunnels(const FileKey& key, int tunnels) {
  refuseStart(key.path, {K::keepsTunnels, {{"tunnels", tunnels}, {"most", *key.shape.genus}}});
}

Mask maskIn(const FileKey& key, LabelFile& labels, std::optional<int> label) {
  Mask mask = labels.mask(label);
  if (mask.inside.empty())
    refuseStart(key.path, label ? Finding(K::hasNoLabel, {{"label", *label}}) : K::hasNoVoxel);
  if (key.shape.keepsLargest) mask = largestPart(mask);
  if (!key.shape.genus) return mask;
  std::optional<Mask> simpler = withFewerTunnels(mask, *key.shape.genus);
  if (!simpler) refuseTunnels(key, countTunnels(mask));
  return *std::move(simpler);
}

//! What fills a tunnel may belong to other labels.
void checkTunnels(const FileKey& key, const std::vector<Mask>& masks) {
  if (!key.shape.genus || masks.size() < 2) return;
  for (const Mask& mask : masks)
    if (const int tunnels = countTunnels(mask); tunnels > *key.shape.genus) refuseTunnels(key, tunnels);
}

//! Voxels that several labels hold are one's, and a tunnel is not filled with voxels of another label. How
//! many each has left to others.
std::vector<std::size_t> keepApart(const FileKey& key, const std::vector<int>& values,
                                   std::vector<Mask>& masks) {
  std::vector<std::size_t> shared = leaveToSmaller(masks);
  for (std::size_t i = 0; i < masks.size(); ++i)
    if (masks[i].inside.empty()) refuseStart(key.path, {K::hasNoneAlone, {{"label", values[i]}}});
  checkTunnels(key, masks);
  return shared;
}

//! What is wrong with masks is told without a subject.
std::vector<LabelMesh> meshesIn(const FileKey& key, const std::vector<Mask>& masks) try {
  LabelMeshOptions options;
  if (key.shape.smoothing) options.smoothing = *key.shape.smoothing;
  return meshesOf(masks, options);
} catch (const InputError& error) {
  refuseStart(key.path, saidBy(error));
}

//! By label; 0: all together.
std::map<int, ReadStart> readFile(const FileKey& key, const std::optional<int>& label,
                                  const DecoderSettings& decoder) {
  const std::string hash = sha256OfPath(key.path);
  if (isMeshInputPath(key.path)) {
    if (label) refuseStart(key.path, K::meshWithoutLabels);
    ReadStart read = readStart(key.path, hash, readMesh(key.path, decoder));
    read.isMesh = true;
    return {{0, std::move(read)}};
  }
  LabelFile labels(key.path, decoder);
  std::vector<int> values = key.among;
  if (values.empty()) values.push_back(label.value_or(0));
  std::vector<Mask> masks;
  for (const int value : values)
    masks.push_back(maskIn(key, labels, value == 0 ? std::nullopt : std::optional(value)));
  std::vector<std::size_t> shared(masks.size());
  if (labels.info().layers > 1 || key.shape.genus) shared = keepApart(key, values, masks);
  std::map<int, ReadStart> read;
  std::vector<LabelMesh> meshes = meshesIn(key, masks);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::vector<Finding> told = labelMeshWarnings(meshes[i].mesh, meshes[i].certificate, masks[i], {});
    const auto at = read.emplace(values[i], readStart(key.path, hash, std::move(meshes[i].mesh))).first;
    at->second.shared = shared[i];
    at->second.warnings = labels.warnings();
    for (Finding& w : told) at->second.warnings.push_back({K::ofFile, {{"file", key.path}}, std::move(w)});
  }
  return read;
}

//! Labels of one map that several objects name.
void chooseAmong(const std::vector<Session*>& sessions) {
  std::map<std::pair<std::string, LabelShape>, std::set<int>> labels;
  for (Session* session : sessions)
    forEachStart(*session, [&](StartSurface& s) {
      if (s.label && s.among.empty() && !s.mesh) labels[{s.path, s.shape}].insert(*s.label);
    });
  for (Session* session : sessions)
    forEachStart(*session, [&](StartSurface& s) {
      if (!s.label || !s.among.empty() || s.mesh) return;
      if (const std::set<int>& all = labels[{s.path, s.shape}]; all.size() > 1)
        s.among.assign(all.begin(), all.end());
    });
}

void take(StartSurface& start, const std::map<int, ReadStart>& file) {
  const auto at = file.find(start.label.value_or(0));
  if (at == file.end()) refuseStart(start.path, {K::lostLabel, {{"label", *start.label}}});
  const ReadStart& read = at->second;
  if (!start.sha256.empty() && start.sha256 != read.sha256 && !hashOfPath(start.path).is(start.sha256))
    throw Told<InputError>(Finding(K::startChanged, {{"file", start.path}}));
  start.sha256 = read.sha256;
  start.mesh = read.mesh;
  start.inside = read.inside;
  start.shared = read.shared;
  start.isMesh = read.isMesh;
  start.warnings = read.warnings;
}

}  // namespace

void loadStarts(const std::vector<Session*>& sessions) {
  for (Session* session : sessions) forEachStart(*session, findByName);
  chooseAmong(sessions);
  std::map<std::pair<FileKey, int>, std::map<int, ReadStart>> known;
  for (Session* session : sessions)
    forEachStart(*session, [&](StartSurface& start) {
      if (start.mesh) return;
      giveUpIfCancelled();
      const FileKey file{start.path, start.among, start.shape};
      const int alone = start.among.empty() ? start.label.value_or(0) : 0;
      auto at = known.find({file, alone});
      if (at == known.end()) {
        auto read = readFile(file, start.label, session->volume.selection.decoder);
        at = known.emplace(std::pair(file, alone), std::move(read)).first;
      }
      take(start, at->second);
    });
}

void findByName(StartSurface& start) {
  if (start.called.empty()) return;
  start.label = labelCalled(start.path, start.called);
  start.called.clear();
}

void loadStarts(Session& session) { loadStarts(std::vector<Session*>{&session}); }

Finding sharedVoxels(const Constraints& constraints) {
  if (!constraints.start || constraints.start->shared == 0) return {};
  return {K::givenShares, {{"voxels", constraints.start->shared}}};
}

SegmentSource sourceInFiles(SegmentSource source, const Constraints& constraints, int iteration,
                            bool isAnonymous) {
  if (!constraints.start || iteration > 0) source.algorithm.reset();
  return isAnonymous ? withoutSite(std::move(source)) : source;
}

bool isMeshAsItIs(const Constraints& constraints) {
  return constraints.start && constraints.start->isDone && constraints.start->isMesh;
}

}  // namespace handlebody
