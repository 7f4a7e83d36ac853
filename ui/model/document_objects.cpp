// The Document's list of objects.

#include <algorithm>

#include "core/io/report/anonymous_names.h"
#include "ui/model/document_private.h"
#include "ui/model/object_labels.h"

namespace handlebody::ui {

// --- what the objects ask and tell ---

std::vector<FinishedWall> Document::Private::wallsFor(const ObjectWork& object) const {
  return objects.wallsFor(object);
}

bool Document::Private::mustWait(const ObjectWork& object) const { return objects.mustWait(object); }

void Document::Private::changed(const ObjectWork& object, Part part) {
  if (&object == &active()) {
    if (part == Part::seeds) Q_EMIT q.seedsChanged();
    if (part == Part::selection) Q_EMIT q.selectedSeedChanged(object.edits().selectedSeed);
    if (part == Part::parameters) Q_EMIT q.parametersChanged();
    if (part == Part::constraints) Q_EMIT q.constraintsChanged();
    if (part == Part::wallConflict) Q_EMIT q.wallConflictChanged();
    if (part == Part::resolved) Q_EMIT q.resolvedChanged();
    if (part == Part::snapshot) Q_EMIT q.snapshotChanged();
    if (part == Part::summaries) Q_EMIT q.summariesChanged();
    if (part == Part::state) Q_EMIT q.stateChanged();
  } else if (part == Part::snapshot || part == Part::state) {
    Q_EMIT q.objectsChanged();
  }
  if (part != Part::snapshot && part != Part::state) return;
  updateModified();
  if (part == Part::state) carryAfterReplay();
  if (part == Part::state) tellIfWithoutSurface(object);
  if (!object.isBusy()) pokeAfter(object);
}

void Document::Private::worthKeeping(const ObjectWork&) { journalNow(); }

void Document::Private::traced(const ObjectWork& object, int index, const EventTrace& trace) {
  if (&object == &active()) Q_EMIT q.eventTraced(index, trace);
}

void Document::Private::leaked(const ObjectWork& object, int index) {
  if (&object == &active())
    Q_EMIT q.leaked(index);
  else if (const int at = objects.indexOf(object); at >= 0)  // it may have been deleted meanwhile
    Q_EMIT q.leakedElsewhere(at);
}

void Document::Private::asked(const ObjectWork& object) {
  if (&object == &active())
    Q_EMIT q.asked();
  else if (const int at = objects.indexOf(object); at >= 0)
    Q_EMIT q.askedElsewhere(at);
}

//! Those after it may have waited for it, or have been made with what it was before.
void Document::Private::pokeAfter(const ObjectWork& object) {
  for (const auto& later : objects.after(object)) later->wallsChanged();  // they may change the list
}

std::shared_ptr<ObjectWork> Document::Private::newObject() {
  auto object = std::make_shared<ObjectWork>(*this);
  growthChoices.applyTo(object->growth());
  return object;
}

// --- which is active ---

void Document::Private::activate(const std::shared_ptr<ObjectWork>& object) {
  if (object == corrected.home()) return leaveCorrection();
  if (const CorrectedFrame* c = corrected.of(object); c && object != objects.active())
    return enter(CorrectedFrame(*c));
  if (object == objects.active() || objects.indexOf(*object) < 0) return;
  active().beHidden();
  objects.activate(object);
  tellAll();
  active().beShown();
}

void Document::Private::tellAll() {
  Q_EMIT q.activeObjectChanged();
  Q_EMIT q.objectsChanged();
  Q_EMIT q.seedsChanged();
  Q_EMIT q.selectedSeedChanged(active().edits().selectedSeed);
  Q_EMIT q.parametersChanged();
  Q_EMIT q.constraintsChanged();
  Q_EMIT q.wallConflictChanged();
  Q_EMIT q.resolvedChanged();
  Q_EMIT q.summariesChanged();
  Q_EMIT q.snapshotChanged();
  Q_EMIT q.stateChanged();
}

int Document::objectCount() const { return static_cast<int>(d_->objects.size()); }
int Document::activeObject() const { return d_->objects.indexOf(d_->active()); }

void Document::setActiveObject(int index) {
  if (index >= 0 && index < objectCount()) d_->activate(d_->objects[index]);
}

ObjectInfo Document::objectInfo(int index) const {
  const ObjectWork& object = d_->objects.at(index);
  return {object.traits.label,
          object.traits.visible,
          object.traits.locked,
          object.isSeeded(),
          object.state(),
          d_->shownOf(object),
          d_->objects.madeWithEarlier(object)};
}

std::weak_ptr<const void> Document::objectKey(int index) const {
  return std::shared_ptr<const void>(d_->objects.all().at(static_cast<std::size_t>(index)));
}

int Document::indexOfObject(const std::weak_ptr<const void>& key) const {
  const auto wanted = key.lock();
  for (int i = 0; wanted && i < objectCount(); ++i)
    if (objectKey(i).lock() == wanted) return i;
  return -1;
}

std::vector<std::string> Document::anonymousNames() const {
  std::vector<NamedObject> named;
  for (const auto& object : d_->objects) {
    // One that is being corrected in another frame is called as the one that was carried there.
    const auto& start = (d_->corrected.isOpen() ? d_->corrected.home() : object)->edits().constraints.start;
    named.push_back({object->traits.label.name, start ? start->path : std::string()});
  }
  return handlebody::anonymousNames(named);
}

std::shared_ptr<const FinishedMesh> Document::finishedMesh(int index) const {
  if (d_->showsHome()) return d_->corrected.home()->finished();
  if (d_->time.showsWorkFrame()) return d_->objects.at(index).finished();
  const CarriedFrame* carried = isCarriedCurrent() ? d_->carriedHere() : nullptr;
  return carried ? carried->finished : nullptr;
}

QString Document::waitsFor() const {
  if (!d_->active().isWaiting()) return {};
  for (const auto& object : d_->objects)
    if (object->isBusy()) return QString::fromStdString(object->traits.label.name);
  return {};
}

// --- changes of the list ---

QString Document::Private::listFault() const {
  return corrected.isOpen() ? tr("A frame is being corrected: end that first.") : QString();
}

QString Document::Private::addFault() const {
  if (QString fault = listFault(); !fault.isEmpty() || objects.size() > 1 || !hasOverTime()) return fault;
  return tr(
      "A session keeps work over time of one object only: save this one, then open the volume anew to have "
      "several objects.");
}

void Document::Private::pushList(const QString& text, ObjectList after, int gesture) {
  if (after.entries == objects.list().entries) return;
  const bool isMore = after.entries.size() > objects.size();
  if (const QString fault = isMore ? addFault() : listFault(); !fault.isEmpty()) {
    Q_EMIT q.refused(fault);
    Q_EMIT q.objectsChanged();  // fields show again what holds
    return;
  }
  undo.push(new ListCommand(text, objects.list(), std::move(after), gesture,
                            [this](const ObjectList& l) { applyList(l); }));
}

void Document::Private::applyList(const ObjectList& after) {
  leaveCorrection();  // an older step that is undone
  const auto before = objects.all();
  const auto stays = [&](const std::shared_ptr<ObjectWork>& object) {
    return std::any_of(after.entries.begin(), after.entries.end(),
                       [&](const ObjectList::Entry& entry) { return entry.object == object; });
  };
  // A change of names or places does not take the user elsewhere.
  const bool sameOnes =
      before.size() == after.entries.size() && std::all_of(before.begin(), before.end(), stays);
  const bool isOther = !sameOnes && after.active != objects.active();
  // As long as the list still has them: who is told of it asks for the active one's place.
  if (isOther) active().beHidden();
  for (const auto& object : before)
    if (!stays(object)) object->pause();
  std::vector<std::shared_ptr<ObjectWork>> now;
  for (const auto& [object, traits] : after.entries) {
    now.push_back(object);
    object->traits = traits;
    growthChoices.applyTo(object->growth());  // it may have been away
  }
  objects.hold(now, isOther ? after.active : objects.active());
  if (isOther)
    tellAll();
  else
    Q_EMIT q.objectsChanged();
  if (isOther) active().beShown();
  const auto all = objects.all();  // what they tell may change the list
  for (const auto& object : all) object->wallsChanged();
  journalNow();
  updateModified();
  if (const QString lost = q.leftOut(); before.size() < now.size() && !lost.isEmpty()) Q_EMIT q.refused(lost);
}

void Document::addObject() {
  if (!hasVolume()) return;
  ObjectList after = d_->objects.list();
  after.active = d_->newObject();
  after.entries.push_back({after.active, {freshLabel(d_->objects.labels()), true, false}});
  d_->pushList(tr("Add object"), std::move(after));
}

void Document::duplicateObject(int index) {
  if (!hasVolume()) return;
  const ObjectWork& original = d_->objects.at(index);
  ObjectList after = d_->objects.list();
  after.active = d_->newObject();
  Edits edits = original.edits();
  edits.constraints.vetoes.clear();
  edits.constraints.pins.clear();
  edits.constraints.edits.clear();
  after.active->start(std::move(edits));
  ObjectLabel label = freshLabel(d_->objects.labels());
  label.term = original.traits.label.term;
  label.source = original.traits.label.source;
  after.entries.insert(after.entries.begin() + index + 1, {after.active, {label, true, false}});
  d_->pushList(tr("Duplicate object"), std::move(after));
}

void Document::removeObject(int index) {
  if (objectCount() < 2) return;
  ObjectList after = d_->objects.list();
  const auto gone = after.entries.begin() + index;
  if (gone->traits.locked) {
    Q_EMIT refused(
        tr("“%1” is locked: unlock it first.").arg(QString::fromStdString(gone->traits.label.name)));
    return;
  }
  const bool wasActive = gone->object == after.active;
  after.entries.erase(gone);
  if (wasActive) after.active = after.entries[std::min(index, objectCount() - 2)].object;
  d_->pushList(tr("Delete object"), std::move(after));
}

void Document::moveObject(int index, int to) {
  ObjectList after = d_->objects.list();
  to = std::clamp(to, 0, objectCount() - 1);
  const ObjectList::Entry moved = after.entries.at(static_cast<std::size_t>(index));
  after.entries.erase(after.entries.begin() + index);
  after.entries.insert(after.entries.begin() + to, moved);
  d_->pushList(tr("Move object in the list"), std::move(after));
}

QString Document::objectLabelFault(int index, const ObjectLabel& label) const {
  return labelFault(static_cast<std::size_t>(index), label, d_->objects.labels());
}

void Document::setObjectLabel(int index, const ObjectLabel& label, const QString& undoText, int gesture) {
  ObjectList after = d_->objects.list();
  after.entries.at(static_cast<std::size_t>(index)).traits.label = label;
  d_->pushList(undoText, std::move(after), gesture);
}

void Document::setObjectVisible(int index, bool visible) {
  ObjectList after = d_->objects.list();
  after.entries.at(static_cast<std::size_t>(index)).traits.visible = visible;
  d_->pushList(visible ? tr("Show object") : tr("Hide object"), std::move(after));
}

void Document::setObjectLocked(int index, bool locked) {
  ObjectList after = d_->objects.list();
  after.entries.at(static_cast<std::size_t>(index)).traits.locked = locked;
  d_->pushList(locked ? tr("Lock object") : tr("Unlock object"), std::move(after));
}

void Document::runAll() {
  bool isOther = false;  // one before it
  const auto all = d_->objects.all();
  for (const auto& object : all) {
    if (object->traits.locked || !object->isSeeded()) continue;
    if (object->isReplaying()) {
      if (!object->isBusy()) object->goOn(Private::Wanted::run);
      continue;
    }
    if (!isOther && object->state() == GrowthState::finished) continue;
    if (isOther)
      object->growAnew();
    else if (!object->isBusy())
      object->goOn(Private::Wanted::run);
    isOther = true;
  }
}

}  // namespace handlebody::ui
