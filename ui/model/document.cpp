#include "ui/model/document.h"

#include <QUndoStack>
#include <algorithm>

#include "ui/model/document_private.h"

namespace handlebody::ui {

namespace {

constexpr int kSettleMilliseconds = 150;
constexpr int kMostUndone = 1000;  // entries, about a kilobyte each

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

bool lieAlike(const Seed& a, const Seed& b) { return a.centre == b.centre && a.background == b.background; }

//! Other clicks or another kind of object: a place in the list of what could be meant means nothing any more.
bool meanOthers(const Edits& a, const Edits& b) {
  return a.parameters.object != b.parameters.object ||
         !std::equal(a.seeds.begin(), a.seeds.end(), b.seeds.begin(), b.seeds.end(), lieAlike);
}

//! Nothing differs but which of the objects is taken, and what has no say in them.
bool offerSameObjects(const Edits& a, const Edits& b) {
  Parameters parameters = b.parameters;
  parameters.candidate = a.parameters.candidate;
  return a.seeds == b.seeds && chooseSameImage(a.parameters, parameters);
}

}  // namespace

Document::Private::Private(Document& document)
    : q(document),
      growth(&document,
             {[this] { growthStateChanged(); }, [this] { Q_EMIT q.snapshotChanged(); },
              [this] { Q_EMIT q.summariesChanged(); },
              [this](int index, const EventTrace& trace) { Q_EMIT q.eventTraced(index, trace); }}) {
  undo.setUndoLimit(kMostUndone);
  settle.setSingleShot(true);
  settle.setInterval(kSettleMilliseconds);
  QObject::connect(&settle, &QTimer::timeout, &q, [this] { preparationDue(); });
  QObject::connect(&undo, &QUndoStack::cleanChanged, &q, [this] { updateModified(); });
}

// The undo list says that it is clear when it goes, and the growth, which would be asked, goes before it.
Document::Private::~Private() {
  QObject::disconnect(&undo, nullptr, &q, nullptr);
  *cancelled = true;
}

Document::Document(QObject* parent) : QObject(parent), d_(std::make_unique<Private>(*this)) {}
Document::~Document() = default;

// --- opening ---

void Document::open(const QString& path, const VolumeSelection& selection) { d_->open(path, selection); }

void Document::Private::open(const QString& path, const VolumeSelection& selection) {
  *cancelled = true;
  cancelled = std::make_shared<std::atomic<bool>>(false);
  isOpening = true;
  const int number = ++openings;
  Q_EMIT q.opening(path, 0);
  files.post([this, number, path, selection, stop = cancelled] {
    if (*stop) return;
    const auto progress = [&](double part) {
      QMetaObject::invokeMethod(
          &q,
          [this, number, path, part] {
            if (number == openings && isOpening) Q_EMIT q.opening(path, part);
          },
          Qt::QueuedConnection);
    };
    auto result = std::make_shared<OpeningResult>(openWork(path, selection, progress, *stop));
    QMetaObject::invokeMethod(
        &q, [this, number, path, result] { finishOpening(number, path, std::move(*result)); },
        Qt::QueuedConnection);
  });
}

void Document::Private::finishOpening(int number, const QString& path, OpeningResult result) {
  if (number != openings || !isOpening) return;  // cancelled, or a newer one is under way
  isOpening = false;
  if (auto* opened = std::get_if<OpenedWork>(&result))
    adopt(path, std::move(*opened));
  else if (const auto* choice = std::get_if<SeriesChoice>(&result))
    Q_EMIT q.seriesChoiceNeeded(path, choice->series);
  else
    Q_EMIT q.openFailed(std::get<OpeningFailed>(result).sentence);
}

void Document::cancelOpening() {
  *d_->cancelled = true;
  d_->isOpening = false;
}

void Document::Private::adopt(const QString& path, OpenedWork opened) {
  const std::optional<Session> session = std::move(opened.session);
  dropGrowth();
  undo.clear();
  journal.clear();
  work = std::move(opened);
  forgetPreparation();
  forgetCandidates();
  error.clear();
  sessionPath.clear();
  view.clear();
  edits = {};
  savedIteration = -1;
  hashInBackground();
  if (session) adoptSession(path, *session);
  Q_EMIT q.opened();
  Q_EMIT q.seedsChanged();
  Q_EMIT q.selectedSeedChanged(edits.selectedSeed);
  Q_EMIT q.parametersChanged();
  Q_EMIT q.constraintsChanged();
  Q_EMIT q.resolvedChanged();
  if (session && (session->stopAt || !session->changes.empty()))
    beginGrowth(Wanted::replay);
  else
    settle.start();
  updateState();
  updateModified();
}

void Document::Private::adoptSession(const QString& path, const Session& session) {
  replayed = {session.seeds, session.requested, session.constraints};
  Request last = replayed;
  for (const ParameterChange& change : session.changes) last = changed(last, change);
  edits.seeds = std::move(last.seeds);
  edits.parameters = last.parameters;
  edits.constraints = std::move(last.constraints);
  view = QByteArray::fromStdString(session.view);
  replay = {session.changes, session.stopAt};
  savedIteration = session.stopAt.value_or(-1);
  if (Journal::isJournal(path)) {
    undo.resetClean();
    journalNow();
  } else {
    sessionPath = path;
  }
}

void Document::Private::hashInBackground() {
  hash = std::make_shared<std::string>(work->reference.sha256);
  if (!hash->empty()) return;
  files.post([known = hash, path = work->reference.path] {
    try {
      *known = sha256OfPath(path);
    } catch (const std::exception&) {  // tried again, and told, when a session is saved
    }
  });
}

bool Document::isOpening() const { return d_->isOpening; }
bool Document::hasVolume() const { return d_->work.has_value(); }
const Volume& Document::volume() const { return d_->work->volume; }
const VolumeInfo& Document::info() const { return d_->work->info; }
QString Document::path() const {
  return d_->work ? QString::fromStdString(d_->work->reference.path) : QString();
}
const VolumeSelection& Document::selection() const { return d_->work->reference.selection; }
QByteArray Document::view() const { return d_->view; }
void Document::setView(const QByteArray& json) { d_->view = json; }

// --- seeds and parameters ---

void Document::Private::push(const QString& text, Edits after, int gesture) {
  if (meanOthers(edits, after)) after.parameters.candidate = 1;
  undo.push(new EditCommand(text, edits, std::move(after), gesture,
                            [this](const Edits& e, EditCommand::Way way) { apply(e, way); }));
}

void Document::Private::apply(const Edits& after, EditCommand::Way way) {
  const bool seeds = after.seeds != edits.seeds, parameters = !(after.parameters == edits.parameters);
  const bool selection = after.selectedSeed != edits.selectedSeed;
  const bool constraints = after.constraints != edits.constraints;
  if (!offerSameObjects(edits, after)) forgetCandidates();
  const Request before = edits.request();
  edits = after;
  if (way == EditCommand::Way::undo) goBackBefore(before);
  if (seeds || parameters || constraints) editsChanged(seeds);
  if (seeds) Q_EMIT q.seedsChanged();
  if (selection) Q_EMIT q.selectedSeedChanged(edits.selectedSeed);
  if (parameters) Q_EMIT q.parametersChanged();
  if (constraints) Q_EMIT q.constraintsChanged();
}

//! A correction that has been grown and is undone: shows the surface as it was when it was made.
void Document::Private::goBackBefore(const Request& undone) {
  const std::vector<ParameterChange>& changes = growth.changes();
  const auto later = [&](const ParameterChange& c) { return c.iteration >= growth.iteration(); };
  const auto last = std::find_if_not(changes.rbegin(), changes.rend(), later);
  if (last == changes.rend() || !(last->seeds || last->constraints)) return;
  Request made = growth.beginning().request();
  for (auto change = changes.begin(); change != last.base(); ++change) made = changed(made, *change);
  if (made == undone) growth.goTo(last->iteration);
}

void Document::Private::editsChanged(bool seeds) {
  forgetPreparation();
  if (seeds && (!growth.exists() || !q.isSeeded())) dropGrowth();
  if (wanted == Wanted::replay) wanted = Wanted::nothing;
  changedOnTheWay = changedOnTheWay || growth.isRunning();
  settle.start();
  journalNow();
  updateState();
}

const std::vector<Seed>& Document::seeds() const { return d_->edits.seeds; }

bool Document::isSeeded() const {
  return std::any_of(seeds().begin(), seeds().end(), [](const Seed& seed) { return !seed.background; });
}

void Document::addSeed(const Seed& seed) {
  Edits after = d_->edits;
  after.seeds.push_back(seed);
  after.selectedSeed = static_cast<int>(after.seeds.size()) - 1;
  d_->push(seed.background ? tr("Add click outside") : tr("Add seed"), std::move(after), -1);
}

void Document::removeSeed(int index) {
  Edits after = d_->edits;
  if (index < 0 || idx(index) >= after.seeds.size()) return;
  const bool outside = after.seeds[idx(index)].background;
  after.seeds.erase(after.seeds.begin() + index);
  after.selectedSeed = std::min(index, static_cast<int>(after.seeds.size()) - 1);
  d_->push(outside ? tr("Delete click outside") : tr("Delete seed"), std::move(after), -1);
}

void Document::moveSeed(int index, const Vec3& centre, int gesture) {
  Edits after = d_->edits;
  if (index < 0 || idx(index) >= after.seeds.size() || after.seeds[idx(index)].centre == centre) return;
  after.seeds[idx(index)].centre = centre;
  after.selectedSeed = index;
  const bool outside = after.seeds[idx(index)].background;
  d_->push(outside ? tr("Move click outside") : tr("Move seed"), std::move(after), gesture);
}

void Document::setSeedRadius(int index, std::optional<double> radius, int gesture) {
  Edits after = d_->edits;
  if (index < 0 || idx(index) >= after.seeds.size() || after.seeds[idx(index)].radius == radius) return;
  after.seeds[idx(index)].radius = radius;
  after.selectedSeed = index;
  const bool outside = after.seeds[idx(index)].background;
  d_->push(outside ? tr("Change radius of click outside") : tr("Change seed radius"), std::move(after),
           gesture);
}

int Document::selectedSeed() const { return d_->edits.selectedSeed; }

void Document::selectSeed(int index) {
  const int last = static_cast<int>(d_->edits.seeds.size()) - 1;
  index = std::clamp(index, -1, last);
  if (index == d_->edits.selectedSeed) return;
  d_->edits.selectedSeed = index;
  Q_EMIT selectedSeedChanged(index);
}

double Document::shownRadius(int index) const {
  const Seed& seed = d_->edits.seeds.at(idx(index));
  if (seed.radius) return *seed.radius;
  if (d_->resolved)
    for (const Seed& known : d_->resolved->seeds)
      if (lieAlike(known, seed) && known.radius) return *known.radius;
  return d_->work ? 2 * d_->work->volume.grid.meanSpacing() : 1;
}

const Parameters& Document::parameters() const { return d_->edits.parameters; }

void Document::setParameters(const Parameters& parameters, const QString& undoText, int gesture) {
  if (parameters == d_->edits.parameters) return;
  Edits after = d_->edits;
  after.parameters = parameters;
  d_->push(undoText, std::move(after), gesture);
}

const std::optional<ResolvedParameters>& Document::resolved() const { return d_->resolved; }
QString Document::resolveError() const { return d_->resolveError; }

CandidateChoice Document::candidateChoice() const {
  const int count = static_cast<int>(d_->candidates.size());
  const int wanted = d_->resolved ? d_->resolved->candidate : d_->edits.parameters.candidate;
  return {d_->candidates, count == 0 ? 0 : std::clamp(wanted, 1, count), d_->isCloseChoice};
}

void Document::chooseCandidate(SizeStep step) {
  const std::optional<int> next = neighbour(candidateChoice(), step);
  if (!next) return;
  Parameters parameters = d_->edits.parameters;
  parameters.candidate = *next;
  setParameters(parameters, step == SizeStep::smaller ? tr("Smaller object") : tr("Larger object"));
}

QUndoStack* Document::undoStack() const { return &d_->undo; }

bool Document::isModified() const { return d_->wasModified; }

void Document::Private::updateModified() {
  const bool modified = work && (!undo.isClean() || growth.iteration() != savedIteration);
  if (modified == wasModified) return;
  wasModified = modified;
  Q_EMIT q.modifiedChanged();
}

}  // namespace handlebody::ui
