#pragma once
// The mesh in 3D, with the slice planes and the stages of an event on request.

#include <QWidget>
#include <memory>

#include "core/surgery/event.h"
#include "ui/view/view_state.h"

namespace handlebody::ui {

class Document;

//! Which stage of an event is shown (the paper's Figures 1 and 7).
enum class EventStage { none, colliding, opened, handle, closed };

class SurfaceView : public QWidget {
  Q_OBJECT

 public:
  SurfaceView(Document& document, ViewState& state, QWidget* parent = nullptr);
  ~SurfaceView() override;

  //! False if the machine gives no OpenGL; the view then says so.
  bool hasOpenGl() const;
  //! Shows a stage of an event instead of the mesh; the camera flies there unless it is shown already.
  void showStage(const EventTrace& trace, EventStage stage);
  void clearStage();
  void resetCamera();
  void lookFrom(Plane plane, bool opposite = false);
  QImage picture();

 Q_SIGNALS:
  void maximiseRequested();

 private:
  struct Private;
  std::unique_ptr<Private> d_;
};

}  // namespace handlebody::ui
