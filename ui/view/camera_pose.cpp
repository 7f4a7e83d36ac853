// The part of the scene that needs no VTK: where the camera looks.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/volume/anatomy.h"
#include "ui/view/surface_scene.h"

namespace handlebody::ui {

namespace {

Vec3 middleOf(const Grid& grid) {
  return grid.toWorld(Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1) / 2);
}

}  // namespace

std::optional<Sight> sightOf(const std::vector<Vec3>& points) {
  if (points.empty()) return std::nullopt;
  Vec3 low = points[0], high = low;
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return Sight{(low + high) / 2, std::max(1e-6, (high - low).norm() / 2)};
}

std::optional<Sight> sightOf(const EventTrace& trace) {
  std::vector<Vec3> points;
  for (const auto* faces :
       {&trace.collidingFaces, &trace.openedFaces, &trace.handleFaces, &trace.closedFaces})
    for (const auto& face : *faces) points.insert(points.end(), face.begin(), face.end());
  for (const auto& loop : trace.boundaryLoops) points.insert(points.end(), loop.begin(), loop.end());
  return sightOf(points);
}

CameraPose between(const CameraPose& from, const CameraPose& to, double share) {
  if (share >= 1) return to;  // to the last digit
  const auto rotation = [](const CameraPose& p) {
    Eigen::Matrix3d axes;
    axes << p.up.cross(p.towardsEye), p.up, p.towardsEye;
    return Eigen::Quaterniond(axes);
  };
  const Eigen::Matrix3d axes = rotation(from).slerp(share, rotation(to)).toRotationMatrix();
  return {from.focus + share * (to.focus - from.focus), axes.col(2), axes.col(1),
          from.height * std::pow(to.height / from.height, share)};
}

CameraPose lookingFrom(const CameraPose& pose, Plane plane, bool opposite) {
  CameraPose result = pose;
  const double side = opposite ? -1 : 1;
  result.up = plane == Plane::axial ? Vec3(0, -1, 0) : Vec3(0, 0, 1);
  result.towardsEye = plane == Plane::axial     ? Vec3(0, 0, side)
                      : plane == Plane::coronal ? Vec3(0, -side, 0)
                                                : Vec3(side, 0, 0);
  return result;
}

CameraPose obliquePose() {
  CameraPose pose;
  pose.towardsEye = obliqueSight();
  pose.up = (Vec3::UnitZ() - pose.towardsEye.z() * pose.towardsEye).normalized();
  return pose;
}

CameraPose around(const Grid& grid, CameraPose pose, double aspect) {
  constexpr double kMargin = 1.12;
  const Vec3 half = Vec3(grid.size[0], grid.size[1], grid.size[2]).cwiseProduct(grid.spacing) / 2;
  const auto reach = [&](const Vec3& screenAxis) {
    return (grid.direction.transpose() * screenAxis).cwiseAbs().dot(half);
  };
  pose.focus = middleOf(grid);
  pose.height =
      std::max(1e-6, kMargin * 2 * std::max(reach(pose.up), reach(pose.up.cross(pose.towardsEye)) / aspect));
  return pose;
}

Vec3 acrossFronts(const EventTrace& trace, const Vec3& towardsEye) {
  if (trace.boundaryLoops.size() < 2) return towardsEye;
  const auto middle = [](const std::vector<Vec3>& loop) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : loop) sum += p;
    return Vec3(sum / static_cast<double>(std::max<std::size_t>(1, loop.size())));
  };
  const Vec3 line = (middle(trace.boundaryLoops[1]) - middle(trace.boundaryLoops[0])).normalized();
  const Vec3 across = towardsEye - towardsEye.dot(line) * line;
  return across.norm() > 0.1 ? across.normalized() : line.unitOrthogonal();
}

}  // namespace handlebody::ui
