#pragma once
// How strong the edge of a growing region is at each level.

#include <vector>

#include "core/evolution/reached_bricks.h"

namespace handlebody::region {

//! Of the gradients at the voxels that lie at a level. These fill a shell whose thickness is inverse to the
//! gradient: weighting them with the gradient gives the mean over the surface.
class LevelEdges {
 public:
  explicit LevelEdges(ReachedBricks& bricks);

  //! Counts the gradient at a voxel of the boundary. Beside padding an edge says nothing about the object.
  void add(Brick& brick, const Entry& entry, int level);
  //! Mean gradient over the boundary at a level; 0 where it has none.
  double of(int level) const;
  //! The same of the first `levels`, averaged over a few of them against noise.
  std::vector<double> smoothed(std::size_t levels) const;

 private:
  double squaredGradient(Brick& brick, const Entry& entry, const Voxel& at);
  double squaredGradientWithin(const Brick& brick, const Voxel& at) const;

  ReachedBricks& bricks_;
  std::vector<double> sumGradient_, sumSquared_;  // per level
};

}  // namespace handlebody::region
