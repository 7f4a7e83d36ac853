#include "ui/view/pinned_surface.h"

#include <algorithm>

#include "core/evolution/painted_pins.h"
#include "ui/model/document.h"
#include "ui/view/brush.h"

namespace handlebody::ui {

namespace {

//! What was made without a growth, as for tests, tells nothing of pins.
std::vector<bool> heldOf(const MeshSnapshot& surface) {
  std::vector<bool> held = surface.pinnedVertices;
  held.resize(surface.mesh.points.size(), false);
  return held;
}

}  // namespace

std::vector<Pin> pinsWithStroke(const Document& document, const Brush& brush) {
  std::vector<Pin> pins = document.shownPins();
  const auto shown = document.snapshot();
  if (!shown || brush.stroke().empty()) return pins;
  if (brush.mode() == Brush::Mode::pin) {
    for (const WallBall& ball : brush.stroke()) pins.push_back({ball.centre, ball.radius, shown->iteration});
  } else if (brush.mode() == Brush::Mode::unpin) {
    const auto held = heldBy(pins, shown->mesh.points, heldOf(*shown), shown->iteration);
    pins = unpinned(std::move(pins), brush.stroke(), shown->mesh.points, held);
  }
  return pins;
}

const std::vector<PinnedSurface::Part>& PinnedSurface::of(const std::shared_ptr<const MeshSnapshot>& surface,
                                                          const std::vector<Pin>& pins) {
  const bool adds = surface == surface_ && pins.size() >= pins_.size() &&
                    std::equal(pins_.begin(), pins_.end(), pins.begin());
  if (adds && pins.size() == pins_.size()) return parts_;
  const std::size_t known = adds ? pins_.size() : 0;
  surface_ = surface;
  pins_ = pins;
  if (known == 0) vertices_.clear();
  parts_.clear();
  if (!surface || pins.empty()) return parts_;
  const std::vector<Pin> fresh(pins.begin() + static_cast<std::ptrdiff_t>(known), pins.end());
  const TriangleSoup& mesh = surface->mesh;
  const std::vector<bool> more = heldBy(fresh, mesh.points, heldOf(*surface), surface->iteration);
  vertices_.resize(mesh.points.size(), false);
  for (std::size_t v = 0; v < more.size(); ++v) vertices_[v] = vertices_[v] || more[v];
  if (std::find(vertices_.begin(), vertices_.end(), true) == vertices_.end()) return parts_;
  parts_.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const auto held = std::count_if(t.begin(), t.end(), [&](int v) { return vertices_[v]; });
    parts_.push_back(held == 0 ? none : held == 3 ? whole : partly);
  }
  return parts_;
}

}  // namespace handlebody::ui
