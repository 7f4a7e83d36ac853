#pragma once
// The object that an image shows around clicks, as points on a grid, and what a surface has in common with
// it.

#include <vector>

#include "core/evolution/object_image.h"
#include "core/mesh/mesh.h"
#include "core/mesh/topology.h"

namespace handlebody {

//! The points of a grid that lie in the object and are joined to a click by others of them.
class ShownObject {
 public:
  //! `places`: where the clicks are; a place outside of the object adds nothing. The grid's points are
  //! voxels, at most half an edge length apart where voxels allow it.
  ShownObject(const ObjectImage& image, const std::vector<Vec3>& places, double edgeLength);
  const Grid& grid() const { return grid_; }
  bool holds(int i, int j, int k) const { return inside_[at(i, j, k)]; }

 private:
  std::size_t at(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(grid_.size[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(grid_.size[0]) +
           static_cast<std::size_t>(i);
  }
  void flood(const ObjectImage& image, const std::vector<Vec3>& places);

  Grid grid_;
  std::vector<bool> inside_;
};

//! Points of the object's grid that a component encloses, and how many of them the object holds.
struct Enclosed {
  double all = 0;
  double common = 0;
  std::vector<Vec3> samples;  //!< some of the common ones, world mm
};

//! Per component; what lies within a cavity is enclosed by the cavity's surface and by the one around it.
std::vector<Enclosed> enclosedBy(const Mesh& mesh, const Components& parts, const ShownObject& object);

}  // namespace handlebody
