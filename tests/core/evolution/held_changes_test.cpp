// Changes of topology that may not happen: vetoes, and limits of components and genus.
#include "core/evolution/held_changes.h"

#include "core/errors.h"
#include "core/evolution/history.h"
#include "core/mesh/shapes.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

const Seed kTorusSeed{kMiddle + Vec3(kTorusR, 0, 0), 3.0};

Constraints vetoing(std::vector<Veto> vetoes) { return {{}, std::move(vetoes), {}}; }
Constraints limited(std::optional<int> components, std::optional<int> genus, std::vector<Vec3> allowed = {}) {
  return {{}, {}, {components, genus, std::move(allowed)}};
}

Parameters bothWays() {
  Parameters p;
  p.direction = Direction::both;
  return p;
}

//! Two balls 8 mm apart, and a start around both of them: it splits between them.
struct TwoBalls {
  Volume volume;
  std::vector<Seed> seeds{{Vec3(14, 20, 20), 42.0}};
  TwoBalls() {
    Grid grid = cubicGrid(41);
    grid.size[0] = 62;
    volume = darkObject(grid, [](const Vec3& p) {
      return std::min((p - Vec3(14, 20, 20)).norm(), (p - Vec3(42, 20, 20)).norm()) - 10;
    });
  }
};

void run(ActiveContour& contour) {
  while (contour.stopReason() == StopReason::running) {
    contour.step();
    REQUIRE(contour.iteration() < 2000);
  }
}

//! The first event that changed the topology, of a run without constraints.
Event firstChange(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& parameters = {}) {
  ActiveContour contour(volume, seeds, parameters);
  while (contour.stopReason() == StopReason::running)
    for (const Event& e : contour.step().events)
      if (changesTopology(e.kind)) return e;
  FAIL("nothing happened");
  return {};
}

Constraints asking(std::optional<int> components, std::optional<int> genus) {
  Constraints c = limited(components, genus);
  c.topology.asks = true;
  return c;
}

//! Up to the first step that asks something.
HeldPlace firstQuestion(ActiveContour& contour) {
  while (contour.stopReason() == StopReason::running)
    if (const StepReport step = contour.step(); !step.questions.empty()) {
      CHECK(step.questions.size() == 1);
      CHECK(step.questions[0].iteration == contour.iteration());
      return step.questions[0];
    }
  FAIL("nothing was asked");
  return {};
}

//! How often somebody is asked from here to the end.
std::size_t countQuestions(ActiveContour& contour) {
  std::size_t n = 0;
  while (contour.stopReason() == StopReason::running) n += contour.step().questions.size();
  return n;
}

int countHeld(const std::vector<StepReport>& reports) {
  int n = 0;
  for (const StepReport& r : reports)
    for (const Event& e : r.events) n += e.held.has_value() && e.kind == EventKind::rolledBack;
  return n;
}

}  // namespace

TEST_CASE("a torus whose fronts may not meet stays a sphere with a gap", "[veto]") {
  const Event meeting = firstChange(torusVolume(), {kTorusSeed});
  REQUIRE(meeting.kind == EventKind::handleInserted);
  ActiveContour contour(torusVolume(), {kTorusSeed}, {}, vetoing({{meeting.iteration, meeting.location}}));
  const auto reports = runCertified(contour);
  CHECK(contour.stopReason() == StopReason::converged);  // what is locked is so because it was asked for
  CHECK(certify(contour.mesh().compact()).genus == std::vector<int>{0});
  CHECK(countHeld(reports) >= 1);
  CHECK_FALSE(contour.waitingVeto().has_value());
  const double whole = 2 * M_PI * M_PI * kTorusR * kTorusr * kTorusr;
  CHECK(volumeOf(contour.mesh()) > 0.9 * whole);
  CHECK(volumeOf(contour.mesh()) < whole);
}

TEST_CASE("a veto in a history goes on from the step before, as if it had been known from the start",
          "[veto][history]") {
  const Event meeting = firstChange(torusVolume(), {kTorusSeed});
  const Constraints veto = vetoing({{meeting.iteration, meeting.location}});
  History history(ActiveContour(torusVolume(), {kTorusSeed}, {}));
  while (history.stopReason() == StopReason::running) history.advance();
  history.goTo(meeting.iteration - 1);
  const Mesh before = history.shown().mesh();
  history.change({{kTorusSeed}, {}, veto});
  CHECK(isSame(history.shown().mesh(), before));
  while (history.stopReason() == StopReason::running) history.advance();
  ActiveContour straight(torusVolume(), {kTorusSeed}, {}, veto);
  run(straight);
  CHECK(isSame(history.shown().mesh(), straight.mesh()));

  // Lifted, the fronts meet after all.
  history.change({{kTorusSeed}, {}, {}});
  while (history.stopReason() == StopReason::running) history.advance();
  CHECK(certify(history.shown().mesh().compact()).genus == std::vector<int>{1});
}

TEST_CASE("two bodies that may not join stay two", "[veto]") {
  const std::vector<Seed> seeds{{kMiddle + Vec3(-5, 0, 0), 3.0}, {kMiddle + Vec3(5, 1, 0), 3.0}};
  const Event meeting = firstChange(ballVolume(), seeds);
  ActiveContour contour(ballVolume(), seeds, {}, vetoing({{meeting.iteration, meeting.location}}));
  runCertified(contour);
  CHECK(certify(contour.mesh().compact()).components == 2);
  CHECK(volumeOf(contour.mesh()) > 0.75 * kBallVolume);
}

TEST_CASE("a neck that may not split stays, thin, for good", "[veto]") {
  const TwoBalls balls;
  const Event cut = firstChange(balls.volume, balls.seeds, bothWays());
  REQUIRE(cut.kind == EventKind::split);
  const Constraints constraints =
      GENERATE_COPY(vetoing({{cut.iteration, cut.location}}), limited(1, std::nullopt));
  ActiveContour contour(balls.volume, balls.seeds, bothWays(), constraints);
  runCertified(contour);
  CHECK(certify(contour.mesh().compact()).components == 1);
  CHECK(volumeOf(contour.mesh()) == Approx(2 * kBallVolume).epsilon(0.05));
  REQUIRE(contour.held().size() == 1);
  CHECK(contour.held()[0].kind == EventKind::split);
  CHECK(contour.held()[0].iteration == cut.iteration);
  CHECK(contour.held()[0].isVetoed == !constraints.vetoes.empty());
}

TEST_CASE("a component that may not be deleted is kept, as small as it is", "[veto]") {
  Parameters p = bothWays();
  p.range = IntensityRange{-1000, 110};
  p.curvature = 50;  // holds fronts of 100 mm and more: everything here collapses
  p.edgeLength = 2;
  p.maxIterations = 300;
  const Volume volume = ballVolume();
  const std::vector<Seed> seeds{{kMiddle, 6.0}};
  const Event last = firstChange(volume, seeds, p);
  REQUIRE(last.kind == EventKind::componentDeleted);
  ActiveContour contour(volume, seeds, p, vetoing({{last.iteration, last.location}}));
  runCertified(contour);
  CHECK(certify(contour.mesh().compact()).components == 1);
  REQUIRE(contour.held().size() == 1);
  CHECK(contour.held()[0].kind == EventKind::componentDeleted);
  CHECK(contour.held()[0].times == 1);  // and then it stays locked
}

TEST_CASE("a veto without sense is refused with one sentence", "[veto]") {
  const auto message = [](const Constraints& constraints) {
    return messageOf([&] {
      ActiveContour contour(torusVolume(), {kTorusSeed}, {}, constraints);
      run(contour);
    });
  };
  CHECK(message(vetoing({{3, kMiddle}})) ==
        "The veto of iteration 3 has nothing to forbid: no change of topology happens there.");
  CHECK(message(vetoing({{0, kMiddle}})).find("at least 1") != std::string::npos);
  CHECK(message(limited(0, {})).find("at least 1") != std::string::npos);
  CHECK(message(limited({}, -1)).find("at least 0") != std::string::npos);
  CHECK(message(limited({}, {}, {kMiddle})).find("no limit") != std::string::npos);
  CHECK(message(limited({}, 0, {Vec3(-9, 0, 0)})).find("outside of the volume") != std::string::npos);
  ActiveContour contour(torusVolume(), {kTorusSeed}, {});
  contour.step();
  contour.step();
  CHECK(messageOf([&] {
          contour.change({{kTorusSeed}, {}, vetoing({{2, kMiddle}})});
        }).find("too late") != std::string::npos);
  CHECK(contour.constraints().empty());
  ActiveContour late(torusVolume(), {kTorusSeed}, {}, vetoing({{1500, kMiddle}}));
  run(late);
  REQUIRE(late.waitingVeto().has_value());
  CHECK(late.waitingVeto()->iteration == 1500);
}

TEST_CASE("a limit of the genus holds what would break it, and lets all else happen", "[veto]") {
  ActiveContour held(torusVolume(), {kTorusSeed}, {}, limited({}, 0));
  for (const StepReport& r : runCertified(held))
    for (const Event& e : r.events) CHECK(e.after.genus == 0);
  CHECK(certify(held.mesh().compact()).genus == std::vector<int>{0});
  ActiveContour free(torusVolume(), {kTorusSeed}, {}),
      allowed(torusVolume(), {kTorusSeed}, {}, limited(1, 1));
  run(free);
  run(allowed);
  CHECK(isSame(free.mesh(), allowed.mesh()));
  held.change({{kTorusSeed}, {}, {}});
  run(held);
  CHECK(certify(held.mesh().compact()).genus == std::vector<int>{1});
}

TEST_CASE("places of the topology and a surface to begin with may lie anywhere in an oblique volume") {
  Grid grid = testing::cubicGrid(20);
  grid.direction = Eigen::AngleAxisd(0.6, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  grid.spacing = Vec3(1, 0.8, 1.25);
  grid.origin = Vec3(-50, 20, 10);
  Constraints c;
  c.topology.genus = 0;
  c.start.emplace();
  c.start->mesh = std::make_shared<const TriangleSoup>(icosphere(grid.toWorld(Vec3(9, 9, 9)), 2, 1));
  for (int i = 0; i < 1000; ++i) {
    const Vec3 place = grid.toWorld(Vec3(i % 10, i / 10 % 10, i / 100) * 2.1);
    c.topology.allowed = c.topology.kept = {place};
    c.start->inside = place;
    REQUIRE_NOTHROW(requireSensible(c, grid));
  }
  c.start->inside = grid.toWorld(Vec3(9, 9, 19.6));
  CHECK_THROWS_AS(requireSensible(c, grid), UsageError);
  c.start.reset();
  c.topology.allowed = {grid.toWorld(Vec3(-0.6, 9, 9))};
  CHECK_THROWS_AS(requireSensible(c, grid), UsageError);
}

TEST_CASE("what a limit holds may happen at an allowed place, known from the start or named on the way",
          "[veto][history]") {
  ActiveContour held(torusVolume(), {kTorusSeed}, {}, limited({}, 0));
  run(held);
  REQUIRE(held.held().size() == 1);
  const Vec3 place = held.held()[0].place;
  const Constraints allowing = limited({}, 0, {place});
  ActiveContour straight(torusVolume(), {kTorusSeed}, {}, allowing), free(torusVolume(), {kTorusSeed}, {});
  run(straight);
  run(free);
  CHECK(isSame(straight.mesh(), free.mesh()));
  CHECK(straight.held().empty());

  held.change({{kTorusSeed}, {}, allowing});
  CHECK(held.held().empty());
  run(held);
  CHECK(certify(held.mesh().compact()).genus == std::vector<int>{1});
  CHECK(held.warnings(held.support()).empty());

  ActiveContour elsewhere(torusVolume(), {kTorusSeed}, {}, limited({}, 0, {kTorusSeed.centre}));
  run(elsewhere);
  CHECK(certify(elsewhere.mesh().compact()).genus == std::vector<int>{0});
  const auto warnings = sentences(elsewhere.warnings(elsewhere.support()));
  CHECK(std::any_of(warnings.begin(), warnings.end(),
                    [](const std::string& d) { return d.find("allowed place") != std::string::npos; }));
}

TEST_CASE("a limit of the components keeps a cavity open to the outside", "[veto]") {
  const auto shell = [](const Vec3& p) {
    const double r = (p - kMiddle).norm();
    return std::max(r - 13, 4 - r);
  };
  ActiveContour contour(darkObject(cubicGrid(41), shell), {Seed{kMiddle + Vec3(8.5, 0, 0), 2.5}}, {},
                        limited(1, {}));
  const auto reports = runCertified(contour);
  CHECK(countHeld(reports) >= 1);
  CHECK(certify(contour.mesh().compact()).components == 1);
}

TEST_CASE("limits that ask tell each change once, with the length of the tunnel, and change no mesh",
          "[veto][ask]") {
  ActiveContour told(torusVolume(), {kTorusSeed}, {}, limited({}, 0)),
      asked(torusVolume(), {kTorusSeed}, {}, asking({}, 0));
  CHECK(countQuestions(told) == 0);
  const HeldPlace question = firstQuestion(asked);
  CHECK(question.kind == EventKind::handleInserted);
  // Around the hole, along edges.
  CHECK(question.size.tunnel > 2 * M_PI * (kTorusR - kTorusr));
  CHECK(question.size.tunnel < 2 * M_PI * (kTorusR + kTorusr));
  CHECK_THAT(sentence(question), Contains("fronts would meet at ") && Contains(" mm around"));
  CHECK_FALSE(question.isDecided);
  CHECK(countQuestions(asked) == 0);
  CHECK(isSame(told.mesh(), asked.mesh()));
  CHECK(asked.held() == told.held());
}

TEST_CASE("an answer lets a held change happen, or holds it for good without another question",
          "[veto][ask][history]") {
  History history(ActiveContour(torusVolume(), {kTorusSeed}, {}, asking({}, 0)));
  while (history.steps().back().questions.empty()) history.advance();
  const HeldPlace question = history.steps().back().questions[0];
  Constraints answer = asking({}, 0);
  SECTION("held") {
    answer.topology.kept = {question.place};
    history.change({{kTorusSeed}, {}, answer});
    while (history.stopReason() == StopReason::running) {
      history.advance();
      CHECK(history.steps().back().questions.empty());
    }
    REQUIRE(history.shown().held().size() == 1);
    CHECK(history.shown().held()[0].isDecided);
    ActiveContour unasked(torusVolume(), {kTorusSeed}, {}, limited({}, 0));
    run(unasked);
    CHECK(isSame(history.shown().mesh(), unasked.mesh()));
    // Known from the start it is not asked at all.
    ActiveContour known(torusVolume(), {kTorusSeed}, {}, answer);
    CHECK(countQuestions(known) == 0);
    CHECK(isSame(known.mesh(), unasked.mesh()));
  }
  SECTION("let happen") {
    answer.topology.allowed = {question.place};
    history.change({{kTorusSeed}, {}, answer});
    while (history.stopReason() == StopReason::running) history.advance();
    CHECK(certify(history.shown().mesh().compact()).genus == std::vector<int>{1});
    CHECK(history.shown().held().empty());
  }
  // The way there is gone again, bit for bit.
  const Mesh end = history.shown().mesh();
  ActiveContour again(torusVolume(), {kTorusSeed}, {}, asking({}, 0));
  while (again.iteration() < question.iteration) again.step();
  again.change({{kTorusSeed}, {}, answer});
  run(again);
  CHECK(isSame(again.mesh(), end));
}

TEST_CASE("what would come off is told with what it encloses, a cavity as one", "[veto][ask]") {
  const TwoBalls balls;
  ActiveContour split(balls.volume, balls.seeds, bothWays(), asking(1, {}));
  const HeldPlace part = firstQuestion(split);
  CHECK(part.kind == EventKind::split);
  CHECK(part.size.part == Approx(kBallVolume).epsilon(0.4));  // both are larger yet
  CHECK_FALSE(part.size.isCavity);
  CHECK_THAT(sentence(part), Contains(" ml would come off at "));

  const double inner = 4;
  const auto shell = [&](const Vec3& p) {
    const double r = (p - kMiddle).norm();
    return std::max(r - 13, inner - r);
  };
  ActiveContour closing(darkObject(cubicGrid(41), shell), {Seed{kMiddle + Vec3(8.5, 0, 0), 2.5}}, {},
                        asking(1, {}));
  const HeldPlace cavity = firstQuestion(closing);
  CHECK(cavity.size.isCavity);
  CHECK(cavity.size.part > 4.0 / 3 * M_PI * std::pow(inner, 3) * 0.8);
  CHECK(cavity.size.part < 4.0 / 3 * M_PI * std::pow(2 * inner, 3));
  CHECK(sentence(cavity).rfind("it would enclose a cavity of ", 0) == 0);
}

TEST_CASE("asking and holding need a limit", "[veto][ask]") {
  const auto message = [](const TopologyLimits& limits) {
    return messageOf([&] { requireSensible(Constraints{{}, {}, limits}, torusVolume().grid); });
  };
  CHECK(message({{}, {}, {}, true}).find("nothing to ask about") != std::string::npos);
  CHECK(message({{}, {}, {}, false, {kMiddle}}).find("nothing to hold") != std::string::npos);
  CHECK(message({{}, 0, {}, true, {Vec3(-9, 0, 0)}}).find("outside of the volume") != std::string::npos);
}
