#pragma once
// Internal: what of the open work the scene of the 3D view shows; a part is made anew only when it has
// changed.

#include <array>
#include <bitset>
#include <functional>
#include <optional>

#include "core/enum_index.h"
#include "core/evolution/constraints.h"
#include "core/mesh/mesh.h"
#include "ui/model/newest_result.h"
#include "ui/view/distance_colours.h"
#include "ui/view/pinned_surface.h"
#include "ui/view/slice_image.h"
#include "ui/view/surface_scene.h"

namespace handlebody::ui {

//! `colours`: of the slices.
enum class ScenePart { mesh, pins, seeds, slices, colours, walls, loops };

class SceneContent {
 public:
  //! `wallsReady` is called on another thread: there is something for takeWalls().
  SceneContent(const Document& document, const ViewState& state, std::function<void()> wallsReady);

  //! Another volume was opened, or none.
  void startVolume();
  //! Another frame of it is shown.
  void startFrame();
  void outdate(ScenePart part) { outdated_.set(indexOf(part)); }
  bool isOutdated(ScenePart part) const { return outdated_.test(indexOf(part)); }
  bool isOutdated() const { return outdated_.any(); }

  //! Makes the parts that are out of date. Walls are asked for; they come later.
  void update(SurfaceScene& scene);
  //! True if there are other walls now. `waits`: until those that were asked for are there.
  bool takeWalls(SurfaceScene& scene, bool waits);

  MeshColouring colouring() const { return colouring_; }
  bool hasPins() const { return hasPins_; }
  bool hasSlices() const { return hasSlices_; }
  //! Of the shown mesh; null: none.
  const DistanceColours* distances() const;

 private:
  void updateMesh(SurfaceScene& scene);
  void updatePins(SurfaceScene& scene);
  void updateSeeds(SurfaceScene& scene) const;
  void requestWalls();
  void updateSlices(SurfaceScene& scene);

  const Document& document_;
  const ViewState& state_;
  std::bitset<7> outdated_;
  MeshColouring colouring_ = MeshColouring::plain;
  PinnedSurface pinned_;
  bool hasPins_ = false;
  bool hasSlices_ = false;
  std::array<SliceImage, 3> slices_;
  std::array<int, 3> shownSlices_{-1, -1, -1};
  std::optional<WallList> walls_;            // asked for last
  NewestResult<TriangleSoup> wallSurfaces_;  // last: its thread calls back
};

}  // namespace handlebody::ui
