#include "ui/view/scene_content.h"

#include <memory>
#include <utility>

#include "ui/model/document.h"
#include "ui/view/other_outlines.h"
#include "ui/view/other_surfaces.h"
#include "ui/view/view_state.h"
#include "ui/view/wall_shapes.h"

namespace handlebody::ui {

namespace {

constexpr Plane kPlanes[] = {Plane::axial, Plane::coronal, Plane::sagittal};

}  // namespace

SceneContent::SceneContent(const Document& document, const ViewState& state, std::function<void()> wallsReady)
    : document_(document), state_(state), wallSurfaces_(std::move(wallsReady)) {
  outdated_.set();
}

void SceneContent::startVolume() {
  outdated_.set();
  shownSlices_ = {-1, -1, -1};
  slices_ = {};  // the volume before is let go
  walls_.reset();
}

void SceneContent::startFrame() {
  slices_ = {};
  outdate(ScenePart::colours);
}

void SceneContent::update(SurfaceScene& scene) {
  if (isOutdated(ScenePart::mesh)) updateMesh(scene);
  if (isOutdated(ScenePart::mesh) || isOutdated(ScenePart::pins)) updatePins(scene);
  if (isOutdated(ScenePart::seeds)) updateSeeds(scene);
  if (isOutdated(ScenePart::walls)) requestWalls();
  if (isOutdated(ScenePart::loops)) scene.setLoops(state_.markedLoops());
  if (isOutdated(ScenePart::slices) || isOutdated(ScenePart::colours)) updateSlices(scene);
  outdated_.reset();
}

void SceneContent::updateMesh(SurfaceScene& scene) {
  colouring_ = state_.meshColouring();
  const bool isPale = document_.isShownOutOfDate() && colouring_ != MeshColouring::edges;
  const auto mesh = isActiveVisible(document_) ? document_.snapshot() : nullptr;
  scene.setMesh(mesh.get(), isPale ? MeshColouring::plain : colouring_,
                activeColour(document_, plainMaterial()));
  if (const DistanceColours* d = distances())
    scene.colourFaces(distancePalette(d->isSigned), paletteEntries(*d));
  scene.setOthers(otherSurfaces(document_));
}

void SceneContent::updatePins(SurfaceScene& scene) {
  const auto mesh = document_.snapshot();
  const bool shows = mesh && isActiveVisible(document_) && state_.showsConstraints();
  const auto& parts = pinned_.of(mesh, shows ? document_.shownPins() : std::vector<Pin>{});
  hasPins_ = !parts.empty();
  scene.setPinned(hasPins_ ? mesh->mesh : TriangleSoup{}, parts);
}

void SceneContent::updateSeeds(SurfaceScene& scene) const {
  std::vector<Seed> seeds;
  if (isActiveVisible(document_)) seeds = document_.shownSeeds();
  for (std::size_t i = 0; i < seeds.size(); ++i) seeds[i].radius = document_.shownRadius(static_cast<int>(i));
  scene.setSeeds(seeds);
}

void SceneContent::requestWalls() {
  const bool any = document_.hasVolume() && isActiveVisible(document_) && state_.showsConstraints();
  const WallList walls = any ? document_.shownWalls() : WallList{};
  if (walls_ == walls) return;
  if (walls.empty())
    wallSurfaces_.set(std::make_shared<const TriangleSoup>());
  else
    wallSurfaces_.request([walls, grid = document_.volume().grid] { return shapesOf(walls, grid); });
  walls_ = walls;
}

bool SceneContent::takeWalls(SurfaceScene& scene, bool waits) {
  if (waits) wallSurfaces_.finish();
  const std::shared_ptr<const TriangleSoup> made = wallSurfaces_.take();
  if (made) scene.setWalls(*made);
  return made != nullptr;
}

void SceneContent::updateSlices(SurfaceScene& scene) {
  hasSlices_ = state_.slicesIn3d() && document_.hasVolume();
  scene.showSlices(hasSlices_);
  if (!hasSlices_) return;
  const Volume& volume = document_.volume();
  for (Plane plane : kPlanes) {
    constexpr double kLargest = 512;  // pixels of a texture
    SliceGeometry geometry = wholeSlice(volume.grid, plane, kLargest);
    const QSizeF& size = geometry.size();
    geometry.setSlice(geometry.nearestSlice(state_.crosshair()));
    const std::size_t i = indexOf(plane);
    if (shownSlices_[i] == geometry.slice() && !isOutdated(ScenePart::colours)) continue;
    shownSlices_[i] = geometry.slice();
    const SliceColours colours{{state_.window(), state_.level()}, state_.colourMap(), {}};
    scene.setSlice(plane, slices_[i].render(volume, geometry, 1, colours),
                   {geometry.toWorld({0, 0}), geometry.toWorld({size.width(), 0}),
                    geometry.toWorld({0, size.height()})});
  }
}

const DistanceColours* SceneContent::distances() const {
  const DistanceColours* d = state_.distances().get();
  return d && d->mesh == document_.snapshot() && isActiveVisible(document_) ? d : nullptr;
}

}  // namespace handlebody::ui
