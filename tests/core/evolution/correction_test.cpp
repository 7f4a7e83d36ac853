// Clicks that change while a surface grows, or after it has grown.

#include "core/evolution/correction.h"

#include <limits>
#include <random>

#include "core/errors.h"
#include "core/evolution/clicked_object.h"
#include "core/evolution/seeds.h"
#include "core/evolution/shown_object.h"
#include "core/mesh/nesting.h"
#include "core/mesh/shapes.h"
#include "core/mesh/topology.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

constexpr int kNone = -1;  // no component is left out
const Vec3 kLeft(12, 24, 24), kRight(36, 24, 24);

double ball(const Vec3& p, const Vec3& centre, double radius) { return (p - centre).norm() - radius; }
double rod(const Vec3& p, const Vec3& a, const Vec3& b, double radius) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm() - radius;
}
double bothBalls(const Vec3& p) { return std::min(ball(p, kLeft, 8), ball(p, kRight, 8)); }
double twoLobes(const Vec3& p) { return std::min(bothBalls(p), rod(p, kLeft, kRight, 2.5)); }

//! Dark (40) in bright (120) with noise, in 49³ voxels.
template <typename F>
Volume noisy(F&& distance, unsigned seed = 5, double sigma = 4) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, std::max(sigma, std::numeric_limits<double>::min()));
  const Grid grid = cubicGrid(49);
  return volumeByIndex(grid, [&](int i, int j, int k) {
    return 40 + 80 * std::clamp(distance(Vec3(i, j, k)) + 0.5, 0.0, 1.0) + noise(random);
  });
}

Seed inside(const Vec3& place) { return {place, {}}; }
Seed outside(const Vec3& place) { return {place, {}, true}; }

ActiveContour grown(const Volume& volume, const std::vector<Seed>& clicks) {
  ActiveContour contour(volume, clicks, {});
  runCertified(contour);
  return contour;
}

//! With other clicks, to the end; certified at once and after every step.
Correction goOn(ActiveContour& contour, const std::vector<Seed>& clicks) {
  contour.change({clicks, {}});
  REQUIRE(certify(contour.mesh().compact()).passes());
  runCertified(contour);
  CHECK(contour.stopReason() == StopReason::converged);
  return contour.correction().value();
}

//! How far the vertices of `before` that satisfy `where` are from the nearest one of `after`: the mean, mm.
template <typename Where>
double meanMove(const Mesh& before, const Mesh& after, Where&& where) {
  double sum = 0, n = 0;
  const std::vector<Vec3> now = after.compact().points;
  for (const Vec3& p : before.compact().points) {
    if (!where(p)) continue;
    double nearest = 1e9;
    for (const Vec3& q : now) nearest = std::min(nearest, (p - q).norm());
    sum += nearest;
    n += 1;
  }
  REQUIRE(n > 50);
  return sum / n;
}

//! Dice of what a surface encloses and where the distance is negative, from the voxels of 49³.
template <typename F>
double diceOf(const Mesh& mesh, F&& distance) {
  const ObjectImage image(std::make_shared<SmoothedVolume>(noisy(distance, 1, 0), 0),
                          IntensityRange{-1e9, 80}, 40);
  std::vector<Vec3> everywhere;
  for (int k = 0; k < 49; ++k)
    for (int j = 0; j < 49; ++j)
      for (int i = 0; i < 49; ++i)
        if (distance(Vec3(i, j, k)) < 0) everywhere.emplace_back(i, j, k);
  const ShownObject object(image, everywhere, 1);
  const Components parts = findComponents(mesh);
  const std::vector<Enclosed> enclosed = enclosedBy(mesh, parts, object);
  double all = 0, common = 0;
  for (int c = 0; c < parts.count(); ++c) {
    const auto at = static_cast<std::size_t>(c);
    const double sign = parts.volume[at] < 0 ? -1 : 1;
    all += sign * enclosed[at].all;
    common += sign * enclosed[at].common;
  }
  return 2 * common / (all + static_cast<double>(everywhere.size()));
}

double volumeOf(double radius) { return 4.0 / 3 * M_PI * std::pow(radius, 3); }

bool encloses(const Mesh& mesh, const Vec3& p) {
  return windingNumber(mesh, findComponents(mesh), kNone, p) == 1;
}

}  // namespace

TEST_CASE("a click outside makes the surface give up a lobe; what is far from it stays bit for bit",
          "[correction]") {
  ActiveContour contour = grown(noisy(twoLobes), {inside(kLeft)});
  const Mesh before = contour.mesh();
  REQUIRE(encloses(before, kRight));
  const Correction c = goOn(contour, {inside(kLeft), outside(kRight)});
  CHECK_FALSE(c.beganAnew);
  CHECK(c.givesGround);
  CHECK(c.common == Approx(0.5).margin(0.05));  // one of two equal lobes
  CHECK_FALSE(encloses(contour.mesh(), kRight));
  CHECK(signedVolume(contour.mesh()) == Approx(volumeOf(8)).epsilon(0.03));
  CHECK(topologyNumbers(contour.mesh()).components == 1);
  CHECK(meanMove(before, contour.mesh(), [](const Vec3& p) { return p[0] < kLeft[0]; }) == 0);
}

TEST_CASE("a click on the way turns the front back, and the part behind it stays where it has settled",
          "[correction]") {
  ActiveContour contour(noisy(twoLobes), {inside(kLeft)}, {});
  while (!encloses(contour.mesh(), Vec3(29, 24, 24))) contour.step();
  const Mesh before = contour.mesh();
  const Correction c = goOn(contour, {inside(kLeft), outside(kRight)});
  CHECK(c.givesGround);
  CHECK(signedVolume(contour.mesh()) == Approx(volumeOf(8)).epsilon(0.03));
  CHECK(meanMove(before, contour.mesh(), [](const Vec3& p) { return p[0] < kLeft[0]; }) == 0);
}

TEST_CASE("where the middle is given up two parts are left, and nothing that turned inside out on the way",
          "[correction]") {
  const Vec3 first(9, 24, 24), middle(24, 24, 24), last(39, 24, 24);
  const auto ends = [&](const Vec3& p) { return std::min(ball(p, first, 7), ball(p, last, 7)); };
  struct Case {
    double rod, sigma;
    unsigned seed;
  };
  // In the second the middle splits off at both ends at once, as a scrap.
  for (const Case& c : {Case{3, 4, 5}, Case{3.9741649440470805, 4.2874855542435188, 2412992964U}}) {
    CAPTURE(c.rod);
    const auto chain = [&](const Vec3& p) {
      return std::min({ends(p), ball(p, middle, 6), rod(p, first, last, c.rod)});
    };
    ActiveContour contour = grown(noisy(chain, c.seed, c.sigma), {inside(first), inside(last)});
    CHECK(topologyNumbers(contour.mesh()).components == 1);
    goOn(contour, {inside(first), inside(last), outside(middle)});
    CHECK(topologyNumbers(contour.mesh()).components == 2);
    CHECK(topologyNumbers(contour.mesh()).euler == 4);
    CHECK(encloses(contour.mesh(), first));
    CHECK(encloses(contour.mesh(), last));
    CHECK_FALSE(encloses(contour.mesh(), middle));
  }
}

TEST_CASE("a click inside of a part that the surface does not reach starts a front there", "[correction]") {
  ActiveContour contour = grown(noisy(bothBalls), {inside(kLeft)});
  const Mesh before = contour.mesh();
  REQUIRE_FALSE(encloses(before, kRight));
  const Correction c = goOn(contour, {inside(kLeft), inside(kRight)});
  CHECK(c.fronts == 1);
  CHECK_FALSE(c.beganAnew);
  CHECK_FALSE(c.givesGround);
  CHECK(topologyNumbers(contour.mesh()).components == 2);
  CHECK(signedVolume(contour.mesh()) == Approx(2 * volumeOf(8)).epsilon(0.03));
  CHECK(meanMove(before, contour.mesh(), [](const Vec3&) { return true; }) == 0);
  CHECK(seedsOfSide(contour.parameters().seeds, false).size() == 2);
}

TEST_CASE("a click inside that the surface encloses changes nothing", "[correction]") {
  ActiveContour contour = grown(noisy(twoLobes), {inside(kLeft)});
  const Mesh before = contour.mesh();
  const Correction c = goOn(contour, {inside(kLeft), inside(kLeft + Vec3(2, 3, 0))});
  CHECK(c.fronts == 0);
  CHECK(c.deleted == 0);
  CHECK(meanMove(before, contour.mesh(), [](const Vec3&) { return true; }) == 0);
}

TEST_CASE("a part whose click is taken away vanishes at once, and the other one stays", "[correction]") {
  ActiveContour contour = grown(noisy(bothBalls), {inside(kLeft), inside(kRight)});
  contour.change({{inside(kLeft)}, {}});
  CHECK(contour.correction()->deleted == 1);
  CHECK(topologyNumbers(contour.mesh()).components == 1);
  CHECK(certify(contour.mesh().compact()).passes());
  CHECK(encloses(contour.mesh(), kLeft));
  runCertified(contour);
  CHECK(signedVolume(contour.mesh()) == Approx(volumeOf(8)).epsilon(0.03));
}

TEST_CASE("a click that takes back one outside lets the surface grow on into what it gave up",
          "[correction]") {
  ActiveContour contour = grown(noisy(twoLobes), {inside(kLeft), outside(kRight)});
  REQUIRE_FALSE(encloses(contour.mesh(), kRight));
  goOn(contour, {inside(kLeft), inside(kRight)});
  CHECK(topologyNumbers(contour.mesh()).euler == 2);
  CHECK(encloses(contour.mesh(), kRight));
}

TEST_CASE("with next to nothing in common the surface begins anew, as a new one, and that is told",
          "[correction]") {
  ActiveContour contour = grown(noisy(bothBalls), {inside(kLeft)});
  const int before = contour.iteration();
  const Correction c = goOn(contour, {inside(kRight)});
  CHECK(c.beganAnew);
  CHECK(c.common < kHardlyInCommon);
  const ActiveContour fresh = grown(noisy(bothBalls), {inside(kRight)});
  CHECK(isSame(contour.mesh(), fresh.mesh()));
  CHECK(contour.iteration() - before == fresh.iteration());
  CHECK(contour.parameters().seeds == fresh.parameters().seeds);
}

TEST_CASE("going on comes to the topology and the accuracy of a new growth with the same clicks",
          "[correction]") {
  std::mt19937 random(11);
  const auto any = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Vec3 a(any(11, 15), any(20, 28), any(20, 28)), b(any(34, 38), any(20, 28), any(20, 28));
    const double ra = any(6, 9), rb = any(4, 9), neck = any(1.8, 3.5);
    const auto left = [&](const Vec3& p) { return ball(p, a, ra); };
    const auto both = [&](const Vec3& p) { return std::min(ball(p, a, ra), ball(p, b, rb)); };
    const auto joined = [&](const Vec3& p) { return std::min(both(p), rod(p, a, b, neck)); };
    CAPTURE(seed, neck);
    const auto compare = [](const Volume& volume, const auto& truth, const std::vector<Seed>& first,
                            const std::vector<Seed>& then) {
      ActiveContour contour = grown(volume, first);
      goOn(contour, then);
      const ActiveContour fresh = grown(volume, then);
      const TopologyNumbers on = topologyNumbers(contour.mesh()), anew = topologyNumbers(fresh.mesh());
      CHECK(std::tie(on.components, on.euler) == std::tie(anew.components, anew.euler));
      CHECK(diceOf(contour.mesh(), truth) > diceOf(fresh.mesh(), truth) - 0.01);
    };
    compare(noisy(joined, seed), left, {inside(a)}, {inside(a), outside(b)});
    compare(noisy(joined, seed), joined, {inside(a), outside(b)}, {inside(a), inside(b)});
    compare(noisy(both, seed), both, {inside(a)}, {inside(a), inside(b)});
    compare(noisy(both, seed), left, {inside(a), inside(b)}, {inside(a)});
  }
}

TEST_CASE("the edge length chosen at first stays with other clicks, that of a new beginning does not",
          "[correction]") {
  // One lobe is too thin for edges of two voxels.
  const auto lobes = [](const Vec3& p) { return std::min(ball(p, kLeft, 8), ball(p, kRight, 2.5)); };
  ActiveContour contour = grown(noisy(lobes), {inside(kLeft)});
  const double edge = contour.parameters().edgeLength;
  contour.change({{inside(kLeft), inside(kRight)}, {}});
  CHECK(contour.parameters().edgeLength == edge);
  Parameters slower;
  slower.balloon = 0.5;
  contour.changeParameters(slower);
  CHECK(contour.parameters().edgeLength == edge);
  contour.change({{inside(kRight)}, {}});
  contour = grown(noisy(lobes), {inside(kLeft)});
  contour.change({{inside(kRight)}, {}});
  CHECK(contour.correction()->beganAnew);
  CHECK(contour.parameters().edgeLength < edge);
}

TEST_CASE("clicks that are refused change nothing", "[correction]") {
  ActiveContour contour = grown(noisy(twoLobes), {inside(kLeft)});
  const Mesh before = contour.mesh();
  CHECK_THROWS_AS(contour.change({{inside(Vec3(500, 0, 0))}, {}}), SeedError);
  CHECK_THROWS_AS(contour.change({{inside(kLeft), outside(Vec3(500, 0, 0))}, {}}), SeedError);
  CHECK(contour.requestedSeeds() == std::vector<Seed>{inside(kLeft)});
  CHECK(isSame(contour.mesh(), before));
  CHECK_FALSE(contour.correction().has_value());
}

TEST_CASE("clicks prepared elsewhere lead to the same mesh as clicks whose image is chosen on the spot",
          "[correction]") {
  const std::vector<Seed> then{inside(kLeft), outside(kRight)};
  const ActiveContour first = grown(noisy(twoLobes), {inside(kLeft)});
  const ActiveContour prepared(noisy(twoLobes), then, {});
  ActiveContour chosen = first, taken = first;
  goOn(chosen, then);
  taken.change(prepared);
  runCertified(taken);
  CHECK(taken.requestedSeeds() == then);
  CHECK(isSame(taken.mesh(), chosen.mesh()));
}

TEST_CASE("any number of threads gives the same mesh after a click", "[correction]") {
  Parameters three;
  three.threads = 3;
  const std::vector<Seed> then{inside(kLeft), outside(kRight)};
  ActiveContour one = grown(noisy(twoLobes), {inside(kLeft)}), many = one;
  one.change({then, {}});
  many.change({then, three});
  runCertified(one);
  runCertified(many);
  CHECK(isSame(one.mesh(), many.mesh()));
}

TEST_CASE("what a surface encloses is counted per component, and what the object holds of it",
          "[correction]") {
  const ObjectImage image(std::make_shared<SmoothedVolume>(noisy(bothBalls, 1, 0), 0),
                          IntensityRange{-1e9, 80}, 40);
  const Mesh mesh = seedMesh({{kLeft, 6.0}, {kRight, 6.0}}, 1);
  const ShownObject left(image, {kLeft}, 1);
  const std::vector<Enclosed> e = enclosedBy(mesh, findComponents(mesh), left);
  REQUIRE(e.size() == 2);
  CHECK(e[0].all == Approx(volumeOf(6)).epsilon(0.03));
  CHECK(e[0].common == e[0].all);
  CHECK(e[1].all == Approx(volumeOf(6)).epsilon(0.03));
  CHECK(e[1].common == 0);  // as dark, but joined to no click
  CHECK_FALSE(left.holds(36, 24, 24));
  CHECK(left.holds(19, 24, 24));
  CHECK_FALSE(left.holds(21, 24, 24));
}

TEST_CASE("with a body its cavities go", "[correction]") {
  const ObjectImage image(std::make_shared<SmoothedVolume>(noisy(bothBalls, 1, 0), 0),
                          IntensityRange{-1e9, 80}, 40);
  Mesh mesh = seedMesh({{kLeft, 6.0}, {kRight, 6.0}}, 1);
  TriangleSoup hollow = mesh.compact();
  for (const Vec3& centre : {kLeft, kRight}) {
    const TriangleSoup cavity = icosphere(centre, 3, 1);
    const int shift = static_cast<int>(hollow.points.size());
    hollow.points.insert(hollow.points.end(), cavity.points.begin(), cavity.points.end());
    for (const Triangle& t : cavity.triangles)
      hollow.triangles.push_back({t[0] + shift, t[2] + shift, t[1] + shift});
  }
  mesh = Mesh(hollow);
  std::vector<Seed> fronts;
  const Correction c = correctComponents(mesh, image, {inside(kLeft + Vec3(4.5, 0, 0))}, 1, 1.4, fronts);
  CHECK(c.deleted == 2);
  CHECK(fronts.empty());
  CHECK(topologyNumbers(mesh).components == 2);
  CHECK(signedVolume(mesh) == Approx(volumeOf(6) - volumeOf(3)).epsilon(0.05));
  CHECK(certify(mesh.compact()).passes());
}

TEST_CASE("a new front keeps an edge length away from the surface, or is not made", "[correction]") {
  const ObjectImage image(std::make_shared<SmoothedVolume>(noisy(bothBalls, 1, 0), 0),
                          IntensityRange{-1e9, 80}, 40);
  for (const double away : {0.2, 1.0, 2.0, 3.5}) {
    CAPTURE(away);
    Mesh mesh = seedMesh({{kLeft, 3.0}}, 1);
    const int before = mesh.vertexCount();
    std::vector<Seed> fronts;
    correctComponents(mesh, image, {inside(kLeft + Vec3(3 + away, 0, 0))}, 1, 1.4, fronts);
    CHECK(certify(mesh.compact()).passes());
    CHECK((mesh.vertexCount() > before) == !fronts.empty());
    for (const Seed& f : fronts) CHECK((f.centre - kLeft).norm() - *f.radius - 3 >= 1);
  }
}
