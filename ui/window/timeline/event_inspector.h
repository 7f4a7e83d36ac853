#pragma once
// One change of topology in its stages: what collided, how the mesh was opened, the handle, the closed mesh
// (the paper's Figures 1 and 7).

#include <QWidget>
#include <optional>

#include "core/evolution/held_changes.h"
#include "ui/view/surface_view.h"

class QButtonGroup;
class QLabel;
class QPushButton;

namespace handlebody::ui {

class Document;
class ToggleButton;

//! "Handle inserted", "Split" …, translated.
QString eventName(EventKind kind);
//! The same, and "Held: …" for a change that was not to happen.
QString eventName(const Event& event);
//! "0 → 1", or "1" where it stays.
QString changeText(int before, int after);

class EventInspector : public QWidget {
  Q_OBJECT

 public:
  EventInspector(Document& document, SurfaceView& surface, QWidget* parent = nullptr);

  //! Index into Document::events(), or -1: none.
  void setEvent(int index);
  int event() const { return index_; }
  void showStage(EventStage stage);

 private:
  void showText();
  void receive(int index, const EventTrace& trace);
  void leaveStage();
  void followIteration();
  void explain();
  void offerConstraint();
  void constrain();
  std::optional<HeldPlace> heldHere() const;

  Document& document_;
  SurfaceView& surface_;
  QLabel *title_, *text_, *stageText_;
  QPushButton* constrain_;
  QWidget* stages_;
  QButtonGroup* stage_;
  ToggleButton* refine_;  // shown where the event has this stage
  int index_ = -1;
  EventStage wanted_ = EventStage::none;
  std::optional<EventTrace> trace_;
};

}  // namespace handlebody::ui
