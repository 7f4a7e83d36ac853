#pragma once
// A plane across a tube, read on rays from a point in it, and the outline of the tube in it: the closed curve
// on which intensities inside against outside, edges and what is expected agree best.

#include <array>

#include "core/object/clicks.h"
#include "core/object/region.h"

namespace handlebody {

//! Outlines are found on `kAngles` rays at `kRadii` places each, from a part of the radius to a multiple.
struct CrossSection {
  static constexpr std::size_t kAngles = 24, kRadii = 24;
  using Costs = std::array<double, kAngles * kRadii>;

  Vec3 centre{0, 0, 0}, along{0, 0, 1}, right{1, 0, 0}, up{0, 1, 0};
  double radius = 1;  //!< mm, that is expected
  std::array<float, kAngles * kRadii> values{};
  std::array<bool, kAngles * kRadii> beyond{};  //!< the image
  std::array<double, kAngles> expected{};       //!< log of the outline's radii, in parts of `radius`
  std::array<std::size_t, kAngles> last{};      //!< the outline's place on each ray
  double edge = 0;                              //!< mean along the outline, in parts of a strong one

  //! Across `along`; `right` turned as little as may be, so that neighbours have the same angles.
  static CrossSection across(const Vec3& centre, const Vec3& along, double radius, const Vec3& right);

  //! Radii of the places, in parts of the one that is expected.
  static const std::array<double, kRadii>& radii();
  Vec3 direction(std::size_t angle) const;
  //! mm, of the outline.
  double radiusAt(std::size_t angle) const { return radius * radii()[last[angle]]; }
  //! mm, of the outline at an angle between two rays, in numbers of rays.
  double radiusBetween(double angle) const;
  //! mm, of a circle as large as the outline.
  double meanRadius() const;
  //! Centre of the outline's area.
  Vec3 middle() const;
  //! Places a circle of the expected radius as the outline.
  void takeCircle();
  //! Intensities on the rays.
  void read(const WorkImage& work);
  //! How intensities fall outwards at a place, per expected radius. 0 at the ends of a ray.
  double fall(std::size_t angle, std::size_t place) const;
  //! The cheapest closed outline that bends little from ray to ray, of the costs at all places.
  void takeOutline(const Costs& costs);
};

//! What tells the inside of a tube from what is around it, and what a strong edge is.
class TubeLook {
 public:
  TubeLook() = default;
  //! Inside up to the outlines, outside in a shell around them.
  TubeLook(const std::vector<CrossSection>& sections, const ObjectPolicy& policy);

  //! Costs of an outline's end at each place. `keep`: of the squared log of what it is off the expected.
  CrossSection::Costs costs(const CrossSection& s, double keep, const ObjectPolicy& policy) const;
  //! Along the outline, in parts of a strong one.
  double edgeOf(const CrossSection& s) const;

 private:
  std::size_t binOf(float value) const;
  double edgeAt(const CrossSection& s, std::size_t angle, std::size_t place) const;

  std::vector<double> odds_;      // log, against each bin
  double low_ = 0, step_ = 1;     // of the bins
  double sign_ = 1, strong_ = 1;  // -1 if the tube is darker than what is around it; a strong edge
};

}  // namespace handlebody
