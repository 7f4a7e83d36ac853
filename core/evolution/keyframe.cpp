#include "core/evolution/keyframe.h"

#include "core/evolution/contour_state.h"

namespace handlebody {

Keyframe::Keyframe(const ActiveContour& contour, const Keyframe* before)
    : bare_(contour), mesh_(contour.mesh(), before ? &before->mesh_ : nullptr) {
  bare_.state_->mesh = Mesh();
}

ActiveContour Keyframe::contour() const {
  ActiveContour out = bare_;
  out.state_->mesh = mesh_.mesh();
  return out;
}

std::size_t Keyframe::memoryBeside(const Keyframe* before) const {
  return bare_.memory() + mesh_.memoryBeside(before ? &before->mesh_ : nullptr);
}

}  // namespace handlebody
