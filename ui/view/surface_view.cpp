#include "ui/view/surface_view_private.h"

#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>

#include <Eigen/Geometry>
#include <QElapsedTimer>
#include <QStyle>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/view/distance_colours.h"
#include "ui/view/measure_overlay.h"
#include "ui/view/other_outlines.h"
#include "ui/view/other_surfaces.h"
#include "ui/view/overlay.h"
#include "ui/view/surface_measuring.h"
#include "ui/view/surface_overlay.h"
#include "ui/view/surface_style.h"

namespace handlebody::ui {
namespace {

const QColor kFrame(0x74, 0x83, 0xe6);
constexpr Plane kPlanes[] = {Plane::axial, Plane::coronal, Plane::sagittal};

}  // namespace

// --- scene ---

void SurfaceView::Private::createOpenGl() {
  if (triedOpenGl) return;
  triedOpenGl = true;
  gl = std::make_unique<OffscreenRenderer>();
  if (!gl->isValid()) {
    gl.reset();
    return;
  }
  scene = std::make_unique<SurfaceScene>(gl->renderer());
  vtkNew<SurfaceStyle> style;
  gl->interactor()->SetInteractorStyle(style);
  gl->onRenderRequest([this] { draw(poseChanged); });
  startVolume();
}

void SurfaceView::Private::startVolume() {
  brush.giveUp();
  meshChanged = pinsChanged = seedsChanged = slicesChanged = coloursChanged = poseChanged = wallsChanged =
      loopsChanged = true;
  shownSlices = {-1, -1, -1};
  slices = {};  // the volume before is let go
  follows = true;
  stage = EventStage::none;
  wallsShown = false;
  const auto camera = std::exchange(wanted, std::nullopt);
  if (!scene) return;
  flight.stop();
  scene->showStage({}, EventStage::none);
  scene->setVolume(document.hasVolume() ? &document.volume().grid : nullptr);
  scene->setPose(document.hasVolume() ? around(document.volume().grid, obliquePose(), aspect())
                                      : obliquePose());
  if (camera) stand(*camera);
}

void SurfaceView::Private::stand(const StandingCamera& camera) {
  if (!scene) {
    wanted = camera;
    return;
  }
  flight.stop();
  follows = camera.follows;
  scene->setPose(camera.pose);
  draw(poseChanged);
}

double SurfaceView::Private::heightFor(const Sight& sight, double margin) const {
  return margin * 2 * sight.radius / std::min(1.0, aspect());
}

void SurfaceView::Private::sync() {
  if (meshChanged) {
    shownColouring = state.meshColouring();
    scene->setMesh(isActiveVisible(document) ? document.snapshot().get() : nullptr, shownColouring,
                   activeColour(document, plainMaterial()));
    if (const DistanceColours* d = shownDistances())
      scene->colourFaces(distancePalette(d->isSigned), paletteEntries(*d));
    scene->setOthers(otherSurfaces(document));
    followMesh();
  }
  if (meshChanged || pinsChanged) syncPins();
  if (seedsChanged) syncSeeds();
  if (wallsChanged) syncWalls();
  if (loopsChanged) scene->setLoops(state.markedLoops());
  if (slicesChanged || coloursChanged) syncSlices();
  loopsChanged = meshChanged = pinsChanged = seedsChanged = slicesChanged = coloursChanged = wallsChanged =
      false;
}

void SurfaceView::Private::syncPins() {
  const auto mesh = document.snapshot();
  const bool shows = mesh && isActiveVisible(document) && state.showsConstraints();
  const auto& parts = pinned.of(mesh, shows ? document.constraints().pins : std::vector<Pin>{});
  hasPins = !parts.empty();
  scene->setPinned(hasPins ? mesh->mesh : TriangleSoup{}, parts);
}

//! Asked for here; they come later.
void SurfaceView::Private::syncWalls() {
  const bool any = document.hasVolume() && isActiveVisible(document) && state.showsConstraints();
  const WallList walls = any ? document.constraints().walls : WallList{};
  if (walls == shownWalls && wallsShown) return;
  wallSurfaces.request(walls, any ? document.volume().grid : Grid{});
  shownWalls = walls;
  wallsShown = true;
}

void SurfaceView::Private::takeWalls() {
  if (waitsForWalls) wallSurfaces.finish();
  const std::optional<TriangleSoup> made = wallSurfaces.take();
  if (!made) return;
  scene->setWalls(*made);
  poseChanged = true;
}

void SurfaceView::Private::syncSeeds() {
  std::vector<Seed> seeds = document.seeds();
  for (std::size_t i = 0; i < seeds.size(); ++i) seeds[i].radius = document.shownRadius(static_cast<int>(i));
  scene->setSeeds(seeds);
}

void SurfaceView::Private::syncSlices() {
  const bool on = state.slicesIn3d() && document.hasVolume();
  scene->showSlices(on);
  slicesShown = on;
  if (!on) return;
  const Volume& volume = document.volume();
  for (Plane plane : kPlanes) {
    constexpr double kLargest = 512;  // pixels of a texture
    SliceGeometry geometry = wholeSlice(volume.grid, plane, kLargest);
    const QSizeF& size = geometry.size();
    geometry.setSlice(geometry.nearestSlice(state.crosshair()));
    const auto i = static_cast<std::size_t>(plane);
    if (shownSlices[i] == geometry.slice() && !coloursChanged) continue;
    shownSlices[i] = geometry.slice();
    const SliceColours colours{{state.window(), state.level()}, state.colourMap(), {}};
    scene->setSlice(plane, slices[i].render(volume, geometry, 1, colours),
                    {geometry.toWorld({0, 0}), geometry.toWorld({size.width(), 0}),
                     geometry.toWorld({0, size.height()})});
  }
}

//! Only when the mesh leaves the view or is lost in it: a camera that moves all the time hides the growth.
void SurfaceView::Private::followMesh() {
  constexpr double kMargin = 2.2, kTooSmall = 5, kTooLarge = 1.05;  // heights of view per mesh
  constexpr double kAtRest = 1.25, kFarAtRest = 1.6;                // and where nothing grows any more
  const std::shared_ptr<const MeshSnapshot> mesh = document.snapshot();
  if (!mesh || !follows || stage != EventStage::none || flight.state() == QAbstractAnimation::Running) return;
  const std::optional<Sight> sight = sightOfSurfaces(document);
  if (!sight) return;
  CameraPose pose = scene->pose();
  const double offset = (sight->centre - pose.focus).norm();
  const bool atRest = document.state() == GrowthState::finished;
  if (pose.height < heightFor(*sight, atRest ? kFarAtRest : kTooSmall) &&
      pose.height > heightFor({sight->centre, sight->radius + offset}, kTooLarge))
    return;
  pose.focus = sight->centre;
  pose.height = heightFor(*sight, atRest ? kAtRest : kMargin);
  flyTo(pose);
}

void SurfaceView::Private::flyTo(const CameraPose& pose) {
  flight.stop();
  const int time =
      flightTime >= 0 ? flightTime : 2 * view.style()->styleHint(QStyle::SH_Widget_Animation_Duration);
  if (time <= 0 || !view.isVisible()) {
    scene->setPose(pose);
    draw(poseChanged);
    return;
  }
  flightFrom = scene->pose();
  flightTo = pose;
  flight.setDuration(time);
  flight.start();
}

// --- picture ---

const QImage& SurfaceView::Private::frame(double pixelRatio) {
  sync();
  takeWalls();
  const QSize size = (QSizeF(view.size()) * pixelRatio).toSize();
  if (!poseChanged && shown.size() == size) return shown;
  QElapsedTimer timer;
  timer.start();
  scene->setPixelRatio(pixelRatio);
  scene->fitDepth();
  shown = gl->render(size, pixelRatio);
  shown.setDevicePixelRatio(pixelRatio);
  poseChanged = false;
  renderTime = timer.elapsed();
  return shown;
}

void SurfaceView::Private::paint(QPainter& painter, double pixelRatio, bool focused) {
  createOpenGl();
  const QSizeF size = view.size();
  if (!gl) {
    painter.fillRect(view.rect(), QColor(0x15, 0x18, 0x1c));
    paintHint(
        painter, size,
        tr("This machine offers no OpenGL 3.2: the surface cannot be shown in 3D. Slices, growth and export "
           "work all the same."));
  } else {
    if (meshChanged || pinsChanged || seedsChanged || slicesChanged || coloursChanged || wallsChanged ||
        loopsChanged)
      poseChanged = true;
    painter.drawImage(QPointF(0, 0), frame(pixelRatio));
    painter.setRenderHint(QPainter::Antialiasing);
    paintOver(painter, size);
  }
  paintText(painter, {kOverlayMargin, kOverlayMargin}, Qt::AlignLeft | Qt::AlignTop, tr("3D"),
            overlayFont(1.05, true), kFrame.lighter(130));
  paintFrame(painter, size, kFrame, focused);
}

//! What does not need a new picture of the scene.
void SurfaceView::Private::paintOver(QPainter& painter, const QSizeF& size) {
  const CameraPose pose = scene->pose();
  const bool empty = !document.hasVolume();
  if (empty) {
    paintHint(painter, size, tr("The surface grows here"));
  } else {
    if (stage == EventStage::none) paintMeasurements(painter, size, pose, document, state.measure());
    paintTriad(painter, size, pose);
    paintScaleBar(painter, size, pose.height / std::max(1.0, size.height()));
  }
  const std::shared_ptr<const MeshSnapshot> mesh = document.snapshot();
  if (mesh && mesh->mesh.triangles.empty())
    paintText(painter, {size.width() / 2, kOverlayMargin}, Qt::AlignHCenter | Qt::AlignTop,
              tr("Nothing is left of the surface"), overlayFont());
  if (stage != EventStage::none) return paintStageCaption(painter, stage);
  if (const DistanceColours* d = shownDistances())
    paintDistanceScale(painter, size, *d);
  else if (mesh && state.meshColouring() == MeshColouring::state)
    paintStateLegend(painter);
  else if (mesh && !mesh->mesh.triangles.empty() && state.meshColouring() == MeshColouring::support)
    paintSupportLegend(painter, size, mesh->support);
  if (hasPins) paintPinLegend(painter, size);
  if (!empty) brush.paint(painter, eye());
}

void SurfaceView::Private::followBrush() {
  if (!gl || !document.hasVolume()) return;
  if (state.brush().isFor3d())
    view.setCursor(brush.cursor(eye()));
  else
    view.unsetCursor();
  view.update();
}

//! First the stroke is given up, if there is one.
void SurfaceView::Private::putBrushAway() {
  if (!brush.isDown()) state.brush().setMode(Brush::Mode::off);
  brush.giveUp();
}

// --- widget ---

SurfaceView::SurfaceView(Document& document, ViewState& state, QWidget* parent)
    : QWidget(parent), d_(std::make_unique<Private>(*this, document, state)) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);  // the brush follows the mouse
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("3D view"));
  setAccessibleDescription(tr(
      "Home, End and Page Down look from superior, anterior and left. With the brush on, left pins, unpins, "
      "smooths or pulls the surface."));
  Private* d = d_.get();
  d->flight.setStartValue(0.0);
  d->flight.setEndValue(1.0);
  d->flight.setEasingCurve(QEasingCurve::InOutCubic);
  // Meshes that came meanwhile were not followed.
  connect(&d->flight, &QVariantAnimation::finished, this, [d] { d->followMesh(); });
  connect(&d->flight, &QVariantAnimation::valueChanged, this, [d](const QVariant& share) {
    d->scene->setPose(between(d->flightFrom, d->flightTo, share.toDouble()));
    d->draw(d->poseChanged);
  });
  d->sliceDelay.setSingleShot(true);
  connect(&d->sliceDelay, &QTimer::timeout, this, [d] { d->view.update(); });
  connect(&document, &Document::opened, this, [d] {
    d->startVolume();
    d->view.update();
  });
  connect(&document, &Document::frameShown, this, [d] {
    d->slices = {};
    d->draw(d->coloursChanged);
  });
  const auto seeds = [d] { d->draw(d->seedsChanged); };
  connect(&document, &Document::seedsChanged, this, seeds);
  connect(&document, &Document::resolvedChanged, this, seeds);
  connect(&state, &ViewState::markedLoopsChanged, this, [d] { d->draw(d->loopsChanged); });
  connect(&state, &ViewState::distancesChanged, this, [d] { d->draw(d->meshChanged); });
  for (auto changed : {&Document::snapshotChanged, &Document::objectsChanged})
    connect(&document, changed, this, [d] { d->draw(d->meshChanged); });
  for (auto changed : {&Document::constraintsChanged, &Document::objectsChanged})
    connect(&document, changed, this, [d] {
      d->draw(d->pinsChanged);
      d->draw(d->wallsChanged);
    });
  for (auto changed : {&Brush::changed, &Brush::strokeChanged})
    connect(&state.brush(), changed, this, [d] { d->followBrush(); });
  connect(&document, &Document::stateChanged, this, [d] {
    if (d->document.state() == GrowthState::finished) d->draw(d->meshChanged);  // it may be seen from nearer
  });
  const auto laterSlices = [d] {
    if (!d->sliceDelay.isActive()) d->sliceDelay.start(static_cast<int>(2 * d->renderTime));
  };
  connect(&state, &ViewState::changed, this, [d, laterSlices] {
    if (d->state.showsConstraints() != d->constraintsShown) {
      d->constraintsShown = d->state.showsConstraints();
      d->draw(d->pinsChanged);
      d->draw(d->wallsChanged);
    }
    if (d->state.meshColouring() != d->shownColouring) d->draw(d->meshChanged);
    if (!d->state.slicesIn3d() && !d->slicesShown) return;
    d->coloursChanged = true;
    laterSlices();
  });
  connect(&state, &ViewState::crosshairChanged, this, [d, laterSlices] {
    if (!d->state.slicesIn3d()) return;
    d->slicesChanged = true;
    laterSlices();
  });
  const auto pose = [d] {
    const bool any = d->scene && d->stage == EventStage::none && d->document.hasVolume();
    return any ? std::optional(d->scene->pose()) : std::nullopt;
  };
  installEventFilter(new SurfaceMeasuring(document, state, pose, *this));
}

//! Of the shown mesh; null: none.
const DistanceColours* SurfaceView::Private::shownDistances() const {
  const DistanceColours* d = state.distances().get();
  return d && d->mesh == document.snapshot() && isActiveVisible(document) ? d : nullptr;
}

SurfaceView::~SurfaceView() = default;

bool SurfaceView::hasOpenGl() const {
  d_->createOpenGl();
  return d_->gl != nullptr;
}

void SurfaceView::showStage(const EventTrace& trace, EventStage stage) {
  if (stage == EventStage::none) return clearStage();
  if (!hasOpenGl()) return;
  const bool first = d_->stage == EventStage::none;
  if (first)
    d_->beforeStage = d_->flight.state() == QAbstractAnimation::Running ? d_->flightTo : d_->scene->pose();
  d_->stage = stage;
  d_->scene->showStage(trace, stage);
  const std::optional<Sight> sight = ui::sightOf(trace);
  const bool there = !first && sight && d_->stageSight && sight->centre == d_->stageSight->centre;
  d_->stageSight = sight;
  if (sight && !there) {
    CameraPose pose = d_->scene->pose();
    pose.focus = sight->centre;
    pose.height = d_->heightFor(*sight, 0.95);  // a mesh fills its ball nowhere near
    pose.towardsEye = acrossFronts(trace, pose.towardsEye);
    pose.up = (pose.up - pose.up.dot(pose.towardsEye) * pose.towardsEye).normalized();
    d_->flyTo(pose);
  }
  d_->draw(d_->poseChanged);
}

void SurfaceView::clearStage() {
  if (d_->stage == EventStage::none) return;
  d_->stage = EventStage::none;
  d_->scene->showStage({}, EventStage::none);
  d_->flyTo(d_->beforeStage);
  d_->draw(d_->meshChanged);
}

void SurfaceView::resetCamera() {
  if (!hasOpenGl() || !d_->document.hasVolume()) return;
  const std::optional<Sight> sight = sightOfSurfaces(d_->document);
  CameraPose pose = d_->scene->pose();
  if (sight) {
    pose.focus = sight->centre;
    pose.height = d_->heightFor(*sight, 1.25);
  } else {
    pose = around(d_->document.volume().grid, pose, d_->aspect());
  }
  d_->follows = true;
  d_->flyTo(pose);
}

void SurfaceView::lookFrom(Plane plane, bool opposite) {
  if (!hasOpenGl()) return;
  const bool flying = d_->flight.state() == QAbstractAnimation::Running;
  d_->flyTo(lookingFrom(flying ? d_->flightTo : d_->scene->pose(), plane, opposite));
}

std::optional<StandingCamera> SurfaceView::camera() const {
  if (!d_->scene) return d_->wanted;
  if (d_->stage != EventStage::none) return StandingCamera{d_->beforeStage, d_->follows};
  const bool flying = d_->flight.state() == QAbstractAnimation::Running;
  return StandingCamera{flying ? d_->flightTo : d_->scene->pose(), d_->follows};
}

void SurfaceView::setCamera(const StandingCamera& camera) { d_->stand(camera); }

void SurfaceView::setFlightTime(int ms) { d_->flightTime = ms; }

QImage SurfaceView::picture() {
  QImage image((QSizeF(size()) * devicePixelRatioF()).toSize(), QImage::Format_RGB32);
  image.setDevicePixelRatio(devicePixelRatioF());
  QPainter painter(&image);
  d_->waitsForWalls = true;
  d_->paint(painter, devicePixelRatioF(), false);
  d_->waitsForWalls = false;
  return image;
}

QSize SurfaceView::minimumSizeHint() const { return {160, 120}; }
QSize SurfaceView::sizeHint() const { return {480, 360}; }

void SurfaceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  d_->paint(painter, devicePixelRatioF(), hasFocus());
}

}  // namespace handlebody::ui
