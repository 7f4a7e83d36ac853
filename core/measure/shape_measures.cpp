#include "core/measure/shape_measures.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "core/mesh/pieces.h"

namespace handlebody {

namespace {

using Matrix = Eigen::Matrix3d;

struct Moments {
  double volume = 0, area = 0;
  Vec3 first{0, 0, 0};
  Matrix second = Matrix::Zero();
};

//! Over the tetrahedra of every triangle and `origin`.
Moments momentsOf(const TriangleSoup& mesh, const Vec3& origin) {
  Moments m;
  for (const Triangle& t : mesh.triangles) {
    const auto corner = [&](std::size_t c) -> Vec3 { return mesh.points[t[c]] - origin; };
    const Vec3 a = corner(0), b = corner(1), c = corner(2), sum = a + b + c;
    const double volume = a.dot(b.cross(c)) / 6;
    m.volume += volume;
    m.area += (b - a).cross(c - a).norm() / 2;
    m.first += volume / 4 * sum;
    m.second += volume / 20 *
                (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose()).eval();
  }
  return m;
}

//! The span of the points along a direction.
double extentAlong(const std::vector<Vec3>& points, const Vec3& direction) {
  double low = direction.dot(points[0]), high = low;
  for (const Vec3& p : points) {
    const double x = direction.dot(p);
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return high - low;
}

//! Of two directions of an axis the one whose largest part is positive, so that equal bodies have equal axes.
Vec3 turned(const Vec3& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0 ? Vec3(-axis) : axis;
}

void setAxes(const Matrix& covariance, const std::vector<Vec3>& points, ShapeMeasures& m) {
  const Matrix found = Eigen::SelfAdjointEigenSolver<Matrix>(covariance).eigenvectors();
  Vec3 lengths;
  for (int a = 0; a < 3; ++a) lengths[a] = extentAlong(points, found.col(a));
  std::array<int, 3> order{2, 1, 0};  // by falling moments
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return lengths[a] > lengths[b]; });
  for (int a = 0; a < 3; ++a) {
    const int from = order[a];
    m.axes.col(a) = turned(found.col(from));
    m.extents[a] = lengths[from];
  }
}

}  // namespace

ShapeMeasures shapeMeasures(const TriangleSoup& soup) {
  const TriangleSoup mesh = withoutLoosePoints(soup);
  const Vec3 origin = mesh.points[0];  // near the body: moments about a far one cancel
  const Moments about = momentsOf(mesh, origin);
  ShapeMeasures m;
  m.volume = about.volume;
  m.area = about.area;
  const Vec3 mean = about.first / about.volume;
  m.centroid = origin + mean;
  m.largest = farthestPair(mesh.points);
  setAxes(about.second / about.volume - mean * mean.transpose(), mesh.points, m);
  for (int a = 0; a < 3; ++a) m.box[a] = extentAlong(mesh.points, Vec3::Unit(a));
  return m;
}

}  // namespace handlebody
