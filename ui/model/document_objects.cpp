// The Document's list of objects.

#include <algorithm>
#include <set>

#include "core/io/meshes/object_name.h"
#include "core/io/report/anonymous_names.h"
#include "ui/model/document_private.h"

namespace handlebody::ui {

namespace {

//! Why an object cannot be called so; empty if it can.
QString nameFaultInWords(const std::string& utf8) {
  const QString name = QString::fromStdString(utf8);
  switch (nameFaultOf(utf8)) {
    case NameFault::none:
      return {};
    case NameFault::empty:
      return Document::tr("The name is empty.");
    case NameFault::notUtf8:
      return Document::tr("The name “%1” is not UTF-8.").arg(name);
    case NameFault::tooLong:
      return Document::tr("The name “%1” has more than %2 characters.")
          .arg(name, QString::number(kLongestName));
    case NameFault::controlCharacter:
      return Document::tr("The name “%1” holds a control character.").arg(name);
    case NameFault::separator:
      break;
  }
  const char separator = utf8[utf8.find_first_of(kNameSeparators)];
  return Document::tr("The name “%1” holds %2, which separates in some of the formats.")
      .arg(name, QString(QLatin1Char(separator)));
}

}  // namespace

// --- what the objects ask and tell ---

std::vector<FinishedWall> Document::Private::wallsFor(const ObjectWork& object) const {
  std::vector<FinishedWall> walls;
  for (const auto& other : objects) {
    if (other.get() == &object) break;
    if (auto mesh = other->finished())
      walls.push_back({QString::fromStdString(other->traits.label.name), std::move(mesh)});
  }
  return walls;
}

bool Document::Private::mustWait(const ObjectWork& object) const {
  for (const auto& other : objects) {
    if (other.get() == &object) return false;
    if (other->isBusy()) return true;
  }
  return false;
}

void Document::Private::changed(const ObjectWork& object, Part part) {
  if (&object == active.get()) {
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
  if (!object.isBusy()) pokeAfter(object);
}

void Document::Private::worthKeeping(const ObjectWork&) { journalNow(); }

void Document::Private::traced(const ObjectWork& object, int index, const EventTrace& trace) {
  if (&object == active.get()) Q_EMIT q.eventTraced(index, trace);
}

void Document::Private::leaked(const ObjectWork& object, int index) {
  if (&object == active.get())
    Q_EMIT q.leaked(index);
  else if (const int at = indexOf(object); at >= 0)  // it may have been deleted meanwhile
    Q_EMIT q.leakedElsewhere(at);
}

void Document::Private::asked(const ObjectWork& object) {
  if (&object == active.get())
    Q_EMIT q.asked();
  else if (const int at = indexOf(object); at >= 0)
    Q_EMIT q.askedElsewhere(at);
}

//! Those after it may have waited for it, or have been made with what it was before.
void Document::Private::pokeAfter(const ObjectWork& object) {
  const auto now = objects;  // what they tell may change the list
  const auto at =
      std::find_if(now.begin(), now.end(), [&](const auto& other) { return other.get() == &object; });
  if (at == now.end()) return;
  for (auto later = std::next(at); later != now.end(); ++later) (*later)->wallsChanged();
}

std::shared_ptr<ObjectWork> Document::Private::newObject() {
  auto object = std::make_shared<ObjectWork>(*this);
  setUp(*object);
  return object;
}

void Document::Private::setUp(ObjectWork& object) const {
  object.growth().setStepsPerFrame(stepsPerFrame);
  object.growth().setPausesAtLeaks(pausesAtLeaks);
}

// --- which is active ---

int Document::Private::indexOf(const ObjectWork& object) const {
  const auto at =
      std::find_if(objects.begin(), objects.end(), [&](const auto& other) { return other.get() == &object; });
  return at == objects.end() ? -1 : static_cast<int>(at - objects.begin());
}

void Document::Private::activate(const std::shared_ptr<ObjectWork>& object) {
  if (object == home) return leaveCorrection();
  for (const Correcting& c : correcting)
    if (c.object == object && object != active) return enter(c);
  if (object == active || indexOf(*object) < 0) return;
  active->beHidden();
  active = object;
  tellAll();
  active->beShown();
}

void Document::Private::tellAll() {
  Q_EMIT q.activeObjectChanged();
  Q_EMIT q.objectsChanged();
  Q_EMIT q.seedsChanged();
  Q_EMIT q.selectedSeedChanged(active->edits().selectedSeed);
  Q_EMIT q.parametersChanged();
  Q_EMIT q.constraintsChanged();
  Q_EMIT q.wallConflictChanged();
  Q_EMIT q.resolvedChanged();
  Q_EMIT q.summariesChanged();
  Q_EMIT q.snapshotChanged();
  Q_EMIT q.stateChanged();
}

int Document::objectCount() const { return static_cast<int>(d_->objects.size()); }
int Document::activeObject() const { return d_->indexOf(*d_->active); }

void Document::setActiveObject(int index) {
  if (index >= 0 && index < objectCount()) d_->activate(d_->objects[static_cast<std::size_t>(index)]);
}

ObjectInfo Document::objectInfo(int index) const {
  const ObjectWork& object = d_->object(index);
  return {object.traits.label, object.traits.visible, object.traits.locked,       object.isSeeded(),
          object.state(),      d_->shownOf(object),   d_->madeWithEarlier(object)};
}

std::vector<std::string> Document::anonymousNames() const {
  std::vector<NamedObject> named;
  for (const auto& object : d_->objects) {
    // One that is being corrected in another frame is called as the one that was carried there.
    const auto& start = (d_->home ? d_->home : object)->edits().constraints.start;
    named.push_back({object->traits.label.name, start ? start->path : std::string()});
  }
  return handlebody::anonymousNames(named);
}

std::shared_ptr<const FinishedMesh> Document::finishedMesh(int index) const {
  if (d_->home && d_->time.showsGrownFrame()) return d_->home->finished();
  if (d_->time.showsWorkFrame()) return d_->object(index).finished();
  const CarriedFrame* carried = objectCount() == 1 ? d_->time.carriedTo(d_->time.shownFrame()) : nullptr;
  return carried ? carried->finished : nullptr;
}

QString Document::Private::madeWithEarlier(const ObjectWork& object) const {
  if (!object.isOutOfDate()) return {};
  const std::vector<FinishedWall> now = wallsFor(object), &then = object.grownWith();
  for (const FinishedWall& wall : now)
    if (std::find(then.begin(), then.end(), wall) == then.end()) return wall.name;
  for (const FinishedWall& wall : then)
    if (std::find(now.begin(), now.end(), wall) == now.end()) return wall.name;
  return now.front().name;  // in another order
}

QString Document::waitsFor() const {
  if (!d_->active->isWaiting()) return {};
  for (const auto& object : d_->objects)
    if (object->isBusy()) return QString::fromStdString(object->traits.label.name);
  return {};
}

// --- changes of the list ---

ObjectList Document::Private::list() const {
  ObjectList list;
  for (const auto& object : objects) list.entries.push_back({object, object->traits});
  list.active = active;
  return list;
}

void Document::Private::pushList(const QString& text, ObjectList after, int gesture) {
  if (after.entries == list().entries) return;
  if (home) {
    Q_EMIT q.refused(tr("A frame is being corrected: end that first."));
    Q_EMIT q.objectsChanged();  // fields show again what holds
    return;
  }
  undo.push(new ListCommand(text, list(), std::move(after), gesture,
                            [this](const ObjectList& l) { applyList(l); }));
}

void Document::Private::applyList(const ObjectList& after) {
  const auto before = objects;
  const auto stays = [&](const std::shared_ptr<ObjectWork>& object) {
    return std::any_of(after.entries.begin(), after.entries.end(),
                       [&](const ObjectList::Entry& entry) { return entry.object == object; });
  };
  // A change of names or places does not take the user elsewhere.
  const bool sameOnes =
      before.size() == after.entries.size() && std::all_of(before.begin(), before.end(), stays);
  const bool isOther = !sameOnes && after.active != active;
  // As long as the list still has them: who is told of it asks for the active one's place.
  if (isOther) active->beHidden();
  for (const auto& object : before)
    if (!stays(object)) object->pause();
  objects.clear();
  for (const auto& [object, traits] : after.entries) {
    objects.push_back(object);
    object->traits = traits;
    setUp(*object);  // it may have been away
  }
  if (isOther) active = after.active;
  if (isOther)
    tellAll();
  else
    Q_EMIT q.objectsChanged();
  if (isOther) active->beShown();
  const auto now = objects;
  for (const auto& object : now) object->wallsChanged();
  journalNow();
  updateModified();
}

ObjectLabel Document::Private::freshLabel(const std::vector<ObjectLabel>& more) const {
  std::vector<ObjectLabel> known = more;
  for (const auto& object : objects) known.push_back(object->traits.label);
  std::set<std::string> names;
  std::vector<int> values;
  std::vector<Colour> colours;
  for (const ObjectLabel& other : known) {
    names.insert(other.name);
    values.push_back(other.value);
    colours.push_back(other.colour);
  }
  ObjectLabel label;
  int number = static_cast<int>(known.size()) + 1;
  do label.name = tr("Object %1").arg(number++).toStdString();
  while (names.count(label.name) != 0);
  label.value = freeLabelValue(values);
  const std::vector<Colour>& all = distinctColours();
  const auto isFree = [&](const Colour& c) {
    return std::find(colours.begin(), colours.end(), c) == colours.end();
  };
  const auto free = std::find_if(all.begin(), all.end(), isFree);
  label.colour = free != all.end() ? *free : all[known.size() % all.size()];
  return label;
}

void Document::addObject() {
  if (!hasVolume()) return;
  ObjectList after = d_->list();
  after.active = d_->newObject();
  after.entries.push_back({after.active, {d_->freshLabel(), true, false}});
  d_->pushList(tr("Add object"), std::move(after));
}

void Document::duplicateObject(int index) {
  if (!hasVolume()) return;
  const ObjectWork& original = d_->object(index);
  ObjectList after = d_->list();
  after.active = d_->newObject();
  Edits edits = original.edits();
  edits.constraints.vetoes.clear();
  edits.constraints.pins.clear();
  edits.constraints.edits.clear();
  after.active->start(std::move(edits));
  ObjectLabel label = d_->freshLabel();
  label.term = original.traits.label.term;
  after.entries.insert(after.entries.begin() + index + 1, {after.active, {label, true, false}});
  d_->pushList(tr("Duplicate object"), std::move(after));
}

void Document::removeObject(int index) {
  if (objectCount() < 2) return;
  ObjectList after = d_->list();
  const auto gone = after.entries.begin() + index;
  if (gone->traits.locked) {
    Q_EMIT refused(
        tr("“%1” is locked: unlock it first.").arg(QString::fromStdString(gone->traits.label.name)));
    return;
  }
  const bool wasActive = gone->object == after.active;
  after.entries.erase(gone);
  if (wasActive)
    after.active = after.entries[static_cast<std::size_t>(std::min(index, objectCount() - 2))].object;
  d_->pushList(tr("Delete object"), std::move(after));
}

void Document::moveObject(int index, int to) {
  ObjectList after = d_->list();
  to = std::clamp(to, 0, objectCount() - 1);
  const ObjectList::Entry moved = after.entries.at(static_cast<std::size_t>(index));
  after.entries.erase(after.entries.begin() + index);
  after.entries.insert(after.entries.begin() + to, moved);
  d_->pushList(tr("Move object in the list"), std::move(after));
}

QString Document::objectLabelFault(int index, const ObjectLabel& label) const {
  if (const QString fault = nameFaultInWords(label.name); !fault.isEmpty()) return fault;
  const QString name = QString::fromStdString(label.name);
  for (int i = 0; i < objectCount(); ++i) {
    const ObjectLabel& other = d_->object(i).traits.label;
    if (i != index && other.name == label.name) return tr("Another object is called “%1”.").arg(name);
    if (i != index && other.value == label.value)
      return tr("“%1” has the label value %2.")
          .arg(QString::fromStdString(other.name), QString::number(label.value));
  }
  return {};
}

void Document::setObjectLabel(int index, const ObjectLabel& label, const QString& undoText, int gesture) {
  ObjectList after = d_->list();
  after.entries.at(static_cast<std::size_t>(index)).traits.label = label;
  d_->pushList(undoText, std::move(after), gesture);
}

void Document::setObjectVisible(int index, bool visible) {
  ObjectList after = d_->list();
  after.entries.at(static_cast<std::size_t>(index)).traits.visible = visible;
  d_->pushList(visible ? tr("Show object") : tr("Hide object"), std::move(after));
}

void Document::setObjectLocked(int index, bool locked) {
  ObjectList after = d_->list();
  after.entries.at(static_cast<std::size_t>(index)).traits.locked = locked;
  d_->pushList(locked ? tr("Lock object") : tr("Unlock object"), std::move(after));
}

void Document::runAll() {
  bool isOther = false;  // one before it
  const auto all = d_->objects;
  for (const auto& object : all) {
    if (object->traits.locked || !object->isSeeded() || object->isReplaying()) continue;
    if (!isOther && object->state() == GrowthState::finished) continue;
    if (isOther)
      object->growAnew();
    else if (!object->isBusy())
      object->goOn(Private::Wanted::run);
    isOther = true;
  }
}

}  // namespace handlebody::ui
