#include "ui/view/surface_view.h"

#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>

#include "ui/view/surface_measuring.h"
#include "ui/view/surface_style.h"
#include "ui/view/surface_view_private.h"

namespace handlebody::ui {

// --- scene ---

SurfaceView::Private::Private(SurfaceView& v, Document& d, ViewState& s)
    : view(v), document(d), state(s), camera(v), brush(d, s), content(d, s, [&v] {
        QMetaObject::invokeMethod(&v, qOverload<>(&QWidget::update), Qt::QueuedConnection);
      }) {}

void SurfaceView::Private::createOpenGl() {
  if (triedOpenGl) return;
  triedOpenGl = true;
  gl = std::make_unique<OffscreenRenderer>();
  if (!gl->isValid()) {
    gl.reset();
    return;
  }
  scene = std::make_unique<SurfaceScene>(gl->renderer());
  camera.setScene(*scene);
  vtkNew<SurfaceStyle> style;
  gl->interactor()->SetInteractorStyle(style);
  gl->onRenderRequest([this] { redraw(); });
  startVolume();
}

void SurfaceView::Private::startVolume() {
  const Grid* grid = document.hasVolume() ? &document.volume().grid : nullptr;
  brush.giveUp();
  content.startVolume();
  isOld = true;
  stage.stage = EventStage::none;
  if (scene) {
    scene->showStage({}, EventStage::none);
    scene->setVolume(grid);
  }
  camera.startVolume(grid);
}

void SurfaceView::Private::followMesh() {
  if (!stage.isOn()) camera.follow(document);
}

void SurfaceView::Private::redraw(ScenePart part) {
  content.outdate(part);
  view.update();
}

void SurfaceView::Private::redraw() {
  isOld = true;
  view.update();
}

void SurfaceView::Private::redrawLater(ScenePart part) {
  content.outdate(part);
  if (!sliceDelay.isActive()) sliceDelay.start(static_cast<int>(2 * renderTime));
}

// --- what it is told ---

void SurfaceView::Private::connectCamera() {
  connect(&camera, &SurfaceCamera::moved, &view, [this] { redraw(); });
  // Meshes that came meanwhile were not followed.
  connect(&camera, &SurfaceCamera::arrived, &view, [this] { followMesh(); });
}

void SurfaceView::Private::connectDocument() {
  connect(&document, &Document::opened, &view, [this] {
    startVolume();
    view.update();
  });
  connect(&document, &Document::frameShown, &view, [this] {
    content.startFrame();
    view.update();
  });
  connect(&document, &Document::activeObjectChanged, &view, [this] {
    if (brush.isDown()) brush.giveUp();
  });
  for (auto changed : {&Document::seedsChanged, &Document::resolvedChanged, &Document::objectsChanged})
    connect(&document, changed, &view, [this] { redraw(ScenePart::seeds); });
  for (auto changed : {&Document::snapshotChanged, &Document::objectsChanged})
    connect(&document, changed, &view, [this] { redraw(ScenePart::mesh); });
  for (auto changed : {&Document::constraintsChanged, &Document::objectsChanged})
    connect(&document, changed, &view, [this] {
      redraw(ScenePart::pins);
      redraw(ScenePart::walls);
    });
  connect(&document, &Document::stateChanged, &view, [this] {
    if (document.state() == GrowthState::finished) redraw(ScenePart::mesh);  // it may be seen from nearer
  });
}

void SurfaceView::Private::connectState() {
  connect(&state, &ViewState::markedLoopsChanged, &view, [this] { redraw(ScenePart::loops); });
  connect(&state, &ViewState::distancesChanged, &view, [this] { redraw(ScenePart::mesh); });
  for (auto changed : {&Brush::changed, &Brush::strokeChanged})
    connect(&state.brush(), changed, &view, [this] { followBrush(); });
  sliceDelay.setSingleShot(true);
  connect(&sliceDelay, &QTimer::timeout, &view, [this] { view.update(); });
  connect(&state, &ViewState::changed, &view, [this] {
    watchConstraints();
    if (state.meshColouring() != content.colouring()) redraw(ScenePart::mesh);
    if (state.slicesIn3d() || content.hasSlices()) redrawLater(ScenePart::colours);
  });
  connect(&state, &ViewState::crosshairChanged, &view, [this] {
    if (state.slicesIn3d()) redrawLater(ScenePart::slices);
  });
}

//! Whether they are shown at all.
void SurfaceView::Private::watchConstraints() {
  if (state.showsConstraints() == constraintsShown) return;
  constraintsShown = state.showsConstraints();
  redraw(ScenePart::pins);
  redraw(ScenePart::walls);
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
  d_->connectCamera();
  d_->connectDocument();
  d_->connectState();
  const auto pose = [d = d_.get()] {
    const bool any = d->scene && !d->stage.isOn() && d->document.hasVolume();
    return any ? std::optional(d->camera.pose()) : std::nullopt;
  };
  installEventFilter(new SurfaceMeasuring(document, state, pose, *this));
}

SurfaceView::~SurfaceView() = default;

bool SurfaceView::hasOpenGl() const {
  d_->createOpenGl();
  return d_->gl != nullptr;
}

void SurfaceView::showStage(const EventTrace& trace, EventStage stage) {
  if (stage == EventStage::none) return clearStage();
  if (!hasOpenGl()) return;
  ShownStage& shown = d_->stage;
  const bool first = !shown.isOn();
  if (first) shown.before = d_->camera.destination();
  shown.stage = stage;
  d_->scene->showStage(trace, stage);
  const std::optional<Sight> sight = ui::sightOf(trace);
  const bool there = !first && sight && shown.sight && sight->centre == shown.sight->centre;
  shown.sight = sight;
  if (sight && !there) {
    CameraPose pose = d_->camera.pose();
    pose.focus = sight->centre;
    pose.height = d_->camera.heightFor(*sight, 0.95);  // a mesh fills its ball nowhere near
    pose.towardsEye = acrossFronts(trace, pose.towardsEye);
    pose.up = (pose.up - pose.up.dot(pose.towardsEye) * pose.towardsEye).normalized();
    d_->camera.flyTo(pose);
  }
  d_->redraw();
}

void SurfaceView::clearStage() {
  if (!d_->stage.isOn()) return;
  d_->stage.stage = EventStage::none;
  d_->scene->showStage({}, EventStage::none);
  d_->camera.flyTo(d_->stage.before);
  d_->redraw(ScenePart::mesh);
}

void SurfaceView::resetCamera() {
  if (hasOpenGl() && d_->document.hasVolume()) d_->camera.seeAll(d_->document);
}

void SurfaceView::lookFrom(Plane plane, bool opposite) {
  if (hasOpenGl()) d_->camera.flyTo(lookingFrom(d_->camera.destination(), plane, opposite));
}

std::optional<StandingCamera> SurfaceView::camera() const {
  if (d_->stage.isOn()) return StandingCamera{d_->stage.before, d_->camera.follows()};
  return d_->camera.standing();
}

void SurfaceView::setCamera(const StandingCamera& camera) { d_->camera.stand(camera); }

void SurfaceView::setFlightTime(int ms) { d_->camera.setFlightTime(ms); }

QSize SurfaceView::minimumSizeHint() const { return {160, 120}; }
QSize SurfaceView::sizeHint() const { return {480, 360}; }

}  // namespace handlebody::ui
