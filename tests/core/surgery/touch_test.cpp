// Local edits: smoothing in a ball, pulling, flat cuts.
#include "core/collision/certify.h"
#include "core/mesh/containment.h"
#include "core/mesh/remesh.h"
#include "core/surgery/flat_cap.h"
#include "core/surgery/local_smoothing.h"
#include "core/surgery/plane_cut.h"
#include "core/surgery/pulling.h"
#include "tests/support/expect_valid.h"
#include "tests/support/mesh_zoo.h"
#include "tests/support/tunnel_shapes.h"

using namespace handlebody;

namespace {

using std::numbers::pi;

void expectCertified(const Mesh& mesh) {
  expectValid(mesh);
  CHECK(certify(mesh.compact()).boundsBody());
}

bool isSame(const Mesh& a, const Mesh& b) {
  const TriangleSoup s = a.compact(), t = b.compact();
  return s.points == t.points && s.triangles == t.triangles;
}

//! A ball of radius 10 mm with noise of up to 0.3 mm along its normals.
Mesh noisyBall(unsigned seed) {
  TriangleSoup s = zoo::scaled(zoo::sphere(12), 10);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-0.03, 0.03);
  for (Vec3& p : s.points) p *= 1 + noise(random);
  return Mesh(s);
}

//! Mean square of the distance from the sphere of radius 10 mm, of the vertices within r mm of a place.
double roughness(const Mesh& mesh, const Vec3& place, double r) {
  double sum = 0, n = 0;
  for (const Vec3& p : mesh.compact().points)
    if ((p - place).norm() < r) {
      sum += (p.norm() - 10) * (p.norm() - 10);
      n += 1;
    }
  return sum / n;
}

double longestEdge(const Mesh& mesh) {
  double longest = 0;
  for (int h = 0; h < 3 * mesh.faceSlots(); ++h)
    if (mesh.isFace(Mesh::faceOf(h)))
      longest = std::max(longest, (mesh.position(mesh.target(h)) - mesh.position(mesh.origin(h))).norm());
  return longest;
}

//! Along z from -length/2 to length/2, with round ends.
Mesh tube(double radius, double length) {
  TriangleSoup s = zoo::scaled(zoo::sphere(10), radius);
  for (Vec3& p : s.points) p.z() += (p.z() > 1e-9 ? 1 : p.z() < -1e-9 ? -1 : 0) * (length / 2 - radius);
  Mesh mesh(s);
  std::vector<unsigned char> all(mesh.vertexSlots(), kActive);
  regulate(mesh, {0.4 * radius, 0.12 * radius, {}}, all);
  return mesh;
}

Vec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Vec3 v;
  for (int a = 0; a < 3; ++a) v[a] = normal(random);
  return v.normalized();
}

std::vector<TriangleSoup> zooOfBodies() {
  return {zoo::bumpySphere(6, 0.4), zoo::torus(36, 14, 3, 1), zoo::cube(6),
          zoo::both(zoo::sphere(5), zoo::moved(zoo::sphere(4), Vec3(2.5, 0.1, 0.2))),
          zoo::perturbed(zoo::torus(40, 20, 2, 0.7), 0.01, 3)};
}

//! A ball with a ball-shaped cavity, of radii 10 and 5 mm.
TriangleSoup hollowBall() {
  TriangleSoup inner = zoo::scaled(zoo::sphere(6), 5);
  for (Triangle& t : inner.triangles) std::swap(t[0], t[1]);
  return zoo::both(zoo::scaled(zoo::sphere(10), 10), inner);
}

double area(const std::vector<Vec3>& p, const std::vector<Triangle>& faces) {
  double sum = 0;
  for (const Triangle& t : faces) {
    const Vec3 &a = p[t[0]], &b = p[t[1]], &c = p[t[2]];
    sum += (b - a).cross(c - a).norm() / 2;
  }
  return sum;
}

}  // namespace

TEST_CASE("noise on a ball is smoothed where it is asked for, and the volume stays", "[touch]") {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Mesh mesh = noisyBall(seed);
    const Vec3 place(0, 6, 8);
    const TouchedMesh out = smoothedHere(mesh, place, 5);
    REQUIRE(out.isDone());
    expectCertified(out.mesh);
    // Half of the ball of 5 mm lies within: some 260 mm³.
    CHECK(std::abs(out.volumeAfter - out.volumeBefore) < 1e-3 * 2.0 / 3 * pi * 125);
    CHECK(out.volumeAfter == Approx(signedVolume(out.mesh)));
    CHECK(roughness(out.mesh, place, 2) < 0.25 * roughness(mesh, place, 2));
    int moved = 0;
    for (int v = 0; v < mesh.vertexSlots(); ++v)
      if (out.mesh.position(v) != mesh.position(v)) {
        ++moved;
        CHECK((mesh.position(v) - place).norm() < 5);
      }
    CHECK(moved > 20);
    CHECK(out.before == out.after);
  }
}

TEST_CASE("smoothing a smooth ball hardly moves it", "[touch]") {
  const Mesh mesh(zoo::scaled(zoo::sphere(12), 10));
  const TouchedMesh out = smoothedHere(mesh, Vec3(0, 0, 10), 6);
  REQUIRE(out.isDone());
  for (int v = 0; v < mesh.vertexSlots(); ++v) CHECK((out.mesh.position(v) - mesh.position(v)).norm() < 0.15);
  CHECK(out.volumeAfter == Approx(out.volumeBefore).epsilon(1e-9));
}

TEST_CASE("smoothing where there is no surface is refused and changes nothing", "[touch]") {
  const Mesh mesh = noisyBall(1);
  const TouchedMesh out = smoothedHere(mesh, Vec3(0, 0, 0), 5);
  CHECK(out.refusal == FindingKind::noVertexInBall);
  CHECK(isSame(out.mesh, mesh));
}

TEST_CASE("a place of the surface is pulled out, or pressed in, and lies where it was asked to", "[touch]") {
  const Mesh mesh(zoo::scaled(zoo::sphere(12), 10));
  for (const double by : {0.5, 2.0, 6.0, 15.0, -0.5, -2.0, -6.0}) {
    CAPTURE(by);
    const Vec3 direction = Vec3(0.3, 0.2, 0.9).normalized();
    const Vec3 to = (10 + by) * direction;
    const TouchedMesh out = pulled(mesh, 11 * direction, to, 4);
    REQUIRE(out.isDone());
    expectCertified(out.mesh);
    expectTopology(out.mesh, 1, 0);
    CHECK((out.volumeAfter > out.volumeBefore) == (by > 0));
    const TriangleSoup soup = out.mesh.compact();
    CHECK(std::find(soup.points.begin(), soup.points.end(), to) != soup.points.end());
    CHECK(longestEdge(out.mesh) < 1.8 * longestEdge(mesh));
    // Volume of a bump by (1 - (d/R)²)² over a flat disc: π R² / 3 times its height.
    if (std::abs(by) < 3) CHECK(out.volumeAfter - out.volumeBefore == Approx(by * pi * 16 / 3).epsilon(0.2));
    // Further away nothing has moved.
    for (const Vec3& p : soup.points)
      if ((p - 10 * direction).norm() > 4.6 + std::abs(by)) CHECK(std::abs(p.norm() - 10) < 1e-9);
  }
}

TEST_CASE("a pull through the other side is refused and changes nothing", "[touch]") {
  const Mesh mesh(zoo::scaled(zoo::sphere(10), 10));
  const TouchedMesh through = pulled(mesh, Vec3(0, 0, 10), Vec3(0, 0, -14), 4);
  CHECK(through.refusal == FindingKind::meetsItself);
  CHECK(isSame(through.mesh, mesh));
  CHECK(pulled(mesh, Vec3(0, 0, 10), Vec3(0, 0, 200), 4).refusal == FindingKind::pullTooFar);
}

TEST_CASE("what lies close by in space but not along the surface is not pulled along", "[touch]") {
  // A torus whose hole is 1 mm wide.
  const Mesh mesh(zoo::torus(72, 36, 3.5, 3));
  const Vec3 place(0.5, 0, 0);
  const TouchedMesh out = pulled(mesh, place, place + Vec3(0.2, 0, 0), 1);
  REQUIRE(out.isDone());
  expectCertified(out.mesh);
  for (const Vec3& p : out.mesh.compact().points)
    if (p.x() < -0.3) {
      const double w = std::hypot(p.x(), p.y()) - 3.5;
      CHECK(std::abs(std::hypot(w, p.z()) - 3) < 1e-9);
    }
}

TEST_CASE("the parts of a tube that was cut add up to it, flat at their ends", "[touch]") {
  const Mesh mesh = tube(2, 20);
  REQUIRE(certify(mesh.compact()).boundsBody());
  std::mt19937 random(5);
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i);
    const Vec3 normal = (Vec3(0, 0, 1) + 0.5 * randomDirection(random)).normalized();
    const Vec3 point(0, 0, std::uniform_real_distribution<double>(-6, 6)(random));
    const TouchedMesh both = cutByPlane(mesh, {point, normal});
    REQUIRE(both.isDone());
    expectCertified(both.mesh);
    expectTopology(both.mesh, 2, 0);
    CHECK(both.volumeAfter == Approx(both.volumeBefore).epsilon(1e-3));
    CHECK(both.volumeAfter < both.volumeBefore + 1e-9);
    const TouchedMesh up = cutByPlane(mesh, {point, normal, KeptSide::positive});
    const TouchedMesh down = cutByPlane(mesh, {point, normal, KeptSide::negative});
    REQUIRE((up.isDone() && down.isDone()));
    for (const TouchedMesh* part : {&up, &down}) {
      expectCertified(part->mesh);
      expectTopology(part->mesh, 1, 0);
      const double side = part == &up ? 1 : -1;
      int flat = 0;
      for (const Vec3& p : part->mesh.compact().points) {
        CHECK(side * (p - point).dot(normal) > -0.1);
        flat += std::abs((p - point).dot(normal)) < 0.1;
      }
      CHECK(flat > 12);
    }
    CHECK(up.volumeAfter + down.volumeAfter == Approx(both.volumeBefore).epsilon(1e-3));
    // Of a tube of round section, cut aslant, what lies above a point of its axis is what lies above a
    // straight cut there.
    CHECK(up.volumeAfter == Approx(pi * 4 * (10 - point.z()) - pi * 8 / 3).epsilon(0.03));
  }
}

TEST_CASE("a torus that is cut in one place has no tunnel any more", "[touch]") {
  const Mesh mesh(zoo::torus(48, 24, 3, 1));
  const PlaneCut side{Vec3(3, 0, 0), Vec3(0, 1, 0), KeptSide::both, 1.5};
  const TouchedMesh one = cutByPlane(mesh, side);
  REQUIRE(one.isDone());
  expectCertified(one.mesh);
  expectTopology(one.mesh, 1, 0);
  CHECK(one.volumeAfter == Approx(one.volumeBefore).epsilon(1e-3));
  PlaneCut half = side;
  half.keep = KeptSide::positive;
  const TouchedMesh none = cutByPlane(mesh, half);
  CHECK(none.refusal == FindingKind::cutPartsNothing);
  CHECK(isSame(none.mesh, mesh));

  half.radius = std::nullopt;
  const TouchedMesh halves = cutByPlane(mesh, {side.point, side.normal});
  REQUIRE(halves.isDone());
  expectTopology(halves.mesh, 2, 0);
  const TouchedMesh upper = cutByPlane(mesh, half);
  REQUIRE(upper.isDone());
  expectTopology(upper.mesh, 1, 0);
  CHECK(upper.volumeAfter == Approx(one.volumeBefore / 2).epsilon(0.01));
  // Through its whole width it falls into two rings, whose caps are rings, too.
  const TouchedMesh rings = cutByPlane(mesh, {Vec3(0, 0, 0.1), Vec3(0.01, 0.02, 1)});
  REQUIRE(rings.isDone());
  expectCertified(rings.mesh);
  expectTopology(rings.mesh, 2, 2);
}

TEST_CASE("a hollow ball is cut open: its cavity is no more", "[touch]") {
  const Mesh mesh(hollowBall());
  REQUIRE(certify(mesh.compact()).boundsBody());
  const TouchedMesh out = cutByPlane(mesh, {Vec3(0, 0, 1), Vec3(0, 0.1, 1)});
  REQUIRE(out.isDone());
  expectCertified(out.mesh);
  expectTopology(out.mesh, 2, 0);
  CHECK(out.volumeAfter == Approx(out.volumeBefore).epsilon(1e-3));
  // Above the cavity, the cavity stays with the larger part, and goes with it.
  const TouchedMesh large = cutByPlane(mesh, {Vec3(0, 0, 8), Vec3(0, 0, 1), KeptSide::negative});
  REQUIRE(large.isDone());
  expectTopology(large.mesh, 2, 0);
  const TouchedMesh small = cutByPlane(mesh, {Vec3(0, 0, 8), Vec3(0, 0, 1), KeptSide::positive});
  REQUIRE(small.isDone());
  expectTopology(small.mesh, 1, 0);
  // A ball's cap of 2 mm; the faces lie some 0.1 mm within the ball.
  CHECK(small.volumeAfter == Approx(pi * 4 * (30 - 2) / 3).epsilon(0.12));
}

TEST_CASE("a plane beside the surface is refused", "[touch]") {
  const Mesh mesh(zoo::sphere(5));
  CHECK(cutByPlane(mesh, {Vec3(0, 0, 3), Vec3(0, 0, 1)}).refusal == FindingKind::planeMisses);
  const TouchedMesh far = cutByPlane(mesh, {Vec3(9, 0, 0), Vec3(0, 0, 1), KeptSide::both, 1.0});
  CHECK(far.refusal == FindingKind::planeMissesNear);
  CHECK(isSame(far.mesh, mesh));
}

TEST_CASE("planes through vertices, edges and faces of a grid cut it all the same", "[touch]") {
  const Mesh mesh(zoo::cube(4));
  for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(1, -1, 0.5)})
    for (const double at : {0.25, 0.5, 0.6}) {
      CAPTURE(normal.transpose(), at);
      const TouchedMesh out = cutByPlane(mesh, {Vec3(at, at, at), normal});
      REQUIRE(out.isDone());
      expectCertified(out.mesh);
      expectTopology(out.mesh, 2, 0);
      CHECK(out.volumeAfter == Approx(1).epsilon(0.02));
    }
}

TEST_CASE("random local edits leave certified meshes or the mesh as it was", "[touch]") {
  int done = 0, refused = 0;
  const auto look = [&](const Mesh& before, const TouchedMesh& out) {
    ++(out.isDone() ? done : refused);
    if (!out.isDone()) {
      CHECK(isSame(before, out.mesh));
      return;
    }
    if (!certify(out.mesh.compact()).boundsBody()) FAIL("an edit left an invalid mesh");
    CHECK(out.after == topologyNumbers(out.mesh));
  };
  unsigned seed = 0;
  for (const TriangleSoup& soup : zooOfBodies()) {
    const Mesh mesh(soup);
    std::mt19937 random(++seed);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 25; ++i) {
      CAPTURE(seed, i);
      const Vec3 place = soup.points[random() % soup.points.size()];
      const double radius = 0.1 + 1.5 * unit(random);
      look(mesh, smoothedHere(mesh, place, radius));
      const Vec3 from = place + 0.2 * randomDirection(random),
                 to = place + unit(random) * randomDirection(random);
      look(mesh, pulled(mesh, from, to, radius));
      for (const KeptSide keep : {KeptSide::both, KeptSide::positive, KeptSide::negative})
        look(mesh, cutByPlane(mesh, {place, randomDirection(random), keep,
                                     i % 2 == 0 ? std::nullopt : std::optional(radius)}));
    }
  }
  CAPTURE(done, refused);
  CHECK(done > 4 * refused);
}

TEST_CASE("flat caps fill regions with holes", "[touch]") {
  // A square of 10 mm with square holes of 1 mm, tilted.
  for (const int holes : {0, 1, 4, 9}) {
    CAPTURE(holes);
    std::vector<Vec3> p;
    std::vector<std::vector<int>> polygons;
    const Vec3 normal = Vec3(1, 2, -3).normalized();
    const Vec3 x = normal.cross(Vec3(0, 1, 0)).normalized(), y = normal.cross(x);
    const auto add = [&](double left, double low, double side, int parts, bool isHole) {
      std::vector<int> polygon;
      const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      for (int c = 0; c < 4; ++c)
        for (int i = 0; i < parts; ++i) {
          const double t = double(i) / parts;
          const double u = (1 - t) * corners[c][0] + t * corners[(c + 1) % 4][0];
          const double v = (1 - t) * corners[c][1] + t * corners[(c + 1) % 4][1];
          polygon.push_back(static_cast<int>(p.size()));
          p.push_back((left + side * u) * x + (low + side * v) * y);
        }
      if (isHole) std::reverse(polygon.begin(), polygon.end());
      polygons.push_back(polygon);
    };
    add(0, 0, 10, 20, false);
    for (int h = 0; h < holes; ++h) {
      const int column = h % 3, row = h / 3;
      add(1 + 3 * column, 1 + 3 * row, 1, 3, true);
    }
    const auto faces = flatCap(p, normal, polygons);
    REQUIRE(faces.has_value());
    CHECK(area(p, *faces) == Approx(100 - holes));
    // n points and h holes: n + 2h - 2 triangles.
    CHECK(static_cast<int>(faces->size()) == static_cast<int>(p.size()) + 2 * holes - 2);
    for (const Triangle& t : *faces) {
      const Vec3 &a = p[t[0]], &b = p[t[1]], &c = p[t[2]];
      CHECK((b - a).cross(c - a).dot(normal) > 0);
    }
    CHECK(windingAround(p, normal, polygons[0], 5 * x + 5 * y) == 1);
    CHECK(windingAround(p, normal, polygons[0], 15 * x + 5 * y) == 0);
  }
}
