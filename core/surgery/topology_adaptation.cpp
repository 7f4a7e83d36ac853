#include "core/surgery/topology_adaptation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <optional>

#include "core/mesh/topology.h"
#include "core/surgery/closing.h"
#include "core/surgery/collision_groups.h"
#include "core/surgery/fold_smoothing.h"
#include "core/surgery/nesting.h"
#include "core/surgery/opening.h"

namespace handlebody {

namespace {

constexpr int kHandleCandidates = 12;  // next-best handles tried before Λ is enlarged
constexpr int kLongestLoop = 120;      // vertices; closing takes time that grows with the cube of this
constexpr int kEnlargements = 4;       // rings added to Λ before a place is given up

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

//! A way to close the openings of a group.
struct Plan {
  std::vector<Opening> openings;
  Patch patch;
  EventKind kind = EventKind::smoothed;
  int fronts = 0;
};

//! A way to close one opening, and what it costs.
struct ClosingChoice {
  Patch patch;
  EventKind kind = EventKind::smoothed;
  double area = 0;  // mm²
  bool shrinks = false;
};

class Adaptation {
 public:
  Adaptation(Mesh& mesh, const AdaptationSettings& settings, std::vector<unsigned char>& touched)
      : mesh_(mesh),
        settings_(settings),
        touched_(touched),
        colliding_(idx(mesh.faceSlots()), 0),
        topology_(settings.topology) {}

  AdaptationResult run(std::span<const FacePair> pairs) {
    for (const auto& [f, g] : pairs) colliding_[idx(f)] = colliding_[idx(g)] = 1;
    for (const CollisionGroup& group : groupCollisions(mesh_, pairs)) treat(group);
    return std::move(result_);
  }

 private:
  // An earlier group of this round may have removed or replaced what this one was found on: next round then.
  bool isStale(const CollisionGroup& group) const {
    for (const auto& lambda : group.lambda)
      for (int v : lambda)
        if (!mesh_.isVertex(v) || (idx(v) < replaced_.size() && replaced_[idx(v)])) return true;
    return false;
  }

  void treat(const CollisionGroup& group) {
    if (isStale(group)) return;
    // A collar that closes behind an enclosed part can be smoothed again and again: it has to be cut.
    const bool cutFirst = settings_.cameBack && settings_.cameBack(middle(group));
    if (!cutFirst && smoothed(group)) return;
    std::vector<std::vector<int>> sets = chooseFronts(group);
    const char* reason = "";
    for (int ring = 0; ring <= kEnlargements; ++ring) {
      if (auto plan = planFor(sets, reason)) {
        apply(group, *plan);
        return;
      }
      for (auto& lambda : sets) lambda = enlarge(mesh_, lambda);
      mergeTouching(sets);
    }
    if (!cutFirst || !smoothed(group)) giveUp(group, reason);
  }

  bool smoothed(const CollisionGroup& group) {
    if (group.lambda.size() != 1 || !smoothFold(mesh_, group.lambda[0], colliding_, touched_)) return false;
    report(group, EventKind::smoothed, {});
    return true;
  }

  //! The one or two sets to work on: of several, the two with the most collisions; the rest waits for the
  //! next round.
  std::vector<std::vector<int>> chooseFronts(const CollisionGroup& group) const {
    if (group.lambda.size() <= 2) return group.lambda;
    std::map<std::pair<std::size_t, std::size_t>, int> count;
    const auto setOf = [&](int f) {
      std::size_t s = 0;
      while (!std::binary_search(group.lambda[s].begin(), group.lambda[s].end(), mesh_.face(f)[0])) ++s;
      return s;
    };
    for (const auto& [f, g] : group.pairs)
      if (setOf(f) != setOf(g)) ++count[std::minmax(setOf(f), setOf(g))];
    const auto best = std::max_element(count.begin(), count.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return {group.lambda[best->first.first], group.lambda[best->first.second]};
  }

  //! Sets that have come to share a neighbour count as one.
  void mergeTouching(std::vector<std::vector<int>>& sets) const {
    if (sets.size() < 2) return;
    const std::vector<int> ring = enlarge(mesh_, sets[0]), other = enlarge(mesh_, sets[1]);
    std::vector<int> common;
    std::set_intersection(ring.begin(), ring.end(), other.begin(), other.end(), std::back_inserter(common));
    if (common.empty()) return;
    sets[0].insert(sets[0].end(), sets[1].begin(), sets[1].end());
    sets[0].insert(sets[0].end(), common.begin(), common.end());
    std::sort(sets[0].begin(), sets[0].end());
    sets[0].erase(std::unique(sets[0].begin(), sets[0].end()), sets[0].end());
    sets.pop_back();
  }

  std::optional<Plan> planFor(const std::vector<std::vector<int>>& sets, const char*& reason) {
    Plan plan;
    std::vector<std::size_t> open;  // openings with a boundary; the others are whole components
    for (const auto& lambda : sets) {
      plan.openings.push_back(openWithRefinement(mesh_, lambda));
      if (!plan.openings.back().loops.empty()) open.push_back(plan.openings.size() - 1);
    }
    for (const Opening& o : plan.openings)
      for (const auto& loop : o.loops)
        if (static_cast<int>(loop.size()) > kLongestLoop) {
          reason = "the opening is too large";
          return std::nullopt;
        }
    colliding_.resize(idx(mesh_.faceSlots()), 0);
    plan.patch.firstNew = mesh_.vertexSlots();
    if (open.empty()) {
      plan.kind = EventKind::componentDeleted;
      return plan;
    }
    const Surroundings surroundings(mesh_, plan.openings, colliding_);
    if (open.size() == 2) return joinFronts(plan, surroundings, reason);
    return closeOne(plan, plan.openings[open[0]], surroundings, reason);
  }

  //! k = 2: a handle between one polygon of each set, caps on all others (parts enclosed by Λ).
  std::optional<Plan> joinFronts(Plan plan, const Surroundings& surroundings, const char*& reason) const {
    struct Choice {
      Patch handle;
      std::size_t i, j;
    };
    std::vector<Choice> choices;
    bool inward = false;
    for (std::size_t i = 0; i < plan.openings[0].loops.size(); ++i)
      for (std::size_t j = 0; j < plan.openings[1].loops.size(); ++j) {
        if (settings_.outwardOnly && !meetOutside(plan.openings[0], i, plan.openings[1], j)) {
          inward = true;
          continue;
        }
        for (Patch& p : handlesBetween(mesh_, plan.openings, plan.openings[0].loops[i],
                                       plan.openings[1].loops[j], kHandleCandidates))
          choices.push_back({std::move(p), i, j});
      }
    std::stable_sort(choices.begin(), choices.end(),
                     [](const Choice& a, const Choice& b) { return a.handle.length < b.handle.length; });
    for (Choice& c : choices) {
      Patch patch = std::move(c.handle);
      for (std::size_t i = 0; i < plan.openings[0].loops.size(); ++i)
        if (i != c.i) patch.append(fanCap(mesh_, plan.openings[0].loops[i]));
      for (std::size_t j = 0; j < plan.openings[1].loops.size(); ++j)
        if (j != c.j) patch.append(fanCap(mesh_, plan.openings[1].loops[j]));
      if (!surroundings.fits(patch)) continue;
      plan.patch = std::move(patch);
      plan.kind = EventKind::handleInserted;
      plan.fronts = 2;
      return plan;
    }
    reason =
        choices.empty() && inward ? "the fronts meet through the inside of the object" : "no handle fits";
    return std::nullopt;
  }

  //! True if the two fronts face each other across outside space: their normals point at each other's
  //! polygon.
  bool meetOutside(const Opening& a, std::size_t i, const Opening& b, std::size_t j) const {
    const Vec3 across = centre(b.loops[j]) - centre(a.loops[i]);
    return (meanNormal(a) - meanNormal(b)).dot(across) > 0;
  }
  Vec3 centre(const std::vector<int>& loop) const {
    Vec3 sum(0, 0, 0);
    for (int v : loop) sum += mesh_.position(v);
    return sum / static_cast<double>(loop.size());
  }
  Vec3 meanNormal(const Opening& o) const {
    Vec3 sum(0, 0, 0);
    for (int f : o.faces) sum += mesh_.areaVector(f);
    return sum.normalized();
  }

  //! One set: a patch if it is a disc; caps (a cut) or a band if it has several polygons, whichever is
  //! smaller. Where only outward motion is allowed, what takes volume away comes last: a narrow neck of
  //! outside space is cut by caps, the crease around a handle that has just been made is not.
  std::optional<Plan> closeOne(Plan plan, const Opening& opening, const Surroundings& surroundings,
                               const char*& reason) const {
    const bool disc = opening.loops.size() == 1;
    std::vector<ClosingChoice> choices = capsFor(opening);
    if (opening.loops.size() == 2)
      for (Patch& p : handlesBetween(mesh_, std::span(&opening, 1), opening.loops[0], opening.loops[1],
                                     kHandleCandidates))
        choices.push_back({std::move(p), EventKind::smoothed});
    for (ClosingChoice& c : choices) {
      c.area = area(mesh_, c.patch);
      c.shrinks = settings_.outwardOnly && volumeGain(mesh_, std::span(&opening, 1), c.patch) < 0;
    }
    if (!disc)
      std::stable_sort(choices.begin(), choices.end(), [](const ClosingChoice& a, const ClosingChoice& b) {
        return a.shrinks != b.shrinks ? b.shrinks : a.area < b.area;
      });
    for (ClosingChoice& c : choices)
      if (surroundings.fits(c.patch)) {
        plan.patch = std::move(c.patch);
        plan.kind = c.kind;
        return plan;
      }
    reason = "no patch fits";
    return std::nullopt;
  }

  //! Caps on every polygon: with barycentres, and of least area. Whether caps on several polygons split the
  //! mesh or close a tunnel is known only when it is done.
  std::vector<ClosingChoice> capsFor(const Opening& opening) const {
    const EventKind kind = opening.loops.size() == 1 ? EventKind::smoothed : EventKind::split;
    Patch fans, flats;
    fans.firstNew = flats.firstNew = mesh_.vertexSlots();
    bool flat = true;
    for (const auto& loop : opening.loops) {
      fans.append(fanCap(mesh_, loop));
      const auto cap = leastAreaCap(mesh_, opening, loop);
      flat = flat && cap;
      if (flat) flats.append(*cap);
    }
    std::vector<ClosingChoice> choices;
    choices.push_back({std::move(fans), kind});
    if (flat) choices.push_back({std::move(flats), kind});
    return choices;
  }

  void apply(const CollisionGroup& group, const Plan& plan) {
    Event event = describe(group, plan);
    std::vector<int> faces, vertices;
    for (const Opening& o : plan.openings) {
      faces.insert(faces.end(), o.faces.begin(), o.faces.end());
      vertices.insert(vertices.end(), o.lambda.begin(), o.lambda.end());
    }
    mesh_.removeFaces(faces);
    for (int v : vertices) mesh_.removeVertex(v);
    std::vector<int> fresh;
    for (const Vec3& p : plan.patch.points) fresh.push_back(mesh_.addVertex(p));
    std::vector<Triangle> patch = plan.patch.faces;
    for (Triangle& t : patch)
      for (int& v : t)
        if (v >= plan.patch.firstNew) v = fresh[idx(v - plan.patch.firstNew)];
    mesh_.addFaces(patch);
    // Removed slots may be filled again: they count as replaced all the same.
    replaced_.resize(idx(mesh_.vertexSlots()), 0);
    touched_.resize(idx(mesh_.vertexSlots()), 0);
    for (int v : vertices) replaced_[idx(v)] = 1;
    for (const Triangle& t : patch)
      for (int v : t) touched_[idx(v)] = replaced_[idx(v)] = 1;
    // Face slots have new owners, which collide with nothing.
    colliding_.resize(idx(mesh_.faceSlots()), 0);
    for (int f : faces) colliding_[idx(f)] = 0;
    for (const Triangle& t : patch)
      for (int v : t) mesh_.forEachOutgoing(v, [&](int h) { colliding_[idx(Mesh::faceOf(h))] = 0; });

    countTopology(event);
    if (plan.kind == EventKind::split || plan.kind == EventKind::smoothed) event.kind = kindOfCut(event);
    const bool cut = event.after.components > event.before.components;
    if (cut && event.kind == EventKind::split && hasCavity(patch)) event.kind = EventKind::enclosedPartCutOff;
    if (settings_.recordTraces)
      for (const Triangle& t : patch)
        event.trace.handleFaces.push_back({mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2])});
    if (settings_.recordTraces) {
      event.trace.closedFaces = event.trace.openedFaces;
      event.trace.closedFaces.insert(event.trace.closedFaces.end(), event.trace.handleFaces.begin(),
                                     event.trace.handleFaces.end());
    }
    result_.events.push_back(std::move(event));
    if (cut && settings_.outwardOnly) deleteFlakes(patch);
    if (cut && !settings_.outwardOnly) deleteMisplaced(patch);
  }

  //! True if the patch bounds a part of outside space that it has just enclosed.
  bool hasCavity(const std::vector<Triangle>& patch) const {
    const Components parts = findComponents(mesh_);
    return std::any_of(patch.begin(), patch.end(),
                       [&](const Triangle& t) { return parts.volume[idx(parts.ofVertex[idx(t[0])])] < 0; });
  }

  //! Motion outwards can cut off nothing but cavities. A solid piece that a cut leaves is a scrap of surface
  //! turned inside out, and would grow into the object once more.
  void deleteFlakes(const std::vector<Triangle>& patch) {
    const Components parts = findComponents(mesh_);
    std::map<int, int> solids;  // component beside the cut → one of its vertices
    for (const Triangle& t : patch)
      if (parts.volume[idx(parts.ofVertex[idx(t[0])])] >= 0) solids.emplace(parts.ofVertex[idx(t[0])], t[0]);
    const auto body = std::max_element(solids.begin(), solids.end(), [&](const auto& a, const auto& b) {
      return parts.volume[idx(a.first)] < parts.volume[idx(b.first)];
    });
    for (auto it = solids.begin(); it != solids.end(); ++it) {
      if (it != body) deletePart(it->second);
    }
  }

  //! Where the surface may shrink, a cut may well leave two solid pieces, and only the place of a piece tells
  //! that it is a scrap.
  void deleteMisplaced(const std::vector<Triangle>& patch) {
    const Components parts = findComponents(mesh_);
    std::map<int, int> beside;  // component beside the cut → one of its vertices
    for (const Triangle& t : patch) beside.emplace(parts.ofVertex[idx(t[0])], t[0]);
    for (const auto& [component, vertex] : beside)
      if (isMisplaced(mesh_, parts, component)) deletePart(vertex);
  }

  void deletePart(int v) {
    Event event;
    event.kind = EventKind::componentDeleted;
    event.iteration = settings_.iteration;
    event.location = mesh_.position(v);
    deleteComponent(mesh_, v);
    countTopology(event);
    result_.events.push_back(std::move(event));
  }

  //! The numbers before are known from the event before; components are counted anew only if something
  //! changed.
  void countTopology(Event& event) {
    event.before = topology_;
    const int euler = mesh_.vertexCount() - mesh_.faceCount() / 2;
    // A handle between two components, or a deleted torus, changes them and not the Euler number.
    if (euler != topology_.euler || event.kind == EventKind::handleInserted ||
        event.kind == EventKind::componentDeleted)
      topology_ = topologyNumbers(mesh_);
    event.after = topology_;
  }

  //! What closing one opening with caps or a band did is known only when it is done.
  static EventKind kindOfCut(const Event& event) {
    if (event.after.components > event.before.components) return EventKind::split;
    return event.after.genus < event.before.genus ? EventKind::tunnelClosed : EventKind::smoothed;
  }

  Event describe(const CollisionGroup& group, const Plan& plan) const {
    Event event;
    event.kind = plan.kind;
    event.iteration = settings_.iteration;
    event.fronts = plan.fronts;
    event.location = middle(group);
    for (const Opening& o : plan.openings)
      for (const auto& loop : o.loops) event.loopSizes.push_back(static_cast<int>(loop.size()));
    if (settings_.recordTraces) event.trace = traceOf(group, plan);
    return event;
  }

  EventTrace traceOf(const CollisionGroup& group, const Plan& plan) const {
    EventTrace trace;
    const auto face = [&](int f) -> std::array<Vec3, 3> {
      const Triangle& t = mesh_.face(f);
      return {mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2])};
    };
    std::vector<int> colliding;
    for (const auto& [f, g] : group.pairs) colliding.insert(colliding.end(), {f, g});
    std::sort(colliding.begin(), colliding.end());
    colliding.erase(std::unique(colliding.begin(), colliding.end()), colliding.end());
    for (int f : colliding)
      if (mesh_.isFace(f)) trace.collidingFaces.push_back(face(f));
    for (const Opening& o : plan.openings) {
      std::vector<Vec3> lambda;
      for (int v : o.lambda) lambda.push_back(mesh_.position(v));
      trace.lambda.push_back(std::move(lambda));
      for (const auto& loop : o.loops) {
        std::vector<Vec3> polygon;
        for (int v : loop) polygon.push_back(mesh_.position(v));
        trace.boundaryLoops.push_back(std::move(polygon));
      }
      std::vector<int> near = o.lambda;
      for (int ring = 0; ring < 4; ++ring) near = enlarge(mesh_, near);
      std::vector<int> faces;
      for (int v : near) mesh_.forEachOutgoing(v, [&](int h) { faces.push_back(Mesh::faceOf(h)); });
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
      for (int f : faces)
        if (std::none_of(plan.openings.begin(), plan.openings.end(), [f](const Opening& p) {
              return std::binary_search(p.faces.begin(), p.faces.end(), f);
            }))
          trace.openedFaces.push_back(face(f));
    }
    return trace;
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

  void report(const CollisionGroup& group, EventKind kind, std::vector<int> loopSizes) {
    Event event;
    event.kind = kind;
    event.iteration = settings_.iteration;
    event.location = middle(group);
    event.loopSizes = std::move(loopSizes);
    event.before = event.after = topology_;
    result_.events.push_back(std::move(event));
  }

  void giveUp(const CollisionGroup& group, const char* reason) {
    Trouble t{middle(group), 0, reason};
    for (const auto& lambda : group.lambda)
      for (int v : enlarge(mesh_, lambda))
        t.radius = std::max(t.radius, (mesh_.position(v) - t.centre).norm());
    result_.troubles.push_back(t);
  }

  Mesh& mesh_;
  const AdaptationSettings& settings_;
  std::vector<unsigned char>& touched_;
  std::vector<unsigned char> colliding_;  // per face
  std::vector<unsigned char> replaced_;   // per vertex
  TopologyNumbers topology_;              // as after the last event
  AdaptationResult result_;
};

}  // namespace

TopologyNumbers topologyNumbers(const Mesh& mesh) {
  TopologyNumbers n;
  n.components = findComponents(mesh).count();
  n.euler = mesh.vertexCount() - mesh.faceCount() / 2;  // E = 3F / 2 on a closed mesh
  n.genus = (2 * n.components - n.euler) / 2;
  return n;
}

AdaptationResult adaptTopology(Mesh& mesh, std::span<const FacePair> pairs,
                               const AdaptationSettings& settings, std::vector<unsigned char>& touched) {
  return Adaptation(mesh, settings, touched).run(pairs);
}

}  // namespace handlebody
