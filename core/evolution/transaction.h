#pragma once
// A step as a transaction: attempts are made until one leaves a valid mesh, each that does not is taken back
// exactly, and the places that failed are locked before the next.

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "core/evolution/held_changes.h"
#include "core/evolution/step_check.h"

namespace handlebody {

//! What one attempt at a step leaves behind besides the mesh.
struct Attempt {
  std::vector<Event> events;
  std::vector<Conflict> conflicts;  //!< places where nothing fitted: all is taken back, and they are locked
  std::vector<HeldChange> held;     //!< changes that may not happen: all is taken back
  std::vector<int> moving;          //!< vertices that were asked to move
  std::vector<double> distances;    //!< how far, mm
  std::vector<unsigned char> touched;  //!< per vertex: its faces have moved or are new, and were looked at
  std::shared_ptr<const Components> parts;  //!< of the mesh as it is left, where they were looked for in it

  //! True if all that is wrong is what the user asked to be kept back: it is, place by place.
  bool isHeldBack() const {
    return !held.empty() || (!conflicts.empty() && std::all_of(conflicts.begin(), conflicts.end(),
                                                               [](const Conflict& t) { return t.atPin; }));
  }
  bool isKept() const { return conflicts.empty() && held.empty(); }
  //! Where the first thing is that was not kept. Precondition: there is one.
  const Vec3& place() const { return held.empty() ? conflicts[0].centre : held[0].place; }
};

//! Of a transaction: the mesh that it works on, and what its caller does.
struct StepWork {
  Mesh& mesh;
  TopologyNumbers topology;          //!< of the mesh
  double longest = 0;                //!< mm, of an edge of the target length
  double longestAnywhere = 0;        //!< mm, of an edge
  std::function<Attempt()> attempt;  //!< changes the mesh
  //! Of an attempt that has passed its check: what it changed and may not. There the surface is locked from
  //! now on.
  std::function<std::vector<HeldChange>(const Attempt&)> judge;
  std::function<void(const Conflict&)> lockAt;  //!< before the next attempt
};

//! Keeps its memory from step to step.
class Transaction {
 public:
  //! The attempt that was kept. If kAttempts failed (kHeldAttempts while all is held back), the last of them,
  //! with its conflicts or what was held, and the mesh as it was, bit for bit. Every place that failed has
  //! been handed to lockAt. What an attempt or the judge throws passes through; the mesh then is as it was,
  //! too.
  Attempt run(const StepWork& work);
  //! A single attempt: kept, or with its conflicts and the mesh as it was, bit for bit. lockAt is not asked.
  Attempt runOnce(const StepWork& work);
  //! What the step that is being made, or was made last, started from.
  const Mesh& before() const { return before_; }
  //! mm³ enclosed by the mesh that is left.
  double volume() const { return volume_; }

  static constexpr int kAttempts = 8;
  static constexpr int kHeldAttempts = 60;  //!< changes are held back one after the other

 private:
  Attempt tryOnce(const StepWork& work);
  Attempt keptOrNot(const StepWork& work);
  Mesh before_;
  StepCheck check_;
  double volume_ = 0;
};

}  // namespace handlebody
