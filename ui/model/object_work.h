#pragma once
// One object of the open work: its clicks, parameters and constraints, what is prepared from them, and its
// growth. It knows nothing of the others but what its host tells. Lives on the GUI thread.

#include <QObject>
#include <QTimer>

#include "core/io/report/report.h"
#include "ui/model/finished_mesh.h"
#include "ui/model/preparation.h"
#include "ui/model/surface_growth.h"
#include "ui/model/undo_commands.h"
#include "ui/model/wall_look.h"

namespace handlebody::ui {

class ObjectWork;

//! What objects ask of the document, and tell it.
class ObjectHost {
 public:
  enum class Part {
    seeds,
    selection,
    parameters,
    constraints,
    wallConflict,
    resolved,
    state,
    snapshot,
    summaries
  };

  virtual ~ObjectHost() = default;
  //! Null before one is open.
  virtual const Volume* openVolume() const = 0;
  //! The surfaces of the objects before it, as they are now.
  virtual std::vector<FinishedWall> wallsFor(const ObjectWork& object) const = 0;
  //! True while one of the objects before it still grows: what it is made with is not known yet.
  virtual bool mustWait(const ObjectWork& object) const = 0;
  virtual void changed(const ObjectWork& object, Part part) = 0;
  //! What is worth a journal: clicks, parameters, constraints, or that the growth came to rest.
  virtual void worthKeeping(const ObjectWork& object) = 0;
  virtual void traced(const ObjectWork& object, int index, const EventTrace& trace) = 0;
  //! The last of its growth's leaks was found just now: `index`.
  virtual void leaked(const ObjectWork& object, int index) = 0;
  //! A limit of the topology has just begun to hold something that somebody is to decide.
  virtual void asked(const ObjectWork& object) = 0;
  //! The shown iteration is an edit that was just made.
  virtual void edited(const ObjectWork& object) = 0;
  //! That edit, which was asked for, could not be made.
  virtual void editRefused(ObjectWork& object, const MeshEdit& edit, const QString& why) = 0;
};

class ObjectWork : public QObject {
 public:
  //! What is to be done when the contour is prepared.
  enum class Wanted { nothing, run, step, toEvent, replay };

  explicit ObjectWork(ObjectHost& host);
  ~ObjectWork() override;

  ObjectTraits traits;

  // --- for another volume ---
  //! As new, without a word; the growth goes.
  void reset();
  //! Takes over what a session holds of an object, without its growth (begin()).
  void adopt(const Session& session);
  //! Another time point of the volume is the one it is grown in: the growth goes, the clicks stay.
  void volumeReplaced();
  //! Grows again as the session says, if it says; else prepares.
  void begin();

  // --- clicks, parameters, constraints ---
  const Edits& edits() const { return edits_; }
  void apply(const Edits& after, EditCommand::Way way);
  //! For one that is new: it grows from that surface in place of its seeds.
  void startFrom(std::shared_ptr<const CarriedStart> surface) { start_ = std::move(surface); }
  //! For one that is new, without a word.
  void start(Edits edits) { edits_ = std::move(edits); }
  //! False if it is selected already.
  bool select(int seed);
  bool isSeeded() const;
  //! With the walls that the objects before it are.
  Request request() const;
  const std::optional<WallConflict>& wallConflict() const { return conflict_; }

  // --- what is prepared ---
  const std::optional<ResolvedParameters>& resolved() const { return resolved_; }
  const QString& resolveError() const { return resolveError_; }
  std::shared_ptr<const ObjectImage> image() const { return prepared_ ? prepared_->image() : nullptr; }
  CandidateChoice candidateChoice() const;
  //! It is shown from now on: prepares what is missing. Others are shown: lets go of what takes memory.
  void beShown();
  void beHidden();
  //! One of the objects before it came to rest, or changed.
  void wallsChanged();

  // --- growth ---
  GrowthState state() const;
  StopReason stopReason() const { return growth_.stopReason(); }
  QString error() const { return error_.isEmpty() ? growth_.error() : error_; }
  void goOn(Wanted what);
  //! From the seeds on, with the walls that there are then.
  void growAnew();
  void pause();
  void goTo(int iteration);
  void stepBack();
  void goToPreviousEvent();
  //! Back to before the surface came to the walls that the growth does not know, and on.
  void goOnBeforeWalls();
  const SurfaceGrowth& growth() const { return growth_; }
  SurfaceGrowth& growth() { return growth_; }
  //! It grows, or is going to when it can.
  bool isBusy() const { return wanted_ != Wanted::nothing || growth_.isRunning(); }
  //! What a session says of it is still to be done, under way, or paused: it goes on as recorded there until
  //! that is done, or something is edited.
  bool isReplaying() const { return replays_; }
  bool isWaiting() const { return isWaiting_ && wanted_ != Wanted::nothing; }

  // --- to the others ---
  //! What is shown of it, for files and as a wall; null if there is no surface.
  std::shared_ptr<const FinishedMesh> finished() const;
  //! The walls that its growth was made with.
  const std::vector<FinishedWall>& grownWith() const { return grownWith_; }
  //! True if its growth was made with other surfaces of the objects before it than there are now.
  bool isOutOfDate() const;

  // --- out ---
  //! What belongs to the object alone: seeds, parameters, constraints, changes, label. While it is replayed
  //! all of the replay.
  Session session() const;
  //! The same, of the shown surface, with what is told of the growth.
  RunReport report() const;
  bool isAsSaved() const { return growth_.iteration() == savedIteration_; }
  void setSavedIteration(int iteration) { savedIteration_ = iteration; }

 private:
  void goBackBefore(const Request& undone);
  void lookAtWalls(bool tells);
  bool isOutdated(const WallQuestion& question) const;
  void lookAgain();
  void wallsLookedAt(const std::optional<WallConflict>& found);
  void editsChanged(bool seeds);
  void requestPreparation(const Request& request);
  void preparationDone(int number, const Prepared& result);
  void preparationDue();
  void takePrepared(const Prepared& result);
  void forgetPreparation();
  void forgetCandidates();
  bool takeWalls();
  void await(Wanted what);
  void beginGrowth(Wanted what);
  void startPrepared();
  void dropGrowth();
  void updateState();
  void goOnThere();
  void makeEdit(const std::vector<MeshEdit>& known);
  void tellOfEdit();
  Request replayedRequest() const;
  Replay replayWithWalls() const;
  void goOnReplaying(Wanted what);
  bool isReplayOver() const;
  Session recorded() const;

  ObjectHost& host_;
  Edits edits_;
  std::vector<FinishedWall> walls_;      // that a growth is begun with
  std::vector<FinishedWall> grownWith_;  // that it was begun with
  mutable std::shared_ptr<const FinishedMesh> finished_;

  std::shared_ptr<const CarriedStart> start_;  // null: from its seeds

  int preparations_ = 0;  // number of the newest that was asked for
  bool isShown_ = false;
  bool isPreparing_ = false;
  bool isWaiting_ = false;                         // to prepare, for the objects before it
  bool changedOnTheWay_ = false;                   // clicks or parameters, while the growth runs
  std::shared_ptr<const ActiveContour> prepared_;  // of the present clicks and parameters
  double prepareSeconds_ = 0;
  std::optional<ResolvedParameters> resolved_;
  std::vector<ObjectCandidate> candidates_;
  bool isCloseChoice_ = false;
  QString resolveError_;
  QTimer settle_;  // from the last change to the preparation

  std::optional<WallConflict> conflict_;
  WallQuestion asked_;  // the last one about walls
  bool isLooking_ = false, tellsAgain_ = false, looksWhenUpToDate_ = false;

  Wanted wanted_ = Wanted::nothing;
  bool goesOnThere_ = false;         // when the iteration that was asked for is shown
  std::optional<MeshEdit> editing_;  // was asked for as the next step, and is under way
  Replay replay_;
  Request replayed_;      // at the beginning of the replay
  bool replays_ = false;  // what the session says is still to be done, under way, or paused
  QString error_;
  GrowthState shownState_ = GrowthState::none;
  StopReason shownStop_ = StopReason::running;
  QString shownError_;
  int savedIteration_ = -1;

  // Threads: last, so that they end before what their jobs report to.
  SurfaceGrowth growth_;
  Preparation preparation_;
  WallLook look_;
};

}  // namespace handlebody::ui
