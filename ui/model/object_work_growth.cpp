// An object's growth, and what is told of it.

#include "ui/model/object_work.h"

#include <algorithm>

#include "core/evolution/wall_pieces.h"

namespace handlebody::ui {

namespace {

//! The finished objects are walls throughout, whatever else changes on the way.
void addWalls(std::vector<ParameterChange>& changes, const std::vector<WallObject>& walls) {
  for (ParameterChange& change : changes)
    if (change.constraints) change.constraints->walls.objects = walls;
}

}  // namespace

Request ObjectWork::replayedRequest() const {
  Request request = replayed_;
  request.constraints.walls.objects = wallObjects(walls_);
  return request;
}

Replay ObjectWork::replayWithWalls() const {
  Replay replay = replay_;
  addWalls(replay.changes, wallObjects(walls_));
  return replay;
}

//! With what is recorded next, and not with what holds at its end.
void ObjectWork::goOnReplaying(Wanted what) {
  replay_.to = what == Wanted::step      ? Replay::To::step
               : what == Wanted::toEvent ? Replay::To::event
                                         : Replay::To::end;
  if (growth_.exists() && (growth_.isRunning() || !isOutOfDate()))
    growth_.replay(replayWithWalls());
  else
    beginGrowth(Wanted::replay);
}

void ObjectWork::goOn(Wanted what) {
  if (!host_.openVolume()) return;
  error_.clear();
  if (replays_) return goOnReplaying(what);
  const bool restart =
      growth_.iteration() == 0 && !growth_.isRunning() && growth_.beginning().request() != request();
  if (!growth_.exists() || restart || (!growth_.isRunning() && isOutOfDate())) {
    beginGrowth(what);
    return;
  }
  const Request& known = growth_.request();
  const bool sameImage = edits_.seeds == known.seeds && chooseSameImage(edits_.parameters, known.parameters);
  if (!prepared_ && !sameImage) {
    await(what);
    return;
  }
  switch (what) {
    case Wanted::run:
      growth_.run(request(), prepared_);
      break;
    case Wanted::step:
      growth_.step(request(), prepared_);
      break;
    case Wanted::toEvent:
      growth_.runToEvent(request(), prepared_);
      break;
    default:
      break;
  }
}

void ObjectWork::growAnew() {
  error_.clear();
  replays_ = false;
  beginGrowth(Wanted::run);
}

//! Goes on when the contour with the present parameters is prepared.
void ObjectWork::await(Wanted what) {
  wanted_ = what;
  if (growth_.isRunning()) growth_.pause();
  if (what == Wanted::replay)
    requestPreparation(replayedRequest());
  else if (!isPreparing_)
    requestPreparation(request());
  updateState();
}

void ObjectWork::beginGrowth(Wanted what) {
  growth_.clear();
  takeWalls();
  if (!isSeeded()) {
    error_ = Document::tr("There is no seed yet: place one inside the object first.");
    updateState();
  } else if (prepared_ && what != Wanted::replay && !host_.mustWait(*this)) {
    wanted_ = what;
    startPrepared();
  } else {
    await(what);
  }
}

void ObjectWork::startPrepared() {
  const Wanted what = std::exchange(wanted_, Wanted::nothing);
  if (what == Wanted::nothing) return;
  if (prepared_ && !growth_.exists()) {
    grownWith_ = walls_;
    growth_.start(prepared_, what == Wanted::replay ? std::optional(replayWithWalls()) : std::nullopt);
  }
  if (prepared_ && what != Wanted::replay) goOn(what);
  updateState();
}

void ObjectWork::dropGrowth() {
  changedOnTheWay_ = goesOnThere_ = false;
  wanted_ = Wanted::nothing;
  error_.clear();
  growth_.clear();
}

GrowthState ObjectWork::state() const {
  if (wanted_ != Wanted::nothing) return GrowthState::preparing;
  if (!growth_.exists()) return GrowthState::none;
  if (growth_.isRunning()) return GrowthState::running;
  const bool others = growth_.request() != request();
  return growth_.stopReason() == StopReason::running || others || isOutOfDate() ? GrowthState::paused
                                                                                : GrowthState::finished;
}

void ObjectWork::updateState() {
  if (goesOnThere_ && growth_.isUpToDate()) goOnThere();
  if (editing_ && !isBusy() && growth_.isUpToDate()) tellOfEdit();
  if (looksWhenUpToDate_ && growth_.isUpToDate())
    lookAtWalls(tellsAgain_);
  else if (conflict_ && !growth_.isRunning())
    lookAgain();
  const bool isOver = isReplayOver();
  if (isOver) replays_ = false;
  const GrowthState now = state();
  const StopReason stop = stopReason();
  const QString failed = error();
  if (!isOver && now == shownState_ && stop == shownStop_ && failed == shownError_) return;
  if (!failed.isEmpty() && failed != shownError_) lookAtWalls(true);
  const bool cameToRest = shownState_ == GrowthState::running && now != GrowthState::running;
  shownState_ = now;
  shownStop_ = stop;
  shownError_ = failed;
  if (cameToRest) host_.worthKeeping(*this);
  host_.changed(*this, ObjectHost::Part::state);
}

//! Done, or it failed: not where it was paused.
bool ObjectWork::isReplayOver() const {
  if (!replays_ || isBusy()) return false;
  if (!growth_.exists()) return !error_.isEmpty();
  return growth_.isUpToDate() && !growth_.isReplayLeft();
}

void ObjectWork::pause() {
  changedOnTheWay_ = goesOnThere_ = false;
  if (wanted_ != Wanted::nothing) {
    wanted_ = Wanted::nothing;
    updateState();
  }
  if (growth_.exists()) growth_.pause();
}

void ObjectWork::goTo(int iteration) {
  changedOnTheWay_ = goesOnThere_ = false;
  if (growth_.exists()) growth_.goTo(iteration);
}

void ObjectWork::stepBack() {
  changedOnTheWay_ = goesOnThere_ = false;
  if (growth_.exists()) growth_.stepBack();
}

void ObjectWork::goToPreviousEvent() {
  changedOnTheWay_ = goesOnThere_ = false;
  if (growth_.exists()) growth_.goToPreviousEvent();
}

void ObjectWork::goOnBeforeWalls() {
  if (!growth_.exists()) return;
  pause();
  replays_ = false;
  goesOnThere_ = true;
  growth_.goBefore(request().constraints.walls);
}

//! In the background: large meshes take a while. `tells`: also if the answer is the one that it was.
void ObjectWork::lookAtWalls(bool tells) {
  const WallList fresh = without(edits_.constraints.walls, growth_.request().constraints.walls);
  const auto shown = growth_.snapshot();
  asked_ = {shown, fresh, edits_.parameters.direction == Direction::both};
  isLooking_ = looksWhenUpToDate_ = false;
  tellsAgain_ = tells;
  if (!growth_.exists() || !shown || shown->mesh.triangles.empty() || fresh.empty()) {
    look_.forget();
    asked_ = {};
    return wallsLookedAt({});
  }
  isLooking_ = true;
  const ActiveContour& known = growth_.beginning();
  look_.ask(asked_, known.grid(), known.parameters().edgeLength, [this](const auto& question, auto found) {
    QMetaObject::invokeMethod(
        this,
        [this, question, found] {
          if (!isLooking_ || question != asked_) return;
          if (!growth_.isRunning() && !growth_.isUpToDate()) {  // it is on its way to another iteration
            isLooking_ = false;
            looksWhenUpToDate_ = true;
            return;
          }
          isOutdated(question) ? lookAtWalls(tellsAgain_) : wallsLookedAt(found);
        },
        Qt::QueuedConnection);
  });
}

//! The growth has gone back meanwhile, or knows the walls now. Where it only went on, the surface has not
//! left them.
bool ObjectWork::isOutdated(const WallQuestion& question) const {
  const auto now = growth_.snapshot();
  if (!now || now->iteration < question.shown->iteration) return true;
  if (!growth_.isRunning() && now != question.shown) return true;
  return without(edits_.constraints.walls, growth_.request().constraints.walls) != question.fresh;
}

//! The answer may be another one now.
void ObjectWork::lookAgain() {
  const bool isSame =
      asked_.shown == growth_.snapshot() && growth_.request().constraints.walls != edits_.constraints.walls;
  if (!isSame) lookAtWalls(false);
}

void ObjectWork::wallsLookedAt(const std::optional<WallConflict>& found) {
  isLooking_ = false;
  const bool changed = conflict_ != found;
  conflict_ = found;
  if (found && growth_.isRunning()) pause();
  if (changed || (found && tellsAgain_)) host_.changed(*this, ObjectHost::Part::wallConflict);
}

//! Only now is it known whether it is the start, from which it begins again.
void ObjectWork::goOnThere() {
  goesOnThere_ = false;
  goOn(Wanted::run);
}

//! If the next step from the shown iteration is an edit that is not one of those.
void ObjectWork::makeEdit(const std::vector<MeshEdit>& known) {
  const auto isNext = [this](const MeshEdit& e) { return e.iteration == growth_.iteration() + 1; };
  const std::vector<MeshEdit>& edits = edits_.constraints.edits;
  const auto edit = std::find_if(edits.begin(), edits.end(), isNext);
  if (isBusy() || edit == edits.end() || std::find(known.begin(), known.end(), *edit) != known.end()) return;
  editing_ = *edit;
  goOn(Wanted::step);
}

void ObjectWork::tellOfEdit() {
  const MeshEdit edit = *std::exchange(editing_, std::nullopt);
  const auto isShown = [this](const Event& e) { return e.edit && e.iteration == growth_.iteration(); };
  if (const QString why = error(); !why.isEmpty())
    host_.editRefused(*this, edit, why);
  else if (std::any_of(growth_.events().begin(), growth_.events().end(), isShown))
    host_.edited(*this);
}

// --- to the others ---

std::shared_ptr<const FinishedMesh> ObjectWork::finished() const {
  const auto shown = growth_.snapshot();
  if (!shown || shown->mesh.triangles.empty()) return nullptr;
  if (!finished_ || !finished_->isOf(*shown)) finished_ = std::make_shared<const FinishedMesh>(shown);
  return finished_;
}

//! What was opened as it is does not depend on the others.
bool ObjectWork::isOutOfDate() const {
  const auto& start = edits_.constraints.start;
  return growth_.exists() && !(start && start->isDone) && host_.wallsFor(*this) != grownWith_;
}

// --- out ---

Session ObjectWork::session() const {
  Session s;
  s.label = traits.label;
  const bool isUnderWay = isReplaying();
  const Request asked = isUnderWay ? replayed_ : edits_.request();
  s.seeds = asked.seeds;
  s.requested = asked.parameters;
  s.constraints = asked.constraints;
  if (isUnderWay) {
    s.changes = replay_.changes;
    s.stopAt = replay_.stopAt;
  }
  // With other walls than there are now the way that it took cannot be gone again.
  return isUnderWay || growth_.iteration() < 0 || isOutOfDate() ? s : recorded();
}

//! How the shown surface was made.
Session ObjectWork::recorded() const {
  Session s;
  s.label = traits.label;
  const int shown = growth_.iteration();
  const Request began = growth_.beginning().request();
  Request last = began;
  s.resolved = growth_.beginning().parameters();
  s.stopAt = shown;
  for (const ParameterChange& change : growth_.changes())
    if (change.iteration < shown) s.changes.push_back(change);
  for (const ParameterChange& change : s.changes) last = changed(last, change);
  if (last != request()) {
    s.changes.push_back({shown, edits_.parameters, {}, {}});
    if (last.seeds != edits_.seeds) s.changes.back().seeds = edits_.seeds;
    if (last.constraints != request().constraints) s.changes.back().constraints = edits_.constraints;
  }
  s.seeds = began.seeds;
  s.requested = began.parameters;
  s.constraints = began.constraints;
  s.constraints.walls.objects.clear();
  addWalls(s.changes, {});
  return s;
}

RunReport ObjectWork::report() const {
  RunReport r;
  // Of a replay that is paused the way up to here: it is about the surface that is shown.
  const bool isPaused = isReplaying() && !isBusy() && growth_.iteration() >= 0 && !isOutOfDate();
  r.session = isPaused ? recorded() : session();
  r.iterations = growth_.iteration();
  r.stopped = growth_.stopReason();
  r.seconds.prepare = prepareSeconds_;
  r.seconds.evolve = growth_.seconds();
  for (const Event& event : growth_.events())
    if (event.iteration <= r.iterations) r.events.push_back(event);
  for (const FoundLeak& found : growth_.leaks())
    if (found.leak.iteration <= r.iterations) r.leaks.push_back({found.leak, LeakAnswer::goOn});
  for (const HeldPlace& held : growth_.questions())
    if (held.iteration <= r.iterations) r.questions.push_back(held);
  for (const RecordedCorrection& correction : growth_.corrections())
    if (correction.iteration < r.iterations) r.corrections.push_back(correction);
  if (const auto shown = growth_.snapshot()) {
    r.held = shown->held;
    r.pinned = shown->pinned;
  }
  if (growth_.exists()) {
    r.session.resolved = growth_.beginning().parameters();
    r.candidates = growth_.beginning().candidates();
    r.isCloseChoice = growth_.beginning().isCloseChoice();
  }
  return r;
}

}  // namespace handlebody::ui
