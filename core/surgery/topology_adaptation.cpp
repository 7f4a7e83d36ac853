#include "core/surgery/topology_adaptation.h"

#include <algorithm>
#include <map>

#include "core/indices.h"
#include "core/mesh/nesting.h"
#include "core/mesh/topology.h"
#include "core/surgery/collision_groups.h"
#include "core/surgery/fold_smoothing.h"
#include "core/surgery/front_gathering.h"
#include "core/surgery/opening.h"
#include "core/surgery/plan.h"
#include "core/surgery/predicted_change.h"
#include "core/surgery/trace.h"

namespace handlebody {

namespace {

constexpr int kEnlargements = 4;        // rings added to Λ before a place is given up
constexpr int kDeletes = 1;             // rings within which a component goes with Λ: its neighbourhood N
constexpr int kReach = 10;              // edges between sets that are one front
constexpr int kManyEnlargements = 1;    // before several fronts are joined two by two
constexpr std::size_t kManyPlaces = 6;  // in a round, for which it pays to sort the faces by place
// In units of WorkBudget: a look at every face of the mesh, and at one of a place that is opened or smoothed.
constexpr std::size_t kMeshWork = 2;
constexpr std::size_t kPlaceWork = 1000;

class Adaptation {
 public:
  Adaptation(Mesh& mesh, const AdaptationSettings& settings, VertexMarks& touched)
      : mesh_(mesh),
        settings_(settings),
        touched_(touched),
        blocks_(mesh),
        colliding_(idx(mesh.faceSlots()), 0),
        topology_(settings.topology) {}

  AdaptationResult run(std::span<const FacePair> pairs) {
    for (const auto& [f, g] : pairs) colliding_[f] = colliding_[g] = 1;
    const std::vector<Gathering> places = gatherFronts(mesh_, groupCollisions(mesh_, pairs), kReach);
    if (places.size() >= kManyPlaces) blocks_.sortByPlace(mesh_);
    for (const Gathering& g : places) {
      std::vector<Finding> before;
      if (!g.parts.empty() && joinGathered(g.whole, before)) continue;
      if (g.parts.empty()) treat(g.whole, before);
      for (const CollisionGroup& part : g.parts) treat(part, before);
    }
    return std::move(result_);
  }

 private:
  // An earlier group of this round may have removed or replaced what this one was found on: next round then.
  bool isStale(const CollisionGroup& group) const {
    for (const auto& lambda : group.lambda)
      for (int v : lambda)
        if (!mesh_.isVertex(v) || (idx(v) < replaced_.size() && replaced_[v])) return true;
    return false;
  }

  //! Joins fronts that were found in several groups at once; if that fails, `before` says why.
  bool joinGathered(const CollisionGroup& group, std::vector<Finding>& before) {
    if (isStale(group) || isPinned(group)) return false;
    FindingKind reason = FindingKind::none;
    const auto fronts = mostColliding(mesh_, group, kMaxFronts);
    if (close(group, fronts, kManyEnlargements, waiting(group, fronts.size()), reason)) return true;
    before = {notAtOnce(fronts.size(), reason)};
    return false;
  }
  static Finding notAtOnce(std::size_t fronts, FindingKind reason) {
    return {FindingKind::frontsNotJoined, {{"fronts", fronts}}, reason};
  }

  static std::vector<Finding> waiting(const CollisionGroup& group, std::size_t fronts) {
    if (group.lambda.size() == fronts) return {};
    return {
        {FindingKind::frontsWait, {{"fronts", group.lambda.size()}, {"left", group.lambda.size() - fronts}}}};
  }

  bool isPinned(const CollisionGroup& group) const {
    return std::any_of(group.lambda.begin(), group.lambda.end(),
                       [this](const auto& lambda) { return settings_.forbidden.isAnyPinned(lambda); });
  }

  //! A fold beside them is smoothed as far as it may be; whatever else meets pinned vertices stops there.
  void treatPinned(const CollisionGroup& group) {
    if (smoothed(group)) return;
    giveUp(group, FindingKind::meetsPinned);
    result_.conflicts.back().atPin = true;
  }

  void treat(const CollisionGroup& group, std::vector<Finding> before) {
    if (isStale(group)) return;
    if (isPinned(group)) return treatPinned(group);
    if (isSpent()) return wait(group);
    const std::size_t hadWork = settings_.work ? settings_.work->left() : 0;
    // A collar that closes behind an enclosed part can be smoothed again and again: it has to be cut.
    const bool cutFirst = settings_.cameBack && settings_.cameBack(middle(group));
    if (!cutFirst && smoothed(group)) return;
    FindingKind reason = FindingKind::none;
    if (group.lambda.size() > 2) {
      const auto fronts = mostColliding(mesh_, group, kMaxFronts);
      if (close(group, fronts, kManyEnlargements, waiting(group, fronts.size()), reason)) return;
      before = {notAtOnce(fronts.size(), reason)};
    }
    if (close(group, mostColliding(mesh_, group, 2), kEnlargements, before, reason)) return;
    if (isSpent() && hadWork < settings_.work->all() / 2) return wait(group);
    if (!cutFirst || !smoothed(group)) giveUp(group, isSpent() ? FindingKind::tooMuchWork : reason);
  }

  //! Closes the openings around the sets, or around more and more rings of them.
  bool close(const CollisionGroup& group, std::vector<std::vector<int>> sets, int enlargements,
             const std::vector<Finding>& before, FindingKind& reason) {
    std::vector<Finding> why = before;
    // Now: where the mesh is refined the faces that collide are no more.
    const EventTrace met = settings_.recordTraces ? traceOfCollision(mesh_, group.pairs) : EventTrace{};
    for (int ring = 0; ring <= enlargements && !isSpent(); ++ring) {
      for (const auto& lambda : sets) spend(kPlaceWork * lambda.size());
      colliding_.resize(mesh_.faceSlots(), 0);
      const auto plan =
          planFor(mesh_, blocks_, sets,
                  {settings_.outwardOnly, colliding_, settings_.forbidden, settings_.work}, reason);
      const bool deletes = plan && plan->kind == EventKind::componentDeleted && ring > kDeletes;
      if (plan && !deletes) {
        apply(group, *plan, why, met);
        return true;
      }
      if (deletes) reason = FindingKind::nothingLeft;
      why = before;
      why.push_back(ring == 0 ? Finding(FindingKind::ringAdded, {}, reason)
                              : Finding(FindingKind::ringsAdded, {{"rings", ring + 1}}, reason));
      for (auto& lambda : sets) lambda = enlarge(mesh_, lambda);
      mergeTouching(mesh_, sets);
    }
    return false;
  }

  bool smoothed(const CollisionGroup& group) {
    spend(kPlaceWork * group.lambda[0].size());
    if (group.lambda.size() != 1 ||
        !smoothFold(mesh_, blocks_, group.lambda[0], colliding_, settings_.forbidden, touched_))
      return false;
    report(group, EventKind::smoothed);
    return true;
  }

  void apply(const CollisionGroup& group, const Plan& plan, const std::vector<Finding>& why,
             const EventTrace& met) {
    Event event = describe(group, plan);
    if (settings_.recordTraces) traceOpening(mesh_, plan.openings, event.trace = met);
    event.reasons = why;
    if (!plan.shortest) event.reasons.push_back(FindingKind::maybeShorter);
    std::vector<int> faces, vertices;
    for (const Opening& o : plan.openings) {
      faces.insert(faces.end(), o.faces.begin(), o.faces.end());
      vertices.insert(vertices.end(), o.lambda.begin(), o.lambda.end());
    }
    spend(kMeshWork * idx(mesh_.faceSlots()));
    mesh_.removeFaces(faces);
    for (int v : vertices) mesh_.removeVertex(v);
    predict(event, predictChange(topology_, mesh_, plan));
    std::vector<int> fresh;
    for (const Vec3& p : plan.patch.points) fresh.push_back(mesh_.addVertex(p));
    std::vector<Triangle> patch = plan.patch.faces;
    for (Triangle& t : patch)
      for (int& v : t)
        if (v >= plan.patch.firstNew) v = fresh[v - plan.patch.firstNew];
    mesh_.addFaces(patch);
    // Removed slots may be filled again: they count as replaced all the same.
    replaced_.resize(mesh_.vertexSlots(), 0);
    touched_.resize(mesh_.vertexSlots(), 0);
    for (int v : vertices) replaced_[v] = 1;
    for (const Triangle& t : patch)
      for (int v : t) touched_[v] = replaced_[v] = 1;
    for (const Triangle& t : patch) blocks_.includeAround(mesh_, t);
    // Face slots have new owners, which collide with nothing.
    colliding_.resize(mesh_.faceSlots(), 0);
    for (int f : faces) colliding_[f] = 0;
    for (const Triangle& t : patch)
      for (int v : t) mesh_.forEachOutgoing(v, [&](int h) { colliding_[Mesh::faceOf(h)] = 0; });

    if (plan.kind == EventKind::split || plan.kind == EventKind::smoothed) event.kind = kindOfCut(event);
    // Where fronts of two components meet and a part between them is cut off, their number stays.
    const bool cut = event.after.components > event.before.components ||
                     (plan.kind == EventKind::handleInserted && idx(event.fronts) < event.loopSizes.size());
    if (cut) {
      const Components parts = findComponents(mesh_);
      if (event.kind == EventKind::split && hasCavity(parts, patch))
        event.kind = EventKind::enclosedPartCutOff;
      report(std::move(event), patch);
      settings_.outwardOnly ? deleteFlakes(parts, patch) : deleteMisplaced(parts, patch);
    } else {
      report(std::move(event), patch);
    }
  }

  void report(Event event, const std::vector<Triangle>& patch) {
    if (settings_.recordTraces) traceClosing(mesh_, patch, event.trace);
    if (event.kind == EventKind::handleInserted) event.faces = patch;
    result_.events.push_back(std::move(event));
  }

  //! True if the patch bounds a part of outside space that it has just enclosed.
  static bool hasCavity(const Components& parts, const std::vector<Triangle>& patch) {
    return std::any_of(patch.begin(), patch.end(),
                       [&](const Triangle& t) { return parts.volume[parts.ofVertex[t[0]]] < 0; });
  }

  //! Motion outwards can cut off nothing but cavities. A solid piece that a cut leaves is a scrap of surface
  //! turned inside out, and would grow into the object once more.
  void deleteFlakes(const Components& parts, const std::vector<Triangle>& patch) {
    std::map<int, int> solids;  // component beside the cut → one of its vertices
    for (const Triangle& t : patch)
      if (parts.volume[parts.ofVertex[t[0]]] >= 0) solids.emplace(parts.ofVertex[t[0]], t[0]);
    const auto body = std::max_element(solids.begin(), solids.end(), [&](const auto& a, const auto& b) {
      return parts.volume[a.first] < parts.volume[b.first];
    });
    for (auto it = solids.begin(); it != solids.end(); ++it) {
      if (it != body) deletePart(parts, it->second);
    }
  }

  //! Where the surface may shrink, a cut may well leave two solid pieces, and only the place of a piece tells
  //! that it is a scrap.
  void deleteMisplaced(const Components& parts, const std::vector<Triangle>& patch) {
    std::map<int, int> beside;  // component beside the cut → one of its vertices
    for (const Triangle& t : patch) beside.emplace(parts.ofVertex[t[0]], t[0]);
    for (const auto& [component, vertex] : beside)
      if (isMisplaced(mesh_, parts, component)) deletePart(parts, vertex);
  }

  void deletePart(const Components& parts, int v) {
    Event event;
    event.kind = EventKind::componentDeleted;
    event.iteration = settings_.iteration;
    event.location = mesh_.position(v);
    predict(event, predictDeletion(topology_, parts, parts.ofVertex[v]));
    deleteComponent(mesh_, v);
    result_.events.push_back(std::move(event));
  }

  void predict(Event& event, const TopologyNumbers& after) {
    event.before = topology_;
    event.after = topology_ = after;
  }

  //! What closing one opening with caps does is known only when the mesh is open.
  static EventKind kindOfCut(const Event& event) {
    if (event.after.components > event.before.components) return EventKind::split;
    return event.after.genus < event.before.genus ? EventKind::tunnelClosed : EventKind::smoothed;
  }

  Event describe(const CollisionGroup& group, const Plan& plan) const {
    Event event;
    event.kind = plan.kind;
    event.iteration = settings_.iteration;
    event.fronts = plan.fronts;
    event.handleFrom = plan.handleFrom;
    event.location = middle(group);
    for (const Opening& o : plan.openings)
      for (const auto& loop : o.loops) event.loopSizes.push_back(static_cast<int>(loop.size()));
    return event;
  }

  Vec3 middle(const CollisionGroup& group) const {
    Vec3 sum(0, 0, 0);
    double n = 0;
    for (const auto& lambda : group.lambda)
      for (int v : lambda) {
        sum += mesh_.position(v);
        n += 1;
      }
    return sum / n;
  }

  void report(const CollisionGroup& group, EventKind kind) {
    Event event;
    event.kind = kind;
    event.iteration = settings_.iteration;
    event.location = middle(group);
    event.before = event.after = topology_;
    result_.events.push_back(std::move(event));
  }

  bool isSpent() const { return settings_.work && settings_.work->isSpent(); }
  void spend(std::size_t units) const {
    if (settings_.work) settings_.work->spend(units);
  }

  void wait(const CollisionGroup& group) {
    giveUp(group, FindingKind::workIsDone);
    result_.conflicts.back().waits = true;
  }

  void giveUp(const CollisionGroup& group, FindingKind reason) {
    Conflict t{middle(group), 0, reason};
    for (const auto& lambda : group.lambda)
      for (int v : enlarge(mesh_, lambda))
        t.radius = std::max(t.radius, (mesh_.position(v) - t.centre).norm());
    std::vector<int> faces;
    for (const auto& [f, g] : group.pairs) faces.insert(faces.end(), {f, g});
    sortUnique(faces);
    for (const int f : faces)
      if (mesh_.isFace(f)) t.faces.push_back(mesh_.face(f));
    result_.conflicts.push_back(t);
  }

  Mesh& mesh_;
  const AdaptationSettings& settings_;
  VertexMarks& touched_;
  FaceBlocks blocks_;
  FaceMarks colliding_;       // per face
  VertexMarks replaced_;      // per vertex
  TopologyNumbers topology_;  // as after the last event
  AdaptationResult result_;
};

}  // namespace

AdaptationResult adaptTopology(Mesh& mesh, std::span<const FacePair> pairs,
                               const AdaptationSettings& settings, VertexMarks& touched) {
  return Adaptation(mesh, settings, touched).run(pairs);
}

}  // namespace handlebody
