#pragma once
// The growth of a contour as it was recorded: any iteration can be shown again exactly, and gone on from with
// other clicks and parameters.

#include <map>
#include <vector>

#include "core/evolution/keyframe.h"

namespace handlebody {

//! What a history may cost.
struct HistoryLimits {
  std::size_t memory = std::size_t{400} << 20;  //!< bytes of all keyframes together
  //! Computing time between two keyframes, seconds: about what going back takes at most. Doubled when the
  //! memory would not suffice.
  double redoSeconds = 0.07;
};

//! Keeps a copy of the contour (a keyframe) every few iterations; an iteration between two of them is the
//! earlier one with the steps after it done again, which gives the same mesh bit for bit. One thread at a
//! time.
class History {
 public:
  //! Begins with what `start` is now, which need not be iteration 0.
  explicit History(ActiveContour start, const HistoryLimits& limits = {});

  //! The contour of the iteration that is shown: at first that of `start`.
  const ActiveContour& shown() const { return shown_; }
  int iteration() const { return shown_.iteration(); }
  int firstIteration() const { return steps_.front().iteration; }
  int lastIteration() const { return steps_.back().iteration; }
  //! Why the growth cannot go on from the iteration that is shown; running if it can.
  StopReason stopReason() const;
  //! What the next step from here is done with.
  const Parameters& parameters() const { return next().requested(); }
  const std::vector<Seed>& seeds() const { return next().requestedSeeds(); }
  const Constraints& constraints() const { return next().constraints(); }
  const ResolvedParameters& resolved() const { return next().parameters(); }

  //! One iteration on: records it, or shows it again where it is recorded. Precondition: stopReason() is
  //! running. If the step throws (no memory), the shown iteration stays.
  void advance();
  //! Shows any iteration from firstIteration() to lastIteration().
  void goTo(int iteration);
  //! Other clicks and parameters from the shown iteration on: what was recorded after it is dropped. Nothing
  //! happens if they are those that hold already (the number of threads does not count). Throws as
  //! ActiveContour::change; nothing has changed then. `prepared`, if given, is a contour of the same volume,
  //! and spares choosing the image again if it was made from `request`.
  void change(const Request& request, const ActiveContour* prepared = nullptr);
  //! The clicks and constraints stay those that hold at the shown iteration.
  void changeParameters(const Parameters& parameters) { change({seeds(), parameters, constraints()}); }

  //! The last iteration up to the shown one at which the surface neither touches nor encloses any of the
  //! walls that would be new now; none if there is none. Costs at most what all steps up to here did.
  std::optional<int> lastFree(const WallList& walls) const;
  //! The last iteration at which the disc that closes the passage was free; the one before the leak if there
  //! is none.
  int lastBefore(const Leak& leak) const;

  //! One per iteration from the first on, without events; the first has the volume alone.
  const std::vector<StepReport>& steps() const { return steps_; }
  //! Of all iterations, in order, without traces.
  const std::vector<Event>& events() const { return events_; }
  //! In order; at most one per iteration.
  std::vector<ParameterChange> changes() const;
  //! What came of those changes that were of the clicks, in order.
  std::vector<RecordedCorrection> corrections() const;
  //! The events of a recorded iteration with their traces: the step is done again. Precondition: it lies
  //! after the first.
  std::vector<Event> traced(int iteration) const;

  //! Bytes that the keyframes take; the image, which all share, is not counted.
  std::size_t memory() const { return memory_; }
  std::size_t keyframes() const { return keyframes_.size() + changes_.size(); }

 private:
  struct Change {
    ParameterChange what;
    ActiveContour after;  // as the change left it, before the next step
  };
  const Change* changeAt(int iteration) const;
  //! What the next step is done with.
  const ActiveContour& next() const;
  StepReport stepFrom(ActiveContour& contour) const;
  ActiveContour restored(int iteration) const;
  void record(StepReport report);
  void keep(const ActiveContour& contour);
  void thinOut();
  void dropAfter(int iteration);
  void countMemory();

  HistoryLimits limits_;
  ActiveContour shown_;
  std::map<int, Keyframe> keyframes_;  // before the change of their iteration
  std::vector<Change> changes_;
  std::vector<StepReport> steps_;
  std::vector<Event> events_;
  double sinceKeyframe_ = 0;  // seconds
  std::size_t memory_ = 0;
};

}  // namespace handlebody
