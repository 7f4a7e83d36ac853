// A frame to which the surface was carried, corrected with the tools of any growth: its own clicks, walls and
// edits, from the surface of the frame beside it on.

#include <QUndoStack>
#include <algorithm>

#include "core/sequence/carried_seeds.h"
#include "ui/model/document_private.h"

namespace handlebody::ui {

namespace {

//! Of a correction, as a session of its own. `moved`: what its object is, if it is of that kind.
Session asSession(FrameCorrection c, const std::optional<MovedObject>& moved) {
  if (c.isOfMoved && moved) c = withObject(std::move(c), moved->given());
  Session session;
  session.seeds = c.request.seeds;
  session.requested = c.request.parameters;
  session.constraints = c.request.constraints;
  session.changes = c.changes;
  session.stopAt = c.stopAt;
  return session;
}

//! A surface that is given here is no file: it has moved from the frame beside it. One that came to rest does
//! so from another surface beside it, too, at another iteration.
FrameCorrection asCorrection(Session s, int frame, StopReason stopped) {
  if (stopped == StopReason::converged) s.stopAt.reset();
  const bool isOfMoved = s.constraints.start.has_value();
  s.constraints.start.reset();
  for (ParameterChange& change : s.changes)
    if (change.constraints) change.constraints->start.reset();
  return {frame, {s.seeds, s.requested, s.constraints}, s.changes, s.stopAt, isOfMoved};
}

void put(std::vector<FrameCorrection>& corrections, FrameCorrection made) {
  std::erase_if(corrections, [&](const FrameCorrection& c) { return c.frame == made.frame; });
  const auto behind = [&](const FrameCorrection& c) { return c.frame > made.frame; };
  corrections.insert(std::find_if(corrections.begin(), corrections.end(), behind), std::move(made));
}

//! The frame from whose surface it starts: the nearest towards the grown one that can be trusted.
int startOf(const TimeSeries& time, int frame) {
  const int step = frame > time.grownFrame() ? -1 : 1;
  for (frame += step; frame != time.grownFrame(); frame += step)
    if (const FrameResult* r = time.resultOf(frame); r && r->startsNext()) break;
  return frame;
}

}  // namespace

std::optional<int> Document::correctedFrame() const {
  return d_->corrected.isOpen() ? std::optional(d_->time.workFrame()) : std::nullopt;
}

QString Document::correctionFault() const {
  const TimeSeries& time = d_->time;
  if (!hasVolume() || !time.hasTime()) return tr("The volume has one time point only.");
  if (d_->corrected.isOpen()) return tr("Frame %1 is being corrected: end that first.").arg(time.workFrame());
  if (time.showsGrownFrame()) return tr("In this frame the surface is grown: change it there as ever.");
  if (time.isCarrying()) return tr("The surface is being carried: wait until that is done, or cancel it.");
  if (!time.resultOf(time.shownFrame()) || !isCarriedCurrent())
    return tr("The surface has not been carried to this frame yet.");
  return {};
}

void Document::correctShownFrame() {
  if (!correctionFault().isEmpty() || (d_->active().traits.locked && !d_->mayGoOn())) return;
  d_->time.play(false);
  const int frame = d_->time.shownFrame();
  const bool isNew = !d_->corrected.at(frame);
  if (isNew) d_->corrected.add({frame, d_->newCorrection(frame), d_->time.volume()});
  const CorrectedFrame now = *d_->corrected.at(frame);
  d_->enter(now);
  if (isNew && now.object->isReplaying())
    now.object->begin();
  else if (isNew)
    now.object->goOn(ObjectWork::Wanted::run);
}

//! As it would be carried there, or as it was corrected before.
std::shared_ptr<ObjectWork> Document::Private::newCorrection(int frame) {
  const OverTimeSettings settings = carrySettings();
  const int from = startOf(time, frame);
  const std::optional<MovedObject>& moved = time.carriedTo(frame)->result.moved;
  const TriangleSoup& beside =
      from == time.grownFrame() ? time.carriedFrom()->get().mesh : time.carriedTo(from)->result.mesh;
  auto start = std::make_shared<CarriedStart>();
  start->mesh = moved ? moved->beginning(beside) : beside;
  start->holdTopology = settings.holdTopology;
  auto object = newObject();
  object->traits.label = base()->traits.label;
  const std::vector<FrameCorrection>& recorded = settings.corrections;
  const auto before =
      std::find_if(recorded.begin(), recorded.end(), [&](const auto& c) { return c.frame == frame; });
  if (before != recorded.end()) {
    Session session = asSession(*before, moved);
    session.label = base()->traits.label;
    object->adopt(session);
  } else {
    const Request r = carriedRequest(settings, frame, moved);
    const TriangleSoup& seeded = moved ? *moved->surface : beside;
    object->start({carriedSeeds(r.seeds, seeded, settings.edgeLength), r.parameters, r.constraints});
  }
  object->startFrom(std::move(start));
  return object;
}

void Document::Private::enter(const CorrectedFrame& frame) {
  forgetSavedCorrection();  // one is left for another
  corrected.putAway(objects.active(), work->volume);
  active().pause();
  active().beHidden();
  objects.hold({frame.object}, frame.object);
  work->volume = frame.volume;
  time.setWorkFrame(frame.frame, frame.volume);
  time.show(frame.frame);
  tellAll();
  active().beShown();
  updateModified();
}

//! The session holds what is left now: it is another one than the work until it is written again.
void Document::Private::forgetSavedCorrection() {
  if (std::exchange(isCorrectionSaved, false)) undo.resetClean();
}

void Document::Private::leaveCorrection() {
  if (!corrected.isOpen()) return;
  forgetSavedCorrection();
  active().pause();
  active().beHidden();
  const auto [home, volume] = corrected.takeBack();
  objects.hold({home}, home);
  work->volume = volume;
  time.setWorkFrame(time.grownFrame(), work->volume);
  tellAll();
  active().beShown();
  updateModified();
}

//! With what is being corrected now, if something of it was grown.
std::vector<FrameCorrection> Document::Private::corrections() const {
  std::vector<FrameCorrection> all = time.request().corrections;
  if (corrected.isOpen() && active().growth().exists())
    put(all, asCorrection(active().session(), time.workFrame(), active().growth().stopReason()));
  return all;
}

bool Document::Private::hasOverTime() const { return time.isAsked() || !corrections().empty(); }

void Document::endCorrection(bool keeps) {
  if (!d_->corrected.isOpen()) return;
  const int frame = d_->time.workFrame();
  const bool isCurrent = isCarriedCurrent();  // else what is nearer than this frame is carried again, too
  if (keeps && (d_->active().isBusy() || !d_->active().finished())) {
    Q_EMIT refused(tr("The correction has no surface at rest yet: let it grow, or pause it."));
    return;
  }
  OverTimeRequest request = d_->time.request();
  if (keeps) request.corrections = d_->corrections();
  d_->leaveCorrection();
  if (!keeps) return d_->journalNow();  // which holds it, too
  d_->time.setRequest(request, true);
  d_->corrected.forgetBeyond(frame, d_->time.grownFrame());
  d_->undo.resetClean();
  // The surface that it is carried from may have been undone meanwhile. The correction is kept all the same.
  if (const QString fault = carryFault(); !fault.isEmpty())
    Q_EMIT refused(fault);
  else
    d_->carryAgain(isCurrent ? std::optional(frame) : std::nullopt);
  d_->journalNow();
}

}  // namespace handlebody::ui
