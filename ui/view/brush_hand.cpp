#include "ui/view/brush_hand.h"

#include "ui/model/document.h"
#include "ui/view/brush.h"

namespace handlebody::ui {

bool mayBePinned(const Document& document) {
  const auto shown = document.snapshot();
  const GrowthState now = document.state();
  return shown && !shown->mesh.triangles.empty() &&
         (now == GrowthState::paused || now == GrowthState::finished) &&
         !document.objectInfo(document.activeObject()).locked;
}

bool mayBeEdited(const Document& document) {
  return mayBePinned(document) && document.snapshot()->certificate.boundsBody();
}

bool BrushHand::isReady() const {
  if (brush_.isForSurface() && !document_.objectInfo(document_.activeObject()).visible) return false;
  switch (brush_.mode()) {
    case Brush::Mode::off:
      return false;
    case Brush::Mode::paintWalls:
    case Brush::Mode::eraseWalls:
      return document_.hasVolume();
    case Brush::Mode::pin:
    case Brush::Mode::unpin:
      return mayBePinned(document_);
    default:
      return mayBeEdited(document_);
  }
}

void BrushHand::press(const Vec3& place, const Vec3& pointer) {
  isDown_ = true;
  offset_ = place - pointer;
  if (brush_.mode() == Brush::Mode::pull)
    brush_.setPull(Brush::Pull{place, place});
  else
    brush_.drawTo(place);
}

void BrushHand::drawTo(const Vec3& pointer, bool joined) {
  if (!isDown_ || !brush_.isOn() || brush_.mode() == Brush::Mode::smooth) return;
  if (brush_.mode() == Brush::Mode::pull) {
    if (brush_.pull()) brush_.setPull(Brush::Pull{brush_.pull()->from, pointer + offset_});
  } else if (joined) {
    brush_.drawTo(pointer);
  } else {
    brush_.jumpTo(pointer);
  }
}

void BrushHand::lift() {
  isDown_ = false;
  if (brush_.mode() == Brush::Mode::pull) return pull();
  const Brush::Mode mode = brush_.mode();
  const std::vector<WallBall> stroke = brush_.take();
  if (stroke.empty() || !isReady()) return;  // given up with Escape; the growth was started by a key
  if (mode == Brush::Mode::paintWalls)
    document_.paintWalls(stroke);
  else if (mode == Brush::Mode::eraseWalls)
    document_.eraseWalls(stroke);
  else if (mode == Brush::Mode::pin)
    document_.pin(stroke);
  else if (mode == Brush::Mode::unpin)
    document_.unpin(stroke);
  else if (mode == Brush::Mode::smooth)
    edit(stroke.front().centre);
}

void BrushHand::giveUp() {
  isDown_ = false;
  brush_.take();
  brush_.setPull(std::nullopt);
}

void BrushHand::edit(const Vec3& place) const {
  MeshEdit smoothing;
  smoothing.kind = MeshEditKind::smooth;
  smoothing.place = place;
  smoothing.radius = brush_.radius();
  document_.editMesh(smoothing);
}

//! A click whose mouse trembles is no pull.
void BrushHand::pull() const {
  const std::optional<Brush::Pull> pulled = brush_.pull();
  brush_.setPull(std::nullopt);
  if (!pulled || !isReady()) return;
  constexpr double kTremble = 0.1;  // voxels
  const double voxel = document_.volume().grid.meanSpacing();
  if ((pulled->to - pulled->from).norm() < kTremble * voxel) return;
  MeshEdit edit;
  edit.kind = MeshEditKind::pull;
  edit.place = pulled->from;
  edit.vector = pulled->to;
  edit.radius = brush_.radius();
  document_.editMesh(edit);
}

}  // namespace handlebody::ui
