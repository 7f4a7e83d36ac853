#include "ui/model/document.h"

#include <QUndoStack>
#include <algorithm>

#include "core/evolution/click_faults.h"
#include "core/indices.h"
#include "ui/model/document_private.h"
#include "ui/model/finding_text.h"

namespace handlebody::ui {

namespace {

constexpr int kMaxUndone = 1000;  // entries, about a kilobyte each

bool lieAlike(const Seed& a, const Seed& b) { return a.centre == b.centre && a.background == b.background; }

//! Other clicks or another kind of object: a place in the list of what could be meant means nothing any more.
bool meanOthers(const Edits& a, const Edits& b) {
  return a.parameters.object != b.parameters.object ||
         !std::equal(a.seeds.begin(), a.seeds.end(), b.seeds.begin(), b.seeds.end(), lieAlike);
}

}  // namespace

Document::Private::Private(Document& document) : q(document) {
  const auto first = newObject();
  objects.hold({first}, first);
  undo.setUndoLimit(kMaxUndone);
  QObject::connect(&undo, &QUndoStack::indexChanged, &q, [this] {
    ++edits;  // told of what merges, too
    dropObsolete();
  });
  QObject::connect(&undo, &QUndoStack::cleanChanged, &q, [this] { updateModified(); });
  QObject::connect(&time, &TimeSeries::shownChanged, &q, [this] { shownFrameChanged(); });
  for (auto changed : {&TimeSeries::carriedChanged, &TimeSeries::requestChanged})
    QObject::connect(&time, changed, &q, [this] {
      if (time.showsWorkFrame()) return;
      Q_EMIT q.objectsChanged();
      Q_EMIT q.snapshotChanged();
    });
  QObject::connect(&time, &TimeSeries::requestChanged, &q, [this] { journalNow(); });
  QObject::connect(&time, &TimeSeries::wantedChanged, &q, [this] { giveUpGrownFrame(); });
  QObject::connect(&measurements, &Measurements::changed, &q, [this] { journalNow(); });
}

// The undo list says that it is clear when it goes, and the growth, which would be asked, goes before it.
Document::Private::~Private() {
  QObject::disconnect(&undo, nullptr, &q, nullptr);
  opening.cancel();
  openingObjects.cancel();
  stopHashing();
}

Document::Document(QObject* parent) : QObject(parent), d_(std::make_unique<Private>(*this)) {}
Document::~Document() = default;

// --- seeds and parameters ---

bool Document::Private::mayGoOn() {
  if (!active().traits.locked) {
    if (objects.isGrown())
      time.show(time.workFrame());
    else
      growInShown();
    return true;
  }
  Q_EMIT q.refused(
      tr("“%1” is locked: unlock it to change it.").arg(QString::fromStdString(active().traits.label.name)));
  Q_EMIT q.seedsChanged();  // fields show again what holds, and the timeline
  Q_EMIT q.parametersChanged();
  Q_EMIT q.stateChanged();
  return false;
}

bool Document::Private::mayChange() { return active().traits.locked ? mayGoOn() : isInGrownFrame(); }

void Document::Private::push(const QString& text, Edits after, int gesture) {
  if (!mayChange()) return;
  if (meanOthers(active().edits(), after)) after.parameters.candidate = 1;
  undo.push(new EditCommand(text, objects.active(), active().edits(), std::move(after), gesture,
                            [this, object = objects.active()](const Edits& e, EditCommand::Way way) {
                              activate(object);
                              if (object != objects.active()) return;  // a correction that is forgotten
                              if (objects.isGrown()) time.show(time.workFrame());
                              object->apply(e, way);
                            }));
}

const std::vector<Seed>& Document::seeds() const { return d_->active().edits().seeds; }

bool Document::isSeeded() const { return d_->active().isSeeded(); }

void Document::addSeed(const Seed& seed) {
  Edits after = d_->active().edits();
  after.seeds.push_back(seed);
  if (d_->work)
    if (const std::optional<Finding> fault = contradictionOf(d_->work->volume.grid, after.seeds))
      return Q_EMIT refused(findingSentence(*fault));
  after.selectedSeed = static_cast<int>(after.seeds.size()) - 1;
  d_->push(seed.background ? tr("Add click outside") : tr("Add seed"), std::move(after), -1);
}

void Document::removeSeed(int index) {
  Edits after = d_->active().edits();
  if (index < 0 || idx(index) >= after.seeds.size()) return;
  const bool outside = after.seeds[index].background;
  after.seeds.erase(after.seeds.begin() + index);
  after.selectedSeed = std::min(index, static_cast<int>(after.seeds.size()) - 1);
  d_->push(outside ? tr("Delete click outside") : tr("Delete seed"), std::move(after), -1);
}

void Document::moveSeed(int index, const Vec3& centre, int gesture) {
  Edits after = d_->active().edits();
  if (index < 0 || idx(index) >= after.seeds.size() || after.seeds[index].centre == centre) return;
  after.seeds[index].centre = centre;
  after.selectedSeed = index;
  const bool outside = after.seeds[index].background;
  d_->push(outside ? tr("Move click outside") : tr("Move seed"), std::move(after), gesture);
}

void Document::setSeedRadius(int index, std::optional<double> radius, int gesture) {
  Edits after = d_->active().edits();
  if (index < 0 || idx(index) >= after.seeds.size() || after.seeds[index].radius == radius) return;
  after.seeds[index].radius = radius;
  after.selectedSeed = index;
  const bool outside = after.seeds[index].background;
  d_->push(outside ? tr("Change radius of click outside") : tr("Change seed radius"), std::move(after),
           gesture);
}

int Document::selectedSeed() const { return d_->active().edits().selectedSeed; }

void Document::selectSeed(int index) {
  if (d_->active().select(index)) Q_EMIT selectedSeedChanged(selectedSeed());
}

double Document::shownRadius(int index) const {
  const Seed& seed = d_->active().edits().seeds.at(idx(index));
  if (seed.radius) return *seed.radius;
  if (resolved())
    for (const Seed& known : resolved()->seeds)
      if (lieAlike(known, seed) && known.radius) return *known.radius;
  return d_->work ? 2 * d_->work->volume.grid.meanSpacing() : 1;
}

const Parameters& Document::parameters() const { return d_->active().edits().parameters; }

void Document::setParameters(const Parameters& parameters, const QString& undoText, int gesture) {
  if (parameters == d_->active().edits().parameters) return;
  Edits after = d_->active().edits();
  after.parameters = parameters;
  d_->push(undoText, std::move(after), gesture);
}

const std::optional<ResolvedParameters>& Document::resolved() const { return d_->active().resolved(); }
QString Document::resolveError() const { return d_->active().resolveError(); }
std::shared_ptr<const ObjectImage> Document::objectImage() const { return d_->active().image(); }
CandidateChoice Document::candidateChoice() const { return d_->active().candidateChoice(); }

void Document::chooseCandidate(SizeStep step) {
  const std::optional<int> next = neighbour(candidateChoice(), step);
  if (!next) return;
  Parameters parameters = d_->active().edits().parameters;
  parameters.candidate = *next;
  setParameters(parameters, step == SizeStep::smaller ? tr("Smaller object") : tr("Larger object"));
}

Measurements& Document::measurements() const { return d_->measurements; }

QUndoStack* Document::undoStack() const { return &d_->undo; }

bool Document::isModified() const { return d_->wasModified; }

bool Document::Private::isAsSaved() const {
  return objects.isAsSaved() && (!corrected.isOpen() || corrected.home()->isAsSaved());
}

void Document::Private::updateModified() {
  const bool modified = work && (!undo.isClean() || !isAsSaved());
  if (modified == wasModified) return;
  wasModified = modified;
  Q_EMIT q.modifiedChanged();
}

}  // namespace handlebody::ui
