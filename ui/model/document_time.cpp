// The Document's time points: which of them is grown in, and the surface carried through the others.

#include <QFile>
#include <QUndoCommand>
#include <algorithm>
#include <utility>

#include "core/io/formats/sequence_writer.h"
#include "core/io/report/frame_files.h"
#include "core/io/report/polished_frames.h"
#include "ui/model/document_private.h"
#include "ui/model/file_name.h"

namespace handlebody::ui {

namespace {

constexpr int kOverTimeId = 0x7135;

class GrownFrameCommand : public QUndoCommand {
 public:
  using Set = std::function<void(int)>;
  GrownFrameCommand(const QString& text, int before, int after, Set set)
      : QUndoCommand(text), before_(before), after_(after), set_(std::move(set)) {}
  void undo() override { set_(before_); }
  void redo() override { set_(after_); }

 private:
  int before_, after_;
  Set set_;
};

class OverTimeCommand : public QUndoCommand {
 public:
  OverTimeCommand(const QString& text, TimeSeries& time, OverTimeRequest after, int gesture)
      : QUndoCommand(text),
        time_(time),
        before_(time.request()),
        after_(std::move(after)),
        wasAsked_(time.isAsked()),
        gesture_(gesture) {}
  int id() const override { return gesture_ >= 0 ? kOverTimeId : -1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const OverTimeCommand*>(other);
    if (next->gesture_ != gesture_ || next->text() != text()) return false;
    after_ = next->after_;
    return true;
  }
  void undo() override { put(before_, wasAsked_); }
  void redo() override { put(after_, true); }

 private:
  //! Corrected frames stay as they are: they are no part of what is undone.
  void put(OverTimeRequest request, bool isAsked) {
    request.corrections = time_.request().corrections;
    time_.setRequest(request, isAsked || !request.corrections.empty());
  }

  TimeSeries& time_;
  OverTimeRequest before_, after_;
  bool wasAsked_;
  int gesture_;
};

QString severalFault() {
  return Document::tr("Several objects are not carried over time: open the volume with one of them.");
}

//! "0–2, 5" of 0, 1, 2, 5.
QString frameSpans(const std::vector<int>& frames) {
  QStringList spans;
  for (auto first = frames.begin(); first != frames.end();) {
    auto last = first;
    while (last + 1 != frames.end() && *(last + 1) == *last + 1) ++last;
    const QString from = QString::number(*first);
    spans << (first == last ? from : QStringLiteral("%1–%2").arg(from).arg(*last));
    first = last + 1;
  }
  return spans.join(Document::tr(", "));
}

//! Those of frames without a surface are removed.
QStringList frameFiles(const QString& path, const OverTimeReport& over) {
  if (!isMeshPath(fileName(path))) return {path};
  std::vector<int> frames;
  for (const FrameResult& r : over.frames) frames.push_back(r.frame);
  QStringList files;
  for (const std::string& file : frameMeshPaths(fileName(path), frames))
    files << QFile::decodeName(file.c_str());
  return files;
}

}  // namespace

TimeSeries& Document::time() const { return d_->time; }

// --- which frame ---

bool Document::Private::isInGrownFrame() {
  if (time.showsWorkFrame()) return true;
  if (!objects.isGrown()) {
    growInShown();
    return true;
  }
  Q_EMIT q.refused(tr("Frame %1 is shown, and the surface is grown in frame %2: go there to change it.")
                       .arg(time.shownFrame())
                       .arg(time.grownFrame()));
  Q_EMIT q.seedsChanged();  // fields show again what holds
  Q_EMIT q.parametersChanged();
  return false;
}

void Document::Private::growInShown() {
  if (!work || time.showsWorkFrame()) return;
  work->volume = time.volume();
  work->reference.selection.frame = time.shownFrame();
  time.setGrownFrame();
  const auto now = objects.all();  // what they tell may change the list
  for (const auto& object : now) object->volumeReplaced();
  journalNow();
  updateModified();
}

void Document::Private::setGrownFrame(int frame) {
  leaveCorrection();  // an older step that is undone
  growsIn = frame;
  if (time.shownFrame() == frame)
    shownFrameChanged();
  else
    time.show(frame);
}

//! Another frame is wanted before the one to grow in could be shown, or that cannot be: what was grown there
//! since is not dropped when somebody looks at it later.
void Document::Private::giveUpGrownFrame() {
  if (growsIn < 0 || (time.wantedFrame() == growsIn && time.error().isEmpty())) return;
  const int frame = std::exchange(growsIn, -1);
  undo.resetClean();  // its entry says otherwise
  updateModified();
  Q_EMIT q.refused(tr("The surface is still grown in frame %1: frame %2 was not shown.")
                       .arg(time.grownFrame())
                       .arg(frame));
}

void Document::Private::shownFrameChanged() {
  if (!work) return;
  if (growsIn == time.shownFrame()) {
    growsIn = -1;
    growInShown();
  }
  Q_EMIT q.frameShown();
  Q_EMIT q.objectsChanged();
  Q_EMIT q.snapshotChanged();
}

std::shared_ptr<const MeshSnapshot> Document::Private::shownOf(const ObjectWork& object) const {
  if (showsHome()) return corrected.home()->growth().snapshot();
  if (time.showsWorkFrame()) return object.growth().snapshot();
  const CarriedFrame* carried = carriedHere();
  return carried ? carried->snapshot : nullptr;
}

const ObjectWork* Document::Private::grownHere() const {
  if (showsHome()) return corrected.home().get();
  return time.showsWorkFrame() ? objects.active().get() : nullptr;
}

const CarriedFrame* Document::Private::carriedHere() const {
  const bool isOfThis = objects.size() == 1 && carriedObject.lock() == base();
  return isOfThis ? time.carriedTo(time.shownFrame()) : nullptr;
}

void Document::growInShownFrame() {
  if (!hasVolume() || d_->corrected.isOpen() || d_->time.showsWorkFrame()) return;
  for (const auto& object : d_->objects)
    if (object->traits.locked)
      return Q_EMIT refused(tr("“%1” is locked: unlock it to grow in another frame.")
                                .arg(QString::fromStdString(object->traits.label.name)));
  d_->undo.push(new GrownFrameCommand(tr("Grow in frame %1").arg(d_->time.shownFrame()),
                                      d_->time.grownFrame(), d_->time.shownFrame(),
                                      [this](int frame) { d_->setGrownFrame(frame); }));
}

QStringList Document::lostElsewhere() const {
  QStringList names;
  for (const auto& object : d_->objects)
    if (object != d_->objects.active() && object->growth().exists())
      names << QString::fromStdString(object->traits.label.name);
  return names;
}

// --- over time ---

QString Document::carryFault() const {
  if (!hasVolume() || !d_->time.hasTime()) return tr("The volume has one time point only.");
  if (correctedFrame()) return tr("Frame %1 is being corrected: end that first.").arg(*correctedFrame());
  if (objectCount() > 1) return severalFault();
  if (constraints().start)
    return tr("A surface that comes from a file is not carried over time: grow one from a click.");
  if (d_->active().isBusy()) return tr("The surface still grows: wait until it is at rest.");
  if (!d_->active().finished() || !d_->active().growth().resolved())
    return tr("There is no surface yet: grow one in a frame first.");
  return {};
}

bool Document::isCarriedCurrent() const {
  const auto& from = d_->time.carriedFrom();
  const auto now = d_->base()->growth().snapshot();
  return from && now && objectCount() == 1 && from->isOf(*now) && d_->time.isAsRequested();
}

bool Document::isShownOutOfDate() const {
  const CarriedFrame* here = d_->grownHere() ? nullptr : d_->carriedHere();
  return here && here->snapshot && !isCarriedCurrent();
}

const WallList& Document::shownWalls() const {
  const ObjectWork* grown = d_->grownHere();
  const CarriedFrame* carried = grown ? nullptr : d_->carriedHere();
  if (carried && carried->snapshot) return carried->result.under.walls;
  return (grown ? grown : d_->base().get())->edits().constraints.walls;
}

const std::vector<Pin>& Document::shownPins() const {
  static const std::vector<Pin> none;
  const ObjectWork* grown = d_->grownHere();
  return grown ? grown->edits().constraints.pins : none;
}

const std::vector<Seed>& Document::shownSeeds() const {
  static const std::vector<Seed> none;
  return d_->time.showsWorkFrame() ? seeds() : none;
}

void Document::carryOverTime() {
  if (!carryFault().isEmpty()) return;
  if (!d_->time.isAsked()) setOverTime(d_->time.request(), tr("Over time"));
  d_->corrected.forget();  // what is recorded of them stays
  d_->carryAgain();
}

OverTimeSettings Document::Private::carrySettings() const {
  const SurfaceGrowth& growth = base()->growth();
  return {base()->request(),
          growth.resolved()->edgeLength,
          growth.resolved()->smoothing,
          time.request().holdTopology,
          time.grownFrame(),
          time.request().corrections};
}

void Document::Private::carryAgain(const std::optional<int>& again) {
  const SurfaceGrowth& growth = base()->growth();
  carriedObject = base();
  CarryOrder order;
  order.again = again;
  order.surface = base()->finished();
  order.start.frame = time.grownFrame();
  order.start.iterations = growth.iteration();
  order.start.stopped = growth.stopReason();
  order.start.seconds = growth.seconds();
  for (const FoundLeak& found : growth.leaks())
    if (found.leak.iteration <= growth.iteration()) order.start.faults.push_back(leakFault(found.leak));
  order.settings = carrySettings();
  const MeshSnapshot& shown = *order.surface->shown();
  for (ToldFault& f : faultsAtEnd(growth.stopReason(), shown.held))
    order.start.faults.push_back(std::move(f));
  order.start.under = {work->volume.grid, order.settings.request.constraints.walls, shown.edgeLength,
                       shown.pinned};
  time.carry(std::move(order));
}

void Document::Private::carryAfterReplay() {
  if (!carriesLater || active().isBusy() || active().isReplaying()) return;
  carriesLater = false;
  if (q.carryFault().isEmpty()) carryAgain();
}

void Document::setOverTime(const OverTimeRequest& request, const QString& undoText, int gesture) {
  if (request == d_->time.request() && d_->time.isAsked()) return;
  if (objectCount() > 1) {
    Q_EMIT refused(severalFault());
    Q_EMIT d_->time.requestChanged();  // fields show again what holds
    return;
  }
  d_->undo.push(new OverTimeCommand(undoText, d_->time, request, gesture));
}

OverTimeReport Document::Private::overTimeReport() const { return time.report(); }

QString Document::framesFault() const {
  if (!isCarriedCurrent() || d_->time.isCarrying())
    return tr("There are no surfaces over time of what is shown: carry it through the frames first.");
  if (d_->time.framesOfRange(false).empty()) return {};
  const OverTimeRequest::Range all = d_->time.range();
  return tr("Of the frames %1–%2 the surface is in these only: %3. Carry it through all of them first.")
      .arg(QString::number(all.first), QString::number(all.last), frameSpans(d_->time.framesOfRange(true)));
}

void Document::exportFrames(const QString& path, CoordinateSpace space) {
  if (const QString fault = framesFault(); !fault.isEmpty())
    Q_EMIT exportRefused(fault);
  else
    d_->exportFrames(path, space);
}

void Document::Private::exportFrames(const QString& path, CoordinateSpace coordinates) {
  setOutput({output.polishes, coordinates});
  OverTimeReport report = overTimeReport();
  const QStringList paths = frameFiles(path, report);  // before the report is handed on
  write(path, paths,
        [this, path, coordinates, over = std::move(report), from = time.carriedFrom(),
         grown = time.grownFrame(), label = active().traits.label, grid = work->volume.grid,
         betters = output.polishes]() mutable -> Written {
          for (FrameResult& r : over.frames)
            if (r.frame == grown) r.mesh = from->get().mesh;
          if (betters) polishFrames(over, [told = polishing(), &label](int) { told(label.name); });
          const std::string file = fileName(path);
          if (isMeshPath(file))
            writeFrameMeshes(over, coordinates, file);
          else
            writeFrameLabels(over, label, grid, file);
          return {polishSentence(together(over.polish)), leftOutTexts(over, grid, path)};
        });
}

}  // namespace handlebody::ui
