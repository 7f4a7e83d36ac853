#pragma once
// Independent answers by CGAL's exact arithmetic (a test-only dependency, kept out of every other program).

#include <memory>
#include <vector>

#include "core/collision/self_intersection.h"
#include "core/mesh/mesh.h"

namespace handlebody::oracle {

//! Polygon_mesh_processing::self_intersections. Precondition: an oriented manifold without degenerate faces;
//! throws std::invalid_argument if it is not one.
std::vector<FacePair> selfIntersections(const TriangleSoup& soup);

//! The same with the mesh built ahead, so that its construction is not timed.
class PreparedMesh {
 public:
  explicit PreparedMesh(const TriangleSoup& soup);
  ~PreparedMesh();
  std::size_t countSelfIntersections() const;
  std::vector<FacePair> selfIntersections() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

//! By definition, for any triangles: constructs the intersection of two faces exactly, as the point sets they
//! are, and looks whether it lies within the vertex or edge they share by index.
bool facesIntersect(const TriangleSoup& soup, const Triangle& a, const Triangle& b);

//! All pairs with facesIntersect: quadratic.
std::vector<FacePair> selfIntersectionsByDefinition(const TriangleSoup& soup);

//! Signs by CGAL's exact kernel.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int axis);

}  // namespace handlebody::oracle
