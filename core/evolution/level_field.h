#pragma once
// The boundary level of the object, place by place: where gain, coil sensitivity or depth change the
// intensities smoothly, no one level fits the whole boundary.

#include <array>
#include <vector>

#include "core/volume/volume.h"

namespace handlebody {

//! A smooth scalar over the volume: values at the nodes of a coarse grid, trilinear between them.
class LevelField {
 public:
  //! The same level everywhere.
  LevelField(const Grid& grid, double level);

  //! Level at a continuous voxel index; outside of the volume that of its border.
  double at(const Vec3& index) const {
    if (values_.size() == 1) return values_[0];
    return interpolate(index);
  }
  //! a + part · (b - a), node by node.
  static LevelField between(const LevelField& a, const LevelField& b, double part);
  double lowest() const;
  double highest() const;

  //! Weighted samples of a level, gathered before they are spread.
  class Samples {
   public:
    explicit Samples(const Grid& grid);
    //! At a continuous voxel index; weight >= 0.
    void add(const Vec3& index, double level, double weight);
    bool empty() const;
    //! Weighted mean of the samples around each node: the weight of a sample falls smoothly with its distance
    //! (half at about 8 voxels) and is small but never zero far from it, so that a place without samples
    //! has the level of the nearest ones. Precondition: not empty().
    LevelField spread() const;

   private:
    friend class LevelField;
    Grid grid_;
    std::array<int, 3> nodes_;
    Vec3 perNode_;  // voxels from node to node
    std::vector<double> sum_, weight_;
  };

 private:
  LevelField() = default;
  double interpolate(const Vec3& index) const;

  std::array<int, 3> nodes_{1, 1, 1};
  Vec3 perVoxel_{0, 0, 0};  // nodes from voxel to voxel
  std::vector<double> values_;
};

}  // namespace handlebody
