// Several objects on the phantoms: what is done is a wall for the next.

#include "core/collision/body_contact.h"
#include "tests/experiments/experiment_support.h"
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

//! mm from the vertices of `a` that count to the nearest point of `b`: the mean, and the furthest.
template <typename F>
std::pair<double, double> gap(const Volume& volume, const Object& a, const Object& b, F&& counts) {
  const Vec3 centre = centreOf(volume.grid);
  double sum = 0, widest = 0;
  int n = 0;
  for (const Vec3& p : a.mesh.points) {
    if (!counts(p - centre)) continue;
    double least = 1e9;
    for (const Triangle& t : b.mesh.triangles) {
      const auto corner = [&](std::size_t i) { return b.mesh.points[t[i]]; };
      if ((corner(0) - p).norm() < least + 5)
        least = std::min(least, bruteDistance(p, corner(0), corner(1), corner(2)));
    }
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

//! Where the surface of the one is a bowl of few voxels, edges of two voxels would leave more than half a
//! one.
Parameters fine() {
  Parameters p;
  p.edgeLength = 1.5;
  return p;
}

constexpr double kInf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("two linked rings that share a bridge are two objects", "[objects]") {
  const Phantom phantom = makePhantom("rings");
  const auto objects = growAll(phantom.volume, {{"first", {-36, 0, 0}, 5, fine(), {{{12, 0, 12}, 6.5}}},
                                                {"second", {36, 0, 0}, 5, fine()}});
  CHECK(objects[0].certificate.genus == std::vector<int>{1});
  CHECK(objects[1].certificate.genus == std::vector<int>{1});
  const auto inBridge = [](const Vec3& p) { return std::hypot(p.x() - 12, p.y()) < 2.5 && p.z() > 3; };
  CHECK(gap(phantom.volume, objects[0], objects[1], inBridge).second <= 0.5);
}

TEST_CASE("the two balls of a neck are two objects", "[objects]") {
  const Phantom phantom = makePhantom("neck");
  const auto objects = growAll(phantom.volume, {{"first", {-24, 2, 1}, 8, fine(), {{{0, 0, 0}, 4}}},
                                                {"second", {24, 2, 1}, 8, fine()}});
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
