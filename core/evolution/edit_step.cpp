#include "core/evolution/edit_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cancellation.h"
#include "core/mesh/topology.h"
#include "core/surgery/local_smoothing.h"
#include "core/surgery/mesh_edits.h"
#include "core/surgery/plane_cut.h"
#include "core/surgery/pulling.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

bool contains(const std::vector<MeshEdit>& list, const MeshEdit& edit) {
  return std::find(list.begin(), list.end(), edit) != list.end();
}

[[noreturn]] void refuse(const MeshEdit& edit, FindingKind why) {
  throw Told<UsageError>(Finding(why, {{"iteration", edit.iteration}, {"place", placeValue(edit.place)}}));
}

double distanceTo(const Mesh& mesh, const SurfaceLoop& loop, const Vec3& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const SurfacePoint& p : loop.points) nearest = std::min(nearest, (positionOf(mesh, p) - place).norm());
  return nearest;
}

//! The tunnel whose middle is the nearest; null if the place is none of a tunnel.
const Tunnel* tunnelAt(const Mesh& mesh, const std::vector<Tunnel>& tunnels, const Vec3& place) {
  const auto distance = [&](const Tunnel& t) { return (t.position - place).norm(); };
  const auto nearest =
      std::min_element(tunnels.begin(), tunnels.end(),
                       [&](const Tunnel& a, const Tunnel& b) { return distance(a) < distance(b); });
  if (nearest == tunnels.end()) return nullptr;
  const double size = nearest->shorter().length;
  const bool isThere = distance(*nearest) <= size || distanceTo(mesh, nearest->handle, place) <= size ||
                       distanceTo(mesh, nearest->tunnel, place) <= size;
  return isThere ? &*nearest : nullptr;
}

EditOutcome closeTunnelAt(Mesh& mesh, const MeshEdit& edit) {
  const TunnelList list = findTunnels(mesh);
  const Tunnel* tunnel = tunnelAt(mesh, list.tunnels, edit.place);
  if (tunnel == nullptr) refuse(edit, FindingKind::editFindsNoTunnel);
  auto closed = closeOneTunnel(mesh, *tunnel, edit.cut);
  if (!closed) refuse(edit, FindingKind::editWithoutCap);
  EditOutcome out;
  out.events.push_back(std::move(closed->event));
  out.touched = std::move(closed->touched);
  return out;
}

//! The component with the nearest vertex; -1 if that is further away than the component is large.
int componentAt(const Mesh& mesh, const Components& parts, const Vec3& place, bool cavitiesOnly) {
  int nearest = -1;
  double distance = std::numeric_limits<double>::infinity();
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    const int c = parts.ofVertex[v];
    if (c < 0 || (cavitiesOnly && parts.volume[c] > 0)) continue;
    const double d = (mesh.position(v) - place).norm();
    if (d < distance) {
      distance = d;
      nearest = c;
    }
  }
  return nearest >= 0 && distance <= parts.extent[nearest] ? nearest : -1;
}

//! No face is new: what is left has not been touched.
EditOutcome removal(const MeshEdit& edit, std::vector<Event> events) {
  if (events.empty()) refuse(edit, FindingKind::editRemovesNothing);
  if (events.back().after.components == 0) refuse(edit, FindingKind::editLeavesNothing);
  return {std::move(events), {}};
}

EditOutcome editComponentAt(Mesh& mesh, const MeshEdit& edit) {
  const bool isCavity = edit.kind == MeshEditKind::fillCavity;
  const int component = componentAt(mesh, findComponents(mesh), edit.place, isCavity);
  if (component < 0)
    refuse(edit, isCavity ? FindingKind::editFindsNoCavity : FindingKind::editFindsNoComponent);
  return removal(edit, edit.kind == MeshEditKind::keepComponent ? keepBodyOf(mesh, component)
                                                                : removeComponent(mesh, component));
}

//! All faces may be others: the whole mesh has been certified.
EditOutcome touchAt(Mesh& mesh, const MeshEdit& edit) {
  TouchedMesh done = touched(mesh, edit);
  if (!done.isDone())
    throw Told<UsageError>(Finding(FindingKind::editRefused, {{"iteration", edit.iteration}}, done.refusal));
  EditOutcome out;
  out.events.push_back(eventOf(edit, done));
  mesh = std::move(done.mesh);
  for (int v = 0; v < mesh.vertexSlots(); ++v) out.touched.push_back(v);
  return out;
}

}  // namespace

const char* meshEditName(MeshEditKind kind) {
  switch (kind) {
    case MeshEditKind::removeComponent:
      return "remove-component";
    case MeshEditKind::keepComponent:
      return "keep-component";
    case MeshEditKind::fillCavity:
      return "fill-cavity";
    case MeshEditKind::smooth:
      return "smooth";
    case MeshEditKind::pull:
      return "pull";
    case MeshEditKind::cut:
      return "cut";
    default:
      return "close-tunnel";
  }
}

std::optional<MeshEditKind> meshEditKind(const std::string& name) {
  for (const MeshEditKind kind :
       {MeshEditKind::closeTunnel, MeshEditKind::removeComponent, MeshEditKind::keepComponent,
        MeshEditKind::fillCavity, MeshEditKind::smooth, MeshEditKind::pull, MeshEditKind::cut})
    if (name == meshEditName(kind)) return kind;
  return std::nullopt;
}

const char* tunnelCutName(TunnelCut cut) {
  return cut == TunnelCut::handle ? "handle" : cut == TunnelCut::tunnel ? "tunnel" : "shorter";
}

std::optional<TunnelCut> tunnelCutOf(const std::string& name) {
  for (const TunnelCut cut : {TunnelCut::shorter, TunnelCut::handle, TunnelCut::tunnel})
    if (name == tunnelCutName(cut)) return cut;
  return std::nullopt;
}

const char* keptSideName(KeptSide side) {
  return side == KeptSide::positive ? "positive" : side == KeptSide::negative ? "negative" : "both";
}

std::optional<KeptSide> keptSideOf(const std::string& name) {
  for (const KeptSide side : {KeptSide::both, KeptSide::positive, KeptSide::negative})
    if (name == keptSideName(side)) return side;
  return std::nullopt;
}

Finding faultOf(const MeshEdit& edit) {
  const auto fault = [&edit](FindingKind kind) { return Finding(kind, {{"iteration", edit.iteration}}); };
  if (!edit.place.allFinite() || !edit.vector.allFinite() || !std::isfinite(edit.radius))
    return fault(FindingKind::editNotFinite);
  const bool isCut = edit.kind == MeshEditKind::cut;
  const bool isBall = edit.kind == MeshEditKind::smooth || edit.kind == MeshEditKind::pull;
  if (isBall && !(edit.radius > 0)) return fault(FindingKind::editWithoutRadius);
  if (isCut && edit.radius < 0) return fault(FindingKind::editRadiusNegative);
  if (isCut && !(edit.vector.norm() > 0)) return fault(FindingKind::editWithoutNormal);
  return {};
}

TouchedMesh touched(const Mesh& mesh, const MeshEdit& edit) {
  if (edit.kind == MeshEditKind::smooth) return smoothedHere(mesh, edit.place, edit.radius);
  if (edit.kind == MeshEditKind::pull) return pulled(mesh, edit.place, edit.vector, edit.radius);
  PlaneCut cut{edit.place, edit.vector, edit.keep, std::nullopt};
  if (edit.radius > 0) cut.radius = edit.radius;
  return cutByPlane(mesh, cut);
}

Event eventOf(const MeshEdit& edit, const TouchedMesh& done) {
  Event event;
  event.kind = edit.kind == MeshEditKind::smooth ? EventKind::surfaceSmoothed
               : edit.kind == MeshEditKind::pull ? EventKind::surfacePulled
                                                 : EventKind::planeCut;
  event.location = edit.place;
  event.before = done.before;
  event.after = done.after;
  event.edit = EditMeasures{0, done.volumeBefore, done.volumeAfter};
  return event;
}

EditOutcome makeEdit(Mesh& mesh, const MeshEdit& edit) {
  giveUpIfCancelled();
  switch (edit.kind) {
    case MeshEditKind::removeComponent:
    case MeshEditKind::keepComponent:
    case MeshEditKind::fillCavity:
      return editComponentAt(mesh, edit);
    case MeshEditKind::smooth:
    case MeshEditKind::pull:
    case MeshEditKind::cut:
      return touchAt(mesh, edit);
    default:
      return closeTunnelAt(mesh, edit);
  }
}

void EditSchedule::choose(const std::vector<MeshEdit>& edits, int iteration) {
  for (const MeshEdit& e : edits)
    if (e.iteration <= iteration && !contains(made_, e))
      throw Told<UsageError>(
          Finding(FindingKind::editTooLate, {{"iteration", e.iteration}, {"now", iteration}}));
  std::erase_if(made_, [&](const MeshEdit& e) { return !contains(edits, e); });
  asked_ = edits;
}

const MeshEdit* EditSchedule::dueAt(int iteration) const {
  const auto at =
      std::find_if(asked_.begin(), asked_.end(), [&](const MeshEdit& e) { return e.iteration == iteration; });
  return at == asked_.end() ? nullptr : &*at;
}

std::optional<MeshEdit> EditSchedule::waiting() const {
  std::optional<MeshEdit> first;
  for (const MeshEdit& e : asked_)
    if (!contains(made_, e) && (!first || e.iteration < first->iteration)) first = e;
  return first;
}

}  // namespace handlebody
