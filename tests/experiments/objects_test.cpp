// Several objects on the phantoms: what is done is a wall for the next.

#include <random>

#include "core/collision/body_contact.h"
#include "tests/experiments/experiment_support.h"
#include "tests/support/test_volume.h"
#include "tests/support/wall_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

struct Asked {
  std::string name;
  Vec3 seed;  //!< mm from the centre of the volume
  double radius;
  Parameters parameters{};
  std::vector<WallBall> walls{};  //!< the same
};

struct Object {
  std::string name;
  TriangleSoup mesh;
  Certificate certificate;
};

Vec3 centreOf(const Grid& grid) {
  return grid.toWorld(Vec3((grid.size[0] - 1) / 2.0, (grid.size[1] - 1) / 2.0, (grid.size[2] - 1) / 2.0));
}

//! Grows them in their order; in pairs they have no point in common, and no voxel twice.
std::vector<Object> growAll(const Volume& volume, const std::vector<Asked>& asked) {
  const Vec3 centre = centreOf(volume.grid);
  std::vector<Object> objects;
  std::vector<WallObject> walls;
  std::vector<int> times(volume.grid.voxelCount(), 0);
  for (const Asked& a : asked) {
    INFO(a.name);
    Constraints constraints;
    constraints.walls.objects = walls;
    for (const WallBall& w : a.walls) constraints.walls.balls.push_back({centre + w.centre, w.radius});
    ActiveContour contour(volume, {{centre + a.seed, a.radius}}, a.parameters, constraints);
    while (contour.stopReason() == StopReason::running) {
      contour.step();
      REQUIRE(contour.iteration() < 3000);
    }
    const TriangleSoup mesh = contour.mesh().compact();
    objects.push_back({a.name, mesh, certify(mesh)});
    CHECK(objects.back().certificate.boundsBody());
    for (const WallObject& other : walls) {
      INFO("and " << other.name);
      CHECK(bodyContact(mesh, *other.mesh) == BodyContact::none);
#ifdef HANDLEBODY_WITH_ORACLE
      TriangleSoup both = *other.mesh;
      for (const Triangle& t : mesh.triangles) {
        const int first = static_cast<int>(other.mesh->points.size());
        both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      }
      both.points.insert(both.points.end(), mesh.points.begin(), mesh.points.end());
      CHECK(oracle::selfIntersections(both).empty());
#endif
    }
    walls.push_back({a.name, std::make_shared<const TriangleSoup>(mesh)});
    const Volume mask = rasterize(mesh, volume.grid);
    for (std::size_t i = 0; i < times.size(); ++i) times[i] += mask.data<std::uint8_t>()[i];
    std::cout << "  " << a.name << ": " << stopReasonName(contour.stopReason()) << " after "
              << contour.iteration() << " iterations, " << objects.back().certificate.vertices
              << " vertices, components " << objects.back().certificate.components << '\n';
  }
  CHECK(*std::max_element(times.begin(), times.end()) == 1);
  return objects;
}

//! mm from a point to the surface; exact if it is nearer than 5 mm.
double distanceTo(const TriangleSoup& mesh, const Vec3& p) {
  double least = 1e9;
  for (const Triangle& t : mesh.triangles) {
    const auto corner = [&](std::size_t i) { return mesh.points[t[i]]; };
    if ((corner(0) - p).norm() < least + 5)
      least = std::min(least, bruteDistance(p, corner(0), corner(1), corner(2)));
  }
  return least;
}

//! mm from the vertices of `a` that count to the nearest point of `b`: the mean, and the furthest.
template <typename F>
std::pair<double, double> gap(const Volume& volume, const Object& a, const Object& b, F&& counts) {
  const Vec3 centre = centreOf(volume.grid);
  double sum = 0, widest = 0;
  int n = 0;
  for (const Vec3& p : a.mesh.points) {
    if (!counts(p - centre)) continue;
    const double least = distanceTo(b.mesh, p);
    sum += least;
    widest = std::max(widest, least);
    ++n;
  }
  REQUIRE(n > 0);
  std::cout << "  " << a.name << " to " << b.name << ": " << n << " vertices, mean " << sum / n
            << " mm, widest " << widest << " mm\n";
  return {sum / n, widest};
}

Parameters within(double low, double high) {
  Parameters p;
  p.range = IntensityRange{low, high};
  return p;
}

//! In voxels of 1 mm.
Parameters edgesOf(std::optional<double> length) {
  Parameters p;
  p.edgeLength = length;
  return p;
}

constexpr double kInf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("two linked rings that share a bridge are two objects", "[objects]") {
  const Phantom phantom = makePhantom("rings");
  const Parameters second = edgesOf(GENERATE(as<std::optional<double>>{}, std::nullopt, 1.5, 3.0));
  const auto objects = growAll(phantom.volume, {{"first", {-36, 0, 0}, 5, {}, {{{12, 0, 12}, 6.5}}},
                                                {"second", {36, 0, 0}, 5, second}});
  CHECK(objects[0].certificate.genus == std::vector<int>{1});
  CHECK(objects[1].certificate.genus == std::vector<int>{1});
  const auto inBridge = [](const Vec3& p) { return std::hypot(p.x() - 12, p.y()) < 2.5 && p.z() > 3; };
  CHECK(gap(phantom.volume, objects[0], objects[1], inBridge).second <= 0.5);
}

TEST_CASE("the two balls of a neck are two objects", "[objects]") {
  const Phantom phantom = makePhantom("neck");
  const Parameters second = edgesOf(GENERATE(as<std::optional<double>>{}, std::nullopt, 1.5));
  const auto objects = growAll(
      phantom.volume, {{"first", {-24, 2, 1}, 8, {}, {{{0, 0, 0}, 4}}}, {"second", {24, 2, 1}, 8, second}});
  const auto inBar = [](const Vec3& p) { return std::hypot(p.y(), p.z()) < 1 && std::abs(p.x()) < 8; };
  CHECK(gap(phantom.volume, objects[0], objects[1], inBar).second <= 0.5);
}

TEST_CASE("balls in a torus are objects of their own, before it and after it", "[objects]") {
  const Phantom phantom = makePhantom("torus");
  const double at = 30 * std::sqrt(0.5);
  std::vector<Asked> balls;
  for (const Vec3& c : {Vec3(at, at, 0), Vec3(-at, at, 0), Vec3(-at, -at, 0), Vec3(at, -at, 0)})
    balls.push_back({"ball " + std::to_string(balls.size()), c, 2, within(120, kInf)});
  const Asked torus{"torus", {30, 0, 0}, 6, within(-kInf, 120)};
  const bool isTorusFirst = GENERATE(true, false);
  std::vector<Asked> asked = balls;
  asked.insert(isTorusFirst ? asked.begin() : asked.end(), torus);
  const auto objects = growAll(phantom.volume, asked);
  const Object& body = isTorusFirst ? objects.front() : objects.back();
  CHECK(body.certificate.components == 5);
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(gap(phantom.volume, objects[i + (isTorusFirst ? 1 : 0)], body, [](const Vec3&) {
            return true;
          }).second <= 0.5);
}

TEST_CASE("the needle in the cyst is an object of its own", "[objects]") {
  PhantomOptions options;
  options.noise = 0;
  const Phantom phantom = makePhantom("cyst", options);
  Parameters bright;
  bright.object = ObjectKind::bright;
  const bool isCystFirst = GENERATE(true, false);
  const Asked cyst{"cyst", phantom.seed - centreOf(phantom.volume.grid), phantom.seedRadius},
      needle{"needle", {14, 0, 4}, 2, bright};
  const auto objects = growAll(
      phantom.volume, isCystFirst ? std::vector<Asked>{cyst, needle} : std::vector<Asked>{needle, cyst});
  CHECK(objects[isCystFirst ? 0 : 1].certificate.genus == std::vector<int>{1});
}

namespace {

struct Ball {
  Vec3 centre;  // mm from the middle of the volume
  double radius;
};

double depthIn(const std::vector<Ball>& balls, const Vec3& p) {
  double depth = -kInf;
  for (const Ball& b : balls) depth = std::max(depth, b.radius - (p - b.centre).norm());
  return depth;
}

Volume darkBalls(const std::vector<Ball>& balls, double noise, std::mt19937& random) {
  std::normal_distribution<double> normal(0, std::max(noise, 1e-9));
  return volumeByIndex(cubicGrid(49), [&](int i, int j, int k) {
    return 100 / (1 + std::exp(depthIn(balls, Vec3(i - 24, j - 24, k - 24)) / 0.6)) + normal(random);
  });
}

//! Each overlaps one before it, and leaves room for its seed beside the walls of those after it.
std::vector<Ball> threeBalls(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  std::vector<Ball> balls{{Vec3::Zero(), between(7, 10)}};
  while (balls.size() < 3) {
    const Ball& to = balls[random() % balls.size()];
    const double radius = between(5, 9), apart = (to.radius + radius) * between(0.6, 0.85);
    const Vec3 way(normal(random), normal(random), normal(random));
    const Ball next{to.centre + apart * way.normalized(), radius};
    const bool fits = next.centre.cwiseAbs().maxCoeff() + radius < 22 &&
                      std::all_of(balls.begin(), balls.end(), [&](const Ball& b) {
                        return (b.centre - next.centre).norm() > 1.05 * radius + 3.5;
                      });
    if (fits) balls.push_back(next);
  }
  return balls;
}

}  // namespace

TEST_CASE("what random bodies leave to the next ones is filled but for half a voxel", "[objects]") {
  constexpr unsigned kBodies = 20;
  constexpr double kTouching = 1.5;  // mm: further away nobody came
  int vertices = 0, wide = 0;
  double sum = 0;
  for (unsigned seed = 0; seed < kBodies; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const std::vector<Ball> balls = threeBalls(random);
    const Volume volume = darkBalls(balls, 5.0 * (seed % 3), random);
    std::vector<Asked> asked;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      asked.push_back({"body " + std::to_string(i), balls[i].centre, 3});
      for (std::size_t j = i + 1; j < balls.size(); ++j)
        asked[i].walls.push_back({balls[j].centre, 1.05 * balls[j].radius});
    }
    const auto objects = growAll(volume, asked);
    const Vec3 middle = centreOf(volume.grid);
    for (std::size_t i = 0; i + 1 < objects.size(); ++i)
      for (const Vec3& p : objects[i].mesh.points) {
        // At a rim the others have an edge of their own with the boundary.
        if (depthIn(balls, p - middle) < 2.5) continue;
        double away = kInf;
        for (std::size_t j = 0; j < objects.size(); ++j)
          if (j != i) away = std::min(away, distanceTo(objects[j].mesh, p));
        if (away > kTouching) continue;
        sum += away;
        wide += away > 0.5;
        ++vertices;
      }
  }
  std::cout << "  " << vertices << " vertices, mean " << sum / vertices << " mm, " << wide
            << " of them further than 0.5 mm\n";
  CHECK(vertices > 400);
  CHECK(wide <= 0.005 * vertices);
}
