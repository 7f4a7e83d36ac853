// Every tunnel of the phantoms is listed, and closed one by one.

#include <numbers>
#include <numeric>

#include "core/surgery/mesh_edits.h"
#include "tests/experiments/experiment_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

constexpr double kAll = std::numeric_limits<double>::infinity();

int genusOf(const Certificate& c) { return std::accumulate(c.genus.begin(), c.genus.end(), 0); }

//! The tunnels from the shortest to the longest, and the lengths of loops that theory gives.
struct Expected {
  std::string name;
  int genus;
  double handle, tunnel;  //!< mm, of the shortest loops, within a tenth; 0: no formula
};

//! One after the other with a certificate after each; the list is made anew each time.
void closeOneByOne(Mesh mesh) {
  int genus = genusOf(examine(mesh));
  while (genus > 0) {
    const TunnelList list = findTunnels(mesh);
    REQUIRE(static_cast<int>(list.tunnels.size()) == genus);
    const Tunnel& first = list.tunnels.front();
    const auto cut =
        closeTunnel(mesh, first, &first.shorter() == &first.handle ? LoopKind::handle : LoopKind::tunnel);
    REQUIRE(cut);
    mesh = cut->mesh;
    const Certificate c = certify(mesh.compact());
    REQUIRE(c.boundsBody());
    REQUIRE(genusOf(c) == --genus);
  }
}

void expectTunnels(const Mesh& mesh, const Expected& expected) {
  const TunnelList list = findTunnels(mesh);
  CHECK(list.unlisted == 0);
  REQUIRE(static_cast<int>(list.tunnels.size()) == expected.genus);
  for (const Tunnel& t : list.tunnels) {
    CHECK(t.handleBounds);
    CHECK(t.tunnelBounds);
  }
  if (expected.handle > 0) CHECK(list.tunnels[0].handle.length == Approx(expected.handle).epsilon(0.02));
  if (expected.tunnel > 0) CHECK(list.tunnels[0].tunnel.length == Approx(expected.tunnel).epsilon(0.02));
}

}  // namespace

TEST_CASE("every tunnel of the grown phantoms is listed; each closed lowers the genus by one") {
  constexpr double kPi = std::numbers::pi;
  // genus3: tubes of 8 mm. torus: 13.3 mm around 30 mm. The surfaces lie within a tenth of a voxel.
  for (const Expected& e : std::vector<Expected>{{"torus", 1, 2 * kPi * 13.3, 2 * kPi * (30 - 13.3)},
                                                 {"genus3", 3, 2 * kPi * 8, 0},
                                                 {"cube", 5, 0, 0},
                                                 {"gyroid", 27, 0, 0}}) {
    INFO(e.name);
    const Outcome grown = grow(makePhantom(e.name));
    const Mesh mesh(grown.mesh);
    expectTunnels(mesh, e);
    closeOneByOne(mesh);
    for (const TunnelCut cut : {TunnelCut::shorter, TunnelCut::handle, TunnelCut::tunnel}) {
      Mesh all = mesh;
      const TunnelsClosed done = closeTunnels(all, kAll, cut);
      CHECK(done.open.empty());
      CHECK(static_cast<int>(done.edits.size()) == e.genus);
      const Certificate c = certify(all.compact());
      CHECK(c.boundsBody());
      CHECK(genusOf(c) == 0);
    }
  }
}

TEST_CASE("the torus is solid when its four cavities are filled") {
  Mesh mesh(grow(makePhantom("torus")).mesh);
  REQUIRE(examine(mesh).cavities == 4);
  CHECK(fillCavities(mesh).size() == 4);
  const Certificate c = certify(mesh.compact());
  CHECK(c.boundsBody());
  CHECK(c.cavities == 0);
  CHECK(c.volume == Approx(2 * std::numbers::pi * std::numbers::pi * 30 * 13.3 * 13.3).epsilon(0.02));
}

TEST_CASE("every tunnel of the grown phantoms is closed by a step each, and a new run makes the same mesh",
          "[edit]") {
  for (const char* name : {"torus", "genus3", "cube"}) {
    CAPTURE(name);
    const Phantom phantom = makePhantom(name, {});
    ActiveContour contour(phantom.volume, {{phantom.seed, phantom.seedRadius}}, {});
    const ActiveContour start = contour;
    while (contour.stopReason() == StopReason::running) contour.step();
    Request request = contour.request();
    for (int genus = topologyNumbers(contour.mesh()).genus; genus > 0; --genus) {
      const TunnelList list = findTunnels(contour.mesh());
      REQUIRE(static_cast<int>(list.tunnels.size()) == genus);
      request.constraints.edits.push_back(
          {contour.iteration() + 1, MeshEditKind::closeTunnel, list.tunnels[0].position});
      contour.change(request);
      contour.step();
      const Certificate c = certify(contour.mesh().compact());
      REQUIRE(c.boundsBody());
      REQUIRE(genusOf(c) == genus - 1);
    }
    CHECK(contour.stopReason() == StopReason::converged);
    ActiveContour again = start;
    again.change(request);
    while (again.stopReason() == StopReason::running) again.step();
    CHECK(again.iteration() == contour.iteration());
    CHECK(again.mesh().compact().points == contour.mesh().compact().points);
    CHECK(again.mesh().compact().triangles == contour.mesh().compact().triangles);
  }
}
