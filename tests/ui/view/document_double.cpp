#include "tests/ui/view/document_double.h"

#include <QUndoStack>
#include <map>

#include "core/collision/certify.h"
#include "ui/model/measurements.h"

namespace handlebody::ui {
namespace {

struct State {
  bool open = false;
  Volume volume;
  std::vector<Seed> seeds;
  int selected = -1;
  std::shared_ptr<const MeshSnapshot> snapshot;
  GrowthState growth = GrowthState::none;
  std::vector<int> gestures;
  Constraints constraints;
  std::vector<WallBall> painted, erased, pinned, unpinned;  //!< the last stroke of each
  std::vector<MeshEdit> edits;
  std::vector<ObjectInfo> others;  //!< behind the active one
  bool outOfDate = false, visible = true;
  std::optional<WallList> carriedWalls;  //!< none: the frame that is changed is shown
};

//! A document's private part is its own; the functions for tests reach its state here.
std::map<const Document*, State*>& states() {
  static std::map<const Document*, State*> all;
  return all;
}

}  // namespace

struct Document::Private : State {
  QUndoStack undo;
  Measurements measurements{undo};
};

Document::Document(QObject* parent) : QObject(parent), d_(std::make_unique<Private>()) {
  states()[this] = d_.get();
}
Document::~Document() { states().erase(this); }

bool Document::hasVolume() const { return d_->open; }
const Volume& Document::volume() const { return d_->volume; }
const std::vector<Seed>& Document::seeds() const { return d_->seeds; }
int Document::selectedSeed() const { return d_->selected; }
GrowthState Document::state() const { return d_->growth; }
std::shared_ptr<const MeshSnapshot> Document::snapshot() const { return d_->snapshot; }

bool Document::isShownOutOfDate() const { return d_->outOfDate; }
const WallList& Document::shownWalls() const {
  return d_->carriedWalls ? *d_->carriedWalls : d_->constraints.walls;
}
const std::vector<Pin>& Document::shownPins() const {
  static const std::vector<Pin> none;
  return d_->carriedWalls ? none : d_->constraints.pins;
}
const std::vector<Seed>& Document::shownSeeds() const {
  static const std::vector<Seed> none;
  return d_->carriedWalls ? none : d_->seeds;
}

int Document::objectCount() const { return 1 + static_cast<int>(d_->others.size()); }
int Document::activeObject() const { return 0; }
ObjectInfo Document::objectInfo(int index) const {
  if (index > 0) return d_->others.at(static_cast<std::size_t>(index) - 1);
  ObjectInfo info;
  info.snapshot = d_->snapshot;
  info.visible = d_->visible;
  return info;
}

void Document::addSeed(const Seed& seed) {
  d_->seeds.push_back(seed);
  Q_EMIT seedsChanged();
}

void Document::removeSeed(int index) {
  d_->seeds.erase(d_->seeds.begin() + index);
  selectSeed(-1);
  Q_EMIT seedsChanged();
}

void Document::moveSeed(int index, const Vec3& centre, int gesture) {
  d_->seeds.at(static_cast<std::size_t>(index)).centre = centre;
  d_->gestures.push_back(gesture);
  Q_EMIT seedsChanged();
}

void Document::setSeedRadius(int index, std::optional<double> radius, int gesture) {
  d_->seeds.at(static_cast<std::size_t>(index)).radius = radius;
  d_->gestures.push_back(gesture);
  Q_EMIT seedsChanged();
}

QUndoStack* Document::undoStack() const { return &d_->undo; }

Measurements& Document::measurements() const { return d_->measurements; }

void Document::selectSeed(int index) {
  d_->selected = index;
  Q_EMIT selectedSeedChanged(index);
}

const Constraints& Document::constraints() const { return d_->constraints; }

bool Document::paintWalls(const std::vector<WallBall>& stroke) {
  d_->painted = stroke;
  return true;
}
void Document::eraseWalls(const std::vector<WallBall>& eraser) { d_->erased = eraser; }

bool Document::pin(const std::vector<WallBall>& stroke) {
  d_->pinned = stroke;
  return true;
}
void Document::unpin(const std::vector<WallBall>& eraser) { d_->unpinned = eraser; }
void Document::editMesh(MeshEdit edit) { d_->edits.push_back(edit); }

double Document::shownRadius(int index) const {
  constexpr double kFitting = 6;  // mm
  return d_->seeds.at(static_cast<std::size_t>(index)).radius.value_or(kFitting);
}

namespace testing {

void setVolume(Document& document, const Volume& volume) {
  State& state = *states().at(&document);
  state = State{};
  state.open = true;
  state.volume = volume;
  Q_EMIT document.opened();
}

void setFrame(Document& document, const Volume& volume) {
  states().at(&document)->volume = volume;
  Q_EMIT document.frameShown();
}

void setSnapshot(Document& document, const TriangleSoup& mesh, const std::vector<FaceState>& faceStates,
                 const SurfaceSupport& support, bool certified) {
  auto snapshot = std::make_shared<MeshSnapshot>();
  snapshot->mesh = mesh;
  if (certified) snapshot->certificate = certify(mesh);
  snapshot->states = faceStates;
  snapshot->states.resize(mesh.triangles.size(), FaceState::moving);
  snapshot->support = support;
  snapshot->support.faces.resize(mesh.triangles.size(), FaceSupport::edge);
  states().at(&document)->snapshot = snapshot;
  Q_EMIT document.snapshotChanged();
}

void forgetSupport(Document& document) {
  auto snapshot = std::make_shared<MeshSnapshot>(*states().at(&document)->snapshot);
  snapshot->support = {};
  states().at(&document)->snapshot = snapshot;
  Q_EMIT document.snapshotChanged();
}

void showCarried(Document& document, const WallList& walls) {
  states().at(&document)->carriedWalls = walls;
  Q_EMIT document.frameShown();
  Q_EMIT document.objectsChanged();
  Q_EMIT document.snapshotChanged();
}

void setOutOfDate(Document& document, bool isOutOfDate) {
  states().at(&document)->outOfDate = isOutOfDate;
  Q_EMIT document.snapshotChanged();
}

void setVisible(Document& document, bool isVisible) {
  states().at(&document)->visible = isVisible;
  Q_EMIT document.objectsChanged();
}

void setOthers(Document& document, const std::vector<ObjectInfo>& others) {
  states().at(&document)->others = others;
  Q_EMIT document.objectsChanged();
}

void setGrowthState(Document& document, GrowthState growth) {
  states().at(&document)->growth = growth;
  Q_EMIT document.stateChanged();
}

void setConstraints(Document& document, const Constraints& constraints) {
  states().at(&document)->constraints = constraints;
  Q_EMIT document.constraintsChanged();
}

const std::vector<WallBall>& painted(const Document& document) { return states().at(&document)->painted; }
const std::vector<WallBall>& erased(const Document& document) { return states().at(&document)->erased; }

const std::vector<WallBall>& pinned(const Document& document) { return states().at(&document)->pinned; }
const std::vector<WallBall>& unpinned(const Document& document) { return states().at(&document)->unpinned; }
const std::vector<MeshEdit>& edits(const Document& document) { return states().at(&document)->edits; }

const std::vector<int>& gestures(const Document& document) { return states().at(&document)->gestures; }

}  // namespace testing
}  // namespace handlebody::ui
