#include "core/evolution/held_changes.h"

#include <algorithm>
#include <string>

#include "core/errors.h"

namespace handlebody {

namespace {

// Longest edges: radius within which fronts rest, and by how much it grows where they meet all the same. Two
// fronts that meet in a step were at most 0.4 of one apart (kStep of both).
constexpr double kSmallest = 0.75;
constexpr double kGrowth = 0.25;
// Fronts that rest in their middle would meet beside it: within so many longest edges of a place that rests
// it is the same change.
constexpr double kSameChange = 2;

bool contains(const std::vector<Veto>& list, const Veto& veto) {
  return std::find(list.begin(), list.end(), veto) != list.end();
}

}  // namespace

bool changesTopology(EventKind kind) { return kind != EventKind::smoothed && kind != EventKind::rolledBack; }

bool HeldChanges::choose(const Constraints& constraints, int iteration) {
  for (const Veto& v : constraints.vetoes)
    if (v.iteration <= iteration && !contains(met_, v))
      throw UsageError("The veto of iteration " + std::to_string(v.iteration) +
                       " comes too late: the surface is at iteration " + std::to_string(iteration) + ".");
  const std::size_t before = places_.size();
  const bool sameLimits = constraints.topology == asked_.topology;
  std::erase_if(
      places_, [&](const Place& p) { return p.veto ? !contains(constraints.vetoes, *p.veto) : !sameLimits; });
  std::erase_if(met_, [&](const Veto& v) { return !contains(constraints.vetoes, v); });
  asked_ = {{}, constraints.vetoes, constraints.topology};
  return places_.size() < before;
}

const HeldChanges::Place* HeldChanges::vetoedNear(const Event& event, double longest) const {
  const auto at = std::find_if(places_.begin(), places_.end(), [&](const Place& p) {
    return p.veto && (p.centre - event.location).norm() < p.radius + kSameChange * longest;
  });
  return at == places_.end() ? nullptr : &*at;
}

bool HeldChanges::breaksLimit(const Event& e) const {
  const TopologyLimits& limits = asked_.topology;
  const bool components = limits.components && e.after.components > *limits.components &&
                          e.after.components > e.before.components;
  const bool genus = limits.genus && e.after.genus > *limits.genus && e.after.genus > e.before.genus;
  return components || genus;
}

//! A new place, or, in the middle of one that did not suffice, that one made larger: so everything near
//! rests in the end.
HeldChange HeldChanges::hold(const Event& event, const std::optional<Veto>& veto, double longest) {
  const auto known = std::find_if(places_.begin(), places_.end(), [&](const Place& p) {
    return p.veto == veto && (p.centre - event.location).norm() < kSmallest / 2 * longest;
  });
  if (known != places_.end())
    known->radius += kGrowth * longest;
  else
    places_.push_back({event.location, kSmallest * longest, veto});
  return {event.kind, event.location,
          veto ? "kept apart here, as asked" : "held: it would break the limit of the topology"};
}

std::vector<HeldChange> HeldChanges::judge(std::span<const Event> events, int iteration, double longest) {
  std::vector<HeldChange> held;
  // What an attempt makes and undoes again breaks no limit.
  const TopologyNumbers last = events.empty() ? TopologyNumbers{} : events.back().after;
  const TopologyLimits& limits = asked_.topology;
  const bool isOver = (limits.components && last.components > *limits.components) ||
                      (limits.genus && last.genus > *limits.genus);
  for (const Event& e : events) {
    if (!changesTopology(e.kind)) continue;
    const Place* near = vetoedNear(e, longest);
    if (near)
      held.push_back(hold(e, std::optional<Veto>(near->veto), longest));
    else if (isOver && breaksLimit(e))
      held.push_back(hold(e, std::nullopt, longest));
  }
  if (!held.empty()) return held;
  // One at a time, in the order in which they were asked for: each was chosen in what the others left.
  const auto veto = std::find_if(asked_.vetoes.begin(), asked_.vetoes.end(), [&](const Veto& v) {
    return v.iteration == iteration && !contains(met_, v);
  });
  if (veto == asked_.vetoes.end()) return held;
  const Event* nearest = nullptr;
  for (const Event& e : events)
    if (changesTopology(e.kind) && (!nearest || (e.location - veto->place).squaredNorm() <
                                                    (nearest->location - veto->place).squaredNorm()))
      nearest = &e;
  if (!nearest)
    throw UsageError("The veto of iteration " + std::to_string(iteration) +
                     " has nothing to forbid: no change of topology happens there.");
  met_.push_back(*veto);
  held.push_back(hold(*nearest, *veto, longest));
  return held;
}

bool HeldChanges::rests(const Vec3& p) const {
  return std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
    return (p - place.centre).squaredNorm() < place.radius * place.radius;
  });
}

std::optional<Veto> HeldChanges::waiting() const {
  for (const Veto& v : asked_.vetoes)
    if (!contains(met_, v)) return v;
  return std::nullopt;
}

}  // namespace handlebody
