// Smoothing, pulling and cutting as steps of the growth.
#include "core/errors.h"
#include "core/evolution/edit_step.h"
#include "core/evolution/history.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

const std::vector<Seed> kSeeds{{kMiddle, 3.0}};

MeshEdit smoothing(int iteration, const Vec3& place, double radius) {
  MeshEdit e;
  e.iteration = iteration;
  e.kind = MeshEditKind::smooth;
  e.place = place;
  e.radius = radius;
  return e;
}
MeshEdit pull(int iteration, const Vec3& from, const Vec3& to, double radius) {
  MeshEdit e = smoothing(iteration, from, radius);
  e.kind = MeshEditKind::pull;
  e.vector = to;
  return e;
}
MeshEdit cut(int iteration, const Vec3& place, const Vec3& normal, KeptSide keep) {
  MeshEdit e = smoothing(iteration, place, 0);
  e.kind = MeshEditKind::cut;
  e.vector = normal;
  e.keep = keep;
  return e;
}

Constraints editing(std::vector<MeshEdit> edits) {
  Constraints c;
  c.edits = std::move(edits);
  return c;
}

ActiveContour grownBall() {
  ActiveContour contour(ballVolume(), kSeeds, {});
  while (contour.stopReason() == StopReason::running) contour.step();
  return contour;
}

Request with(const ActiveContour& contour, const MeshEdit& edit) {
  Request request = contour.request();
  request.constraints.edits.push_back(edit);
  return request;
}

}  // namespace

TEST_CASE("a step smooths, pulls or cuts; what it made of a surface at rest stays", "[touch][edit]") {
  const ActiveContour grown = grownBall();
  const int next = grown.iteration() + 1;
  const double volume = volumeOf(grown.mesh());
  const Vec3 pole = kMiddle + Vec3(0, 0, 10), out = kMiddle + Vec3(0, 0, 13);
  struct Case {
    MeshEdit edit;
    EventKind kind;
    double volume;
    int components;
  };
  const std::vector<Case> cases{
      {smoothing(next, pole, 5), EventKind::surfaceSmoothed, volume, 1},
      {pull(next, pole, out, 4), EventKind::surfacePulled, volume + M_PI * 16 / 3 * 3, 1},
      {cut(next, kMiddle, Vec3(0, 0, 1), KeptSide::both), EventKind::planeCut, volume, 2},
      {cut(next, kMiddle, Vec3(0, 0, 1), KeptSide::positive), EventKind::planeCut, volume / 2, 1}};
  for (const Case& c : cases) {
    CAPTURE(meshEditName(c.edit.kind));
    ActiveContour contour = grown;
    contour.change(with(contour, c.edit));
    const StepReport report = contour.step();
    REQUIRE(report.events.size() == 1);
    CHECK(report.events[0].kind == c.kind);
    CHECK(volumeOf(contour.mesh()) == Approx(c.volume).epsilon(0.02));
    CHECK(report.volume == Approx(volumeOf(contour.mesh())));
    CHECK(topologyNumbers(contour.mesh()).components == c.components);
    CHECK(certify(contour.mesh().compact()).boundsBody());
    CHECK(contour.stopReason() == StopReason::converged);
  }
}

TEST_CASE("local edits on the way are certified, go on, and replay from a history",
          "[touch][edit][history]") {
  const Constraints edits = editing({pull(6, kMiddle + Vec3(0, 0, 5), kMiddle + Vec3(0, 0, 8), 3),
                                     smoothing(8, kMiddle + Vec3(5, 0, 0), 4),
                                     cut(12, kMiddle + Vec3(0.3, 0, 0), Vec3(1, 0.2, 0), KeptSide::both),
                                     cut(20, kMiddle, Vec3(0, 0, 1), KeptSide::negative)});
  ActiveContour straight(ballVolume(), kSeeds, {}, edits);
  std::vector<Mesh> meshes{straight.mesh()};
  while (straight.stopReason() == StopReason::running) {
    straight.step();
    REQUIRE(certify(straight.mesh().compact()).boundsBody());
    meshes.push_back(straight.mesh());
    REQUIRE(meshes.size() < 3000);
  }
  CHECK_FALSE(straight.waitingEdit());
  HistoryLimits often;
  often.redoSeconds = 0.003;
  History history(ActiveContour(ballVolume(), kSeeds, {}, edits), often);
  while (history.stopReason() == StopReason::running) history.advance();
  for (const int iteration : {0, 7, 12, 13, 25, history.lastIteration(), 5, 20}) {
    history.goTo(iteration);
    CHECK(isSame(history.shown().mesh(), meshes.at(static_cast<std::size_t>(iteration))));
  }
}

TEST_CASE("a pinned part outlives cuts elsewhere, and refuses those through it", "[touch][edit][pin]") {
  const ActiveContour grown = grownBall();
  Request request = grown.request();
  const Pin pin{kMiddle + Vec3(0, 0, 10), 4, grown.iteration()};
  request.constraints.pins.push_back(pin);
  ActiveContour contour = grown;
  contour.change(request);
  const Mesh before = contour.mesh();
  const auto isHeld = [&](int v) {
    return before.isVertex(v) && (before.position(v) - pin.centre).norm() <= 4;
  };
  const int next = contour.iteration() + 1;
  contour.change(with(contour, cut(next, kMiddle, Vec3(0, 0, 1), KeptSide::both)));
  contour.step();
  for (int v = 0; v < before.vertexSlots(); ++v)
    if (isHeld(v)) CHECK(contour.mesh().position(v) == before.position(v));
  const Mesh cutMesh = contour.mesh();
  for (const MeshEdit& edit :
       {cut(next + 1, pin.centre, Vec3(1, 0, 0), KeptSide::both),
        cut(next + 1, kMiddle + Vec3(0, 0, 3), Vec3(0, 0, 1), KeptSide::negative),
        smoothing(next + 1, pin.centre, 6), pull(next + 1, pin.centre, pin.centre + Vec3(0, 0, 2), 3)}) {
    ActiveContour refused = contour;
    refused.change(with(refused, edit));
    CHECK(messageOf([&] { refused.step(); }) == "The edit of iteration " + std::to_string(next + 1) +
                                                    " cannot be made: a pinned part would change.");
    CHECK(isSame(refused.mesh(), cutMesh));
  }
}

TEST_CASE("local edits without sense are refused with one sentence", "[touch][edit]") {
  const auto message = [](const MeshEdit& edit) {
    return messageOf([&] {
      ActiveContour contour(ballVolume(), kSeeds, {}, editing({edit}));
      while (contour.stopReason() == StopReason::running) contour.step();
    });
  };
  CHECK(message(smoothing(3, kMiddle, 0)) == "The edit of iteration 3 has no radius above 0 mm.");
  CHECK(message(cut(3, kMiddle, Vec3(0, 0, 0), KeptSide::both)) ==
        "The edit of iteration 3 has a normal of no length.");
  CHECK(message(smoothing(3, kMiddle, 0.5)) ==
        "The edit of iteration 3 cannot be made: no vertex of the surface lies in the ball.");
  CHECK(message(cut(3, Vec3(1, 1, 1), Vec3(0, 0, 1), KeptSide::both)) ==
        "The edit of iteration 3 cannot be made: the plane does not meet the surface.");
}

TEST_CASE("a cut that makes more components than may be is refused, one that keeps a part is made",
          "[touch][edit]") {
  const ActiveContour grown = grownBall();
  ActiveContour contour = grown;
  Request request = with(contour, cut(grown.iteration() + 1, kMiddle, Vec3(0, 0, 1), KeptSide::both));
  request.constraints.topology.components = 1;
  contour.change(request);
  CHECK_THROWS_WITH(contour.step(), Catch::Contains("more components than may be"));
  CHECK(isSame(contour.mesh(), grown.mesh()));
  request.constraints.edits.back().keep = KeptSide::positive;
  contour = grown;
  contour.change(request);
  CHECK(contour.step().events.at(0).kind == EventKind::planeCut);
}
