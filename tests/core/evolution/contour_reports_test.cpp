// What the evolution says about itself: reports, stop reasons, parameters, traces.
#include <limits>

#include "core/errors.h"
#include "core/evolution/active_contour.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

const std::vector<Seed> kSeed{Seed{kMiddle, 4.0}};
const std::vector<Seed> kTorusSeed{Seed{kMiddle + Vec3(kTorusR, 0, 0), 3.0}};

bool isEmpty(const EventTrace& t) {
  return t.collidingFaces.empty() && t.lambda.empty() && t.openedFaces.empty() && t.boundaryLoops.empty() &&
         t.handleFaces.empty() && t.closedFaces.empty();
}

std::vector<StepReport> run(ActiveContour& contour) {
  std::vector<StepReport> reports;
  while (contour.stopReason() == StopReason::running) reports.push_back(contour.step());
  return reports;
}

}  // namespace

TEST_CASE("a contour starts as its seed sphere, running, at iteration nought") {
  const ActiveContour contour(ballVolume(), kSeed, {});
  CHECK(contour.iteration() == 0);
  CHECK(contour.stopReason() == StopReason::running);
  const Certificate c = certify(contour.mesh().compact());
  CHECK(c.passes());
  CHECK(c.components == 1);
  for (const Vec3& p : contour.mesh().compact().points) CHECK((p - kMiddle).norm() == Approx(4));
}

TEST_CASE("iterations are counted from one, in the reports and in their events") {
  ActiveContour contour(torusVolume(), kTorusSeed, {});
  int expected = 0;
  for (const StepReport& r : run(contour)) {
    CHECK(r.iteration == ++expected);
    for (const Event& e : r.events) CHECK(e.iteration == r.iteration);
  }
  CHECK(contour.iteration() == expected);
}

TEST_CASE("an evolution that converges does so with nothing moved and nothing happened") {
  ActiveContour contour(ballVolume(), kSeed, {});
  const auto reports = run(contour);
  CHECK(contour.stopReason() == StopReason::converged);
  CHECK(reports.back().movedVertices == 0);
  CHECK(reports.back().events.empty());
  CHECK(reports.back().unmovedVertices == contour.mesh().vertexCount());
  CHECK(reports.front().movedVertices > 0);
}

TEST_CASE("no vertex is reported to move further than a step may go") {
  ActiveContour contour(ballVolume(), kSeed, {});
  const double edge = contour.parameters().edgeLength;
  for (const StepReport& r : run(contour)) CHECK(r.largestMove <= 0.5 * edge);
}

TEST_CASE("the evolution stops at the number of iterations that was asked for") {
  Parameters p;
  p.maxIterations = 5;
  ActiveContour contour(ballVolume(), kSeed, p);
  CHECK(run(contour).size() == 5);
  CHECK(contour.stopReason() == StopReason::maxIterations);
  CHECK(contour.iteration() == 5);
  CHECK(certify(contour.mesh().compact()).passes());
}

TEST_CASE("with no iterations allowed none is made") {
  Parameters p;
  p.maxIterations = 0;
  ActiveContour contour(ballVolume(), kSeed, p);
  CHECK(run(contour).empty());
}

TEST_CASE("every stop reason has its name") {
  CHECK(std::string(stopReasonName(StopReason::running)) == "running");
  CHECK(std::string(stopReasonName(StopReason::converged)) == "converged");
  CHECK(std::string(stopReasonName(StopReason::maxIterations)) == "max-iterations");
  CHECK(std::string(stopReasonName(StopReason::empty)) == "empty");
  CHECK(std::string(stopReasonName(StopReason::frozen)) == "frozen");
  CHECK(std::string(stopReasonName(StopReason::stuck)) == "stuck");
}

TEST_CASE("what shrinks away altogether ends empty") {
  Parameters p;
  p.direction = Direction::both;
  p.range = IntensityRange{-1000, 110};
  p.curvature = 50;  // holds fronts of 100 mm and more: everything here collapses
  p.edgeLength = 2;
  ActiveContour contour(ballVolume(), kSeed, p);
  const auto reports = run(contour);
  CHECK(contour.stopReason() == StopReason::empty);
  CHECK(contour.mesh().faceCount() == 0);
  CHECK(reports.back().volume == Approx(0).margin(1e-9));
  REQUIRE_FALSE(reports.back().events.empty());
  CHECK(reports.back().events.back().kind == EventKind::componentDeleted);
  CHECK(reports.back().events.back().after.components == 0);
}

TEST_CASE("parameters that were given are used, the others are chosen from the image") {
  Parameters p;
  p.edgeLength = 1.3;
  p.smoothing = 0.7;
  p.balloon = 0.9;
  p.curvature = 0.4;
  p.maxIterations = 77;
  p.threads = 2;
  p.direction = Direction::both;
  const ResolvedParameters r = ActiveContour(ballVolume(), {Seed{kMiddle, {}}}, p).parameters();
  CHECK(r.edgeLength == 1.3);
  CHECK(r.smoothing == 0.7);
  CHECK(r.balloon == 0.9);
  CHECK(r.curvature == 0.4);
  CHECK(r.maxIterations == 77);
  CHECK(r.threads == 2);
  CHECK(r.direction == Direction::both);
  CHECK(r.object == ObjectKind::dark);
  CHECK(r.range.high == Approx(110).margin(10));
  REQUIRE(r.seeds.size() == 1);
  REQUIRE(r.seeds[0].radius);
  CHECK(*r.seeds[0].radius > 2);
  CHECK(*r.seeds[0].radius < 10);
}

TEST_CASE("the resolved parameters given as parameters lead to the same mesh") {
  ActiveContour first(ballVolume(), {Seed{kMiddle, {}}}, {});
  const ResolvedParameters r = first.parameters();
  Parameters p;
  p.object = r.object;
  p.range = r.range;
  p.smoothing = r.smoothing;
  p.edgeLength = r.edgeLength;
  ActiveContour second(ballVolume(), r.seeds, p);
  CHECK(second.parameters().range == r.range);
  run(first);
  run(second);
  // The first looks for the boundary at levels that differ from place to place (level_field.h), the second at
  // the one of the range. 0.0064 mm are measured, an intensity of one where the image rises by 180 in a
  // millimetre; two are allowed.
  const TriangleSoup one = first.mesh().compact(), other = second.mesh().compact();
  CHECK(first.iteration() == second.iteration());
  REQUIRE(one.triangles == other.triangles);
  double apart = 0;
  for (std::size_t v = 0; v < one.points.size(); ++v)
    apart = std::max(apart, (one.points[v] - other.points[v]).norm());
  CHECK(apart < 2.0 / 180);
}

TEST_CASE("parameters without meaning are refused") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const auto refused = [](auto&& change) {
    Parameters p;
    change(p);
    CHECK_THROWS_AS(ActiveContour(ballVolume(), kSeed, p), UsageError);
  };
  for (double bad : {0.0, -1.0, nan, infinity}) {
    refused([bad](Parameters& p) { p.balloon = bad; });
    refused([bad](Parameters& p) { p.edgeLength = bad; });
  }
  for (double bad : {-1.0, nan, infinity}) {
    refused([bad](Parameters& p) { p.curvature = bad; });
    refused([bad](Parameters& p) { p.smoothing = bad; });
  }
  refused([](Parameters& p) { p.maxIterations = -1; });
  refused([](Parameters& p) { p.threads = -1; });
  refused([](Parameters& p) { p.range = IntensityRange{10, 0}; });
}

TEST_CASE("a seed radius without meaning is refused") {
  for (double bad : {0.0, -1.0, std::nan("")})
    CHECK_THROWS_AS(ActiveContour(ballVolume(), {Seed{kMiddle, bad}}, {}), std::runtime_error);
}

TEST_CASE("a seed outside the volume is refused") {
  CHECK_THROWS_AS(ActiveContour(ballVolume(), {Seed{Vec3(-5, 20, 20), {}}}, {}), SeedError);
  CHECK_THROWS_AS(ActiveContour(ballVolume(), {}, {}), UsageError);
}

TEST_CASE("an edge length that would fill the memory is refused before anything is made",
          "[active_contour]") {
  Parameters p;
  for (double edge : {1e-3, 1e-12, 1e-300}) {
    p.edgeLength = edge;
    CHECK_THROWS_AS(ActiveContour(ballVolume(), {Seed{kMiddle, 4.0}}, p), UsageError);
  }
}

TEST_CASE("two seeds at the same place are one") {
  const ActiveContour contour(ballVolume(), {Seed{kMiddle, 4.0}, Seed{kMiddle, 4.0}}, {});
  CHECK(contour.parameters().seeds.size() == 1);
  CHECK(certify(contour.mesh().compact()).passes());
}

TEST_CASE("no traces are recorded unless they are asked for") {
  ActiveContour contour(torusVolume(), kTorusSeed, {});
  std::size_t events = 0;
  for (const StepReport& r : run(contour))
    for (const Event& e : r.events) {
      CHECK(isEmpty(e.trace));
      ++events;
    }
  CHECK(events > 0);
}

TEST_CASE("traces that are asked for agree with their events, and do not change the mesh") {
  ActiveContour plain(torusVolume(), kTorusSeed, {}), traced(torusVolume(), kTorusSeed, {});
  traced.recordTraces(true);
  run(plain);
  int handles = 0;
  for (const StepReport& r : run(traced))
    for (const Event& e : r.events) {
      if (e.kind != EventKind::handleInserted) continue;
      ++handles;
      CHECK_FALSE(e.trace.collidingFaces.empty());
      CHECK_FALSE(e.trace.openedFaces.empty());
      CHECK(e.trace.lambda.size() == 2);
      REQUIRE(e.trace.boundaryLoops.size() == e.loopSizes.size());
      std::size_t corners = 0;
      for (std::size_t i = 0; i < e.loopSizes.size(); ++i) {
        CHECK(e.trace.boundaryLoops[i].size() == static_cast<std::size_t>(e.loopSizes[i]));
        corners += e.trace.boundaryLoops[i].size();
      }
      CHECK(e.trace.handleFaces.size() == corners);
      for (const auto& face : e.trace.collidingFaces)
        for (const Vec3& p : face) CHECK((p - e.location).norm() < 10 * traced.parameters().edgeLength);
    }
  CHECK(handles >= 1);
  CHECK(plain.mesh().compact().points == traced.mesh().compact().points);
}
