#pragma once
// The image as a force sees it: how far inside the object's intensities a point lies.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "core/evolution/level_field.h"
#include "core/evolution/neck.h"
#include "core/evolution/parameters.h"
#include "core/evolution/walls.h"
#include "core/object/object_model.h"
#include "core/object/region_field.h"
#include "core/volume/smoothed_volume.h"

namespace handlebody {

//! A region as limits: the surface lies where the levels have it, no more than `slack` mm from the region's
//! own; the less, the less the edges around a place agree on whether the image rises or falls outwards.
struct RegionLimits {
  std::shared_ptr<const RegionField> field;
  Grid levelGrid;                                   //!< of the levels' indices
  std::shared_ptr<const LevelField> low{}, high{};  //!< half-way levels of edges that fall and that rise
  std::shared_ptr<const LevelField> side{};  //!< +1 where the edges rise, -1 where they fall, mixed between
  double slack = 0;                          //!< mm
  double cell = 1;                           //!< mm
  bool mayHaveHoles = false;  //!< inwards the levels alone decide, also far from the region's surface
  //! World: next to them, and to the balls around them, the surface is the region's own, on their right side.
  std::vector<ObjectClick> clicks{};
};

//! Smoothed volume and intensity range of the object. With `levels` the range's finite end is theirs, place
//! by place (the upper end if both are finite); with `neck` the object ends there. `view` says where there is
//! no image.
//! Or a region (RegionLimits).
class ObjectImage {
 public:
  //! An object that is a region. `scale`: intensity units; `view` may be null.
  ObjectImage(std::shared_ptr<const SmoothedVolume> volume, RegionLimits region, double scale,
              std::shared_ptr<const FieldOfView> view)
      : volume_(std::move(volume)),
        scale_(positive(scale)),
        view_(std::move(view)),
        region_(std::move(region)) {}

  //! The same image where `changes` have made another region of the object: near them as this has its
  //! limits, elsewhere as before.
  ObjectImage(std::shared_ptr<const ObjectImage> before, RegionField changes, RegionLimits region)
      : volume_(before->volume_),
        scale_(before->scale_),
        view_(before->view_),
        region_(std::move(region)),
        before_(std::move(before)),
        changes_(std::make_shared<const RegionField>(std::move(changes))) {}

  ObjectImage(std::shared_ptr<const SmoothedVolume> volume, const IntensityRange& range, double scale,
              std::shared_ptr<const LevelField> levels = nullptr,
              std::shared_ptr<const NeckCut> neck = nullptr,
              std::shared_ptr<const FieldOfView> view = nullptr)
      : volume_(std::move(volume)),
        range_(range),
        scale_(positive(scale)),
        levels_(std::move(levels)),
        neck_(std::move(neck)),
        view_(std::move(view)) {
    findBounds();
  }

  //! The same object with these walls, which are outside of it; null: with none.
  std::shared_ptr<const ObjectImage> behind(std::shared_ptr<const Walls> walls) const {
    auto image = std::make_shared<ObjectImage>(*this);
    image->walls_ = std::move(walls);
    image->voxel_ = volume_->grid().meanSpacing();
    return image;
  }

  //! > 0 inside the object, 0 at its boundary, < 0 outside; 1 is `scale` intensity units from the boundary.
  //! World mm. Outside the volume, and from half a voxel beyond the centres of the border voxels on, it is
  //! negative.
  double inside(const Vec3& world) const {
    const Reading r = read(world);
    return r.limits.inside(r.intensity);
  }
  //! inside() > 0 at the centre of a voxel of the grid; walls do not count. Quick where only the intensity
  //! decides.
  bool holds(const std::array<int, 3>& voxel) const;
  //! The same for a row of `n` voxels along the first axis; 1 = held.
  void holdsRow(const std::array<int, 3>& first, int n, std::uint8_t* held) const;
  //! The same for all voxels of a box, its corners included, with the limits of an intensity as they are in
  //! its middle.
  bool holdsBox(const std::array<int, 3>& low, const std::array<int, 3>& high) const;
  //! Smoothed; outside the volume that of its border. World mm.
  double intensity(const Vec3& world) const { return volume_->sample(volume_->grid().toIndex(world)); }
  //! What makes an intensity one of the object at a place.
  struct Limits {
    double low, high;  //!< intensity
    double scale;      //!< intensity units
    double most;       //!< of inside(), whatever the intensity
    double least = -std::numeric_limits<double>::infinity();
    double inside(double intensity) const {
      return std::min(std::max(std::min((intensity - low) / scale, (high - intensity) / scale), least), most);
    }
  };
  //! The image at a place.
  struct Reading {
    double intensity;
    Limits limits;
  };
  Reading read(const Vec3& world) const;
  //! Has what inside(world) reads fetched from memory meanwhile.
  void prefetch(const Vec3& world) const { volume_->prefetch(volume_->grid().toIndex(world)); }
  //! The same without the neck or the region: what the intensities alone say.
  double insideByIntensity(const Vec3& world) const {
    const Vec3 index = volume_->grid().toIndex(world);
    return limitsWithin(index, world, false).inside(volume_->sample(index));
  }
  bool isRegion() const { return region_.field != nullptr; }
  //! True if a front that needs this much room (mm) surely comes from one place to the other; false if the
  //! object is no region, or if there are walls.
  bool reaches(const Vec3& from, const Vec3& to, double room) const {
    return isRegion() && !walls_ && region_.field->areJoined(from, to, room);
  }
  const SmoothedVolume& volume() const { return *volume_; }
  //! Null if the object is not cut off.
  const NeckCut* neck() const { return neck_.get(); }
  //! Null if the volume holds an image everywhere.
  const FieldOfView* view() const { return view_.get(); }

 private:
  //! Where the image is constant no contrast gives a unit, and any serves.
  static double positive(double scale) { return scale > 0 ? scale : 1; }
  void findBounds();
  bool holds(const std::array<int, 3>& voxel, double value) const;
  Limits limitsWithin(const Vec3& index, const Vec3& world, bool held) const;  // without the neck
  Limits limitsOfRegion(const Vec3& world, bool held, Limits limits) const;
  //! How far (mm) the levels may have the surface from the region's own, where the edges agree.
  double slackAt(const Vec3& world) const;
  //! How much of what was before counts: 0 next to changes, 1 from some cells on.
  double shareOfBefore(const Vec3& world) const;

  std::shared_ptr<const SmoothedVolume> volume_;
  IntensityRange range_{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  double scale_;  // intensity units
  std::shared_ptr<const LevelField> levels_;
  std::shared_ptr<const NeckCut> neck_;
  std::shared_ptr<const FieldOfView> view_;
  RegionLimits region_{};
  std::shared_ptr<const ObjectImage> before_{};   // what clicks have changed, and where: with a region
  std::shared_ptr<const RegionField> changes_{};  // positive there
  std::shared_ptr<const Walls> walls_{};
  double voxel_ = 1;  // mm, mean; with walls
  // Whatever the levels of the place: intensities that are of the object, and that may be; of no region.
  IntensityRange surely_{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  IntensityRange maybe_{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

}  // namespace handlebody
