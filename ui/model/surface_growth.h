#pragma once
// The growth as the GUI thread knows it: what the worker last handed over, and what was asked of it since.

#include <QObject>
#include <functional>

#include "ui/model/growth_worker.h"

namespace handlebody::ui {

class SurfaceGrowth {
 public:
  //! All are called on the thread of `context`.
  struct Listener {
    std::function<void()> stateChanged;
    std::function<void()> snapshotChanged;
    std::function<void()> summariesChanged;
    std::function<void(int, const EventTrace&)> traced;
    std::function<void(int)> leaked;
    std::function<void()> asked;
  };
  SurfaceGrowth(QObject* context, Listener listener);

  //! A new growth from what was prepared, at rest; with `replay`, on its way as recorded.
  void start(std::shared_ptr<const ActiveContour> contour, const std::optional<Replay>& replay);
  void clear();
  bool exists() const { return start_ != nullptr; }
  //! As it was before the first step. Precondition: exists().
  const ActiveContour& beginning() const { return *start_; }

  void run(const Request& request, PreparedContour prepared = {});
  void step(const Request& request, PreparedContour prepared = {});
  void runToEvent(const Request& request, PreparedContour prepared = {});
  //! Goes on with a replay that was paused.
  void replay(const Replay& replay);
  void pause();
  void goTo(int iteration);
  void stepBack();
  void goToPreviousEvent();
  //! The last iteration that is free of the walls that would be new at the shown one; else the first.
  void goBefore(const WallList& walls);
  void trace(int index) { worker_.trace(index); }
  void setStepsPerFrame(int steps) { worker_.setStepsPerFrame(steps); }

  void setPausesAtLeaks(bool on) { worker_.setPausesAtLeaks(on); }

  //! What was asked for is done.
  bool isUpToDate() const { return processed_ >= expected_; }
  bool isRunning() const { return running_; }
  //! A replay is under way or was paused, and there is more of it. Known when isUpToDate().
  bool isReplayLeft() const { return replayLeft_; }
  //! Of the shown iteration; running while it could go on.
  StopReason stopReason() const { return stopReason_; }
  const QString& error() const { return error_; }
  void forgetError() { error_.clear(); }
  std::shared_ptr<const MeshSnapshot> snapshot() const { return snapshot_; }
  int iteration() const { return snapshot_ ? snapshot_->iteration : -1; }
  const std::vector<IterationSummary>& summaries() const { return summaries_; }
  const std::vector<Event>& events() const { return events_; }
  const std::vector<FoundLeak>& leaks() const { return leaks_; }
  //! What was held and asked about, in all recorded iterations.
  const std::vector<HeldPlace>& questions() const { return questions_; }
  //! What the next step from the shown iteration is done with, as recorded.
  const Request& request() const { return request_; }
  const std::vector<ParameterChange>& changes() const { return changes_; }
  const std::vector<RecordedCorrection>& corrections() const { return corrections_; }
  double seconds() const { return seconds_; }
  //! As used at the shown iteration; none before it is known.
  const std::optional<ResolvedParameters>& resolved() const { return resolved_; }

 private:
  void collect();
  bool takeLists(GrowthUpdate& update);
  void expect(bool running);

  Listener listener_;
  std::shared_ptr<const ActiveContour> start_;
  bool running_ = false, replayLeft_ = false;
  int expected_ = 0;   // commands that must be done before an update tells whether it runs
  int processed_ = 0;  // commands that the last update knew of
  int started_ = 0;    // and before it tells of this growth at all
  StopReason stopReason_ = StopReason::running;
  QString error_;
  std::shared_ptr<const MeshSnapshot> snapshot_;
  std::vector<IterationSummary> summaries_;
  std::vector<Event> events_;
  std::vector<FoundLeak> leaks_;
  std::vector<HeldPlace> questions_;
  Request request_;
  std::vector<ParameterChange> changes_;
  std::vector<RecordedCorrection> corrections_;
  double seconds_ = 0;
  std::optional<ResolvedParameters> resolved_;
  GrowthWorker worker_;  // last: its thread ends before the rest
};

}  // namespace handlebody::ui
