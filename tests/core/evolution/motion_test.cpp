#include "core/evolution/motion.h"

#include <Eigen/Geometry>
#include <limits>
#include <numeric>
#include <random>

#include "core/mesh/shapes.h"
#include "tests/support/expect_valid.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByDistance;
using testing::volumeByIndex;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Vec3 kCentre(20, 20, 20);

//! Intensity grows by one per mm from the centre: a ball of radius `level` is the object. Voxels of 0.5 mm:
//! between them trilinear values are at most h²/4r = 0.006 mm off.
ObjectImage ballImage(double level) {
  Grid grid = cubicGrid(65);
  grid.spacing = Vec3(0.5, 0.5, 0.5);
  grid.origin = kCentre - Vec3(16, 16, 16);
  const Volume volume = volumeByIndex(
      grid, [&](int i, int j, int k) { return (grid.toWorld(Vec3(i, j, k)) - kCentre).norm(); });
  return {std::make_shared<SmoothedVolume>(volume, 0), {-kInfinity, level}, 1};
}

//! As ballImage(10), with white noise.
ObjectImage noisyBallImage(double noise) {
  Grid grid = cubicGrid(65);
  grid.spacing = Vec3(0.5, 0.5, 0.5);
  grid.origin = kCentre - Vec3(16, 16, 16);
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, std::max(noise, std::numeric_limits<double>::min()));
  const Volume volume = volumeByIndex(grid, [&](int i, int j, int k) {
    return (grid.toWorld(Vec3(i, j, k)) - kCentre).norm() + normal(random);
  });
  return {std::make_shared<SmoothedVolume>(volume, 0), {-kInfinity, 10}, 1};
}

//! Distance from the centre at which the image itself ends along a ray: halved between 9 and 11.
double endAlong(const ObjectImage& image, const Vec3& direction) {
  double in = 9, out = 11;
  for (int i = 0; i < 30; ++i) {
    const double r = (in + out) / 2;
    (image.inside(kCentre + r * direction) > 0 ? in : out) = r;
  }
  return in;
}

double rootMeanSquare(const std::vector<double>& x) {
  double sum = 0;
  for (double v : x) sum += v * v;
  return std::sqrt(sum / static_cast<double>(x.size()));
}

//! Everything is object.
ObjectImage endlessImage() {
  return {std::make_shared<SmoothedVolume>(volumeByIndex(cubicGrid(41), [](int, int, int) { return 0; }), 0),
          {-1, 1},
          1};
}

std::vector<int> allVertices(const Mesh& mesh) {
  std::vector<int> v(mesh.vertexSlots());
  std::iota(v.begin(), v.end(), 0);
  return v;
}

MotionSettings settingsFor(double edge) {
  MotionSettings s;
  s.edgeLength = edge;
  s.largestStep = 0.3 * edge;
  return s;
}

Vec3 outward(const Mesh& mesh, int v) { return (mesh.position(v) - kCentre).normalized(); }

double meanRadius(const Mesh& mesh) {
  double sum = 0;
  for (int v = 0; v < mesh.vertexSlots(); ++v) sum += (mesh.position(v) - kCentre).norm();
  return sum / mesh.vertexCount();
}

void move(Mesh& mesh, const ObjectImage& image, const MotionSettings& s) {
  const std::vector<int> v = allVertices(mesh);
  const std::vector<Vec3> d = computeMotion(mesh, image, s, v);
  for (std::size_t i = 0; i < v.size(); ++i) mesh.setPosition(v[i], mesh.position(v[i]) + d[i]);
}

}  // namespace

TEST_CASE("inside is positive in the object, nought on its boundary and negative outside") {
  const ObjectImage image = ballImage(10);
  CHECK(image.inside(kCentre + Vec3(9.5, 0, 0)) == Approx(0.5).margin(0.02));
  CHECK(image.inside(kCentre + Vec3(7, 0, 0)) > 0.5);
  CHECK(image.inside(kCentre + Vec3(10, 0, 0)) == Approx(0).margin(1e-6));
  CHECK(image.inside(kCentre + Vec3(13, 0, 0)) == Approx(-3));
}

TEST_CASE("outside the volume is outside of every object") {
  const ObjectImage image = endlessImage();
  CHECK(image.inside(Vec3(0, 20, 20)) > 0);
  CHECK(image.inside(Vec3(-0.5, 20, 20)) < 0);
  CHECK(image.inside(Vec3(20, 40.5, 20)) < 0);
  CHECK(image.inside(Vec3(20, 20, 1000)) < 0);
}

TEST_CASE("a sphere in a linear ramp moves to the boundary, from inside and from outside") {
  for (double start : {9.0, 11.0}) {
    Mesh mesh(icosphere(kCentre, start, 1));
    for (int i = 0; i < 40; ++i) move(mesh, ballImage(10), settingsFor(1));
    // The mean of the surface lies on the boundary: corners up to e²/(8r) outside of it.
    CHECK(meanRadius(mesh) == Approx(10).margin(0.02));
    const Certificate c = examine(mesh.compact());
    CHECK(c.volume == Approx(4.0 / 3 * M_PI * 1000).epsilon(0.002));
    for (int v = 0; v < mesh.vertexSlots(); ++v)
      CHECK((mesh.position(v) - kCentre).norm() == Approx(10).margin(0.05));
  }
}

TEST_CASE("the last step to the boundary ends on it and not beyond") {
  Mesh mesh(icosphere(kCentre, 9.9, 1));
  move(mesh, ballImage(10), settingsFor(1));
  CHECK(meanRadius(mesh) == Approx(10).margin(0.02));
}

TEST_CASE("no vertex moves further along its normal than the largest step") {
  Mesh mesh(icosphere(kCentre, 5, 1));
  const MotionSettings s = settingsFor(1);
  for (const ObjectImage& image : {ballImage(15), ballImage(1), endlessImage()}) {
    const std::vector<Vec3> d = computeMotion(mesh, image, s, allVertices(mesh));
    for (int v = 0; v < mesh.vertexSlots(); ++v)
      CHECK(std::abs(d[v].dot(outward(mesh, v))) <= s.largestStep * 1.01);
  }
}

TEST_CASE("the curvature weight holds a front of radius curvature times edge length over balloon") {
  MotionSettings s = settingsFor(0.5);
  s.outwardOnly = false;
  s.balloon = 2;
  for (double standing : {3.0, 6.0}) {
    s.curvature = standing * s.balloon / s.edgeLength;
    const auto meanMove = [&](double radius) {
      const Mesh mesh(icosphere(kCentre, radius, 0.5));
      const std::vector<Vec3> d = computeMotion(mesh, endlessImage(), s, allVertices(mesh));
      double sum = 0;
      for (int v = 0; v < mesh.vertexSlots(); ++v) sum += d[v].dot(outward(mesh, v));
      return sum / mesh.vertexCount() / s.largestStep;
    };
    CHECK(meanMove(standing) == Approx(0).margin(0.02));
    // Force: 1 - standing / radius.
    CHECK(meanMove(1.25 * standing) == Approx(0.2).margin(0.02));
    CHECK(meanMove(0.8 * standing) == Approx(-0.25).margin(0.02));
  }
}

TEST_CASE("outward motion never goes inwards in the object, however strong the curvature weight") {
  MotionSettings s = settingsFor(1);
  s.curvature = 100;
  for (double radius : {2.0, 5.0}) {
    const Mesh mesh(icosphere(kCentre, radius, 1));
    const std::vector<Vec3> d = computeMotion(mesh, ballImage(10), s, allVertices(mesh));
    for (int v = 0; v < mesh.vertexSlots(); ++v) CHECK(d[v].dot(outward(mesh, v)) >= -1e-12);
  }
}

TEST_CASE("the displacements are the same bits with one, two and three threads") {
  const Mesh mesh(icosphere(kCentre, 9, 0.5));
  const std::vector<int> vertices = allVertices(mesh);
  REQUIRE(vertices.size() > 3000);  // enough for three threads to have work
  MotionSettings s = settingsFor(0.5);
  std::vector<std::vector<Vec3>> moves;
  for (int threads : {1, 2, 3, 7}) {
    s.threads = threads;
    moves.push_back(computeMotion(mesh, ballImage(10), s, vertices));
  }
  for (const auto& m : moves) CHECK(m == moves[0]);
}

TEST_CASE("the displacements do not depend on which vertices are asked for, nor in which order") {
  const Mesh mesh(icosphere(kCentre, 9, 1));
  const ObjectImage image = ballImage(10);
  const std::vector<int> vertices = allVertices(mesh);
  const std::vector<Vec3> all = computeMotion(mesh, image, settingsFor(1), vertices);
  const std::vector<int> some{17, 3, 99};
  const std::vector<Vec3> d = computeMotion(mesh, image, settingsFor(1), some);
  REQUIRE(d.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(d[i] == all[some[i]]);
  CHECK(computeMotion(mesh, image, settingsFor(1), {}).empty());
}

TEST_CASE("motion does not depend on how the voxels lie in space") {
  Grid oblique = cubicGrid(41);
  oblique.direction = Eigen::AngleAxisd(0.6, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  oblique.spacing = Vec3(1, 0.8, 1.25);
  oblique.origin = kCentre - oblique.direction * Vec3(20, 16, 25);
  const Volume volume =
      volumeByDistance(oblique, 0, 100, [](const Vec3& p) { return (p - kCentre).norm() - 10; });
  const ObjectImage image(std::make_shared<SmoothedVolume>(volume, 0), {-kInfinity, 50}, 50);
  Mesh mesh(icosphere(kCentre, 9, 1));
  for (int i = 0; i < 30; ++i) move(mesh, image, settingsFor(1));
  CHECK(meanRadius(mesh) == Approx(10).margin(0.1));  // the ramp is one voxel wide, sampled at 0.8 … 1.25
}

TEST_CASE("noise moves the resting surface by less than half of what it moves the image's own end") {
  const ObjectImage image = noisyBallImage(0.25);
  Mesh mesh(icosphere(kCentre, 9, 1));
  for (int i = 0; i < 60; ++i) move(mesh, image, settingsFor(1));
  std::vector<double> surface, own;
  for (const Triangle& t : mesh.faces()) {
    const Vec3 middle = (mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3 - kCentre;
    surface.push_back(middle.norm() - 10);
    own.push_back(endAlong(image, middle.normalized()) - 10);
  }
  CHECK(rootMeanSquare(surface) < 0.5 * rootMeanSquare(own));
  CHECK(rootMeanSquare(own) > 0.05);  // there is something to compare
}

TEST_CASE("a surface in noise comes to rest") {
  const ObjectImage image = noisyBallImage(0.25);
  Mesh mesh(icosphere(kCentre, 9, 1));
  MotionSettings s = settingsFor(1);
  for (int i = 0; i < 150; ++i) move(mesh, image, s);
  const std::vector<Vec3> d = computeMotion(mesh, image, s, allVertices(mesh));
  double farthest = 0;
  for (const Vec3& m : d) farthest = std::max(farthest, m.norm());
  CHECK(farthest < 0.01);
}

TEST_CASE("a vertex in a thin branch goes on, though all of the surface around it stands at the boundary") {
  const Mesh mesh(icosphere(kCentre, 10, 1));
  const Vec3 along = outward(mesh, 0);
  Grid grid = cubicGrid(129);
  grid.spacing = Vec3(0.25, 0.25, 0.25);
  grid.origin = kCentre - Vec3(16, 16, 16);
  const Volume volume = volumeByDistance(grid, 0, 100, [&](const Vec3& p) {
    const Vec3 x = p - kCentre;
    const double beside = (x - x.dot(along) * along).norm() - 0.6;
    return std::min(x.norm() - 10, x.dot(along) > 0 ? beside : kInfinity);
  });
  const ObjectImage image(std::make_shared<SmoothedVolume>(volume, 0), {-kInfinity, 50}, 50);
  const MotionSettings s = settingsFor(1);
  const std::vector<Vec3> d = computeMotion(mesh, image, s, allVertices(mesh));
  CHECK(d[0].dot(along) == Approx(s.largestStep).epsilon(0.05));
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if ((mesh.position(v) - mesh.position(0)).norm() > 1.5) CHECK(d[v].norm() < 0.02);
}
