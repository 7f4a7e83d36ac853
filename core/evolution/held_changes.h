#pragma once
// Changes of topology that are not to happen: those that were vetoed, and those that would break a limit. The
// fronts are locked there.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/evolution/constraints.h"
#include "core/evolution/held_size.h"
#include "core/finding.h"
#include "core/surgery/event.h"

namespace handlebody {

//! A change that an attempt at a step made and that may not happen.
struct HeldChange {
  EventKind kind = EventKind::handleInserted;
  Vec3 place{0, 0, 0};  //!< mm
  FindingKind reason = FindingKind::none;
};

//! Where fronts are kept from a change now: one for all places that hang together.
struct HeldPlace {
  EventKind kind = EventKind::handleInserted;  //!< of the first change that was held there
  int iteration = 0;                           //!< the same
  Vec3 place{0, 0, 0};                         //!< mm; the same
  bool isVetoed = false;                       //!< false: for a limit
  int times = 0;                               //!< how often a change was held there
  HeldSize size{};                             //!< of the first; nothing is measured for a veto
  bool isDecided = false;                      //!< somebody has answered that it is held
  bool operator==(const HeldPlace&) const = default;
};

//! What the held change would do: wouldEnclose, wouldComeOff, frontsWouldMeet, wouldMakeTunnel or
//! wouldChange.
Finding findingOf(const HeldPlace& held);
inline std::string sentence(const HeldPlace& held) { return sentence(findingOf(held)); }

class HeldChanges {
 public:
  //! From after `iteration` on. True if something that was held is free now. Throws UsageError for a veto of
  //! an iteration that is over, unless it has been known in time.
  bool choose(const Constraints& constraints, int iteration);

  //! No change of topology at all may happen from now on, or all that nothing else forbids.
  void holdTopology(bool on) { holdsTopology_ = on; }

  //! Which events of an attempt may not happen; around each of them the surface is locked from now on.
  //! Precondition: the attempt would be accepted otherwise. Throws UsageError if a veto of this iteration
  //! finds no change. `longest`: mm, of the mesh's edges. `measure`: tells how large that is which a limit
  //! holds, asked for the first of what hangs together; empty: it is not known.
  std::vector<HeldChange> judge(std::span<const Event> events, int iteration, double longest,
                                const std::function<HeldSize(const Event&)>& measure = {});

  //! True where the surface is locked for good.
  bool isLocked(const Vec3& p) const;
  //! In the order in which they came.
  std::vector<HeldPlace> list() const;
  //! Of the list what a limit has held since this iteration's step and nobody has answered yet; none unless
  //! the limits ask.
  std::vector<HeldPlace> questions(int iteration) const;
  //! Allowed places at which nothing has come that a limit would have held.
  std::vector<Finding> warnings() const;
  //! The first veto whose iteration has not come yet.
  std::optional<Veto> waiting() const;

 private:
  struct Place {
    Vec3 centre;
    double radius;             // mm, within which the surface is locked
    double reach;              // mm, within which it is the same change
    std::optional<Veto> veto;  // none: for the limits
    HeldPlace told;
    bool holds(const Event& e) const { return (centre - e.location).norm() < reach; }
  };
  std::vector<std::size_t> groups() const;
  void free(const Vec3& allowed);
  const Place* vetoedNear(const Event& event) const;
  bool mayBreakLimits(const Event& event, double longest);
  bool isOverLimits(const TopologyNumbers& before, const TopologyNumbers& after) const;
  bool breaksLimit(const Event& event) const;
  using Measure = std::function<HeldSize(const Event&)>;
  void holdForLimits(std::span<const Event> events, double longest, const Measure& measure,
                     std::vector<HeldChange>& held);
  HeldChange hold(const Event& event, const std::optional<Veto>& veto, double longest,
                  const Measure& measure = {});
  bool isDecided(const Place& place) const;
  const Event* metByVeto(std::span<const Event> events, const Veto& veto) const;

  Constraints asked_;  // without walls
  bool holdsTopology_ = false;
  std::vector<Veto> met_;
  std::vector<Place> places_;
  std::vector<Place> freed_;  // where they were allowed to go on
  std::vector<Vec3> used_;    // of the allowed places
};

}  // namespace handlebody
