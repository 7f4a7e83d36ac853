#pragma once
// The middle of a tube from one place in it to another, and how wide it is there.

#include <optional>
#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

//! A point of the line.
struct CentreLinePoint {
  Vec3 place{0, 0, 0};
  double along = 0;              //!< mm from the beginning, on the line
  Vec3 direction{0, 0, 0};       //!< unit vector
  double radius = 0;             //!< mm, of the ball around it that fits inside
  std::optional<double> area{};  //!< mm², of the section at right angles to the line (sectionArea)

  //! mm, of the circle with the section's area; 0 without one
  double equivalentDiameter() const;
};

//! Why there is no line.
enum class CentreLineFault { none, firstOutside, secondOutside, samePlace, tooLongAndThin, noWay };

//! In English, as the end of a sentence.
const char* centreLineFaultText(CentreLineFault fault);

struct CentreLine {
  std::vector<CentreLinePoint> points;  //!< evenly spaced; none if there is no way
  double length = 0;                    //!< mm
  CentreLineFault fault = CentreLineFault::none;
};

//! From the ball that fits around `from` to the one around `to` (a click is moved away from the surface to
//! the centre of the largest ball that touches it at the same place), along the shortest way through
//! overlapping balls in which a millimetre costs 1/radius²; then every point is moved, at right angles to the
//! line, to where the largest ball fits, and the line is smoothed over about a radius by parabolas, which
//! keep bends. Precondition: closed, manifold, oriented, without self-intersections. Deterministic.
CentreLine centreLine(const TriangleSoup& mesh, const Vec3& from, const Vec3& to);

inline constexpr int kMaxLinePoints = 500;

}  // namespace handlebody
