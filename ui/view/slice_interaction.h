#pragma once
// What mouse and keys do in a slice.

#include <QCursor>
#include <QElapsedTimer>
#include <QPointF>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "ui/view/brush_hand.h"
#include "ui/view/colour_map.h"
#include "ui/view/seed_circles.h"
#include "ui/view/slice_geometry.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace handlebody::ui {

class Document;

//! Changes the view state, the document's seeds and the slice's zoom; the caller repaints. Precondition of
//! all events: the document has a volume. Every event function returns false if the event is not for a slice.
class SliceInteraction {
 public:
  SliceInteraction(Document& document, ViewState& state, SliceGeometry& geometry);

  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool keyPress(const QKeyEvent& event);
  //! True for a key that means more here than as a shortcut of the window: it matters how long it is held.
  static bool isOwnKey(const QKeyEvent& event);
  bool keyRelease(const QKeyEvent& event);
  //! The outline of the active surface in the slice, mm: what a pull takes hold of.
  void setOutline(std::function<const std::vector<std::array<Vec3, 2>>&()> outline);
  //! Ends what the mouse has hold of, as when the volume is replaced; a stroke of the brush is not kept.
  void cancel();
  //! Another object is active: what has hold of the one before ends, the mouse's drag and a key's.
  void leaveObject();

  //! What the mouse would do at a place, or is doing.
  QCursor cursorAt(const QPointF& pixel) const;
  std::vector<SeedCircle> circles() const;
  //! Where a brush for the surface would take hold of it, mm: on the outline near a place for a pull, else
  //! that place. None: nothing is there, or it cannot be used now.
  std::optional<Vec3> brushPlace(const QPointF& pixel) const;

 private:
  enum class Drag { none, crosshair, pan, zoom, window, moveSeed, resizeSeed, brush };

  void startLeftDrag(const QPointF& pixel);
  std::optional<Vec3> nearestOfOutline(const QPointF& pixel) const;
  bool isSeedLost() const;
  void setCrosshairAt(const QPointF& pixel);
  void moveSeedTo(const QPointF& pixel);
  void stepCrosshair(int axis, int voxels);
  void stepSlice(int slices) { stepCrosshair(geometry_.axes().normal, slices * geometry_.forward()); }
  bool arrowKey(int key, int voxels);
  bool seedKey(const QKeyEvent& event);
  void addSeed(bool outside);
  void changeRadius(double step, bool repeated);
  void windowLevelKey(bool pressed);
  Qt::CursorShape brushCursor(const QPointF& pixel) const;
  Qt::CursorShape rimCursor(const SeedGrab& grab, const QPointF& pixel) const;

  Document& document_;
  ViewState& state_;
  SliceGeometry& geometry_;
  BrushHand hand_;
  std::function<const std::vector<std::array<Vec3, 2>>&()> outline_;
  Drag drag_ = Drag::none;
  Qt::MouseButton button_ = Qt::NoButton;  // that drags
  QPointF start_, last_;
  WindowLevel startWindow_;
  QPointF seedOffset_;  // from the mouse to the centre of the seed
  int seed_ = -1, gesture_ = -1;
  std::size_t seedCount_ = 0;  // when the mouse took hold of one
  int wheelAngle_ = 0;         // what is left of a turn smaller than a notch, 1/8 degree
  const QCursor contrast_;
  QElapsedTimer toolKey_;
  bool toolWasOn_ = false, toolUsed_ = false;
};

}  // namespace handlebody::ui
