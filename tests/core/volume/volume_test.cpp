#include "core/volume/volume.h"

#include <Eigen/Geometry>

#include "tests/support/catch.h"

using namespace handlebody;

TEST_CASE("voxel and world coordinates are inverses on an oblique anisotropic grid") {
  Grid grid;
  grid.size = {10, 20, 30};
  grid.spacing = Vec3(0.5, 1, 2);
  grid.origin = Vec3(-7, 3, 11);
  grid.direction = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Vec3 index(1.25, -3, 17);
  CHECK((grid.toIndex(grid.toWorld(index)) - index).norm() < 1e-12);
  CHECK((grid.toWorld(Vec3(1, 0, 0)) - grid.origin).norm() == Approx(0.5));
}

TEST_CASE("a grid contains its voxels up to their outer faces and nothing else") {
  Grid grid;
  grid.size = {4, 4, 4};
  CHECK(grid.contains(Vec3(-0.5, 0, 3.5)));
  CHECK_FALSE(grid.contains(Vec3(-0.51, 0, 0)));
  CHECK_FALSE(grid.contains(Vec3(0, 0, 3.6)));
  CHECK_FALSE(grid.contains(Vec3(std::nan(""), 0, 0)));
}
