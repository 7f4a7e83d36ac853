#pragma once
// The parts of a SurfaceView. Only for surface_view*.cpp.

#include <QImage>
#include <QPainter>
#include <QTimer>

#include "ui/model/document.h"
#include "ui/view/offscreen_renderer.h"
#include "ui/view/scene_content.h"
#include "ui/view/surface_brush.h"
#include "ui/view/surface_camera.h"
#include "ui/view/surface_scene.h"
#include "ui/view/surface_view.h"

namespace handlebody::ui {

//! The stage of an event that is shown instead of the mesh.
struct ShownStage {
  EventStage stage = EventStage::none;
  std::optional<Sight> sight;
  CameraPose before;  // of the camera, to come back to

  bool isOn() const { return stage != EventStage::none; }
};

struct SurfaceView::Private {
  Private(SurfaceView& v, Document& d, ViewState& s);

  void createOpenGl();
  void startVolume();
  void connectCamera();
  void connectDocument();
  void connectState();
  void watchConstraints();
  void followMesh();
  Eye eye() const { return {camera.pose(), view.size()}; }

  const QImage& frame(double pixelRatio);
  void paint(QPainter& painter, double pixelRatio, bool focused);
  void paintOver(QPainter& painter, const QSizeF& size);
  void paintMeaning(QPainter& painter, const QSizeF& size);
  //! The scene has to be drawn again, with a part of it made anew.
  void redraw(ScenePart part);
  void redraw();
  //! The same for the slices, a little later: while they are scrolled they are not held up by this view.
  void redrawLater(ScenePart part);

  void followBrush();
  void putBrushAway();
  void tell(const QPointF& pixel, Qt::KeyboardModifiers modifiers, unsigned long event);

  SurfaceView& view;
  Document& document;
  ViewState& state;
  bool triedOpenGl = false;
  std::unique_ptr<OffscreenRenderer> gl;  // null where there is none
  std::unique_ptr<SurfaceScene> scene;
  SurfaceCamera camera;
  ShownStage stage;
  SurfaceBrush brush;
  bool dragging = false;
  QImage shown;
  bool isOld = true;      // the picture
  qint64 renderTime = 0;  // ms, of the last picture
  QTimer sliceDelay;
  bool constraintsShown = true;
  bool waitsForWalls = false;
  SceneContent content;  // last: a thread of its uses the view
};

}  // namespace handlebody::ui
