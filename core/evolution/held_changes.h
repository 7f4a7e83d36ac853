#pragma once
// Changes of topology that are not to happen: those that were vetoed, and those that would break a limit. The
// fronts rest there.

#include <optional>
#include <span>
#include <vector>

#include "core/evolution/constraints.h"
#include "core/surgery/event.h"

namespace handlebody {

//! A change that an attempt at a step made and that may not happen.
struct HeldChange {
  EventKind kind = EventKind::handleInserted;
  Vec3 place{0, 0, 0};  //!< mm
  const char* reason = "";
};

class HeldChanges {
 public:
  //! From after `iteration` on. True if something that was held is free now. Throws UsageError for a veto of
  //! an iteration that is over, unless it has been known in time.
  bool choose(const Constraints& constraints, int iteration);

  //! Which events of an attempt may not happen; around each of them the surface rests from now on.
  //! Precondition: the attempt would be accepted otherwise. Throws UsageError if a veto of this iteration
  //! finds no change. `longest`: mm, of the mesh's edges.
  std::vector<HeldChange> judge(std::span<const Event> events, int iteration, double longest);

  //! True where the surface rests for good.
  bool rests(const Vec3& p) const;
  bool any() const { return !places_.empty(); }
  //! The first veto whose iteration has not come yet.
  std::optional<Veto> waiting() const;

 private:
  struct Place {
    Vec3 centre;
    double radius;             // mm
    std::optional<Veto> veto;  // none: for the limits
  };
  const Place* vetoedNear(const Event& event, double longest) const;
  bool breaksLimit(const Event& event) const;
  HeldChange hold(const Event& event, const std::optional<Veto>& veto, double longest);

  Constraints asked_;  // without walls
  std::vector<Veto> met_;
  std::vector<Place> places_;
};

//! True if a kind of event changes the topology.
bool changesTopology(EventKind kind);

}  // namespace handlebody
