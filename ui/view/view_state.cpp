#include "ui/view/view_state.h"

#include <algorithm>
#include <cmath>

#include "ui/view/colour_map.h"

namespace handlebody::ui {

namespace {

// Differences of intensities and their shares of a window stay far from the ends of single precision, 1e±38.
constexpr double kMinWindow = 1e-30, kLargestIntensity = 1e30;

}  // namespace

template <typename T>
void ViewState::change(T& member, const T& value) {
  if (member == value) return;
  member = value;
  Q_EMIT changed();
}

void ViewState::setCrosshair(const Vec3& world) {
  if (crosshair_ == world) return;
  crosshair_ = world;
  Q_EMIT crosshairChanged();
}

void ViewState::setWindowLevel(double window, double level) {
  if (!std::isfinite(window) || !std::isfinite(level) || !(window > 0)) return;
  window = std::clamp(window, kMinWindow, kLargestIntensity);
  level = std::clamp(level, -kLargestIntensity, kLargestIntensity);
  if (window == window_ && level == level_) return;
  window_ = window;
  level_ = level;
  Q_EMIT changed();
}

void ViewState::setAutomaticWindow(const Volume& volume) {
  const WindowLevel automatic = windowOver(displayRange(volume));
  setWindowLevel(automatic.window, automatic.level);
}

void ViewState::startWith(const Volume& volume) {
  const Grid& grid = volume.grid;
  setTint(std::nullopt);
  markLoops({});
  for (DistancesOf whose : {DistancesOf::comparison, DistancesOf::sensitivity}) setDistances(whose, nullptr);
  brush_.startWith(grid);
  measure_.reset();
  setAutomaticWindow(volume);
  // On voxels, so that all three slices pass exactly through it.
  setCrosshair(grid.toWorld(Vec3(grid.size[0] / 2, grid.size[1] / 2, grid.size[2] / 2)));
}

void ViewState::setWindowLevelTool(bool on) { change(windowLevelTool_, on); }
void ViewState::setColourMap(ColourMap map) { change(colourMap_, map); }
void ViewState::setMeshColouring(MeshColouring colouring) { change(meshColouring_, colouring); }
void ViewState::setSlicesIn3d(bool on) { change(slicesIn3d_, on); }

void ViewState::setShowsConstraints(bool on) { change(showsConstraints_, on); }

void ViewState::setTint(std::optional<Tint> tint) { change(tint_, tint); }

void ViewState::markLoops(const std::vector<MarkedLoop>& loops) {
  if (markedLoops_ == loops) return;
  markedLoops_ = loops;
  Q_EMIT markedLoopsChanged();
}

std::shared_ptr<const DistanceColours> ViewState::distances() const {
  return distances_.empty() ? nullptr : distances_.back().second;
}

void ViewState::setDistances(DistancesOf whose, std::shared_ptr<const DistanceColours> colours) {
  const auto before = distances();
  std::erase_if(distances_, [&](const auto& entry) { return entry.first == whose; });
  if (colours) distances_.emplace_back(whose, std::move(colours));
  if (distances() != before) Q_EMIT distancesChanged();
}

int ViewState::nextGesture() {
  static int last = 0;  // of the GUI thread, for all windows: documents only compare it
  return ++last;
}

}  // namespace handlebody::ui
