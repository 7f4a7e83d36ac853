#pragma once
// How far each vertex moves in one iteration: balloon force times image speed, plus regularisation.

#include <memory>
#include <span>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/evolution/size_field.h"
#include "core/mesh/mesh.h"

namespace handlebody {

struct MotionSettings {
  double balloon = 1;  //!< weight of the balloon force
  double curvature =
      0.2;  //!< weight of the curvature; a front of radius curvature · edgeLength / balloon stands still
  double edgeLength = 1;     //!< mm, the target
  double largestStep = 0.3;  //!< mm along the normal
  bool outwardOnly = true;
  int threads = 1;
  //! Where edges are longer than the target, steps are, and what else is said in edge lengths. Null: nowhere.
  std::shared_ptr<const SizeField> sizes{};
};

//! Displacements (mm) of the listed vertices, in the same order. Along the normal a vertex goes no further
//! than the object's boundary, as the image has it at the vertex and on the surface around
//! (normal_profile.h); a vertex outside the object goes back to it. Where the field of sizes says that none
//! is near, the image is not asked. Every vertex depends on the mesh as it is, not on the others'
//! displacements, so the result does not depend on the number of threads.
std::vector<Vec3> computeMotion(const Mesh& mesh, const ObjectImage& image, const MotionSettings& settings,
                                std::span<const int> vertices);

}  // namespace handlebody
