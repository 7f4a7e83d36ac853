#pragma once
// What the image says about the level of an edge, along a line of voxels across it.

#include <optional>

#include "core/evolution/object_region.h"
#include "core/volume/smoothed_volume.h"

namespace handlebody {

//! An edge across a face between a voxel of a region and its outer neighbour. Intensities are signed: they
//! rise outwards.
struct ImageEdge {
  Vec3 place;         //!< continuous voxel index
  double level;       //!< mean of the intensities across it, weighted with the squares of the steps
  double step;        //!< the largest between neighbouring voxels
  double weight = 1;  //!< how much it is to count, 0 … 1
};

//! Reads edges at the faces of a region. All of them look from one voxel before the inner voxel to one beyond
//! the outer one: the ramp of an edge that the smoothing has left sharp. None if nothing rises there.
class EdgeReader {
 public:
  //! `sign`: +1 for a dark object, -1 for a bright one.
  EdgeReader(const SmoothedVolume& volume, double sign);

  //! Between two plateaus the half-way level, wherever the region's boundary lay in the ramp between them.
  std::optional<ImageEdge> halfWay(const ObjectRegion::Voxel& inner, const ObjectRegion::Face& face) const;

  //! The same for small and thin objects. Lines that cross the edge at a slant see less of the plateau within
  //! such an object and take the edge for a higher one: they count with the fourth power of the cosine, and
  //! `step` is as it would be along the normal. Corners, with radii below two voxels, hardly count.
  std::optional<ImageEdge> halfWayAlong(const ObjectRegion::Voxel& inner,
                                        const ObjectRegion::Face& face) const;

  //! As halfWayAlong(), but the level that the boundary itself has after the smoothing. On a curved boundary
  //! it is not the half-way one: a Gaussian moves the half-way level of an edge towards the centre of the
  //! curvature, by sigma²/2 times the sum of the principal curvatures (the heat equation along the normal),
  //! so that a tube of radius R would come out thinner by sigma²/2R and a ball smaller by sigma²/R. The
  //! boundary stayed where it was, and its level rose by what a second smoothing of the same kind adds at the
  //! half-way level: to first order half the variance times the Laplacian. The variance is that of the
  //! Gaussian and of the voxel itself.
  std::optional<ImageEdge> ofShape(const ObjectRegion::Voxel& inner, const ObjectRegion::Face& face) const;

 private:
  struct Look;
  double value(const ObjectRegion::Voxel& v) const {
    return sign_ * static_cast<double>(volume_.at(v[0], v[1], v[2]));
  }
  ObjectRegion::Voxel moved(ObjectRegion::Voxel v, std::size_t axis, int steps) const;
  std::optional<ImageEdge> read(const ObjectRegion::Voxel& inner, const ObjectRegion::Face& face,
                                double again) const;
  Look lookAt(const ObjectRegion::Voxel& v) const;

  const SmoothedVolume& volume_;
  double sign_;
  Vec3 again_;           // half the variance of the smoothing, voxels²
  double perCurvature_;  // mm · voxels: times gradient and curvature per voxel, what a second smoothing adds
};

}  // namespace handlebody
