#include "core/collision/closest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/geometry/triangle_distance.h"
#include "core/mesh/nesting.h"

namespace handlebody {

namespace {

//! Enough for a tree that halves 2^31 triangles: each level leaves one node waiting.
constexpr std::size_t kDeepest = 64;

double squaredToBox(const Vec3& p, const Box& box) {
  return (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0).squaredNorm();
}

//! Whether the ray from p along x may meet the box.
bool isOnRay(const Vec3& p, const Box& box) {
  return p.x() <= box.high.x() && p.y() >= box.low.y() && p.y() <= box.high.y() && p.z() >= box.low.z() &&
         p.z() <= box.high.z();
}

}  // namespace

ClosestPoint::ClosestPoint(const TriangleSoup& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  std::vector<Vec3> centres;
  centres.reserve(order_.size());
  for (const Triangle& t : mesh.triangles)
    centres.push_back(mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]);
  if (!order_.empty()) buildNode(centres, 0, static_cast<int>(order_.size()));
}

Box ClosestPoint::boxOf(int triangle) const {
  const Triangle& t = mesh_.triangles[triangle];
  const Vec3 &a = mesh_.points[t[0]], &b = mesh_.points[t[1]], &c = mesh_.points[t[2]];
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

//! Halves at the median along the longest axis, so the depth is at most log2 of the number of triangles.
int ClosestPoint::buildNode(std::vector<Vec3>& centres, int first, int last) {
  const int node = static_cast<int>(nodes_.size());
  Box all = boxOf(order_[first]);
  for (int i = first + 1; i < last; ++i) {
    const Box b = boxOf(order_[i]);
    all = {all.low.cwiseMin(b.low), all.high.cwiseMax(b.high)};
  }
  nodes_.push_back({all, first, last, 0});
  if (last - first <= kLeafSize) return node;
  Eigen::Index axis = 0;
  (all.high - all.low).maxCoeff(&axis);
  const int middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](int i, int j) { return centres[i][axis] < centres[j][axis]; });
  buildNode(centres, first, middle);
  const int right = buildNode(centres, middle, last);
  nodes_[node].right = right;
  return node;
}

double ClosestPoint::squaredTo(const Vec3& p, int triangle) const {
  const Triangle& t = mesh_.triangles[triangle];
  return squaredDistance(p, mesh_.points[t[0]], mesh_.points[t[1]], mesh_.points[t[2]]);
}

double ClosestPoint::distance(const Vec3& p, int* hint) const {
  if (nodes_.empty()) return std::numeric_limits<double>::infinity();
  int nearest = hint && *hint >= 0 ? *hint : order_[0];
  double best = squaredTo(p, nearest);
  struct Waiting {
    int node;
    double squared;
  };
  std::array<Waiting, kDeepest> stack;
  std::size_t size = 0;
  stack[size++] = {0, squaredToBox(p, nodes_[0].box)};
  while (size > 0) {
    const Waiting w = stack[--size];
    if (!(w.squared < best)) continue;
    const Node& node = nodes_[w.node];
    if (node.right == 0) {
      for (int i = node.first; i < node.last; ++i) {
        const int triangle = order_[i];
        if (!(squaredToBox(p, boxOf(triangle)) < best)) continue;  // cheaper than the distance
        if (const double squared = squaredTo(p, triangle); squared < best) {
          best = squared;
          nearest = triangle;
        }
      }
      continue;
    }
    Waiting near{w.node + 1, squaredToBox(p, nodes_[w.node + 1].box)};
    Waiting far{node.right, squaredToBox(p, nodes_[node.right].box)};
    if (far.squared < near.squared) std::swap(near, far);
    stack[size++] = far;
    stack[size++] = near;
  }
  if (hint) *hint = nearest;
  return std::sqrt(best);
}

int ClosestPoint::windingNumber(const Vec3& p) const {
  if (nodes_.empty()) return 0;
  int winding = 0;
  std::array<int, kDeepest> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const int at = stack[--size];
    const Node& node = nodes_[at];
    if (!isOnRay(p, node.box)) continue;
    if (node.right != 0) {
      stack[size++] = node.right;
      stack[size++] = at + 1;
      continue;
    }
    for (int i = node.first; i < node.last; ++i) {
      const Triangle& t = mesh_.triangles[order_[i]];
      winding += crossing(mesh_.points[t[0]], mesh_.points[t[1]], mesh_.points[t[2]], p);
    }
  }
  return winding;
}

}  // namespace handlebody
