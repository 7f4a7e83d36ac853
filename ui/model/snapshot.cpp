#include "ui/model/snapshot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/collision/certify.h"
#include "core/collision/self_intersection.h"

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
    snapshot->certificate = examine(contour.mesh());
    snapshot->certificate.selfIntersections =
        static_cast<int>(findSelfIntersections(snapshot->mesh.points, snapshot->mesh.triangles).size());
  }
  snapshot->support = contour.support();
  snapshot->held = contour.held();
  snapshot->edgeLength = contour.parameters().edgeLength;
  snapshot->pinned = contour.pinned();
  for (int v = 0; v < contour.mesh().vertexSlots(); ++v)  // in the order of compact()
    if (contour.mesh().isVertex(v)) snapshot->pinnedVertices.push_back(contour.isPinned(v));
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
