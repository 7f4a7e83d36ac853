// The picture of the 3D view: the scene, and what is painted over it.

#include <QElapsedTimer>

#include "ui/view/distance_colours.h"
#include "ui/view/measure_overlay.h"
#include "ui/view/overlay.h"
#include "ui/view/surface_overlay.h"
#include "ui/view/surface_view_private.h"

namespace handlebody::ui {

namespace {

const QColor kFrame(0x74, 0x83, 0xe6);

}  // namespace

const QImage& SurfaceView::Private::frame(double pixelRatio) {
  if (content.isOutdated()) isOld = true;
  const bool isMeshNew = content.isOutdated(ScenePart::mesh);
  content.update(*scene);
  if (isMeshNew) followMesh();
  if (content.takeWalls(*scene, waitsForWalls)) isOld = true;
  const QSize size = (QSizeF(view.size()) * pixelRatio).toSize();
  if (!isOld && shown.size() == size) return shown;
  QElapsedTimer timer;
  timer.start();
  scene->setPixelRatio(pixelRatio);
  scene->fitDepth();
  shown = gl->render(size, pixelRatio);
  shown.setDevicePixelRatio(pixelRatio);
  isOld = false;
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
  const CameraPose pose = camera.pose();
  const bool empty = !document.hasVolume();
  if (empty) {
    paintHint(painter, size, tr("The surface grows here"));
  } else {
    if (!stage.isOn()) paintMeasurements(painter, size, pose, document, state.measure());
    paintTriad(painter, size, pose);
    paintScaleBar(painter, size, pose.height / std::max(1.0, size.height()));
  }
  const std::shared_ptr<const MeshSnapshot> mesh = document.snapshot();
  if (mesh && mesh->mesh.triangles.empty())
    paintText(painter, {size.width() / 2, kOverlayMargin}, Qt::AlignHCenter | Qt::AlignTop,
              tr("Nothing is left of the surface"), overlayFont());
  if (stage.isOn()) return paintStageCaption(painter, stage.stage);
  paintMeaning(painter, size);
  if (!empty) brush.paint(painter, eye());
}

//! Of the colours of the mesh.
void SurfaceView::Private::paintMeaning(QPainter& painter, const QSizeF& size) {
  const std::shared_ptr<const MeshSnapshot> mesh = document.snapshot();
  const bool isCurrent = !document.isShownOutOfDate();
  if (const DistanceColours* d = content.distances())
    paintDistanceScale(painter, size, *d);
  else if (mesh && isCurrent && state.meshColouring() == MeshColouring::state)
    paintStateLegend(painter);
  else if (mesh && isCurrent && !mesh->mesh.triangles.empty() &&
           state.meshColouring() == MeshColouring::support)
    paintSupportLegend(painter, size, *mesh);
  if (content.hasPins()) paintPinLegend(painter, size);
}

QImage SurfaceView::picture() {
  QImage image((QSizeF(size()) * devicePixelRatioF()).toSize(), QImage::Format_RGB32);
  image.setDevicePixelRatio(devicePixelRatioF());
  QPainter painter(&image);
  d_->waitsForWalls = true;
  d_->paint(painter, devicePixelRatioF(), false);
  d_->waitsForWalls = false;
  return image;
}

void SurfaceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  d_->paint(painter, devicePixelRatioF(), hasFocus());
}

}  // namespace handlebody::ui
