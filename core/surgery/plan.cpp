#include "core/surgery/plan.h"

#include <algorithm>

#include "core/surgery/handle_fitting.h"

namespace handlebody {

namespace {

// Vertices of a loop. Closing one opening, or joining more than two, takes the cube of this; joining two the
// square, so that fronts that meet flat over a wide area are joined along its rim.
constexpr std::size_t kLongestLoop = 120;
constexpr std::size_t kLongestOfTwo = 400;
// A cap with a middle makes a vertex of as many faces as its loop has vertices. Of several loops, one of them
// longer than this, caps without are tried first: docs/surgery.md.
constexpr std::size_t kWidestFan = 40;

constexpr std::size_t kCapWork = 1;  // for the cube of a loop

using Loops = std::vector<std::vector<int>>;

Vec3 centre(const Mesh& mesh, const std::vector<int>& loop) {
  Vec3 sum(0, 0, 0);
  for (const int v : loop) sum += mesh.position(v);
  return sum / static_cast<double>(loop.size());
}

Vec3 meanNormal(const Mesh& mesh, const Opening& o) {
  Vec3 sum(0, 0, 0);
  for (const int f : o.faces) sum += mesh.areaVector(f);
  return sum.normalized();
}

//! The next combination of one polygon of each opening; false after the last.
bool nextChoice(std::span<const Opening> openings, std::vector<std::size_t>& chosen) {
  for (std::size_t i = chosen.size(); i-- > 0;) {
    if (++chosen[i] < openings[i].loops.size()) return true;
    chosen[i] = 0;
  }
  return false;
}

bool isTooLarge(const Opening& o, std::size_t longest) {
  return std::any_of(o.loops.begin(), o.loops.end(),
                     [longest](const std::vector<int>& loop) { return loop.size() > longest; });
}

//! A way to close one opening, and what it costs.
struct ClosingChoice {
  Patch patch;
  EventKind kind = EventKind::smoothed;
  std::vector<int> joined{};  // as in the plan
  HandleSource handleFrom = HandleSource::none;
  double area = 0;  // mm²
  bool shrinks = false;
  bool isWideFan = false;  // see kWidestFan
};

HandleSource sourceOf(const FittingHandle& handle) {
  return handle.isListed ? HandleSource::database : HandleSource::search;
}

std::vector<int> oneOfEach(const Loops& loops) {
  std::vector<int> out;
  for (const auto& loop : loops) out.push_back(loop[0]);
  return out;
}

class Planner {
 public:
  Planner(const Mesh& mesh, const FaceBlocks& blocks, Plan& plan, const PlanSettings& settings,
          FindingKind& reason)
      : mesh_(mesh),
        plan_(plan),
        settings_(settings),
        reason_(reason),
        surroundings_(mesh, blocks, plan.openings, settings.colliding, settings.forbidden) {}
  bool joinFronts(std::span<const Opening> openings);
  bool closeOne(const Opening& opening);
  //! Where the openings are whole components.
  bool deleteAll();

 private:
  bool meetOutside(std::span<const Opening> openings, const Loops& loops) const;
  bool isSpent() const { return settings_.work && settings_.work->isSpent(); }
  Patch capsBut(std::span<const Opening> openings, const std::vector<std::size_t>& chosen) const;
  std::vector<ClosingChoice> capsFor(const Opening& opening) const;

  const Mesh& mesh_;
  Plan& plan_;
  const PlanSettings& settings_;
  FindingKind& reason_;
  Surroundings surroundings_;
};

//! A handle between one polygon of each opening, caps on all others (parts enclosed by Λ).
bool Planner::joinFronts(std::span<const Opening> openings) {
  bool inward = false;
  bool tried = false;
  FittingHandle best;
  std::vector<std::size_t> chosen(openings.size(), 0);
  do {
    Loops loops;
    for (std::size_t i = 0; i < chosen.size(); ++i) loops.push_back(openings[i].loops[chosen[i]]);
    if (settings_.outwardOnly && !meetOutside(openings, loops)) {
      inward = true;
      continue;
    }
    tried = true;
    FittingHandle handle = shortestFittingHandle(mesh_, plan_.openings, loops, capsBut(openings, chosen),
                                                 surroundings_, settings_.work);
    const bool better = !best.found || handle.patch.length < best.patch.length;
    if (!handle.found || !better) continue;
    best = std::move(handle);
    plan_.joined = oneOfEach(loops);
  } while (!isSpent() && nextChoice(openings, chosen));
  if (best.found) {
    plan_.patch = std::move(best.patch);
    plan_.kind = EventKind::handleInserted;
    plan_.shortest = best.shortest;
    plan_.handleFrom = sourceOf(best);
    plan_.fronts = static_cast<int>(openings.size());
    return true;
  }
  reason_ = inward && !tried ? FindingKind::meetInside : FindingKind::noHandle;
  return false;
}

Patch Planner::capsBut(std::span<const Opening> openings, const std::vector<std::size_t>& chosen) const {
  Patch caps;
  caps.firstNew = mesh_.vertexSlots();
  for (std::size_t i = 0; i < chosen.size(); ++i)
    for (std::size_t l = 0; l < openings[i].loops.size(); ++l)
      if (l != chosen[i]) caps.append(fanCap(mesh_, openings[i].loops[l]));
  return caps;
}

//! True if the fronts face each other across outside space: two if their normals together point at each
//! other's polygon, several if the normal of each points to the middle of all.
bool Planner::meetOutside(std::span<const Opening> openings, const Loops& loops) const {
  Vec3 middle(0, 0, 0);
  for (const auto& loop : loops) middle += centre(mesh_, loop) / static_cast<double>(loops.size());
  double sum = 0;
  double least = 1e300;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const double ahead = meanNormal(mesh_, openings[i]).dot(middle - centre(mesh_, loops[i]));
    sum += ahead;
    least = std::min(least, ahead);
  }
  return loops.size() == 2 ? sum > 0 : least > 0;
}

//! One set: a patch if it is a disc; caps (a cut) or a band if it has several polygons, whichever is
//! smaller. Where only outward motion is allowed, what takes volume away comes last: a narrow neck of outside
//! space is cut by caps, the crease around a handle that has just been made is not.
bool Planner::closeOne(const Opening& opening) {
  const bool disc = opening.loops.size() == 1;
  const std::span<const Opening> one(&opening, 1);
  std::vector<ClosingChoice> choices = capsFor(opening);
  if (opening.loops.size() == 2) {
    Patch noCaps;
    noCaps.firstNew = mesh_.vertexSlots();
    FittingHandle band =
        shortestFittingHandle(mesh_, one, opening.loops, noCaps, surroundings_, settings_.work);
    if (band.found)
      choices.push_back(
          {std::move(band.patch), EventKind::smoothed, oneOfEach(opening.loops), sourceOf(band)});
  }
  for (ClosingChoice& c : choices) {
    c.area = area(mesh_, c.patch);
    c.shrinks = settings_.outwardOnly && volumeGain(mesh_, one, c.patch) < 0;
  }
  if (!disc)
    std::stable_sort(choices.begin(), choices.end(), [](const ClosingChoice& a, const ClosingChoice& b) {
      if (a.shrinks != b.shrinks) return b.shrinks;
      return a.isWideFan != b.isWideFan ? b.isWideFan : a.area < b.area;
    });
  for (ClosingChoice& c : choices)
    if (surroundings_.fits(c.patch) && !surroundings_.sweepsOver(c.patch)) {
      plan_.patch = std::move(c.patch);
      plan_.kind = c.kind;
      plan_.joined = std::move(c.joined);
      plan_.handleFrom = c.handleFrom;
      return true;
    }
  reason_ = FindingKind::noPatch;
  return false;
}

//! Caps on every polygon: with barycentres, and of least area. Whether caps on several polygons split the
//! mesh or close a tunnel is known only when it is done.
std::vector<ClosingChoice> Planner::capsFor(const Opening& opening) const {
  const EventKind kind = opening.loops.size() == 1 ? EventKind::smoothed : EventKind::split;
  Patch fans, flats;
  fans.firstNew = flats.firstNew = mesh_.vertexSlots();
  bool flat = true;
  for (const auto& loop : opening.loops) {
    fans.append(fanCap(mesh_, loop));
    if (settings_.work) settings_.work->spend(kCapWork * loop.size() * loop.size() * loop.size());
    const auto cap = leastAreaCap(mesh_, opening, loop);
    flat = flat && cap;
    if (flat) flats.append(*cap);
  }
  std::vector<ClosingChoice> choices;
  choices.push_back({std::move(fans), kind});
  choices.back().isWideFan = isTooLarge(opening, kWidestFan);
  if (flat) choices.push_back({std::move(flats), kind});
  return choices;
}

bool Planner::deleteAll() {
  plan_.kind = EventKind::componentDeleted;
  if (!surroundings_.sweepsOver(plan_.patch)) return true;
  reason_ = FindingKind::enclosesForbidden;
  return false;
}

//! Looks for what closes the openings of the plan.
bool closeAll(const Mesh& mesh, const FaceBlocks& blocks, Plan& plan, const PlanSettings& settings,
              FindingKind& reason) {
  // Whole components in Λ come first: they have no boundary.
  const auto open = std::stable_partition(plan.openings.begin(), plan.openings.end(),
                                          [](const Opening& o) { return o.loops.empty(); });
  const std::span<const Opening> opened(open, plan.openings.end());
  const std::size_t longest = opened.size() == 2 ? kLongestOfTwo : kLongestLoop;
  if (std::any_of(opened.begin(), opened.end(), [&](const Opening& o) { return isTooLarge(o, longest); })) {
    reason = FindingKind::openingTooLarge;
    return false;
  }
  plan.patch.firstNew = mesh.vertexSlots();
  Planner planner(mesh, blocks, plan, settings, reason);
  if (opened.empty()) return planner.deleteAll();
  return opened.size() == 1 ? planner.closeOne(opened[0]) : planner.joinFronts(opened);
}

}  // namespace

std::optional<Plan> planFor(Mesh& mesh, FaceBlocks& blocks, const std::vector<std::vector<int>>& sets,
                            const PlanSettings& settings, FindingKind& reason) {
  Plan plan;
  // Refinement that led to nothing would make the next try refine what has been refined: after a few rings
  // faces a millionth of a millimetre thin.
  std::optional<Mesh> unrefined;
  for (const auto& lambda : sets) {
    std::optional<Opening> opening = planOpening(mesh, lambda);
    if (!opening) {
      if (!unrefined) unrefined = mesh;
      opening = openWithRefinement(mesh, lambda);
      // An edge is split between a vertex of Λ and a neighbour: the new faces have the new vertex.
      blocks.includeAround(mesh, enlarge(mesh, lambda));
    }
    plan.openings.push_back(*std::move(opening));
  }
  const bool isPinned = std::any_of(plan.openings.begin(), plan.openings.end(), [&](const Opening& o) {
    return settings.forbidden.isAnyPinned(o.lambda);
  });
  if (isPinned) reason = FindingKind::pinnedThere;
  if (!isPinned && closeAll(mesh, blocks, plan, settings, reason)) return plan;
  if (unrefined) mesh = *std::move(unrefined);
  return std::nullopt;
}

}  // namespace handlebody
