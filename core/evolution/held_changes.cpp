#include "core/evolution/held_changes.h"

#include <algorithm>
#include <numeric>

#include "core/told_error.h"

namespace handlebody {

namespace {

// Longest edges: radius within which fronts are locked, and by how much it grows where they meet all the
// same. Two fronts that meet in a step were at most 0.4 of one apart (kStep of both).
constexpr double kSmallest = 0.75;
constexpr double kGrowth = 0.25;
// Fronts that are locked in their middle would meet beside it: within so many longest edges of a place that
// is locked it is the same change.
constexpr double kSameChange = 2.75;

bool contains(const std::vector<Veto>& list, const Veto& veto) {
  return std::find(list.begin(), list.end(), veto) != list.end();
}

}  // namespace

Finding findingOf(const HeldPlace& held) {
  const auto place = placeValue(held.place);
  const HeldSize& s = held.size;
  if (s.part > 0)
    return {s.isCavity ? FindingKind::wouldEnclose : FindingKind::wouldComeOff,
            {{"ml", s.part / 1000}, {"place", place}}};
  if (held.kind != EventKind::handleInserted)
    return {FindingKind::wouldChange, {{"event", std::string(eventKindName(held.kind))}, {"place", place}}};
  if (s.tunnel > 0) return {FindingKind::wouldMakeTunnel, {{"place", place}, {"around_mm", s.tunnel}}};
  return {FindingKind::frontsWouldMeet, {{"place", place}}};
}

bool HeldChanges::choose(const Constraints& constraints, int iteration) {
  for (const Veto& v : constraints.vetoes)
    if (v.iteration <= iteration && !contains(met_, v))
      throw Told<UsageError>(
          Finding(FindingKind::vetoTooLate, {{"iteration", v.iteration}, {"now", iteration}}));
  const std::size_t before = places_.size();
  const TopologyLimits &old = asked_.topology, &limits = constraints.topology;
  const bool sameLimits = limits.components == old.components && limits.genus == old.genus;
  std::erase_if(
      places_, [&](const Place& p) { return p.veto ? !contains(constraints.vetoes, *p.veto) : !sameLimits; });
  std::erase_if(met_, [&](const Veto& v) { return !contains(constraints.vetoes, v); });
  if (limits.allowed != old.allowed) freed_.clear();
  for (const Vec3& p : limits.allowed) free(p);
  asked_ = {{}, constraints.vetoes, limits};
  return places_.size() < before;
}

//! For each place the first one that hangs together with it, over others or directly, for the same reason.
std::vector<std::size_t> HeldChanges::groups() const {
  std::vector<std::size_t> group(places_.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (std::size_t i = 0; i < places_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Place &a = places_[i], &b = places_[j];
      if (group[i] == group[j] || a.veto != b.veto ||
          (a.centre - b.centre).norm() >= std::max(a.reach, b.reach))
        continue;
      const auto [low, high] = std::minmax(group[i], group[j]);
      std::replace(group.begin(), group.end(), std::size_t{high}, std::size_t{low});
    }
  return group;
}

//! What is held for the limits at that place goes on.
void HeldChanges::free(const Vec3& allowed) {
  const std::vector<std::size_t> group = groups();
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (!places_[i].veto && (places_[i].centre - allowed).norm() < places_[i].reach) free.push_back(group[i]);
  if (!free.empty()) used_.push_back(allowed);
  std::vector<Place> left;
  for (std::size_t i = 0; i < places_.size(); ++i)
    (std::find(free.begin(), free.end(), group[i]) == free.end() ? left : freed_).push_back(places_[i]);
  places_ = std::move(left);
}

const HeldChanges::Place* HeldChanges::vetoedNear(const Event& event) const {
  const auto at =
      std::find_if(places_.begin(), places_.end(), [&](const Place& p) { return p.veto && p.holds(event); });
  return at == places_.end() ? nullptr : &*at;
}

bool HeldChanges::mayBreakLimits(const Event& event, double longest) {
  for (const Vec3& p : asked_.topology.allowed)
    if ((p - event.location).norm() < kSameChange * longest) {
      used_.push_back(p);
      return true;
    }
  return std::any_of(freed_.begin(), freed_.end(), [&](const Place& p) { return p.holds(event); });
}

//! Of a whole attempt: what it makes and undoes again breaks no limit.
bool HeldChanges::isOverLimits(const TopologyNumbers& before, const TopologyNumbers& after) const {
  const TopologyLimits& limits = asked_.topology;
  if (holdsTopology_ && (after.components != before.components || after.genus != before.genus)) return true;
  return (limits.components && after.components > std::max(*limits.components, before.components)) ||
         (limits.genus && after.genus > std::max(*limits.genus, before.genus));
}

bool HeldChanges::breaksLimit(const Event& e) const {
  if (holdsTopology_) return e.after.components != e.before.components || e.after.genus != e.before.genus;
  const TopologyLimits& limits = asked_.topology;
  const bool components = limits.components && e.after.components > *limits.components &&
                          e.after.components > e.before.components;
  const bool genus = limits.genus && e.after.genus > *limits.genus && e.after.genus > e.before.genus;
  return components || genus;
}

//! A new place, or, in the middle of one that did not suffice, that one made larger: so everything near is
//! locked in the end.
HeldChange HeldChanges::hold(const Event& event, const std::optional<Veto>& veto, double longest,
                             const Measure& measure) {
  const auto known = std::find_if(places_.begin(), places_.end(), [&](const Place& p) {
    return p.veto == veto && (p.centre - event.location).norm() < kSmallest / 2 * longest;
  });
  if (known != places_.end()) {
    known->radius += kGrowth * longest;
    known->reach += kGrowth * longest;
    ++known->told.times;
  } else {
    const bool isFirst = std::none_of(places_.begin(), places_.end(),
                                      [&](const Place& p) { return p.veto == veto && p.holds(event); });
    const HeldSize size = measure && isFirst ? measure(event) : HeldSize();
    const HeldPlace told{event.kind, event.iteration, event.location, veto.has_value(), 1, size};
    places_.push_back({event.location, kSmallest * longest, kSameChange * longest, veto, told});
  }
  return {event.kind, event.location, veto ? FindingKind::keptApart : FindingKind::overLimit};
}

void HeldChanges::holdForLimits(std::span<const Event> events, double longest, const Measure& measure,
                                std::vector<HeldChange>& held) {
  if (!isOverLimits(events.front().before, events.back().after)) return;
  for (const Event& e : events)
    if (changesTopology(e.kind) && breaksLimit(e) && !mayBreakLimits(e, longest))
      held.push_back(hold(e, std::nullopt, longest, measure));
}

std::vector<HeldChange> HeldChanges::judge(std::span<const Event> events, int iteration, double longest,
                                           const Measure& measure) {
  std::vector<HeldChange> held;
  if (asked_.empty() && !holdsTopology_) return held;
  for (const Event& e : events) {
    const Place* near = changesTopology(e.kind) ? vetoedNear(e) : nullptr;
    if (near) held.push_back(hold(e, std::optional<Veto>(near->veto), longest));
  }
  if (held.empty() && !events.empty()) holdForLimits(events, longest, measure, held);
  if (!held.empty()) return held;
  // One at a time, in the order in which they were asked for: each was chosen in what the others left.
  const auto veto = std::find_if(asked_.vetoes.begin(), asked_.vetoes.end(), [&](const Veto& v) {
    return v.iteration == iteration && !contains(met_, v);
  });
  if (veto == asked_.vetoes.end()) return held;
  const Event* met = metByVeto(events, *veto);
  if (!met) throw Told<UsageError>(Finding(FindingKind::vetoFindsNothing, {{"iteration", iteration}}));
  met_.push_back(*veto);
  held.push_back(hold(*met, *veto, longest));
  return held;
}

//! The nearest change of topology; null if there is none.
const Event* HeldChanges::metByVeto(std::span<const Event> events, const Veto& veto) const {
  const Event* nearest = nullptr;
  for (const Event& e : events)
    if (changesTopology(e.kind) && (!nearest || (e.location - veto.place).squaredNorm() <
                                                    (nearest->location - veto.place).squaredNorm()))
      nearest = &e;
  return nearest;
}

bool HeldChanges::isLocked(const Vec3& p) const {
  return std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
    return (p - place.centre).squaredNorm() < place.radius * place.radius;
  });
}

std::vector<HeldPlace> HeldChanges::list() const {
  std::vector<HeldPlace> out;
  const std::vector<std::size_t> group = groups();
  std::vector<std::size_t> row(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (group[i] == i) {
      row[i] = out.size();
      out.push_back(places_[i].told);
    } else {
      out[row[group[i]]].times += places_[i].told.times;
    }
    if (isDecided(places_[i])) out[row[group[i]]].isDecided = true;
  }
  return out;
}

bool HeldChanges::isDecided(const Place& place) const {
  const std::vector<Vec3>& kept = asked_.topology.kept;
  return !place.veto && std::any_of(kept.begin(), kept.end(),
                                    [&](const Vec3& p) { return (place.centre - p).norm() < place.reach; });
}

std::vector<HeldPlace> HeldChanges::questions(int iteration) const {
  const bool isAny = asked_.topology.asks && std::any_of(places_.begin(), places_.end(), [&](const Place& p) {
                       return p.told.iteration == iteration;
                     });
  if (!isAny) return {};
  std::vector<HeldPlace> all = list();
  std::erase_if(all,
                [&](const HeldPlace& h) { return h.isVetoed || h.isDecided || h.iteration != iteration; });
  return all;
}

std::vector<Finding> HeldChanges::warnings() const {
  std::vector<Finding> warnings;
  for (const Vec3& p : asked_.topology.allowed)
    if (std::find(used_.begin(), used_.end(), p) == used_.end())
      warnings.push_back({FindingKind::nothingAllowed, {{"place", placeValue(p)}}});
  return warnings;
}

std::optional<Veto> HeldChanges::waiting() const {
  for (const Veto& v : asked_.vetoes)
    if (!contains(met_, v)) return v;
  return std::nullopt;
}

}  // namespace handlebody
