#pragma once
// The parts of a SurfaceView. Only for surface_view*.cpp.

#include <QImage>
#include <QPainter>
#include <QTimer>
#include <QVariantAnimation>
#include <algorithm>

#include "ui/model/document.h"
#include "ui/view/offscreen_renderer.h"
#include "ui/view/slice_image.h"
#include "ui/view/surface_brush.h"
#include "ui/view/surface_scene.h"
#include "ui/view/surface_view.h"
#include "ui/view/wall_surfaces.h"

namespace handlebody::ui {

struct SurfaceView::Private {
  Private(SurfaceView& v, Document& d, ViewState& s)
      : view(v), document(d), state(s), brush(d, s), wallSurfaces([&v] {
          QMetaObject::invokeMethod(&v, qOverload<>(&QWidget::update), Qt::QueuedConnection);
        }) {}

  void createOpenGl();
  void startVolume();
  void sync();
  const DistanceColours* shownDistances() const;
  void syncSeeds();
  void syncPins();
  void syncWalls();
  void takeWalls();
  void syncSlices();
  void followMesh();
  Eye eye() const { return {scene->pose(), view.size()}; }
  double aspect() const {
    return std::max(1, view.width()) / std::max(1.0, static_cast<double>(view.height()));
  }
  double heightFor(const Sight& sight, double margin) const;
  void flyTo(const CameraPose& pose);
  void stand(const StandingCamera& camera);
  const QImage& frame(double pixelRatio);
  void paint(QPainter& painter, double pixelRatio, bool focused);
  void paintOver(QPainter& painter, const QSizeF& size);
  void followBrush();
  void putBrushAway();
  void tell(const QPointF& pixel, Qt::KeyboardModifiers modifiers, unsigned long event);
  void draw(bool& part) {
    part = true;
    view.update();
  }

  SurfaceView& view;
  Document& document;
  ViewState& state;
  bool triedOpenGl = false;
  std::unique_ptr<OffscreenRenderer> gl;  // null where there is none
  std::unique_ptr<SurfaceScene> scene;
  QImage shown;
  bool meshChanged = true, pinsChanged = true, seedsChanged = true, slicesChanged = true,
       coloursChanged = true, poseChanged = true, wallsChanged = true, loopsChanged = true;
  std::array<SliceImage, 3> slices;
  std::array<int, 3> shownSlices{-1, -1, -1};
  bool slicesShown = false;
  MeshColouring shownColouring = MeshColouring::plain;
  SurfaceBrush brush;
  PinnedSurface pinned;
  bool hasPins = false;  // that are shown
  WallList shownWalls;
  bool wallsShown = false;
  bool constraintsShown = true;
  bool follows = true;                   // the mesh, until the camera is moved by hand
  std::optional<StandingCamera> wanted;  // asked for before there was a scene
  bool dragging = false;
  EventStage stage = EventStage::none;
  std::optional<Sight> stageSight;
  CameraPose beforeStage;
  QVariantAnimation flight;
  CameraPose flightFrom, flightTo;
  int flightTime = -1;
  QTimer sliceDelay;      // slices that are scrolled are not held up by this view
  qint64 renderTime = 0;  // ms, of the last picture
  bool waitsForWalls = false;
  WallSurfaces wallSurfaces;  // last: its thread uses the view
};

}  // namespace handlebody::ui
