#include "ui/view/brush_hand.h"

#include <Eigen/Geometry>

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

namespace {

//! What is dragged is an arrow or a line, no stroke.
bool isLine(Brush::Mode mode) { return mode == Brush::Mode::pull || mode == Brush::Mode::cut; }

}  // namespace

void BrushHand::press(const Vec3& place, const Vec3& pointer, const Vec3& sight) {
  isDown_ = true;
  offset_ = place - pointer;
  sight_ = sight;
  if (isLine(brush_.mode()))
    brush_.setPull(Brush::Pull{place, place});
  else
    brush_.drawTo(place);
}

void BrushHand::drawTo(const Vec3& pointer, bool joined) {
  if (!isDown_ || !brush_.isOn() || brush_.mode() == Brush::Mode::smooth) return;
  if (isLine(brush_.mode())) {
    if (brush_.pull()) brush_.setPull(Brush::Pull{brush_.pull()->from, pointer + offset_});
  } else if (joined) {
    brush_.drawTo(pointer);
  } else {
    brush_.jumpTo(pointer);
  }
}

void BrushHand::lift() {
  isDown_ = false;
  if (isLine(brush_.mode())) return pull();
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

//! Of the sections of the plane through the line those that come between its ends, or hold its middle; both
//! parts stay.
void BrushHand::cut(const Vec3& from, const Vec3& to) const {
  MeshEdit edit;
  edit.kind = MeshEditKind::cut;
  edit.place = (from + to) / 2;
  edit.vector = (to - from).cross(sight_).normalized();
  edit.radius = (to - from).norm() / 2;
  document_.editMesh(edit);
}

//! A click whose mouse trembles is neither a pull nor a cut.
void BrushHand::pull() const {
  const std::optional<Brush::Pull> pulled = brush_.pull();
  brush_.setPull(std::nullopt);
  if (!pulled || !isReady()) return;
  constexpr double kTremble = 0.1;  // voxels
  const double voxel = document_.volume().grid.meanSpacing();
  if ((pulled->to - pulled->from).norm() < kTremble * voxel) return;
  if (brush_.mode() == Brush::Mode::cut) return cut(pulled->from, pulled->to);
  MeshEdit edit;
  edit.kind = MeshEditKind::pull;
  edit.place = pulled->from;
  edit.vector = pulled->to;
  edit.radius = brush_.radius();
  document_.editMesh(edit);
}

}  // namespace handlebody::ui
