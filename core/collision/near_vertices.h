#pragma once
// Which vertices at rest are near enough to an active one that their faces may meet.

#include <vector>

#include "core/collision/detection_workspace.h"
#include "core/collision/near_points.h"
#include "core/collision/vertex_levels.h"

namespace handlebody {

//! Keeps its tables.
class NearVertices {
 public:
  //! Adds to work.vertices, which are the active ones, measured, the vertices at rest that one of them can
  //! reach, and some others; measures their stars, and the longest edge of all. Precondition: not work.all.
  void add(DetectionWorkspace& work);

 private:
  double measureFaces(const DetectionWorkspace& work);
  void addOfLevels(DetectionWorkspace& work);

  NearPoints near_;
  NearLevels nearLevels_;
  std::vector<double> longest_;     // per face: squared longest edge
  std::vector<double> mostAround_;  // per vertex: squared longest edge of its faces, opposite ones included
};

}  // namespace handlebody
