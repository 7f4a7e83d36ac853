#include "core/io/start_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <tuple>

#include "core/cancellation.h"
#include "core/collision/certify.h"
#include "core/errors.h"
#include "core/io/compared.h"
#include "core/io/mesh_io.h"
#include "core/io/result.h"
#include "core/measure/inscribed_balls.h"
#include "core/solid/label_mesh.h"

namespace handlebody {

namespace {

constexpr std::size_t kPlacesTried = 200;  // on a surface, for one deep inside
constexpr double kJustInside = 1e-3;       // of the square root of a face's area

std::string cannot(const std::string& path, const std::string& why) {
  return path + " cannot be a surface to begin with: it " + why + ".";
}

//! Why a mesh does not bound a body, as the end of a sentence; empty if it does.
std::string faultOf(const Certificate& c) {
  if (!c.closed) return "is not closed";
  if (!c.manifold) return "is not manifold";
  if (!c.oriented) return "has faces that are not oriented alike";
  if (c.selfIntersections > 0)
    return "intersects itself (" + std::to_string(c.selfIntersections) + " pairs of faces)";
  if (c.misplaced > 0) return "has components that lie where they bound nothing";
  return c.boundsBody() ? std::string() : "encloses no volume";
}

//! Turned if it is inside out. Throws InputError.
TriangleSoup certified(const std::string& path, TriangleSoup mesh) {
  if (mesh.triangles.empty()) throw InputError(cannot(path, "has no triangles"));
  Certificate found = certify(mesh);
  if (found.closed && found.oriented && found.volume < 0) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
    found = certify(mesh);
  }
  if (const std::string fault = faultOf(found); !fault.empty()) throw InputError(cannot(path, fault));
  try {
    return certifiedForExport(mesh).mesh;
  } catch (const std::runtime_error&) {
    throw InputError(cannot(path, "intersects itself in single precision"));
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
    const auto corner = [&](int c) {
      return mesh.points[static_cast<std::size_t>(t[static_cast<std::size_t>(c)])];
    };
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
    throw InputError(cannot(
        path, label ? "has no voxel of the value " + std::to_string(*label) : "has no voxel that is not 0"));
  return mask;
}

//! By label; 0: all together.
std::map<int, ReadStart> readFile(const FileKey& key, const std::optional<int>& label) {
  const std::string hash = sha256OfPath(key.path);
  if (isMeshPath(key.path)) {
    if (label) throw InputError(cannot(key.path, "is a mesh, which has no labels"));
    return {{0, readStart(key.path, hash, readMesh(key.path))}};
  }
  std::vector<std::string> warnings;
  const Volume labels = readLabels(key.path, warnings).volume;
  std::vector<int> values = key.among;
  if (values.empty()) values.push_back(label.value_or(0));
  std::vector<Mask> masks;
  for (const int value : values)
    masks.push_back(maskIn(key.path, labels, value == 0 ? std::nullopt : std::optional(value)));
  std::map<int, ReadStart> read;
  try {
    std::vector<LabelMesh> meshes = meshesOf(masks, {});
    for (std::size_t i = 0; i < values.size(); ++i)
      read.emplace(values[i], readStart(key.path, hash, std::move(meshes[i].mesh)));
  } catch (const InputError& error) {
    const std::string text = error.what();
    throw text.rfind(key.path, 0) == 0 ? error : InputError(cannot(key.path, text));
  }
  return read;
}

template <typename F>
void forEachStart(Session& session, F&& f) {
  if (session.constraints.start) f(*session.constraints.start);
  for (ParameterChange& change : session.changes)
    if (change.constraints && change.constraints->start) f(*change.constraints->start);
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
  if (at == file.end())
    throw InputError(cannot(start.path, "became surfaces without the label " + std::to_string(*start.label)));
  const ReadStart& read = at->second;
  if (!start.sha256.empty() && start.sha256 != read.sha256)
    throw InputError(start.path + " is not the file that the session began with: its SHA-256 differs.");
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
      if (at == known.end()) at = known.emplace(std::pair(file, alone), readFile(file, start.label)).first;
      take(start, at->second);
    });
}

void loadStarts(Session& session) { loadStarts(std::vector<Session*>{&session}); }

bool isMeshAsItIs(const Constraints& constraints) {
  return constraints.start && constraints.start->isDone && isMeshPath(constraints.start->path);
}

namespace {

//! What 3D Slicer's keys in the header of a .seg.nrrd say.
std::map<int, std::string> namesIn(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::map<std::string, std::string> names;
  std::map<int, std::string> out;
  std::string line;
  for (int count = 0; count < 10'000 && std::getline(in, line) && !line.empty() && line != "\r"; ++count) {
    if (line.back() == '\r') line.pop_back();
    const auto equals = line.find(":="), bar = line.find('_');
    if (line.rfind("Segment", 0) != 0 || equals == std::string::npos || bar == std::string::npos) continue;
    const std::string which = line.substr(0, bar), key = line.substr(bar + 1, equals - bar - 1),
                      value = line.substr(equals + 2);
    if (key == "Name") names[which] = value;
    if (key != "LabelValue") continue;
    names.emplace(which, std::string());
    out[std::atoi(value.c_str())] = which;
  }
  for (auto& [value, which] : out) which = names[which];
  return out;
}

}  // namespace

std::vector<NamedLabel> labelsIn(const std::string& path) {
  std::vector<std::string> warnings;
  const Volume labels = readLabels(path, warnings).volume;
  std::set<int> values;
  visitVoxels(labels, [&](const auto* value) {
    double last = 0;
    for (std::size_t i = 0; i < labels.grid.voxelCount() && values.size() <= kMostLabels; ++i) {
      const auto v = static_cast<double>(value[i]);
      if (v == last || v == 0) continue;
      values.insert(static_cast<int>(std::lround(v)));
      last = v;
    }
  });
  if (values.empty()) throw InputError(path + " holds no object: all of its voxels are 0.");
  if (values.size() > kMostLabels)
    throw InputError(path + " is hardly a label map: it has more than " + std::to_string(kMostLabels) +
                     " different values.");
  const std::map<int, std::string> names = namesIn(path);
  std::vector<NamedLabel> out;
  for (const int value : values) {
    const auto name = names.find(value);
    out.push_back({value, name == names.end() ? std::string() : name->second});
  }
  return out;
}

}  // namespace handlebody
