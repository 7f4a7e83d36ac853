#include "ui/model/snapshot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/collision/certify.h"
#include "core/collision/self_intersection.h"
#include "core/mesh/topology.h"

namespace handlebody::ui {

namespace {

constexpr int kNewFor = 8;             // iterations that a new handle stays marked
constexpr double kAroundEvent = 2;     // edge lengths beyond the loops of an event
constexpr double kAroundRollBack = 3;  // edge lengths: about what rests there

//! A ball in which faces are marked.
struct Mark {
  Vec3 centre;
  double radius;
  FaceState state;
};

std::vector<Mark> marksOf(const History& history) {
  std::vector<Mark> marks;
  const double edge = history.shown().parameters().edgeLength;
  const int now = history.iteration();
  for (const Event& e : history.events()) {
    if (e.iteration > now || e.iteration <= now - kNewFor) continue;
    if (e.kind == EventKind::handleInserted) {
      int longest = 0;
      for (int size : e.loopSizes) longest = std::max(longest, size);
      const double loop = longest * edge / (2 * std::numbers::pi);
      marks.push_back({e.location, loop + kAroundEvent * edge, FaceState::newHandle});
    } else if (e.kind == EventKind::rolledBack && e.iteration == now) {
      marks.push_back({e.location, kAroundRollBack * edge, FaceState::colliding});
    }
  }
  return marks;
}

FaceState stateOf(const ActiveContour& contour, const Triangle& face, const std::vector<Mark>& marks) {
  const Mesh& mesh = contour.mesh();
  const Vec3 middle = (mesh.position(face[0]) + mesh.position(face[1]) + mesh.position(face[2])) / 3;
  for (const Mark& m : marks)
    if ((middle - m.centre).squaredNorm() < m.radius * m.radius) return m.state;
  const bool settled = std::all_of(face.begin(), face.end(), [&](int v) { return contour.isSettled(v); });
  return settled ? FaceState::settled : FaceState::moving;
}

//! Every half-edge has its opposite, and the faces around every vertex form one fan: closed, manifold and
//! oriented.
bool isClosedManifold(const Mesh& mesh) {
  int corners = 0;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) mesh.forEachOutgoing(v, [&](int) { ++corners; });
  if (corners != 3 * mesh.faceCount()) return false;
  for (int f = 0; f < mesh.faceSlots(); ++f)
    for (int h = 3 * f; mesh.isFace(f) && h < 3 * f + 3; ++h)
      if (mesh.opposite(h) < 0) return false;
  return true;
}

//! The same as examine(), an order of magnitude faster, from the mesh's own structure; without
//! self-intersections.
Certificate examineStructure(const Mesh& mesh) {
  Certificate c;
  const Components parts = findComponents(mesh);
  c.vertices = mesh.vertexCount();
  c.faces = mesh.faceCount();
  c.components = parts.count();
  c.closed = c.manifold = c.oriented = c.faces > 0 && isClosedManifold(mesh);
  for (std::size_t i = 0; i < parts.vertices.size(); ++i) {
    const int euler = parts.vertices[i] - parts.faces[i] / 2;  // 2 E = 3 F
    c.euler += euler;
    if (c.closed) c.genus.push_back((2 - euler) / 2);
    c.volume += parts.volume[i];
  }
  for (int f = 0; f < mesh.faceSlots(); ++f)
    if (mesh.isFace(f)) c.area += mesh.areaVector(f).norm() / 2;
  c.oriented = c.oriented && c.volume > 0;
  return c;
}

}  // namespace

std::shared_ptr<const MeshSnapshot> makeSnapshot(const History& history, Checking checking) {
  const ActiveContour& contour = history.shown();
  auto snapshot = std::make_shared<MeshSnapshot>();
  snapshot->iteration = contour.iteration();
  snapshot->mesh = contour.mesh().compact();
  const std::vector<Mark> marks = marksOf(history);
  snapshot->states.reserve(snapshot->mesh.triangles.size());
  for (const Triangle& face : contour.mesh().faces())  // in the order of compact()
    if (face[0] >= 0) snapshot->states.push_back(stateOf(contour, face, marks));
  if (checking == Checking::everything) {
    snapshot->certificate = certify(snapshot->mesh);
  } else {
    // A step leaves no self-intersections, but what says so on the screen has looked.
    snapshot->certificate = examineStructure(contour.mesh());
    snapshot->certificate.selfIntersections =
        static_cast<int>(findSelfIntersections(snapshot->mesh.points, snapshot->mesh.triangles).size());
  }
  snapshot->support = contour.support();
  snapshot->held = contour.held();
  if (checking == Checking::everything) snapshot->doubts = contour.doubts(snapshot->support);
  return snapshot;
}

std::vector<IterationSummary> summariesFrom(const History& history, std::size_t from) {
  std::vector<IterationSummary> out;
  const std::vector<StepReport>& steps = history.steps();
  for (std::size_t i = from; i < steps.size(); ++i) {
    const double all = std::max(1, steps[i].movedVertices + steps[i].settledVertices);
    out.push_back({steps[i].iteration, steps[i].volume, steps[i].movedVertices / all, 0});
  }
  if (out.empty()) return out;
  for (auto e = history.events().rbegin(); e != history.events().rend(); ++e) {
    if (e->iteration < out.front().iteration) break;
    if (changesTopology(e->kind))
      ++out[static_cast<std::size_t>(e->iteration - out.front().iteration)].events;
  }
  return out;
}

}  // namespace handlebody::ui
