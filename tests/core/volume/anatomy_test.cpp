#include "core/volume/anatomy.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "tests/support/catch.h"

using namespace handlebody;

namespace {

//! All 48 ways in which voxel axes can lie along those of the patient, each turned by `degrees` as well.
std::vector<Grid> allOrientations(double degrees) {
  std::vector<Grid> grids;
  std::array<int, 3> order{0, 1, 2};
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(degrees * M_PI / 180, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d direction = Eigen::Matrix3d::Zero();
      for (int a = 0; a < 3; ++a) direction(order[a], a) = (signs >> a & 1) != 0 ? -1 : 1;
      Grid grid;
      grid.size = {10, 20, 30};
      grid.direction = turn * direction;
      grids.push_back(grid);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return grids;
}

//! The world direction that a letter stands for.
Vec3 directionOf(char letter) {
  const std::string positive = "LPS", negative = "RAI";
  for (int w = 0; w < 3; ++w) {
    if (positive[w] == letter) return Vec3::Unit(w);
    if (negative[w] == letter) return -Vec3::Unit(w);
  }
  FAIL("no such letter");
  return Vec3::Zero();
}

}  // namespace

TEST_CASE("The letters at a slice's edges say where its axes run, however the voxels lie", "[anatomy]") {
  for (double degrees : {0.0, 20.0})
    for (const Grid& grid : allOrientations(degrees))
      for (AnatomicalPlane plane :
           {AnatomicalPlane::axial, AnatomicalPlane::coronal, AnatomicalPlane::sagittal}) {
        const SliceAxes axes = sliceAxes(grid, plane);
        const Vec3 rightwards = axes.acrossSign * grid.direction.col(axes.across);
        const Vec3 downwards = axes.downSign * grid.direction.col(axes.down);
        CHECK(rightwards.dot(directionOf(axes.right)) > 0.8);
        CHECK(rightwards.dot(directionOf(axes.left)) < -0.8);
        CHECK(downwards.dot(directionOf(axes.bottom)) > 0.8);
        CHECK(downwards.dot(directionOf(axes.top)) < -0.8);
        CHECK(std::abs(grid.direction(static_cast<int>(plane), axes.normal)) > 0.8);
      }
}

TEST_CASE("The patient's right is on the left, superior is up, anterior up or on the left", "[anatomy]") {
  for (const Grid& grid : allOrientations(0)) {
    const SliceAxes axial = sliceAxes(grid, AnatomicalPlane::axial),
                    coronal = sliceAxes(grid, AnatomicalPlane::coronal),
                    sagittal = sliceAxes(grid, AnatomicalPlane::sagittal);
    CHECK(std::string{axial.left, axial.right, axial.top, axial.bottom} == "RLAP");
    CHECK(std::string{coronal.left, coronal.right, coronal.top, coronal.bottom} == "RLSI");
    CHECK(std::string{sagittal.left, sagittal.right, sagittal.top, sagittal.bottom} == "APSI");
  }
}

TEST_CASE("A volume is oblique from one degree on", "[anatomy]") {
  for (const Grid& grid : allOrientations(0.9)) CHECK_FALSE(isOblique(grid));
  // Turned about an axis that is none of the three, so that some axis is off by less than the angle.
  for (const Grid& grid : allOrientations(2)) CHECK(isOblique(grid));
}

TEST_CASE("A place is told with a letter instead of a sign", "[anatomy]") {
  CHECK(anatomicalPlace(0, 12.34) == "L 12.3");
  CHECK(anatomicalPlace(0, -12.36) == "R 12.4");
  CHECK(anatomicalPlace(1, -0.06) == "A 0.1");
  CHECK(anatomicalPlace(2, 100) == "S 100.0");
}

TEST_CASE("A scale bar is 1, 2 or 5 times a power of ten, and as long as fits", "[anatomy]") {
  CHECK(roundLength(1) == 1);
  CHECK(roundLength(1.99) == 1);
  CHECK(roundLength(2) == 2);
  CHECK(roundLength(49.9) == 20);
  CHECK(roundLength(99) == 50);
  CHECK(roundLength(0.07) == Approx(0.05));
}
