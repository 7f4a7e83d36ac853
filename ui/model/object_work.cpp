// An object's clicks and parameters, and what is prepared from them.

#include "ui/model/object_work.h"

#include <algorithm>

#include "ui/model/document.h"

namespace handlebody::ui {

namespace {

constexpr int kSettleMilliseconds = 150;

//! Nothing differs but which of the objects is taken, and what has no say in them.
bool offerSameObjects(const Edits& a, const Edits& b) {
  Parameters parameters = b.parameters;
  parameters.candidate = a.parameters.candidate;
  return a.seeds == b.seeds && chooseSameImage(a.parameters, parameters);
}

}  // namespace

ObjectWork::ObjectWork(ObjectHost& host)
    : host_(host),
      growth_(this, {[this] { updateState(); }, [this] { host_.changed(*this, ObjectHost::Part::snapshot); },
                     [this] { host_.changed(*this, ObjectHost::Part::summaries); },
                     [this](int index, const EventTrace& trace) { host_.traced(*this, index, trace); },
                     [this](int index) { host_.leaked(*this, index); }, [this] { host_.asked(*this); }}) {
  settle_.setSingleShot(true);
  settle_.setInterval(kSettleMilliseconds);
  connect(&settle_, &QTimer::timeout, this, [this] { preparationDue(); });
}

ObjectWork::~ObjectWork() = default;

void ObjectWork::reset() {
  dropGrowth();
  forgetPreparation();
  forgetCandidates();
  preparation_.forget();
  settle_.stop();
  edits_ = {};
  start_.reset();
  walls_.clear();
  look_.forget();
  conflict_.reset();
  isLooking_ = looksWhenUpToDate_ = false;
  replays_ = isShown_ = false;
  savedIteration_ = -1;
  traits = {};
  traits.label.name = handlebody::ui::Document::tr("Object").toStdString();
}

void ObjectWork::adopt(const Session& session) {
  replayed_ = {session.seeds, session.requested, session.constraints};
  Request last = replayed_;
  for (const ParameterChange& change : session.changes) last = changed(last, change);
  edits_.seeds = std::move(last.seeds);
  edits_.parameters = last.parameters;
  edits_.constraints = std::move(last.constraints);
  traits.label = session.label;
  replay_ = {session.changes, session.stopAt};
  replays_ = session.stopAt || !session.changes.empty();
  savedIteration_ = session.stopAt.value_or(-1);
}

void ObjectWork::volumeReplaced() {
  pause();
  replays_ = false;
  dropGrowth();
  forgetPreparation();
  forgetCandidates();
  preparation_.forget();
  if (isShown_) settle_.start();
  host_.changed(*this, ObjectHost::Part::resolved);
  updateState();
}

void ObjectWork::begin() {
  replays_ = replays_ && isSeeded();
  if (replays_)
    beginGrowth(Wanted::replay);
  else if (isShown_)
    settle_.start();
}

// --- clicks, parameters, constraints ---

void ObjectWork::apply(const Edits& after, EditCommand::Way way) {
  const bool seeds = after.seeds != edits_.seeds, parameters = !(after.parameters == edits_.parameters);
  const bool selection = after.selectedSeed != edits_.selectedSeed;
  const bool constraints = after.constraints != edits_.constraints;
  const bool walls = after.constraints.walls != edits_.constraints.walls;
  if (!offerSameObjects(edits_, after)) forgetCandidates();
  const Request before = request();
  edits_ = after;
  if (editing_ && !holds(edits_, *editing_)) editing_.reset();
  if (way == EditCommand::Way::undo) goBackBefore(before);
  if (seeds || parameters || constraints) editsChanged(seeds);
  if (seeds) host_.changed(*this, ObjectHost::Part::seeds);
  if (selection) host_.changed(*this, ObjectHost::Part::selection);
  if (parameters) host_.changed(*this, ObjectHost::Part::parameters);
  if (constraints) host_.changed(*this, ObjectHost::Part::constraints);
  if (walls) lookAtWalls(true);
  if (constraints && way == EditCommand::Way::redo) makeEdit(before.constraints.edits);
}

//! A correction that has been grown and is undone: shows the surface as it was when it was made.
void ObjectWork::goBackBefore(const Request& undone) {
  const std::vector<ParameterChange>& changes = growth_.changes();
  const auto later = [&](const ParameterChange& c) { return c.iteration >= growth_.iteration(); };
  const auto last = std::find_if_not(changes.rbegin(), changes.rend(), later);
  if (last == changes.rend() || !(last->seeds || last->constraints)) return;
  Request made = growth_.beginning().request();
  for (auto change = changes.begin(); change != last.base(); ++change) made = changed(made, *change);
  if (made == undone) growth_.goTo(last->iteration);
}

void ObjectWork::editsChanged(bool seeds) {
  forgetPreparation();
  if (seeds && (!growth_.exists() || !isSeeded())) dropGrowth();
  if (wanted_ == Wanted::replay) wanted_ = Wanted::nothing;
  replays_ = goesOnThere_ = false;
  error_.clear();  // it was about what has been asked before
  growth_.forgetError();
  changedOnTheWay_ = changedOnTheWay_ || growth_.isRunning();
  settle_.start();
  host_.worthKeeping(*this);
  updateState();
}

bool ObjectWork::select(int seed) {
  const int last = static_cast<int>(edits_.seeds.size()) - 1;
  seed = std::clamp(seed, -1, last);
  if (seed == edits_.selectedSeed) return false;
  edits_.selectedSeed = seed;
  return true;
}

bool ObjectWork::isSeeded() const {
  return edits_.constraints.start ||
         std::any_of(edits_.seeds.begin(), edits_.seeds.end(), [](const Seed& s) { return !s.background; });
}

Request ObjectWork::request() const {
  Request request = edits_.request();
  request.constraints.walls.objects = wallObjects(walls_);
  return request;
}

// --- what is prepared ---

void ObjectWork::forgetPreparation() {
  preparation_.cancel();
  isPreparing_ = isWaiting_ = false;
  ++preparations_;
  prepared_.reset();
  resolved_.reset();
  resolveError_.clear();
}

void ObjectWork::forgetCandidates() {
  candidates_.clear();
  isCloseChoice_ = false;
}

//! Seeds or parameters have been at rest for a moment.
void ObjectWork::preparationDue() {
  if (!host_.openVolume() || !isSeeded() || prepared_ || isPreparing_) return;
  if (isLooking_) return settle_.start();  // a growth that runs is not to go on into a wall
  if (!growth_.exists()) takeWalls();
  requestPreparation(request());
}

void ObjectWork::requestPreparation(const Request& request) {
  settle_.stop();
  isWaiting_ = !growth_.exists() && host_.mustWait(*this);
  if (isWaiting_) return;
  isPreparing_ = true;
  const int number = ++preparations_;
  preparation_.request(*host_.openVolume(), request, walls_, start_, [this, number](const Prepared& result) {
    QMetaObject::invokeMethod(
        this, [this, number, result] { preparationDone(number, result); }, Qt::QueuedConnection);
  });
}

void ObjectWork::preparationDone(int number, const Prepared& result) {
  if (number != preparations_) return;  // out of date
  isPreparing_ = false;
  prepareSeconds_ = result.seconds;
  if (wanted_ != Wanted::nothing) error_ = result.error;
  prepared_ = result.contour;
  if (prepared_ && prepared_->request() != request()) {  // for the beginning of a replay
    startPrepared();
    prepared_.reset();
    preparationDue();
    return;
  }
  takePrepared(result);
  host_.changed(*this, ObjectHost::Part::resolved);
  // Also if it came to its end meanwhile: it would have gone on with these.
  if (std::exchange(changedOnTheWay_, false) && prepared_ && growth_.exists())
    growth_.run(request(), prepared_);
  startPrepared();
}

void ObjectWork::takePrepared(const Prepared& result) {
  resolveError_ = result.error;
  if (!prepared_) return;
  resolved_ = prepared_->parameters();
  candidates_ = prepared_->candidates();
  isCloseChoice_ = prepared_->isCloseChoice();
}

CandidateChoice ObjectWork::candidateChoice() const {
  const int count = static_cast<int>(candidates_.size());
  const int wanted = resolved_ ? resolved_->candidate : edits_.parameters.candidate;
  return {candidates_, count == 0 ? 0 : std::clamp(wanted, 1, count), isCloseChoice_};
}

void ObjectWork::beShown() {
  isShown_ = true;
  wallsChanged();
  if (!prepared_) settle_.start();
}

void ObjectWork::beHidden() {
  isShown_ = false;
  if (isBusy() || changedOnTheWay_) return;  // what was changed a moment ago is still prepared
  settle_.stop();
  preparation_.forget();
  isPreparing_ = isWaiting_ = false;
  ++preparations_;
}

//! What was prepared for a growth to come is worth nothing with other walls.
void ObjectWork::wallsChanged() {
  if (!growth_.exists()) {
    const bool waited = isWaiting_;
    const bool areOthers = takeWalls();
    if ((areOthers || waited) && wanted_ != Wanted::nothing)
      await(wanted_);
    else if ((areOthers || waited) && isShown_)
      settle_.start();
    if (areOthers) host_.changed(*this, ObjectHost::Part::resolved);
  }
  updateState();
}

//! The objects before it as they are now, for a growth that is to begin. True if they are others than before.
bool ObjectWork::takeWalls() {
  std::vector<FinishedWall> now = host_.wallsFor(*this);
  if (now == walls_) return false;
  forgetPreparation();
  walls_ = std::move(now);
  return true;
}

}  // namespace handlebody::ui
