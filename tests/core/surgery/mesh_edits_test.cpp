#include "core/surgery/mesh_edits.h"

#include "core/collision/certify.h"
#include "core/mesh/containment.h"
#include "core/mesh/pieces.h"
#include "tests/support/expect_valid.h"
#include "tests/support/tunnel_shapes.h"

using namespace handlebody;

namespace {

using std::numbers::pi;
constexpr double kAll = std::numeric_limits<double>::infinity();

void expectCertified(const Mesh& mesh) {
  expectValid(mesh);
  CHECK(certify(mesh.compact()).boundsBody());
}

//! A long thin body along z through the origin.
TriangleSoup rod(double radius) {
  TriangleSoup s = zoo::sphere(4);
  for (Vec3& p : s.points) p = Vec3(radius * p.x(), radius * p.y(), 6 * p.z());
  return s;
}

}  // namespace

TEST_CASE("a membrane in the tunnel of a torus makes it a sphere and adds volume") {
  Mesh mesh(zoo::torus(48, 24, 3, 1));
  const double before = signedVolume(mesh);
  const TunnelsClosed done = closeTunnels(mesh, kAll, TunnelCut::tunnel);
  REQUIRE(done.edits.size() == 1);
  CHECK(done.open.empty());
  const Event& e = done.edits[0];
  CHECK(e.kind == EventKind::tunnelClosed);
  CHECK(e.edit->loop == Approx(2 * pi * 2).epsilon(0.02));
  CHECK(e.edit->volumeBefore == Approx(before));
  CHECK(e.edit->volumeAfter == Approx(signedVolume(mesh)));
  CHECK(e.edit->volumeAfter > before);
  CHECK(e.before.genus == 1);
  CHECK(e.after.euler == e.before.euler + 2);
  expectCertified(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("a cut through the handle of a torus makes it a sphere and takes volume away") {
  Mesh mesh(zoo::torus(48, 24, 3, 1));
  const TunnelsClosed done = closeTunnels(mesh, kAll);  // the handle's loop is the shorter
  REQUIRE(done.edits.size() == 1);
  CHECK(done.edits[0].kind == EventKind::handleCut);
  CHECK(done.edits[0].edit->loop == Approx(2 * pi).epsilon(0.02));
  // A slice of the tube goes: a few edges of it.
  CHECK(done.edits[0].edit->volumeAfter < done.edits[0].edit->volumeBefore);
  CHECK(done.edits[0].edit->volumeAfter > 0.9 * done.edits[0].edit->volumeBefore);
  expectCertified(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("each of the tunnels of a frame is closed by one, along either loop") {
  for (const TunnelCut cut : {TunnelCut::shorter, TunnelCut::handle, TunnelCut::tunnel}) {
    Mesh mesh(zoo::frame(3));
    const TunnelsClosed done = closeTunnels(mesh, kAll, cut);
    CHECK(done.open.empty());
    REQUIRE(done.edits.size() == 5);
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(done.edits[i].before.genus == 5 - static_cast<int>(i));
      CHECK(done.edits[i].after.genus == 4 - static_cast<int>(i));
      CHECK(done.edits[i].after.components == 1);
    }
    expectCertified(mesh);
    expectTopology(mesh, 1, 0);
  }
}

TEST_CASE("one cut leaves a certified mesh of one tunnel less, and the mesh it was given as it was") {
  const Mesh mesh(zoo::frame(2));
  for (const Tunnel& tunnel : findTunnels(mesh).tunnels)
    for (const LoopKind kind : {LoopKind::handle, LoopKind::tunnel}) {
      const auto cut = closeTunnel(mesh, tunnel, kind);
      REQUIRE(cut);
      expectCertified(cut->mesh);
      expectTopology(cut->mesh, 1, 4);
    }
  expectTopology(mesh, 1, 5);
}

TEST_CASE("only tunnels with a shorter loop are closed") {
  const TriangleSoup two =
      zoo::both(zoo::torus(40, 20, 3, 1), zoo::moved(zoo::torus(40, 20, 6, 2), Vec3(20, 0, 0)));
  Mesh mesh(two);
  const TunnelsClosed done = closeTunnels(mesh, 8);
  CHECK(done.edits.size() == 1);
  CHECK(done.edits[0].location.norm() < 4);
  expectCertified(mesh);
  expectTopology(mesh, 2, 1);
  CHECK(closeTunnels(mesh, 8).edits.empty());
}

TEST_CASE("a membrane that would cut another body is refused, and the mesh stays as it was") {
  Mesh mesh(zoo::both(zoo::torus(48, 24, 3, 1), rod(0.4)));
  const TriangleSoup before = mesh.compact();
  const TunnelsClosed refused = closeTunnels(mesh, kAll, TunnelCut::tunnel);
  CHECK(refused.edits.empty());
  REQUIRE(refused.open.size() == 1);
  CHECK(refused.open[0].tunnelLength == Approx(4 * pi).epsilon(0.02));
  CHECK(mesh.compact().points == before.points);
  CHECK(mesh.compact().triangles == before.triangles);
  CHECK(closeTunnels(mesh, kAll).edits.size() == 1);  // through the handle it goes
  expectCertified(mesh);
  expectTopology(mesh, 2, 0);
}

TEST_CASE("a cut goes around a cavity in the tube") {
  // Where the tube is thinnest there is a ball in it.
  TriangleSoup tube = zoo::torus(72, 24, 3, 1);
  for (Vec3& p : tube.points)
    if (p.x() > 0) p.z() *= 1 - 0.1 * p.x() / 4;
  const TriangleSoup ball = zoo::insideOut(zoo::moved(zoo::scaled(zoo::sphere(4), 0.5), Vec3(3, 0, 0)));
  Mesh mesh(zoo::both(tube, ball));
  const TunnelsClosed done = closeTunnels(mesh, kAll, TunnelCut::handle);
  CHECK(done.edits.size() == 1);
  expectCertified(mesh);
  expectTopology(mesh, 2, 0);
}

TEST_CASE("a knotted handle can be cut, its tunnel cannot be filled") {
  Mesh mesh(zoo::trefoil(240, 16, 0.4));
  const TunnelsClosed refused = closeTunnels(mesh, kAll, TunnelCut::tunnel);
  CHECK(refused.edits.empty());
  CHECK(refused.open.size() == 1);
  CHECK(closeTunnels(mesh, kAll).edits.size() == 1);
  expectCertified(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("filled cavities go with what lies in them") {
  const TriangleSoup shell =
      zoo::both(zoo::scaled(zoo::sphere(6), 9), zoo::insideOut(zoo::scaled(zoo::sphere(5), 7)));
  const TriangleSoup island =
      zoo::both(zoo::scaled(zoo::sphere(4), 5), zoo::insideOut(zoo::scaled(zoo::sphere(3), 3)));
  Mesh mesh(zoo::both(shell, island));
  REQUIRE(certify(mesh.compact()).boundsBody());
  CHECK(listPieces(mesh)[1].isCavity);
  CHECK(listPieces(mesh)[1].within == 0);
  CHECK(listPieces(mesh)[3].within == 2);
  const double outer = listPieces(mesh)[0].volume;
  const std::vector<Event> edits = fillCavities(mesh);
  CHECK(edits.size() == 3);
  CHECK(edits.back().edit->volumeAfter == Approx(outer));
  CHECK(signedVolume(mesh) == Approx(outer));
  expectCertified(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("the largest body keeps its cavities, and what lies in those goes") {
  // The shell holds less than the ball beside it, although its outer surface is the larger one.
  const TriangleSoup shell =
      zoo::both(zoo::scaled(zoo::sphere(9), 9), zoo::insideOut(zoo::scaled(zoo::sphere(9), 8.7)));
  const TriangleSoup ball =
      zoo::moved(zoo::both(zoo::scaled(zoo::sphere(6), 7), zoo::insideOut(zoo::scaled(zoo::sphere(3), 2))),
                 Vec3(30, 0, 0));
  Mesh mesh(zoo::both(zoo::both(shell, zoo::scaled(zoo::sphere(2), 1)), ball));
  REQUIRE(certify(mesh.compact()).boundsBody());
  const std::vector<Event> edits = keepLargest(mesh);
  CHECK(edits.size() == 3);
  expectCertified(mesh);
  expectTopology(mesh, 2, 0);
  for (const Piece& p : listPieces(mesh)) CHECK(p.centre.x() == Approx(30).margin(0.2));
  CHECK(keepLargest(mesh).empty());
}

TEST_CASE("a component is removed with its cavity") {
  const TriangleSoup shell =
      zoo::both(zoo::scaled(zoo::sphere(5), 3), zoo::insideOut(zoo::scaled(zoo::sphere(4), 2)));
  Mesh mesh(zoo::both(shell, zoo::moved(zoo::sphere(3), Vec3(9, 0, 0))));
  CHECK(removeComponent(mesh, 0).size() == 2);
  expectCertified(mesh);
  expectTopology(mesh, 1, 0);
}

TEST_CASE("components are told what surrounds them") {
  const Mesh mesh(zoo::both(zoo::both(zoo::torus(40, 20, 3, 1), rod(0.4)),
                            zoo::insideOut(zoo::moved(zoo::scaled(zoo::sphere(3), 0.5), Vec3(0, 3, 0)))));
  CHECK(surroundingComponents(mesh, findComponents(mesh)) == std::vector<int>{-1, -1, 0});
}

TEST_CASE("the coarsest meshes with tunnels are closed, too") {
  for (const TriangleSoup& soup : {zoo::torus(3, 3, 3, 1), zoo::torus(4, 3, 3, 1), zoo::torus(3, 5, 3, 1.2),
                                   zoo::frame(1), zoo::torus(20, 3, 3, 0.1)}) {
    REQUIRE(certify(soup).passes());
    for (const TunnelCut cut : {TunnelCut::handle, TunnelCut::tunnel}) {
      Mesh mesh(soup);
      const int genus = topologyNumbers(mesh).genus;
      const TunnelsClosed done = closeTunnels(mesh, kAll, cut);
      CHECK(done.open.empty());
      CHECK(static_cast<int>(done.edits.size()) == genus);
      expectCertified(mesh);
      expectTopology(mesh, 1, 0);
    }
  }
}
