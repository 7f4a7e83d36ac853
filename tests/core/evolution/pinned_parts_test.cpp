// Parts of the surface that stay as they are.
#include "core/evolution/pinned_parts.h"

#include <array>
#include <set>

#include "core/errors.h"
#include "core/evolution/history.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

using Place = std::array<double, 3>;
Place placeOf(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

//! What lies in a ball, by its places alone: no number of a vertex or face is needed to find it again.
struct Held {
  std::set<Place> vertices;
  std::set<std::array<Place, 3>> faces;
};

std::array<Place, 3> placesOf(const Mesh& mesh, int face) {
  const Triangle& t = mesh.face(face);
  std::array<Place, 3> p{placeOf(mesh.position(t[0])), placeOf(mesh.position(t[1])),
                         placeOf(mesh.position(t[2]))};
  std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
  return p;
}

Held heldBy(const Mesh& mesh, const Pin& pin) {
  const auto isIn = [&](int v) { return (mesh.position(v) - pin.centre).norm() <= pin.radius; };
  Held out;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && isIn(v)) out.vertices.insert(placeOf(mesh.position(v)));
  for (int f = 0; f < mesh.faceSlots(); ++f)
    if (mesh.isFace(f) && isIn(mesh.face(f)[0]) && isIn(mesh.face(f)[1]) && isIn(mesh.face(f)[2]))
      out.faces.insert(placesOf(mesh, f));
  return out;
}

bool isStillThere(const Mesh& mesh, const Held& held) {
  std::set<Place> vertices;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) vertices.insert(placeOf(mesh.position(v)));
  std::set<std::array<Place, 3>> faces;
  for (int f = 0; f < mesh.faceSlots(); ++f)
    if (mesh.isFace(f)) faces.insert(placesOf(mesh, f));
  return std::includes(vertices.begin(), vertices.end(), held.vertices.begin(), held.vertices.end()) &&
         std::includes(faces.begin(), faces.end(), held.faces.begin(), held.faces.end());
}

Constraints pinning(std::vector<Pin> pins) {
  Constraints c;
  c.pins = std::move(pins);
  return c;
}

struct Shape {
  const char* name;
  Volume volume;
  std::vector<Seed> seeds;
  Parameters parameters{};
};

Volume cubeVolume() {
  return darkObject(cubicGrid(41), [](const Vec3& p) { return (p - kMiddle).cwiseAbs().maxCoeff() - 9; });
}

std::vector<Shape> shapes() {
  Parameters both;
  both.direction = Direction::both;
  Parameters finer;
  finer.edgeLength = 1.3;
  return {{"torus", torusVolume(), {{kMiddle + Vec3(kTorusR, 0, 0), 3.0}}},
          {"torus, finer", torusVolume(), {{kMiddle + Vec3(kTorusR, 0, 0), 3.0}}, finer},
          {"two seeds", ballVolume(), {{kMiddle + Vec3(-5, 0, 0), 3.0}, {kMiddle + Vec3(5, 1, 0), 3.0}}},
          {"cube", cubeVolume(), {{kMiddle, 3.0}}},
          {"ball, from outside", ballVolume(), {{kMiddle, 14.0}}, both},
          {"torus, from a ball", torusVolume(), {{kMiddle + Vec3(kTorusR, 0, 0), 12.0}}, both}};
}

//! A vertex of the mesh, and a ball about it.
Pin randomPin(const Mesh& mesh, int iteration, std::mt19937& random) {
  std::vector<int> vertices;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) vertices.push_back(v);
  const auto v = std::uniform_int_distribution<std::size_t>(0, vertices.size() - 1)(random);
  return {mesh.position(vertices[v]), std::uniform_real_distribution<double>(0.1, 7)(random), iteration};
}

//! Every mesh of a run with pins, each certified and with all that is pinned as it was.
std::vector<Mesh> runPinned(ActiveContour contour, const std::vector<Pin>& pins) {
  std::vector<Mesh> meshes;
  std::vector<std::pair<Pin, Held>> held;
  for (;;) {
    const Mesh& mesh = contour.mesh();
    meshes.push_back(mesh);
    for (const auto& [pin, what] : held)
      if (!isStillThere(mesh, what))
        FAIL("the pin " << written(pin) << " did not hold in iteration " << contour.iteration());
    for (const Pin& pin : pins)
      if (pin.iteration == contour.iteration()) held.emplace_back(pin, heldBy(mesh, pin));
    if (contour.stopReason() != StopReason::running) break;
    contour.step();
    REQUIRE(meshes.size() < 3000);
    if (!certify(contour.mesh().compact()).boundsBody())
      FAIL("a step left an invalid mesh at iteration " << contour.iteration());
  }
  CHECK(held.size() == pins.size());
  return meshes;
}

}  // namespace

TEST_CASE("what is pinned stays bit for bit, whatever else changes, and replays", "[pin]") {
  for (const Shape& shape : shapes())
    for (unsigned seed = 1; seed <= 6; ++seed) {
      CAPTURE(shape.name, seed);
      std::mt19937 random(seed);
      std::vector<Pin> pins;
      ActiveContour free(shape.volume, shape.seeds, shape.parameters);
      const int at = std::uniform_int_distribution<int>(0, seed % 2 == 0 ? 40 : 6)(random);
      while (free.iteration() < at && free.stopReason() == StopReason::running) free.step();
      for (unsigned i = 0; i < 1 + seed % 3; ++i)
        pins.push_back(randomPin(free.mesh(), free.iteration(), random));
      const ActiveContour start(shape.volume, shape.seeds, shape.parameters, pinning(pins));
      const std::vector<Mesh> once = runPinned(start, pins);

      // The same from a history, in which it goes to and fro.
      HistoryLimits often;
      often.redoSeconds = 0.005;
      History history(start, often);
      while (history.stopReason() == StopReason::running) history.advance();
      REQUIRE(history.lastIteration() + 1 == static_cast<int>(once.size()));
      for (const int iteration :
           {0, history.lastIteration(), history.lastIteration() / 2, free.iteration()}) {
        history.goTo(iteration);
        CHECK(isSame(history.shown().mesh(), once[iteration]));
      }

      // And where the pins came on the way.
      History late(ActiveContour(shape.volume, shape.seeds, shape.parameters), often);
      while (late.iteration() < free.iteration()) late.advance();
      late.change({shape.seeds, shape.parameters, pinning(pins)});
      while (late.stopReason() == StopReason::running) late.advance();
      CHECK(isSame(late.shown().mesh(), once.back()));
    }
}

TEST_CASE("a cavity over a pinned part does not turn inside out", "[pin]") {
  // A cavity may be a few pinned faces and one vertex over them: that comes through without a collision.
  Grid grid = cubicGrid(32);
  grid.spacing = Vec3::Constant(2.5);
  const Vec3 middle(38.75, 38.75, 38.75);
  const Volume ball = darkObject(grid, [&](const Vec3& p) { return ((p - middle).norm() - 23) / 2.5; });
  for (const double beside : {2.0, 3.0, 4.0, 5.0})
    for (const double radius : {1.5, 3.0, 5.0}) {
      const std::vector<Seed> seeds{{middle, 3.0}};
      ActiveContour free(ball, seeds, {});
      for (int i = 0; i < 3; ++i) free.step();
      const Pin pin{middle + Vec3(beside, 0.3, 0.1), radius, 3};
      if (heldBy(free.mesh(), pin).vertices.empty()) continue;
      CAPTURE(written(pin));
      runPinned(ActiveContour(ball, seeds, {}, pinning({pin})), {pin});
    }
}

TEST_CASE("fronts stop before what is pinned, and go on when it is free", "[pin]") {
  const std::vector<Seed> seeds{{kMiddle + Vec3(-5, 0, 0), 3.0}, {kMiddle + Vec3(5, 1, 0), 3.0}};
  const Pin whole{kMiddle + Vec3(-5, 0, 0), 3.5, 0};
  ActiveContour contour(ballVolume(), seeds, {}, pinning({whole}));
  const auto reports = runCertified(contour);
  CHECK(certify(contour.mesh().compact()).components >= 2);  // the other grows around it
  REQUIRE(contour.pinned().size() == 1);
  CHECK(contour.pinned()[0].vertices > 10);
  CHECK(contour.pinned()[0].stops > 0);
  int told = 0;
  for (const StepReport& r : reports)
    for (const Event& e : r.events)
      told += e.kind == EventKind::rolledBack && sentence(e.reasons).find("pinned") != std::string::npos;
  CHECK(told >= contour.pinned()[0].stops);

  contour.change({seeds, {}, {}});
  CHECK(contour.stopReason() == StopReason::running);
  runCertified(contour);
  CHECK(certify(contour.mesh().compact()).components == 1);
  CHECK(volumeOf(contour.mesh()) == Approx(kBallVolume).epsilon(0.05));
}

TEST_CASE("a pinned sphere never moves at all", "[pin]") {
  ActiveContour contour(ballVolume(), {{kMiddle, 3.0}}, {}, pinning({{kMiddle, 30, 0}}));
  const Mesh before = contour.mesh();
  CHECK(contour.pinned()[0].vertices == before.vertexCount());
  runCertified(contour);
  CHECK(isSame(contour.mesh(), before));
  CHECK(contour.stopReason() == StopReason::converged);
}

TEST_CASE("what is pinned stays under another edge length, finer or coarser", "[pin]") {
  const double edge = GENERATE(0.5, 1.0, 4.0);
  ActiveContour contour(ballVolume(), {{kMiddle, 3.0}}, {});
  for (int i = 0; i < 8; ++i) contour.step();
  const Pin pin{contour.mesh().position(0), 4, 8};
  const Held held = heldBy(contour.mesh(), pin);
  REQUIRE(held.faces.size() > 5);
  Parameters p;
  p.edgeLength = edge;
  p.maxIterations = 60;
  contour.change({contour.requestedSeeds(), p, pinning({pin})});
  runCertified(contour);
  CHECK(isStillThere(contour.mesh(), held));
}

TEST_CASE("what is pinned stays when the clicks change, and a surface does not begin anew over it", "[pin]") {
  Grid grid = cubicGrid(41);
  grid.size[0] = 62;
  const Volume balls = darkObject(grid, [](const Vec3& p) {
    return std::min((p - Vec3(14, 20, 20)).norm() - 10, (p - Vec3(46, 20, 20)).norm() - 10);
  });
  const Seed left{Vec3(14, 20, 20), 3.0}, right{Vec3(46, 20, 20), 3.0};
  ActiveContour both(balls, {left, right}, {});
  for (int i = 0; i < 12; ++i) both.step();
  const Pin pin{Vec3(46, 20, 20), 40, 12};  // all of it
  const Held held = heldBy(both.mesh(), {Vec3(46, 20, 20), 12, 12});
  REQUIRE(certify(both.mesh().compact()).components == 2);
  ActiveContour kept = both;
  kept.change({{left}, {}, pinning({{Vec3(46, 20, 20), 12, 12}})});
  runCertified(kept);
  CHECK(isStillThere(kept.mesh(), held));

  ActiveContour one(balls, {left}, {});
  for (int i = 0; i < 12; ++i) one.step();
  const Mesh before = one.mesh();
  CHECK(messageOf([&] {
          one.change({{right}, {}, pinning({pin})});
        }) ==
        "The clicks have so little in common with the surface that it would begin anew, but a part of it is "
        "pinned: take the pins away first.");
  CHECK(isSame(one.mesh(), before));
  CHECK(one.constraints().pins.empty());
}

TEST_CASE("a pin without sense is refused with one sentence", "[pin]") {
  const auto message = [](const Pin& pin) {
    return messageOf([&] {
      ActiveContour contour(ballVolume(), {{kMiddle, 3.0}}, {}, pinning({pin}));
      while (contour.stopReason() == StopReason::running) contour.step();
    });
  };
  CHECK(message({kMiddle, 1, 0}) ==
        "The pin 20,20,20,1@0 holds nothing: no vertex of the surface lies there at iteration 0.");
  CHECK(message({kMiddle, 1, 5}) ==
        "The pin 20,20,20,1@5 holds nothing: no vertex of the surface lies there at iteration 5.");
  CHECK(message({kMiddle, 0, 5}) == "The pin at 20,20,20 has no radius above 0 mm.");
  CHECK(message({kMiddle, std::nan(""), 5}) == "The pin at 20,20,20 has no radius above 0 mm.");
  CHECK(message({kMiddle, 3, -1}) == "The pin at 20,20,20 mm has an iteration below 0.");
  CHECK(message({Vec3(90, 20, 20), 3, 1}) == "The pin at 90,20,20 mm lies outside of the volume.");

  ActiveContour contour(ballVolume(), {{kMiddle, 3.0}}, {});
  for (int i = 0; i < 4; ++i) contour.step();
  const Mesh before = contour.mesh();
  CHECK(messageOf([&] {
          contour.change({contour.requestedSeeds(), {}, pinning({{kMiddle, 9, 3}})});
        }) == "The pin 20,20,20,9@3 comes too late: the surface is at iteration 4.");
  CHECK(messageOf([&] {
          contour.change({contour.requestedSeeds(), {}, pinning({{kMiddle, 1, 4}})});
        }) == "The pin 20,20,20,1@4 holds nothing: no vertex of the surface lies there at iteration 4.");
  CHECK(isSame(contour.mesh(), before));
  CHECK(contour.constraints().pins.empty());
}

TEST_CASE("a pin put twice counts once", "[pin]") {
  const Pin pin{kMiddle, 30, 0};
  ActiveContour contour(ballVolume(), {{kMiddle, 3.0}}, {}, pinning({pin, pin}));
  contour.change({contour.requestedSeeds(), {}, pinning({pin})});
  contour.step();
  CHECK(contour.pinned()[0].vertices == contour.mesh().vertexCount());
}
