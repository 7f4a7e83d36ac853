#pragma once
// When a contour stops, and why.

#include <functional>
#include <optional>

#include "core/evolution/convergence.h"
#include "core/evolution/locked_regions.h"
#include "core/evolution/motion.h"
#include "core/evolution/step_report.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! What a contour is when it is decided whether it goes on.
struct StopFacts {
  int iteration = 0;      //!< of the last step
  int maxIterations = 0;  //!< after which it stops
  int vertices = 0;       //!< of the mesh
  int faces = 0;          //!< the same
  bool isGiven = false;   //!< it is a surface that was given, and nothing grows
  //! Of the first edit that has not been made.
  std::optional<int> nextEdit{};
};

//! What the last step did.
struct StepStir {
  bool isEdit = false;
  bool isUneventful = false;  //!< nothing happened in it, and no locked region will unlock
  int movedVertices = 0;      //!< by more than kUnmoved
};

//! Owned by the contour and copied with it. An edit that steps come to keeps it going, whatever else there
//! is, as long as there is a surface.
class StopDecision {
 public:
  //! StopReason::running while steps are to be made.
  StopReason reason() const { return reason_; }
  //! Before the first step.
  void begin(const StopFacts& facts);
  //! After other clicks, parameters or constraints; `activates`: they may move what does not move now.
  void change(const StopFacts& facts, bool activates);
  //! After a step. `whyAtRest` is asked if the surface has come to rest (see reasonOfRest).
  void afterStep(const StopFacts& facts, const StepStir& stir, const std::function<StopReason()>& whyAtRest);
  //! Rest is counted from here on.
  void forgetLocks() { convergence_ = {}; }

 private:
  void applyGivenAndEdit(const StopFacts& facts);

  Convergence convergence_;
  StopReason reason_ = StopReason::running;
};

//! Why nothing moves: of its own accord (converged), or because all of it (stuck) or some of it (frozen)
//! rests for good and would move if it did not.
StopReason reasonOfRest(const Mesh& mesh, const ObjectImage& image, const MotionSettings& motion,
                        const LockedRegions& lockedRegions, int iteration);

}  // namespace handlebody
