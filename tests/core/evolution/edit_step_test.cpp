// Edits as steps of the growth: tunnels closed, components removed, cavities filled.
#include "core/evolution/edit_step.h"

#include <numeric>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/evolution/history.h"
#include "core/mesh/pieces.h"
#include "core/mesh/tunnels.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

const Seed kTorusSeed{kMiddle + Vec3(kTorusR, 0, 0), 3.0};
const std::vector<Seed> kTwoSeeds{{Vec3(14, 20, 20), 3.0}, {Vec3(42, 20, 20), 3.0}};

Constraints editing(std::vector<MeshEdit> edits, WallList walls = {}) {
  Constraints c;
  c.walls = std::move(walls);
  c.edits = std::move(edits);
  return c;
}

Volume twoBalls() {
  Grid grid = cubicGrid(41);
  grid.size[0] = 62;
  return darkObject(grid, [](const Vec3& p) {
    return std::min((p - Vec3(14, 20, 20)).norm(), (p - Vec3(42, 20, 20)).norm()) - 10;
  });
}

//! A ball with a hollow of radius 6 mm in its middle.
double shellDistance(const Vec3& p) {
  const double r = (p - kMiddle).norm();
  return std::max(r - 13, 6 - r);
}
Volume shellVolume() { return darkObject(cubicGrid(41), shellDistance); }
const Seed kShellSeed{kMiddle + Vec3(9.5, 0, 0), 2.0};

void run(ActiveContour& contour) {
  while (contour.stopReason() == StopReason::running) {
    contour.step();
    REQUIRE(contour.iteration() < 2000);
  }
}

const ActiveContour& grownTorus() {
  static const ActiveContour grown = [] {
    ActiveContour contour(torusVolume(), {kTorusSeed}, {});
    run(contour);
    return contour;
  }();
  return grown;
}

Request with(const ActiveContour& contour, const MeshEdit& edit) {
  Request request = contour.request();
  request.constraints.edits.push_back(edit);
  return request;
}

int genusOf(const Mesh& mesh) {
  const Certificate c = certify(mesh.compact());
  REQUIRE(c.boundsBody());
  return std::accumulate(c.genus.begin(), c.genus.end(), 0);
}

//! The tunnel of the torus, or of the first that there is.
MeshEdit closing(const ActiveContour& contour, TunnelCut cut = TunnelCut::shorter) {
  const TunnelList list = findTunnels(contour.mesh());
  REQUIRE_FALSE(list.tunnels.empty());
  return {contour.iteration() + 1, MeshEditKind::closeTunnel, list.tunnels[0].position, cut};
}

}  // namespace

TEST_CASE("a step closes the tunnel of a torus along either loop, and is certified", "[edit]") {
  for (const TunnelCut cut : {TunnelCut::handle, TunnelCut::tunnel}) {
    ActiveContour contour = grownTorus();
    REQUIRE(contour.stopReason() == StopReason::converged);
    const int before = contour.iteration();
    const double volume = volumeOf(contour.mesh());
    contour.change(with(contour, closing(contour, cut)));
    CHECK(contour.stopReason() == StopReason::running);
    REQUIRE(contour.waitingEdit());
    const StepReport report = contour.step();
    CHECK(contour.iteration() == before + 1);
    CHECK(report.iteration == before + 1);
    REQUIRE(report.events.size() == 1);
    const Event& e = report.events[0];
    CHECK(e.kind == (cut == TunnelCut::handle ? EventKind::handleCut : EventKind::tunnelClosed));
    CHECK(e.iteration == before + 1);
    CHECK(changesTopology(e.kind));
    CHECK(e.before.genus == 1);
    CHECK(e.after.genus == 0);
    REQUIRE(e.edit);
    CHECK(e.edit->loop > 0);
    CHECK(e.edit->volumeBefore == Approx(volume));
    CHECK(e.edit->volumeAfter == Approx(volumeOf(contour.mesh())));
    CHECK((e.edit->volumeAfter > volume) == (cut == TunnelCut::tunnel));
    CHECK(report.volume == Approx(volumeOf(contour.mesh())));
    CHECK(genusOf(contour.mesh()) == 0);
    CHECK_FALSE(contour.waitingEdit());
    CHECK(contour.stopReason() == StopReason::converged);  // what rested goes on resting
  }
}

TEST_CASE("what an edit made sleeps, and goes on with everything else when that is woken", "[edit]") {
  ActiveContour contour = grownTorus();
  contour.change(with(contour, closing(contour, TunnelCut::tunnel)));
  const int known = contour.mesh().vertexSlots();
  std::vector<unsigned char> was;
  for (int v = 0; v < known; ++v) was.push_back(contour.mesh().isVertex(v) && contour.isConverged(v));
  const Mesh before = contour.mesh();
  contour.step();
  int fresh = 0;
  for (int v = 0; v < contour.mesh().vertexSlots(); ++v) {
    if (!contour.mesh().isVertex(v)) continue;
    const bool isNew = v >= known || !before.isVertex(v);
    fresh += isNew;
    CHECK(contour.isConverged(v) == (isNew || was[v] != 0));
  }
  CHECK(fresh > 0);
  Parameters other = contour.requested();
  other.curvature = 0.3;
  contour.changeParameters(other);
  CHECK(contour.stopReason() == StopReason::running);
  CHECK(runCertified(contour).size() > 1);
}

TEST_CASE("an edit on the way is followed by steps as any; known from the start it makes the same mesh",
          "[edit][history]") {
  History history(ActiveContour(torusVolume(), {kTorusSeed}, {}));
  const auto isTorus = [&] { return topologyNumbers(history.shown().mesh()).genus == 1; };
  while (!isTorus()) history.advance();
  const int met = history.iteration();
  const MeshEdit edit = closing(history.shown(), TunnelCut::handle);
  history.change(with(history.shown(), edit));
  history.advance();
  CHECK(history.iteration() == met + 1);
  CHECK(genusOf(history.shown().mesh()) == 0);
  while (history.stopReason() == StopReason::running) history.advance();
  CHECK(history.lastIteration() > met + 1);
  ActiveContour straight(torusVolume(), {kTorusSeed}, {}, editing({edit}));
  runCertified(straight);
  CHECK(isSame(history.shown().mesh(), straight.mesh()));
  CHECK(straight.iteration() == history.lastIteration());
}

TEST_CASE("back from an edit and forth again is exact, and without it the tunnel is there again",
          "[edit][history]") {
  History history(grownTorus());
  const int last = history.iteration();
  const Mesh open = history.shown().mesh();
  const Request free = history.shown().request();
  history.change(with(history.shown(), closing(history.shown())));
  history.advance();
  const Mesh closed = history.shown().mesh();
  CHECK(history.lastIteration() == last + 1);
  CHECK(genusOf(closed) == 0);
  history.goTo(last);
  CHECK(isSame(history.shown().mesh(), open));
  history.goTo(last + 1);
  CHECK(isSame(history.shown().mesh(), closed));
  REQUIRE(history.changes().size() == 1);
  CHECK(history.changes()[0].constraints->edits.size() == 1);
  CHECK(history.traced(last + 1).at(0).kind == history.events().back().kind);
  history.goTo(last);
  history.change(free);
  CHECK(history.lastIteration() == last);
  CHECK(history.events().empty());
  CHECK(history.stopReason() == StopReason::converged);
}

TEST_CASE("an edit that is refused leaves a history as it was, also what it shows", "[edit][history]") {
  History history(grownTorus());
  const Request before = history.shown().request();
  history.change(with(history.shown(), {history.iteration() + 1, MeshEditKind::fillCavity, kMiddle}));
  CHECK(history.stopReason() == StopReason::running);
  CHECK_THROWS_AS(history.advance(), UsageError);
  CHECK(history.shown().request() == before);
  CHECK(history.shown().stopReason() == StopReason::converged);
  history.change(before);
  CHECK(history.stopReason() == StopReason::converged);
  CHECK(history.changes().empty());
}

TEST_CASE("an edit that finds nothing or fits nowhere is one sentence, and nothing changes", "[edit]") {
  ActiveContour contour = grownTorus();
  const int next = contour.iteration() + 1;
  const Mesh before = contour.mesh();
  const auto message = [&](MeshEditKind kind, const Vec3& place) {
    contour.change({contour.requestedSeeds(), contour.requested(), editing({{next, kind, place}})});
    const std::string said = messageOf([&] { contour.step(); });
    CHECK(isSame(contour.mesh(), before));
    CHECK(contour.iteration() == next - 1);
    return said;
  };
  const std::string number = std::to_string(next);
  CHECK(message(MeshEditKind::closeTunnel, Vec3(500, 0, 0)) ==
        "The edit of iteration " + number + " finds no tunnel at 500,0,0.");
  CHECK(message(MeshEditKind::fillCavity, kMiddle) ==
        "The edit of iteration " + number + " finds no cavity at 20,20,20.");
  CHECK(message(MeshEditKind::removeComponent, Vec3(-500, 0, 0)) ==
        "The edit of iteration " + number + " finds no component at -500,0,0.");
  CHECK(message(MeshEditKind::removeComponent, kTorusSeed.centre) ==
        "The edit of iteration " + number + " would leave nothing of the surface.");
  CHECK(message(MeshEditKind::keepComponent, kTorusSeed.centre).find("nothing beside") != std::string::npos);
  // Without it all is as if it had never been.
  contour.change(grownTorus().request());
  CHECK(isSame(contour.mesh(), before));
}

TEST_CASE("edits without sense are refused with one sentence", "[edit]") {
  const auto message = [](const Constraints& c) {
    return messageOf([&] { ActiveContour(torusVolume(), {kTorusSeed}, {}, c); });
  };
  const MeshEdit one{3, MeshEditKind::removeComponent, kMiddle};
  CHECK(message(editing({{0, MeshEditKind::closeTunnel, kMiddle}})).find("at least 1") != std::string::npos);
  CHECK(message(editing({one, {3, MeshEditKind::closeTunnel, kMiddle}})) ==
        "There are two edits of iteration 3: a step can be one only.");
  Constraints both = editing({one});
  both.vetoes.push_back({3, kMiddle});
  CHECK(message(both) == "Iteration 3 is an edit: there is nothing that a veto could forbid.");
  ActiveContour late = grownTorus();
  CHECK(messageOf([&] { late.change(with(late, one)); }).find("comes too late") != std::string::npos);
}

TEST_CASE("a contour at rest goes on for an edit that waits, one at its limit only for the next step",
          "[edit]") {
  ActiveContour contour = grownTorus();
  const int rested = contour.iteration();
  MeshEdit later = closing(contour);
  later.iteration = rested + 6;
  contour.change(with(contour, later));
  run(contour);
  CHECK(contour.iteration() == rested + 6);
  CHECK(contour.stopReason() == StopReason::converged);
  CHECK(genusOf(contour.mesh()) == 0);

  Parameters few;
  few.maxIterations = 8;
  ActiveContour limited(twoBalls(), kTwoSeeds, few);
  run(limited);
  REQUIRE(limited.stopReason() == StopReason::maxIterations);
  const Vec3 place = kTwoSeeds[1].centre;
  ActiveContour tooFar = limited;
  tooFar.change(with(tooFar, {10, MeshEditKind::removeComponent, place}));
  CHECK(tooFar.stopReason() == StopReason::maxIterations);
  limited.change(with(limited, {9, MeshEditKind::removeComponent, place}));
  CHECK(limited.stopReason() == StopReason::running);
  limited.step();
  CHECK(limited.stopReason() == StopReason::maxIterations);
  CHECK(topologyNumbers(limited.mesh()).components == 1);
}

TEST_CASE("components are removed and kept by a place on them, and the others grow on", "[edit]") {
  for (const MeshEditKind kind : {MeshEditKind::removeComponent, MeshEditKind::keepComponent}) {
    ActiveContour contour(twoBalls(), kTwoSeeds, {});
    for (int i = 0; i < 10; ++i) contour.step();
    const double half = volumeOf(contour.mesh()) / 2;
    contour.change(with(contour, {11, kind, kTwoSeeds[0].centre}));
    const StepReport report = contour.step();
    REQUIRE(report.events.size() == 1);
    CHECK(report.events[0].kind == EventKind::componentRemoved);
    CHECK(report.events[0].edit->volumeAfter == Approx(half).epsilon(0.05));
    runCertified(contour);
    CHECK(volumeOf(contour.mesh()) == Approx(kBallVolume).epsilon(0.1));
    const double middle = listPieces(contour.mesh())[0].centre.x();
    CHECK(middle == Approx(kind == MeshEditKind::removeComponent ? 42 : 14).margin(1));
  }
}

TEST_CASE("a cavity is filled, unless a wall lies in it", "[edit][walls]") {
  WallList wall;
  wall.balls.push_back({kMiddle, 2});
  for (const bool walled : {false, true}) {
    ActiveContour contour(shellVolume(), {kShellSeed}, {}, editing({}, walled ? wall : WallList{}));
    run(contour);
    REQUIRE(topologyNumbers(contour.mesh()).components == 2);
    const Mesh before = contour.mesh();
    contour.change(
        with(contour, {contour.iteration() + 1, MeshEditKind::fillCavity, kMiddle + Vec3(6, 0, 0)}));
    if (walled) {
      CHECK(messageOf([&] { contour.step(); }).find("into a wall or around it") != std::string::npos);
      CHECK(isSame(contour.mesh(), before));
      continue;
    }
    const StepReport report = contour.step();
    REQUIRE(report.events.size() == 1);
    CHECK(report.events[0].kind == EventKind::cavityFilled);
    CHECK(report.volume == Approx(4.0 / 3 * M_PI * 13 * 13 * 13).epsilon(0.05));
    CHECK(certify(contour.mesh().compact()).boundsBody());
  }
}

TEST_CASE("a membrane is not put into a wall, and the other loop goes around it", "[edit][walls]") {
  WallList wall;
  wall.balls.push_back({kMiddle, 3});
  ActiveContour contour(torusVolume(), {kTorusSeed}, {}, editing({}, wall));
  run(contour);
  REQUIRE(genusOf(contour.mesh()) == 1);
  const Mesh before = contour.mesh();
  ActiveContour other = contour;
  contour.change(with(contour, closing(contour, TunnelCut::tunnel)));
  CHECK(messageOf([&] { contour.step(); }).find("into a wall or around it") != std::string::npos);
  CHECK(isSame(contour.mesh(), before));
  other.change(with(other, closing(other, TunnelCut::handle)));
  other.step();
  CHECK(genusOf(other.mesh()) == 0);
}

TEST_CASE("a limit of the genus is no obstacle to an edit, which only ever lowers it", "[edit]") {
  ActiveContour contour = grownTorus();
  Request request = with(contour, closing(contour));
  request.constraints.topology.genus = 0;
  contour.change(request);
  contour.step();
  CHECK(genusOf(contour.mesh()) == 0);
  runCertified(contour);
  CHECK(genusOf(contour.mesh()) == 0);
}

TEST_CASE("an edit that is cancelled has not begun", "[edit]") {
  ActiveContour contour = grownTorus();
  contour.change(with(contour, closing(contour)));
  const Mesh before = contour.mesh();
  {
    const std::atomic<bool> stopRequest{true};
    const CancelScope scope(stopRequest);
    CHECK_THROWS_AS(contour.step(), Cancelled);
  }
  CHECK(isSame(contour.mesh(), before));
  CHECK(contour.waitingEdit());
  contour.step();
  CHECK(genusOf(contour.mesh()) == 0);
}

namespace {

//! Random steps, ways back and edits of a growth. Every mesh that comes out is certified.
class RandomWalk {
 public:
  RandomWalk(const ActiveContour& start, unsigned seed) : history_(start), random_(seed) {}

  void walk(int turns) {
    for (int i = 0; i < turns; ++i) {
      const unsigned what = random_() % 4;
      if (what == 0)
        history_.goTo(history_.firstIteration() +
                      static_cast<int>(random_() % static_cast<unsigned>(history_.lastIteration() -
                                                                         history_.firstIteration() + 1)));
      else if (what == 1)
        go(1 + random_() % 40);
      else
        edit();
      expectCertified();
    }
  }
  const History& history() const { return history_; }
  int made() const { return made_; }
  int refused() const { return refused_; }

 private:
  void expectCertified() const {
    const Certificate c = certify(history_.shown().mesh().compact());
    CAPTURE(history_.iteration());
    if (!c.boundsBody()) FAIL("an invalid mesh");
  }
  void go(unsigned long steps) {
    for (unsigned long i = 0; i < steps && history_.stopReason() == StopReason::running; ++i) try {
        history_.advance();
      } catch (const UsageError&) {  // an edit that waits finds nothing on this way
        ++refused_;
        leaveOut(history_.iteration() + 1);
      }
  }
  void leaveOut(int iteration) {
    Request request{history_.seeds(), history_.parameters(), history_.constraints()};
    std::erase_if(request.constraints.edits, [&](const MeshEdit& e) { return e.iteration == iteration; });
    history_.change(request);
  }
  Vec3 somePlace() {
    const Mesh& mesh = history_.shown().mesh();
    const std::vector<Tunnel> tunnels = findTunnels(mesh).tunnels;
    if (!tunnels.empty() && random_() % 2 == 0) return tunnels[random_() % tunnels.size()].position;
    const TriangleSoup soup = mesh.compact();
    return soup.points[random_() % soup.points.size()];
  }
  void edit() {
    const MeshEdit edit{history_.iteration() + 1, static_cast<MeshEditKind>(random_() % 4), somePlace(),
                        static_cast<TunnelCut>(random_() % 3)};
    const Request before{history_.seeds(), history_.parameters(), history_.constraints()};
    Request request = before;
    std::erase_if(request.constraints.edits,
                  [&](const MeshEdit& e) { return e.iteration > history_.iteration(); });
    request.constraints.edits.push_back(edit);
    history_.change(request);
    const Mesh mesh = history_.shown().mesh();
    try {
      history_.advance();
      ++made_;
    } catch (const UsageError&) {
      ++refused_;
      CHECK(isSame(history_.shown().mesh(), mesh));
      leaveOut(edit.iteration);
    }
  }

  History history_;
  std::mt19937 random_;
  int made_ = 0, refused_ = 0;
};

//! The same again from what a session would hold.
Mesh replayed(ActiveContour contour, const History& history) {
  const std::vector<ParameterChange> changes = history.changes();
  while (contour.iteration() < history.iteration()) {
    for (const ParameterChange& c : changes)
      if (c.iteration == contour.iteration()) contour.change(changed(contour.request(), c));
    contour.step();
  }
  return contour.mesh();
}

}  // namespace

TEST_CASE("random sequences of edits, steps and ways back leave valid meshes and replay the same",
          "[edit][history]") {
  const std::vector<ActiveContour> starts{
      {torusVolume(), {kTorusSeed}, {}}, {shellVolume(), {kShellSeed}, {}}, {twoBalls(), kTwoSeeds, {}}};
  int made = 0, refused = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    const ActiveContour& start = starts[seed % starts.size()];
    ActiveContour begun = start;
    for (unsigned i = 0; i < 60 + 10 * seed && begun.stopReason() == StopReason::running; ++i) begun.step();
    RandomWalk walk(begun, seed);
    walk.walk(14);
    made += walk.made();
    refused += walk.refused();
    CHECK(isSame(replayed(begun, walk.history()), walk.history().shown().mesh()));
  }
  CHECK(made > 12);
  CHECK(refused > 12);
  INFO(made << " made, " << refused << " refused");
}
