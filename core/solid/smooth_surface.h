#pragma once
// Internal: the smooth surface that the voxels of an object mean.

#include <vector>

#include "core/collision/closest_point.h"
#include "core/mesh/mesh.h"
#include "core/solid/blurred_mask.h"
#include "core/solid/mask.h"

namespace handlebody {

//! Voxels: how far a vertex may go between two looks at the edges. What is thin would draw back without end.
struct VertexReach {
  double along;  //!< the normal
  double any;    //!< in any direction
};

//! A continuous index midway between two voxels.
bool isCrossing(const Vec3& index);

//! Where the blurred mask has the mean value that it has around there on
//! the surface between the voxels. Half way on a plane; on what is thin or curved, another one, so that it
//! keeps its size.
class SmoothSurface {
 public:
  //! `surface`: the maskSurface. `sigma`: of the blur, voxels.
  SmoothSurface(const Mask& mask, const TriangleSoup& surface, const Vec3& sigma);
  SmoothSurface(const SmoothSurface&) = delete;
  SmoothSurface& operator=(const SmoothSurface&) = delete;

  //! Where a vertex is, and what it is to do.
  struct VertexAim {
    Vec3 from, to;      //!< mm
    Vec3 normal;        //!< of the mesh, of any length
    double offset;      //!< mm, outside of the surface that is meant
    Vec3 anchor;        //!< mm
    VertexReach reach;  //!< from there
  };

  //! From `to` towards the surface. Never farther than kMaxMove from the voxels' surface, and only to where
  //! that faces the same way: else what is as thin as a voxel would draw back along itself.
  Vec3 towards(const VertexAim& place, int& hint) const;
  //! From the voxels' surface, in voxels.
  double distance(const Vec3& p) const { return nearest_.distance(grid_.toIndex(p)); }

 private:
  Vec3 normalInVoxels(const Vec3& normal) const;
  bool facesLike(const Vec3& normal, int triangle) const;
  Vec3 step(const Vec3& index, double level) const;
  double firstLevel(const Mesh& mesh, int v) const;
  Vec3 outwards(const Vec3& index, double offset) const;
  std::vector<double> meanLevels(const Mesh& mesh) const;

  Grid grid_;
  BlurredMask blurred_;
  TriangleSoup inVoxels_;
  ClosestPoint nearest_;
  std::vector<double> levels_;
};

}  // namespace handlebody
