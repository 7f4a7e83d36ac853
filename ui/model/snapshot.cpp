#include "ui/model/snapshot.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/collision/certify.h"
#include "core/collision/self_intersection.h"
#include "core/geometry/triangle_distance.h"

namespace handlebody::ui {

namespace {

constexpr int kNewFor = 8;          // iterations that a new handle stays marked
constexpr double kLiesIn = 0.1;     // edge lengths: the middle of a face from one that it is a part of
constexpr double kLongestPart = 3;  // edge lengths: slots that others have got by now

//! A face that is marked: of this step it is known, of one before what was made of it lies in it.
struct Mark {
  Triangle corners;
  std::array<Vec3, 3> points;
  bool isOfNow;
  FaceState state;
};

//! None if its vertices are there no more.
std::optional<Mark> markOf(const ActiveContour& contour, const Triangle& corners, bool isOfNow,
                           FaceState state) {
  const Mesh& mesh = contour.mesh();
  Mark mark{corners, {}, isOfNow, state};
  for (std::size_t i = 0; i < 3; ++i) {
    if (corners[i] >= mesh.vertexSlots() || !mesh.isVertex(corners[i])) return std::nullopt;
    mark.points[i] = mesh.position(corners[i]);
  }
  if (isOfNow) return mark;
  const double longest = kLongestPart * contour.parameters().edgeLength;
  for (std::size_t i = 0; i < 3; ++i)
    if ((mark.points[i] - mark.points[(i + 1) % 3]).norm() > longest) return std::nullopt;
  return mark;
}

std::vector<Mark> marksOf(const History& history) {
  std::vector<Mark> marks;
  const int now = history.iteration();
  for (const Event& e : history.events()) {
    if (e.iteration > now || e.iteration <= now - kNewFor) continue;
    const bool isNew = e.kind == EventKind::handleInserted, isOfNow = e.iteration == now;
    if (!isNew && !(e.kind == EventKind::rolledBack && isOfNow)) continue;
    for (const Triangle& t : e.faces)
      if (auto m = markOf(history.shown(), t, isOfNow, isNew ? FaceState::newHandle : FaceState::colliding))
        marks.push_back(*m);
  }
  return marks;
}

bool isMarked(const Triangle& face, const Vec3& middle, double edge, const Mark& mark) {
  if (mark.isOfNow) return std::is_permutation(face.begin(), face.end(), mark.corners.begin());
  const double reach = (kLongestPart + kLiesIn) * edge;
  if ((middle - mark.points[0]).squaredNorm() > reach * reach) return false;
  const double apart = squaredDistance(middle, mark.points[0], mark.points[1], mark.points[2]);
  return apart < kLiesIn * kLiesIn * edge * edge;
}

FaceState stateOf(const ActiveContour& contour, const Triangle& face, const std::vector<Mark>& marks) {
  const Mesh& mesh = contour.mesh();
  const Vec3 middle = (mesh.position(face[0]) + mesh.position(face[1]) + mesh.position(face[2])) / 3;
  const double edge = contour.parameters().edgeLength;
  for (const Mark& m : marks)
    if (isMarked(face, middle, edge, m)) return m.state;
  const bool converged = std::all_of(face.begin(), face.end(), [&](int v) { return contour.isConverged(v); });
  return converged ? FaceState::converged : FaceState::moving;
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
  if (checking == Checking::everything) snapshot->warnings = contour.warnings(snapshot->support);
  return snapshot;
}

std::vector<IterationSummary> summariesFrom(const History& history, std::size_t from) {
  std::vector<IterationSummary> out;
  const std::vector<StepReport>& steps = history.steps();
  for (std::size_t i = from; i < steps.size(); ++i) {
    const double all = std::max(1, steps[i].movedVertices + steps[i].unmovedVertices);
    out.push_back({steps[i].iteration, steps[i].volume, steps[i].movedVertices / all});
  }
  if (out.empty()) return out;
  for (auto e = history.events().rbegin(); e != history.events().rend(); ++e) {
    if (e->iteration < out.front().iteration) break;
    IterationSummary& summary = out[e->iteration - out.front().iteration];
    summary.events += changesTopology(e->kind);
    summary.rollBacks += e->kind == EventKind::rolledBack;
  }
  return out;
}

}  // namespace handlebody::ui
