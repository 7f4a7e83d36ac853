#pragma once
// The mesh in 3D, with the slice planes and the stages of an event on request.

#include <QWidget>
#include <memory>
#include <optional>

#include "core/surgery/event.h"
#include "ui/view/view_state.h"

namespace handlebody::ui {

class Document;
struct StandingCamera;

//! Which stage of an event is shown (the paper's Figures 1 and 7); `refined`, between colliding and opened,
//! only some events have.
enum class EventStage { none, colliding, opened, handle, closed, refined };

//! Parallel projection. Mouse: left rotates, right or wheel zooms, middle or Shift+left pans. With the brush
//! for the surface on, left does there what it is for (brush.h), and rotates beside it; Ctrl+wheel changes
//! its radius. Keys, with the focus: Home, End, PgDn look from superior, anterior, left (Shift: from the
//! other side). Until the camera is moved by hand it follows the mesh. Without a growth the seeds are shown.
class SurfaceView : public QWidget {
  Q_OBJECT

 public:
  SurfaceView(Document& document, ViewState& state, QWidget* parent = nullptr);
  ~SurfaceView() override;

  //! False if the machine gives no OpenGL; the view then says so.
  bool hasOpenGl() const;
  //! Shows a stage of an event instead of the mesh; the camera flies there unless it is shown already.
  void showStage(const EventTrace& trace, EventStage stage);
  //! The mesh again, seen as before the first stage.
  void clearStage();
  //! All of the mesh, or of the volume where there is none; follows the mesh from now on.
  void resetCamera();
  void lookFrom(Plane plane, bool opposite = false);
  //! Where the camera stands, or stood before a stage was shown. None: there is no picture yet.
  std::optional<StandingCamera> camera() const;
  //! Of the open volume; it may be asked for before there is a picture.
  void setCamera(const StandingCamera& camera);
  //! Of the camera's flights, ms; 0: it jumps. Without a call the style's (0 where the system asks for less
  //! motion).
  void setFlightTime(int ms);
  //! Picture of the view as it is shown, in device pixels, without the sign of the keyboard's focus.
  QImage picture();

  QSize minimumSizeHint() const override;
  QSize sizeHint() const override;

 Q_SIGNALS:
  void maximiseRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  struct Private;
  std::unique_ptr<Private> d_;
};

}  // namespace handlebody::ui
