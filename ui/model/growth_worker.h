#pragma once
// The growth on its own thread: steps while it runs, steps back, and hands over what it did.

#include <QString>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "core/evolution/history.h"
#include "ui/model/document.h"

namespace handlebody::ui {

//! What has happened since the last update.
struct GrowthUpdate {
  int processed = 0;  //!< commands that are done; see GrowthWorker::send
  bool running = false;
  StopReason stopReason = StopReason::running;   //!< of the shown iteration; running: it can go on
  QString error;                                 //!< of the last command; empty if it did not fail
  std::shared_ptr<const MeshSnapshot> snapshot;  //!< null: the same as before
  std::size_t summariesFrom = 0;                 //!< what was known from this index on is replaced
  std::vector<IterationSummary> summaries;
  std::size_t eventsFrom = 0;
  std::vector<Event> events;
  std::vector<std::pair<int, EventTrace>> traces;
  std::vector<FoundLeak> leaks;      //!< all that are recorded
  bool leaked = false;               //!< the last of them is new
  std::vector<HeldPlace> questions;  //!< all that are recorded
  bool asked = false;                //!< the last of them is new
  Request request;                   //!< what the next step from the shown iteration is done with
  std::optional<ResolvedParameters> resolved;
  std::vector<ParameterChange> changes;
  std::vector<RecordedCorrection> corrections;
  double seconds = 0;       //!< computing time of all steps
  bool replayLeft = false;  //!< a replay was paused, or runs: not all of it is done yet
};

//! Made elsewhere for the same volume and the request it comes with, so that changing to it takes no time;
//! may be null.
using PreparedContour = std::shared_ptr<const ActiveContour>;

//! A growth to be made again: these changes on the way, and the iteration to pause at.
struct Replay {
  enum class To { end, step, event };
  std::vector<ParameterChange> changes;
  std::optional<int> stopAt;
  To to = To::end;  //!< it pauses after the next step, or event, already
};

//! Every call returns at once; commands are done in order. What ends a run (a pause, another iteration,
//! another growth) does not wait for the step that is being made: it is taken back. Calls come from one
//! thread.
class GrowthWorker {
 public:
  //! `notify` is called on the worker's thread when there is something to collect; not again before that is
  //! collected.
  explicit GrowthWorker(std::function<void()> notify);
  ~GrowthWorker();
  GrowthWorker(const GrowthWorker&) = delete;
  GrowthWorker& operator=(const GrowthWorker&) = delete;

  //! A new growth, shown as it is; what was grown before is gone.
  void start(std::shared_ptr<const ActiveContour> contour);
  //! Nothing is grown any more.
  void clear();
  //! A step that is refused (UsageError) leaves the clicks and parameters as they were, too, and an edit by
  //! hand that is refused what was recorded.
  //! All three go on from the shown iteration with these clicks and parameters; if they are others than
  //! recorded, what was recorded after it is dropped.
  void run(const Request& request, PreparedContour prepared = {});
  void step(const Request& request, PreparedContour prepared = {});
  void runToEvent(const Request& request, PreparedContour prepared = {});
  //! Grows again as recorded in a session, from the shown iteration on, which must lie on that way.
  void replay(const Replay& replay);
  void pause();
  void goTo(int iteration);
  void stepBack();
  void goToPreviousEvent();
  //! The last iteration up to the shown one that is free of the walls that would be new there; else the
  //! first. What ends a run breaks it off, and the shown iteration stays.
  void goBefore(const WallList& walls);
  //! Works out the stages of events()[index].
  void trace(int index);
  void setStepsPerFrame(int steps);
  void setPausesAtLeaks(bool on);

  //! Number of commands given so far: compare with GrowthUpdate::processed.
  int sent() const { return sent_; }
  GrowthUpdate collect();

 private:
  enum class Mode { idle, run, toEvent, replay };
  using Command = std::function<void()>;

  enum class Urgency { normal, endsStep, goesTo };
  void send(Command command, Urgency urgency = Urgency::normal);
  void loop(const std::stop_token& stop);
  std::optional<Command> next(const std::stop_token& stop);
  void perform(const Command& command);
  void goOn(const Request& request, const ActiveContour* prepared, Mode mode);
  void tryEdit(const Request& request, const ActiveContour* prepared);
  bool goToRecordedEvent();
  void stepOnce();
  bool noticeLeaks();
  bool noticeQuestions();
  bool isToPause();
  bool replayChange();
  bool hasReached() const;
  Request nextRequest() const;
  bool isEventIteration(int iteration) const;
  void show(int iteration);
  void showBefore(const WallList& walls);
  void traceEvent(int index);
  void change(const Request& request, const ActiveContour* prepared = nullptr);
  std::shared_ptr<const MeshSnapshot> nextFrame();
  void publish(std::shared_ptr<const MeshSnapshot> frame);
  void publishLists();
  void notifyOnce();

  const std::function<void()> notify_;

  // The worker's own.
  std::optional<History> history_;
  Mode mode_ = Mode::idle;
  Replay replay_;
  bool replayLeft_ = false;
  int sinceFrame_ = 0;
  int framed_ = -1;  // iteration of the last frame
  bool framedInFull_ = false;
  int kept_ = -1;  // what was published up to this iteration still holds
  double seconds_ = 0;
  QString error_;
  std::vector<FoundLeak> leaks_;
  std::vector<HeldPlace> questions_;
  bool hasLeaked_ = false, hasAsked_ = false;  // told with the frame that shows it, not before

  // Shared.
  std::mutex mutex_;
  std::condition_variable_any changed_;
  struct Sent {
    Command command;
    Urgency urgency;
    int count;  // of those sent: it and the ones in whose place it stands
  };
  std::deque<Sent> commands_;
  std::atomic<bool> endsStep_{false};  // one of them does
  int done_ = 0;
  int stepsPerFrame_ = 1;
  bool pausesAtLeaks_ = false;
  bool notified_ = false;
  GrowthUpdate update_;  // without the lists
  std::vector<IterationSummary> summaries_;
  std::vector<Event> events_;
  std::size_t knownSummaries_ = 0, knownEvents_ = 0;

  int sent_ = 0;         // the caller's
  std::jthread thread_;  // last: it uses the others
};

}  // namespace handlebody::ui
