#pragma once
// Finished objects as walls: how near their surfaces are, and what they enclose. The meshes themselves are
// the wall, not voxels of them, so that what keeps clear of it cannot intersect them.

#include <array>
#include <vector>

#include "core/evolution/constraints.h"
#include "core/mesh/mesh.h"

namespace handlebody {

class WallSurface {
 public:
  //! `cell`: mm, about the reach of the questions that are asked most. Precondition: every object has a mesh
  //! as WallObject says.
  WallSurface(const std::vector<WallObject>& objects, double cell);

  //! True if the place lies in an object. Exact, for places that lie on no surface.
  bool encloses(const Vec3& world) const;
  //! Index of the object that the place lies in; -1 if it lies in none.
  int objectAt(const Vec3& world) const;
  //! What is nearest to a place.
  struct Nearest {
    double distance;  //!< mm to the nearest surface, negative within an object
    //! Half of the largest normal curvature there, 1/mm: at r mm from where a plane touches the surface it
    //! lies by r² times this below the plane. 0 where the surface is hollow.
    double bulge;
  };
  //! From `limit` (mm, > 0) on a distance is told as that.
  Nearest nearest(const Vec3& world, double limit) const;
  double distance(const Vec3& world, double limit) const { return nearest(world, limit).distance; }
  //! True if the triangle has a point in common with a surface: exact. `which`, if wanted, gets the indices
  //! of the objects.
  bool meets(const Vec3& a, const Vec3& b, const Vec3& c, std::vector<int>* which = nullptr) const;
  //! True if the triangle keeps more than `clearance` (mm) from all surfaces.
  bool clears(const Vec3& a, const Vec3& b, const Vec3& c, double clearance) const;

  //! A part of a surface that hangs together.
  struct Part {
    int object = 0;       //!< index
    Vec3 place{0, 0, 0};  //!< one of its vertices
    double extent = 0;    //!< longest side of its bounding box, mm
  };
  const std::vector<Part>& parts() const { return parts_; }
  //! A vertex, within so many mm of a place, of each part that has one there.
  std::vector<Vec3> places(const Vec3& world, double within) const;

  const std::vector<Vec3>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  //! Per point, 1/mm: half of the largest curvature towards the outside. A neighbour r mm away lies by up to
  //! r² times this above the tangent plane; 0 where the surface bulges in all directions.
  const std::vector<double>& hollows() const { return hollows_; }

 private:
  using Index = std::array<int, 3>;
  struct Range {
    Index low, high;  // both included; empty if high < low
    bool isEmpty() const { return low[0] > high[0] || low[1] > high[1] || low[2] > high[2]; }
  };
  enum class Cell : unsigned char { outside, inside, surface };

  void gather(const std::vector<WallObject>& objects);
  void layOut(double cell);
  void fillCells();
  void markInside();
  void measureBulges();
  int at(const Index& c) const { return (c[2] * size_[1] + c[1]) * size_[0] + c[0]; }
  Range cellsOf(const Vec3& low, const Vec3& high) const;
  bool winds(const Vec3& p, Index cell) const;
  const Vec3& corner(int triangle, int i) const;
  //! f(triangle), once each, for those whose bounding box may meet the box.
  template <typename F>
  void forEachNear(const Vec3& low, const Vec3& high, F&& f) const;

  std::vector<Vec3> points_;
  std::vector<Triangle> triangles_;
  std::vector<int> objectOf_, partOf_;  // per triangle, per point
  std::vector<Part> parts_;
  std::vector<double> bulges_, hollows_;  // per point
  Vec3 low_{0, 0, 0}, high_{0, 0, 0};
  double cell_ = 1;
  Index size_{0, 0, 0};
  std::vector<int> first_, held_;  // which triangles a cell holds: first_[c] … first_[c + 1]
  std::vector<Range> rangeOf_;     // per triangle
  std::vector<Cell> cells_;
};

}  // namespace handlebody
