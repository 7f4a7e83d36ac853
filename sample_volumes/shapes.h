#pragma once
// The shapes behind the phantoms, in millimetres in the volume's own frame: 0 is the centre of the volume,
// the axes are the volume's. Spacing, size and rotation never enter here.

#include <string>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody::phantoms {

//! A hole through a wall that is perpendicular to x: a range in y and z, mm. Empty unless low < high.
struct Hole {
  double low[2] = {0, 0};
  double high[2] = {0, 0};
  bool empty() const { return !(low[0] < high[0] && low[1] < high[1]); }
};

struct Shape {
  std::string name;
  Vec3 extent{0, 0, 0};      //!< mm: the volume's own size
  Vec3 objectHalf{0, 0, 0};  //!< mm: everything dark lies within ± this
  double thinnest = 0;       //!< mm: the thinnest part that decides the topology
  Vec3 seed{0, 0, 0};        //!< mm
  double seedRadius = 0;     //!< mm
  std::vector<int> genus;    //!< per component of the surface, the largest component first
  double noise = 0.1;        //!< default standard deviation / contrast
  bool speckle = false;      //!< ultrasound speckle in place of white Gaussian noise
  double depthLoss = 0;      //!< fall of the intensity along z over the extent / contrast
  //! Signed distance to the object, mm.
  double (*distance)(const Vec3& p) = nullptr;
  //! Signed distance to what is dark, where that is more than the object; nullptr: the object.
  double (*dark)(const Vec3& p, const Hole& hole) = nullptr;
  //! Intensity outside the object / contrast (0 = object); nullptr: 1 everywhere.
  double (*brightness)(const Vec3& p) = nullptr;
};

const std::vector<Shape>& allShapes();
//! Throws UsageError for an unknown name.
const Shape& findShape(const std::string& name);

//! The body of the cyst alone, exact within 4 mm of its surface, and the needle alone.
double cystBodyDistance(const Vec3& p);
double cystNeedleDistance(const Vec3& p);
//! The cyst: its body without the needle.
double cystDistance(const Vec3& p);
//! 1, and more within the needle.
double cystBrightness(const Vec3& p);

}  // namespace handlebody::phantoms
