#include "core/mesh/tunnels.h"

#include <numeric>

#include "core/collision/certify.h"
#include "tests/support/catch.h"
#include "tests/support/tunnel_shapes.h"

using namespace handlebody;

namespace {

using std::numbers::pi;

TunnelList tunnelsOf(const TriangleSoup& soup) { return findTunnels(Mesh(soup)); }

//! Whether each point lies in one face with the next.
bool liesOn(const Mesh& mesh, const SurfaceLoop& loop) {
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const SurfacePoint &p = loop.points[i], &q = loop.points[(i + 1) % loop.points.size()];
    bool together = false;
    mesh.forEachOutgoing(p.from, [&](int h) {
      const Triangle& t = mesh.face(Mesh::faceOf(h));
      const auto has = [&](int v) { return std::find(t.begin(), t.end(), v) != t.end(); };
      together = together || (has(p.from) && has(p.to) && has(q.from) && has(q.to));
    });
    if (!together) return false;
  }
  return loop.points.size() >= 3;
}

double lengthOf(const Mesh& mesh, const SurfaceLoop& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.points.size(); ++i)
    sum += (positionOf(mesh, loop.points[i]) - positionOf(mesh, loop.points[(i + 1) % loop.points.size()]))
               .norm();
  return sum;
}

}  // namespace

TEST_CASE("a tree and a cotree leave two edges per handle, whose loops meet once") {
  for (const auto& [soup, genus] :
       {std::pair(zoo::torus(12, 7, 3, 1), 1), std::pair(zoo::frame(2), 5), std::pair(zoo::sphere(3), 0)}) {
    const Mesh mesh(soup);
    const TreeCotree trees = treeCotree(mesh);
    REQUIRE(trees.generators.size() == 2 * static_cast<std::size_t>(genus));
    for (int i = 0; i < 2 * genus; ++i) {
      std::vector<int> crossed(static_cast<std::size_t>(3 * mesh.faceSlots()), 0);
      const std::vector<int> dual = dualLoop(mesh, trees, i);
      for (std::size_t k = 0; k < dual.size(); ++k) {
        crossed[dual[k]] += 1;
        crossed[mesh.opposite(dual[k])] -= 1;
        CHECK(Mesh::faceOf(mesh.opposite(dual[k])) == Mesh::faceOf(dual[(k + 1) % dual.size()]));
      }
      for (int j = 0; j < 2 * genus; ++j) {
        const std::vector<int> primal = primalLoop(mesh, trees, j);
        int meetings = 0;
        for (std::size_t k = 0; k < primal.size(); ++k) {
          meetings += crossed[primal[k]];
          CHECK(mesh.target(primal[k]) == mesh.origin(primal[(k + 1) % primal.size()]));
        }
        CHECK(meetings == (i == j ? 1 : 0));
      }
    }
  }
}

TEST_CASE("a torus has one tunnel, with loops as long as circles on it") {
  for (const double r : {0.5, 1.0, 1.8}) {
    const Mesh mesh(zoo::torus(96, 40, 3, r));
    const TunnelList list = findTunnels(mesh);
    CHECK(list.unlisted == 0);
    REQUIRE(list.tunnels.size() == 1);
    const Tunnel& t = list.tunnels[0];
    CHECK(t.handle.length == Approx(2 * pi * r).epsilon(0.01));
    CHECK(t.tunnel.length == Approx(2 * pi * (3 - r)).epsilon(0.02));
    CHECK(t.handleBounds);
    CHECK(t.tunnelBounds);
    for (const SurfaceLoop* loop : {&t.handle, &t.tunnel}) {
      CHECK(liesOn(mesh, *loop));
      CHECK(lengthOf(mesh, *loop) == Approx(loop->length));
    }
  }
}

TEST_CASE("a cavity in the shape of a torus has its loops the other way round") {
  const TunnelList list =
      tunnelsOf(zoo::both(zoo::scaled(zoo::sphere(4), 9), zoo::insideOut(zoo::torus(60, 30, 3, 1))));
  REQUIRE(list.tunnels.size() == 1);
  CHECK(list.tunnels[0].component == 1);
  CHECK(list.tunnels[0].tunnel.length == Approx(2 * pi * 1).epsilon(0.02));
  CHECK(list.tunnels[0].handle.length == Approx(2 * pi * 2).epsilon(0.02));
}

TEST_CASE("the frame of a cube has five tunnels, and each pair of loops meets") {
  const Mesh mesh(zoo::frame(3));
  const TunnelList list = findTunnels(mesh);
  CHECK(list.unlisted == 0);
  REQUIRE(list.tunnels.size() == 5);
  for (const Tunnel& t : list.tunnels) {
    CHECK(t.handle.length == Approx(4).epsilon(0.03));  // around a bar
    CHECK(t.tunnel.length == Approx(4).epsilon(0.03));  // round a window
    CHECK(liesOn(mesh, t.handle));
    CHECK(liesOn(mesh, t.tunnel));
  }
}

TEST_CASE("the loops do not depend on the order of vertices and faces, nor on the place") {
  const TriangleSoup soup =
      zoo::both(zoo::torus(40, 20, 3, 1), zoo::moved(zoo::torus(40, 20, 5, 1.5), Vec3(20, 3, 1)));
  const Eigen::AngleAxisd turn(1.1, Vec3(1, 2, 3).normalized());
  for (unsigned seed = 0; seed < 4; ++seed) {
    TriangleSoup other = zoo::shuffled(soup, seed);
    for (Vec3& p : other.points) p = turn * p + Vec3(300, -200, 100);
    const TunnelList list = tunnelsOf(other);
    REQUIRE(list.tunnels.size() == 2);
    CHECK(list.tunnels[0].handle.length == Approx(2 * pi * 1).epsilon(0.02));
    CHECK(list.tunnels[0].tunnel.length == Approx(2 * pi * 2).epsilon(0.02));
    CHECK(list.tunnels[1].handle.length == Approx(2 * pi * 1.5).epsilon(0.02));
    CHECK(list.tunnels[1].tunnel.length == Approx(2 * pi * 3.5).epsilon(0.02));
  }
}

TEST_CASE("linked tori are told apart from knots: each component is looked at alone") {
  TriangleSoup second = zoo::torus(60, 20, 3, 0.8);
  for (Vec3& p : second.points) p = Vec3(p.x() + 3, p.z(), -p.y());
  const TunnelList list = tunnelsOf(zoo::both(zoo::torus(60, 20, 3, 0.8), second));
  REQUIRE(list.tunnels.size() == 2);
  for (const Tunnel& t : list.tunnels) {
    CHECK(t.handle.length == Approx(2 * pi * 0.8).epsilon(0.02));
    CHECK(t.tunnel.length == Approx(2 * pi * 2.2).epsilon(0.02));
    CHECK(t.tunnelBounds);
  }
}

TEST_CASE("a knotted handle has a loop around it, and one along it that bounds nowhere") {
  const TriangleSoup soup = zoo::trefoil(240, 16, 0.4);
  REQUIRE(certify(soup).passes());
  const TunnelList list = tunnelsOf(soup);
  CHECK(list.unlisted == 0);
  REQUIRE(list.tunnels.size() == 1);
  CHECK(list.tunnels[0].handleBounds);
  CHECK_FALSE(list.tunnels[0].tunnelBounds);
  CHECK(list.tunnels[0].handle.length == Approx(2 * pi * 0.4).epsilon(0.03));
  CHECK(list.tunnels[0].tunnel.length > 15);
  CHECK(&list.tunnels[0].shorter() == &list.tunnels[0].handle);
}

TEST_CASE("what has no tunnel has an empty list") {
  CHECK(tunnelsOf(zoo::sphere(3)).tunnels.empty());
  CHECK(findTunnels(Mesh()).tunnels.empty());
  CHECK(findTunnels(Mesh()).unlisted == 0);
}

TEST_CASE("the quick list is that of a mesh that passes, loose points or not") {
  TriangleSoup soup = zoo::torus(20, 10, 3, 1);
  soup.points.insert(soup.points.begin(), Vec3(50, 50, 50));
  for (Triangle& t : soup.triangles)
    for (int& v : t) ++v;
  const auto list = findTunnelsQuickly(soup, certify(soup));
  REQUIRE(list);
  CHECK(list->tunnels.size() == 1);
  soup.triangles.pop_back();
  CHECK_FALSE(findTunnelsQuickly(soup, certify(soup)));
}
