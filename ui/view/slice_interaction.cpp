#include "ui/view/slice_interaction.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/geometry/closest_points.h"
#include "ui/model/document.h"
#include "ui/view/other_outlines.h"

namespace handlebody::ui {
namespace {

constexpr double kZoomPixels = 150;  // of a drag that zooms by a factor of e
constexpr double kZoomNotch = 1.2;
constexpr double kClickReach = 14;  // pixels from the outline at which a pull takes hold of it
constexpr int kNotch = 120;         // Qt's angle of one notch of a wheel
// Keys with them are not a slice's.
constexpr auto kOthers = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;

//! Half black, half white, as on a monitor's contrast knob.
QCursor contrastCursor() {
  QPixmap picture(24, 24);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Qt::black, 3));
  painter.setBrush(Qt::black);
  painter.drawEllipse(4, 4, 16, 16);
  painter.setPen(QPen(Qt::white, 1.5));
  painter.drawEllipse(4, 4, 16, 16);
  painter.setBrush(Qt::white);
  painter.drawPie(4, 4, 16, 16, 90 * 16, 180 * 16);
  return QCursor(picture, 12, 12);
}

}  // namespace

SliceInteraction::SliceInteraction(Document& document, ViewState& state, SliceGeometry& geometry)
    : document_(document),
      state_(state),
      geometry_(geometry),
      hand_(document, state.brush()),
      contrast_(contrastCursor()) {}

std::vector<SeedCircle> SliceInteraction::circles() const {
  if (!isActiveVisible(document_)) return {};
  std::vector<Vec3> centres;
  std::vector<double> radii;
  // A little more than half a slice: a ball between two of them is on one at least.
  constexpr double kAlmost = 1 + 1e-9;
  const double reach = kAlmost * geometry_.grid().spacing[geometry_.axes().normal] / 2;
  for (const Seed& seed : document_.shownSeeds()) {
    radii.push_back(document_.shownRadius(static_cast<int>(centres.size())));
    centres.push_back(seed.centre);
  }
  std::vector<SeedCircle> circles = seedCircles(geometry_, centres, radii, reach);
  for (SeedCircle& circle : circles) circle.outside = document_.shownSeeds()[circle.seed].background;
  return circles;
}

// --- mouse ---

bool SliceInteraction::press(const QMouseEvent& event) {
  if (drag_ != Drag::none && event.button() != button_ && (event.buttons() & button_)) return true;
  cancel();  // what was held by a button whose release came to nobody
  button_ = event.button();
  start_ = last_ = event.position();
  const bool shift = event.modifiers() & Qt::ShiftModifier;
  if (event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && shift))
    drag_ = Drag::pan;
  else if (event.button() == Qt::RightButton)
    drag_ = Drag::zoom;
  else if (event.button() == Qt::LeftButton)
    startLeftDrag(start_);
  else
    return false;
  return true;
}

void SliceInteraction::startLeftDrag(const QPointF& pixel) {
  if (state_.windowLevelTool()) {
    drag_ = Drag::window;
    startWindow_ = {state_.window(), state_.level()};
    toolUsed_ = true;
    return;
  }
  if (state_.brush().isOn()) {
    const std::optional<Vec3> place = brushPlace(pixel);
    if (!place) return;
    drag_ = Drag::brush;
    hand_.press(*place, geometry_.toWorld(pixel), geometry_.grid().direction.col(geometry_.axes().normal));
    return;
  }
  const SeedGrab grab = seedAt(circles(), pixel, document_.selectedSeed());
  if (grab.part == SeedGrab::Part::none) {
    drag_ = Drag::crosshair;
    setCrosshairAt(pixel);
    return;
  }
  seed_ = grab.seed;
  seedCount_ = document_.seeds().size();
  gesture_ = ViewState::nextGesture();
  document_.selectSeed(seed_);
  drag_ = grab.part == SeedGrab::Part::rim ? Drag::resizeSeed : Drag::moveSeed;
  const Vec3& centre = document_.seeds()[seed_].centre;
  seedOffset_ = geometry_.worldToScreen(centre) - pixel;
}

//! It may be deleted by a key, or by undoing, while the mouse has hold of it; another one may have its place.
bool SliceInteraction::isSeedLost() const {
  return (drag_ == Drag::moveSeed || drag_ == Drag::resizeSeed) && document_.seeds().size() != seedCount_;
}

bool SliceInteraction::move(const QMouseEvent& event) {
  if (isSeedLost()) cancel();
  const QPointF pixel = event.position(), step = pixel - last_, all = pixel - start_;
  last_ = pixel;
  switch (drag_) {
    case Drag::none:
      return false;
    case Drag::crosshair:
      setCrosshairAt(pixel);
      break;
    case Drag::pan:
      geometry_.pan(step);
      break;
    case Drag::zoom:
      geometry_.zoom(std::exp(-step.y() / kZoomPixels), start_);
      break;
    case Drag::window: {
      const WindowLevel next = draggedWindow(startWindow_, all.x(), all.y());
      state_.setWindowLevel(next.window, next.level);
      break;
    }
    case Drag::brush:
      hand_.drawTo(geometry_.toWorld(pixel));
      break;
    case Drag::moveSeed:
      moveSeedTo(pixel + seedOffset_);
      break;
    case Drag::resizeSeed: {
      const double least = geometry_.grid().spacing.minCoeff();
      const Vec3 centre = document_.seeds()[seed_].centre;
      document_.setSeedRadius(seed_, std::max(least, draggedRadius(geometry_, centre, pixel)), gesture_);
      break;
    }
  }
  return true;
}

bool SliceInteraction::release(const QMouseEvent& event) {
  if (drag_ != Drag::none && event.button() != button_) return true;
  const bool wasDragging = drag_ != Drag::none;
  if (drag_ == Drag::brush) hand_.lift();
  // A click on a seed that drags nothing is a click: the crosshair goes there as anywhere else.
  if ((drag_ == Drag::moveSeed || drag_ == Drag::resizeSeed) && last_ == start_) setCrosshairAt(start_);
  cancel();
  return wasDragging;
}

void SliceInteraction::setOutline(std::function<const std::vector<std::array<Vec3, 2>>&()> outline) {
  outline_ = std::move(outline);
}

std::optional<Vec3> SliceInteraction::brushPlace(const QPointF& pixel) const {
  if (!hand_.isReady()) return std::nullopt;
  return state_.brush().mode() == Brush::Mode::pull ? nearestOfOutline(pixel)
                                                    : std::optional(geometry_.toWorld(pixel));
}

std::optional<Vec3> SliceInteraction::nearestOfOutline(const QPointF& pixel) const {
  if (!outline_) return std::nullopt;
  const Vec3 place = geometry_.toWorld(pixel);
  double least = kClickReach * geometry_.mmPerPixel();
  std::optional<Vec3> nearest;
  for (const auto& [from, to] : outline_()) {
    const Vec3 on = closestPoint(place, {from, to, to});
    if (const double distance = (on - place).norm(); distance <= least) {
      least = distance;
      nearest = on;
    }
  }
  return nearest;
}

void SliceInteraction::cancel() {
  if (drag_ == Drag::brush) hand_.giveUp();
  drag_ = Drag::none;
  seed_ = -1;
}

void SliceInteraction::leaveObject() {
  gesture_ = ViewState::nextGesture();
  if (drag_ == Drag::moveSeed || drag_ == Drag::resizeSeed || drag_ == Drag::brush) cancel();
}

void SliceInteraction::setCrosshairAt(const QPointF& pixel) {
  state_.setCrosshair(geometry_.grid().toWorld(geometry_.clamped(geometry_.toIndex(pixel))));
}

//! Within the slice: how far the seed lies from it stays.
void SliceInteraction::moveSeedTo(const QPointF& pixel) {
  const Grid& grid = geometry_.grid();
  const int normal = geometry_.axes().normal;
  Vec3 index = geometry_.clamped(geometry_.toIndex(pixel));
  index[normal] = grid.toIndex(document_.seeds()[seed_].centre)[normal];
  document_.moveSeed(seed_, grid.toWorld(index), gesture_);
}

bool SliceInteraction::wheel(const QWheelEvent& event) {
  wheelAngle_ += event.angleDelta().y();
  const int notches = wheelAngle_ / kNotch;
  if ((event.modifiers() & Qt::ControlModifier) && state_.brush().isOn()) {
    wheelAngle_ = 0;
    const double turned = event.angleDelta().y() / static_cast<double>(kNotch);
    state_.brush().turnWheel(turned);
  } else if (event.modifiers() & Qt::ControlModifier) {
    wheelAngle_ = 0;
    geometry_.zoom(std::pow(kZoomNotch, event.angleDelta().y() / static_cast<double>(kNotch)),
                   event.position());
  } else if (notches != 0) {
    wheelAngle_ -= notches * kNotch;
    stepSlice(notches * (event.modifiers() & Qt::ShiftModifier ? 5 : 1));
  }
  return true;
}

// --- keys ---

void SliceInteraction::stepCrosshair(int axis, int voxels) {
  const Grid& grid = geometry_.grid();
  Vec3 index = grid.toIndex(state_.crosshair());
  // From the slice that is shown, so that every step shows the next one.
  if (axis == geometry_.axes().normal) index[axis] = geometry_.slice();
  index[axis] += voxels;
  state_.setCrosshair(grid.toWorld(geometry_.clamped(index)));
}

bool SliceInteraction::arrowKey(int key, int voxels) {
  const SliceAxes& axes = geometry_.axes();
  const int right = voxels * static_cast<int>(axes.acrossSign),
            down = voxels * static_cast<int>(axes.downSign);
  switch (key) {
    case Qt::Key_Left:
      stepCrosshair(axes.across, -right);
      return true;
    case Qt::Key_Right:
      stepCrosshair(axes.across, right);
      return true;
    case Qt::Key_Up:
      stepCrosshair(axes.down, -down);
      return true;
    case Qt::Key_Down:
      stepCrosshair(axes.down, down);
      return true;
    case Qt::Key_PageUp:
      stepSlice(voxels);
      return true;
    case Qt::Key_PageDown:
      stepSlice(-voxels);
      return true;
    default:
      return false;
  }
}

bool SliceInteraction::isOwnKey(const QKeyEvent& event) {
  return event.key() == Qt::Key_W && !(event.modifiers() & (kOthers | Qt::ShiftModifier));
}

bool SliceInteraction::keyPress(const QKeyEvent& event) {
  if (event.modifiers() & kOthers) return false;
  if (arrowKey(event.key(), event.modifiers() & Qt::ShiftModifier ? 5 : 1)) return true;
  if (seedKey(event)) return true;
  if (event.key() == Qt::Key_W) {
    if (!event.isAutoRepeat()) windowLevelKey(true);
    return true;
  }
  if (event.key() == Qt::Key_Escape && state_.windowLevelTool()) {
    state_.setWindowLevelTool(false);
    return true;
  }
  if (event.key() == Qt::Key_Escape && state_.brush().isOn()) {
    if (!hand_.isDown()) state_.brush().setMode(Brush::Mode::off);
    hand_.giveUp();
    drag_ = Drag::none;
    return true;
  }
  return false;
}

bool SliceInteraction::keyRelease(const QKeyEvent& event) {
  if (event.key() != Qt::Key_W || event.isAutoRepeat() || !toolKey_.isValid()) return false;
  windowLevelKey(false);
  return true;
}

//! A short press switches the tool; while the key is held down it is on, and after that as before.
void SliceInteraction::windowLevelKey(bool pressed) {
  constexpr qint64 kShortPress = 400;  // ms
  if (pressed) {
    toolWasOn_ = state_.windowLevelTool();
    toolUsed_ = false;
    toolKey_.start();
    state_.setWindowLevelTool(true);
    return;
  }
  const bool held = toolUsed_ || toolKey_.elapsed() > kShortPress;
  state_.setWindowLevelTool(held ? toolWasOn_ : !toolWasOn_);
  toolKey_.invalidate();
}

bool SliceInteraction::seedKey(const QKeyEvent& event) {
  const double step = geometry_.grid().spacing.minCoeff() / 2;
  switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (!event.isAutoRepeat()) addSeed(event.modifiers() & Qt::ShiftModifier);
      return true;
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
      if (document_.selectedSeed() >= 0) document_.removeSeed(document_.selectedSeed());
      return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:  // + without Shift on many keyboards
      changeRadius(step, event.isAutoRepeat());
      return true;
    case Qt::Key_Minus:
      changeRadius(-step, event.isAutoRepeat());
      return true;
    default:
      return false;
  }
}

void SliceInteraction::addSeed(bool outside) {
  document_.addSeed({state_.crosshair(), {}, outside});
  document_.selectSeed(static_cast<int>(document_.seeds().size()) - 1);
}

//! A key that is held down is one change to undo.
void SliceInteraction::changeRadius(double step, bool repeated) {
  const int seed = document_.selectedSeed();
  if (seed < 0) return;
  if (!repeated) gesture_ = ViewState::nextGesture();
  const double least = geometry_.grid().spacing.minCoeff();
  document_.setSeedRadius(seed, std::max(least, document_.shownRadius(seed) + step), gesture_);
}

// --- cursor ---

Qt::CursorShape SliceInteraction::rimCursor(const SeedGrab& grab, const QPointF& pixel) const {
  const Vec3& centre = document_.seeds()[grab.seed].centre;
  const double angle = QLineF(geometry_.worldToScreen(centre), pixel).angle();  // degrees, counter-clockwise
  constexpr Qt::CursorShape kShapes[] = {Qt::SizeHorCursor, Qt::SizeBDiagCursor, Qt::SizeVerCursor,
                                         Qt::SizeFDiagCursor};
  return kShapes[static_cast<int>(std::lround(angle / 45)) % 4];
}

Qt::CursorShape SliceInteraction::brushCursor(const QPointF& pixel) const {
  if (!hand_.isReady()) return Qt::ForbiddenCursor;
  if (state_.brush().mode() != Brush::Mode::pull) return Qt::CrossCursor;
  if (drag_ == Drag::brush) return Qt::ClosedHandCursor;
  return brushPlace(pixel) ? Qt::OpenHandCursor : Qt::CrossCursor;
}

QCursor SliceInteraction::cursorAt(const QPointF& pixel) const {
  if (drag_ == Drag::pan) return Qt::ClosedHandCursor;
  if (drag_ == Drag::zoom) return Qt::SizeVerCursor;
  if (drag_ == Drag::moveSeed) return Qt::SizeAllCursor;
  if (state_.windowLevelTool()) return contrast_;
  if (state_.brush().isOn()) return brushCursor(pixel);
  if (drag_ == Drag::resizeSeed && !isSeedLost()) return rimCursor({SeedGrab::Part::rim, seed_}, pixel);
  if (drag_ == Drag::crosshair) return Qt::CrossCursor;
  const SeedGrab grab = seedAt(circles(), pixel, document_.selectedSeed());
  if (grab.part == SeedGrab::Part::rim) return rimCursor(grab, pixel);
  if (grab.part == SeedGrab::Part::centre) return Qt::SizeAllCursor;
  return Qt::CrossCursor;
}

}  // namespace handlebody::ui
