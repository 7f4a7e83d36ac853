#pragma once
// How long the edges of the surface may be, place by place: longer where the image shows no boundary near by.

#include <array>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/geometry/vec.h"

namespace handlebody {

//! Edge lengths in parts of the target edge length: 1 near everything that ends the object (its boundary,
//! specks of noise, thin parts, the border of the volume) and wherever nothing is known; up to kLongest in
//! its wide inside. From place to place it changes by no more than kRound times the distance, so that edges
//! side by side differ by a bounded ratio. Where it is above 1, the object goes on for more than a
//! step of that place in every direction. It is no more than kRound times the distance to the nearest start:
//! a front that comes from there is round with such edges, and longer ones would take its volume.
class SizeField {
 public:
  static constexpr double kLongest = 4;
  static constexpr double kGrade = 0.6;  //!< edge length won per length of the distance to the boundary
  static constexpr double kRound = 0.7;  //!< the longest edges of a sphere, in parts of its radius

  //! Of the part of the object that hangs together with the starts (mm) by whole cells, each of about one
  //! edge length (mm): a look at each of its voxels once, and a distance map of the cells.
  SizeField(const ObjectImage& image, const std::vector<Vec3>& starts, double edgeLength);

  //! At a world point, mm.
  double at(const Vec3& world) const;
  //! The least on a sphere.
  double leastOn(const Vec3& centre, double radius) const;
  //! The most edge lengths that a place of the object has to where its boundary may lie; 0 if nothing is
  //! known.
  double widest() const { return widest_; }
  std::size_t memory() const { return sizes_.size() * sizeof(float); }

 private:
  void keepRound(const Vec3& start, double edgeLength);

  Grid grid_;                 // of the cells in the box of that part, and one more on every side
  std::vector<float> sizes_;  // at their centres
  double widest_ = 0;         // edge lengths
};

}  // namespace handlebody
