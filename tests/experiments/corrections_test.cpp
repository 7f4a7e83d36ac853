// Any corrections, in any order, taken back too, with runs between them: never an invalid mesh or a crash, a
// refusal changes nothing, and what was recorded makes the same mesh again, bit for bit.

#include <cstdlib>
#include <iostream>
#include <map>

#include "core/errors.h"
#include "core/evolution/history.h"
#include "core/mesh/pieces.h"
#include "core/mesh/tunnels.h"
#include "tests/core/evolution/contour_support.h"
#include "tests/support/wall_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

//! A minute; HANDLEBODY_CORRECTIONS=1000 makes as many sequences, HANDLEBODY_CORRECTIONS_FROM=500 others.
int number(const char* variable, int otherwise) {
  const char* const text = std::getenv(variable);
  return text ? std::max(0, std::atoi(text)) : otherwise;
}

constexpr int kSequences = 60;
constexpr int kCorrections = 12;  // of a sequence

//! A ball with a hollow, three bars that cross, a torus, two balls joined by a bar.
double shell(const Vec3& p) { return std::max((p - kMiddle).norm() - 13, 6 - (p - kMiddle).norm()); }
double bars(const Vec3& p) {
  const Vec3 q = p - kMiddle;
  const auto frame = [](double a, double b, double c) {  // a square of bars round the c axis
    return std::max(std::abs(std::max(std::abs(a), std::abs(b)) - 10), std::abs(c)) - 3.5;
  };
  return std::min({frame(q.x(), q.y(), q.z()), frame(q.y(), q.z(), q.x())});
}
double dumbbell(const Vec3& p) {
  const Vec3 q = p - kMiddle;
  const double balls = std::min((q - Vec3(9, 0, 0)).norm(), (q + Vec3(9, 0, 0)).norm()) - 7;
  return std::min(balls, std::max(std::hypot(q.y(), q.z()) - 3, std::abs(q.x()) - 9));
}

struct Shape {
  const char* name;
  double (*distance)(const Vec3&);
  std::vector<Seed> seeds;
};
const Shape kShapes[] = {
    {"torus", torusDistance, {{kMiddle + Vec3(kTorusR, 0, 0), 3.0}}},
    {"shell", shell, {{kMiddle + Vec3(9.5, 0, 0), 2.0}}},
    {"bars", bars, {{kMiddle + Vec3(10, 0, 0), 2.0}}},
    {"dumbbell", dumbbell, {{kMiddle + Vec3(9, 0, 0), 3.0}, {kMiddle - Vec3(9, 0, 0), 3.0}}},
};

class Sequence {
 public:
  Sequence(const Shape& shape, unsigned seed) : random_(seed), history_(begin(shape)) {}

  void play() {
    for (int i = 0; i < kCorrections; ++i) {
      correct();
      run(static_cast<int>(random_() % 15));
    }
    run(400);
  }
  //! Everything again from the beginning, as a session does it.
  Mesh replayed() const {
    ActiveContour again = beginning_.value();
    const std::vector<ParameterChange> changes = history_.changes();
    auto change = changes.begin();
    for (;;) {
      if (change != changes.end() && change->iteration == again.iteration()) {
        again.change(changed(again.request(), *change));
        ++change;
      }
      if (again.iteration() >= history_.iteration()) return again.mesh();
      again.step();
    }
  }
  const Mesh& mesh() const { return history_.shown().mesh(); }
  void count(std::map<std::string, int>& made, std::map<std::string, int>& refused) const {
    for (const auto& [name, n] : made_) made[name] += n;
    for (const auto& [name, n] : refused_) refused[name] += n;
  }

 private:
  ActiveContour begin(const Shape& shape) {
    Parameters p;
    p.direction = random_() % 3 == 0 ? Direction::both : Direction::outward;
    p.maxIterations = 600;
    if (random_() % 2) p.edgeLength = uniform(1.6, 3);
    if (random_() % 2) p.range = IntensityRange{-1e9, 110};
    beginning_ = ActiveContour(darkObject(cubicGrid(41), shape.distance), shape.seeds, p);
    return *beginning_;
  }
  double uniform(double a, double b) { return a + (b - a) * static_cast<double>(random_()) / 4294967296.0; }
  Vec3 away(double mm) { return {uniform(-mm, mm), uniform(-mm, mm), uniform(-mm, mm)}; }
  Vec3 onSurface() {
    const std::vector<Vec3> points = mesh().compact().points;
    return points.empty() ? kMiddle : points[random_() % points.size()];
  }
  Request now() const { return {history_.seeds(), history_.parameters(), history_.constraints()}; }

  //! What is refused has changed nothing.
  bool change(const std::string& name, const Request& request) {
    const Mesh before = mesh();
    try {
      history_.change(request);
      ++made_[name];
      return true;
    } catch (const UsageError& error) {
      REQUIRE(std::string(error.what()).size() > 20);
      REQUIRE(isSame(before, mesh()));
      ++refused_[name];
      return false;
    }
  }

  void run(int steps) {
    for (int i = 0; i < steps && history_.stopReason() == StopReason::running; ++i) {
      const Mesh before = mesh();
      try {
        history_.advance();
      } catch (const UsageError&) {  // an edit or a pin that finds nothing: taken away again
        REQUIRE(isSame(before, mesh()));
        ++refused_["at its step"];
        Request request = now();
        const int next = history_.iteration() + 1;
        std::erase_if(request.constraints.edits, [&](const MeshEdit& e) { return e.iteration >= next; });
        std::erase_if(request.constraints.pins, [&](const Pin& p) { return p.iteration >= next; });
        std::erase_if(request.constraints.vetoes, [&](const Veto& v) { return v.iteration >= next; });
        history_.change(request);
        continue;
      }
      const TriangleSoup soup = mesh().compact();
      if (!soup.triangles.empty()) REQUIRE(certify(soup).boundsBody());
      REQUIRE(mesh().vertexCount() < 20000);
      if (history_.iteration() == history_.lastIteration()) answer();
    }
    // The surface never has a point in a wall, unless it is being pushed out of it.
    if (history_.parameters().direction == Direction::outward)
      REQUIRE(clearance(mesh(), history_.constraints().walls.balls) > 0);
  }

  void correct() {
    using Kind = void (Sequence::*)();
    static constexpr Kind kKinds[] = {
        &Sequence::wall,  &Sequence::wall,  &Sequence::disc,     &Sequence::pin,    &Sequence::pin,
        &Sequence::veto,  &Sequence::veto,  &Sequence::tunnel,   &Sequence::piece,  &Sequence::touch,
        &Sequence::touch, &Sequence::limit, &Sequence::takeAway, &Sequence::goBack, &Sequence::otherForces};
    if (mesh().faceCount() == 0) return goBack();
    (this->*kKinds[random_() % std::size(kKinds)])();
  }
  void wall() {
    Request request = now();
    request.constraints.walls.balls.push_back({onSurface() + away(6), uniform(0.6, 4)});
    const WallList wall{{request.constraints.walls.balls.back()}, {}, {}, {}};
    if (change("wall", request)) return;
    // "Go back to before it came in here."
    if (const auto free = history_.lastFree(wall)) {
      history_.goTo(*free);
      Request there = now();
      there.constraints.walls.balls.push_back(wall.balls[0]);
      change("wall after going back", there);
    }
  }
  void disc() {
    Request request = now();
    request.constraints.walls.discs.push_back(
        {onSurface() + away(8), away(1) + Vec3(0, 0, 1e-3), uniform(1, 6)});
    change("disc", request);
  }
  void pin() {
    Request request = now();
    const int later = random_() % 4 ? 0 : static_cast<int>(random_() % 6);
    request.constraints.pins.push_back({onSurface(), uniform(1, 6), history_.iteration() + later});
    change("pin", request);
  }
  void veto() {
    std::vector<Event> events;
    for (const Event& e : history_.events())
      if (changesTopology(e.kind) && !e.edit && e.iteration <= history_.iteration()) events.push_back(e);
    if (events.empty()) return;
    const Event& e = events[random_() % events.size()];
    history_.goTo(e.iteration - 1);
    Request request = now();
    request.constraints.vetoes.push_back({e.iteration, e.location});
    if (!change("veto", request)) return;
    run(1);
  }
  void edit(const std::string& name, MeshEdit e) {
    e.iteration = history_.iteration() + 1;
    Request request = now();
    request.constraints.edits.push_back(e);
    if (change(name, request)) run(1);
  }
  void tunnel() {
    const TunnelList list = findTunnels(mesh());
    if (list.tunnels.empty()) return;
    MeshEdit e;
    e.kind = MeshEditKind::closeTunnel;
    e.place = list.tunnels[random_() % list.tunnels.size()].position;
    e.cut = static_cast<TunnelCut>(random_() % 3);
    edit("tunnel", e);
  }
  void piece() {
    MeshEdit e;
    static constexpr MeshEditKind kKinds[] = {MeshEditKind::removeComponent, MeshEditKind::keepComponent,
                                              MeshEditKind::fillCavity, MeshEditKind::fillCavity};
    if (listPieces(mesh()).size() < 2) return;
    e.kind = kKinds[random_() % std::size(kKinds)];
    e.place = onSurface();
    edit("piece", e);
  }
  void touch() {
    MeshEdit e;
    static constexpr MeshEditKind kKinds[] = {MeshEditKind::smooth, MeshEditKind::pull, MeshEditKind::cut};
    e.kind = kKinds[random_() % std::size(kKinds)];
    e.place = onSurface();
    e.radius = uniform(2, 8);
    if (e.kind == MeshEditKind::pull) e.vector = e.place + away(5);
    if (e.kind == MeshEditKind::cut) {
      e.vector = away(1) + Vec3(0, 0, 1e-3);
      e.radius = random_() % 2 ? e.radius : 0;
      e.keep = static_cast<KeptSide>(random_() % 3);
    }
    edit(meshEditName(e.kind), e);
  }
  void limit() {
    Request request = now();
    TopologyLimits& limits = request.constraints.topology = {};
    if (random_() % 2) limits.components = 1 + static_cast<int>(random_() % 3);
    if (random_() % 2) limits.genus = static_cast<int>(random_() % 3);
    limits.asks = (limits.components || limits.genus) && random_() % 4 != 0;
    change("limit", request);
  }
  //! What the step just made has asked, if it has: let happen, held on, or left open.
  void answer() {
    const std::vector<HeldPlace> questions = history_.steps().back().questions;
    for (const HeldPlace& held : questions) {
      const auto which = random_() % 3;
      if (which == 2) continue;
      Request request = now();
      TopologyLimits& limits = request.constraints.topology;
      (which == 0 ? limits.allowed : limits.kept).push_back(held.place);
      change(which == 0 ? "let happen" : "held on", request);
    }
  }
  void takeAway() {
    Request request = now();
    Constraints& c = request.constraints;
    const auto drop = [this](auto& list) {
      if (!list.empty()) list.erase(list.begin() + static_cast<std::ptrdiff_t>(random_() % list.size()));
    };
    const auto which = random_() % 4;
    if (which == 0) drop(c.walls.balls);
    if (which == 1) drop(c.walls.discs);
    if (which == 2) drop(c.pins);
    if (which == 3) drop(c.vetoes);
    change("taken away", request);
  }
  void goBack() {
    const int last = history_.iteration();
    history_.goTo(history_.firstIteration() +
                  static_cast<int>(random_() % static_cast<unsigned>(last - history_.firstIteration() + 1)));
    ++made_["gone back"];
    if (random_() % 2 && history_.lastIteration() > history_.iteration()) history_.goTo(last);  // and forth
  }
  void otherForces() {
    Request request = now();
    request.parameters.curvature = uniform(0, 0.8);
    request.parameters.balloon = uniform(0.6, 1.5);
    change("other forces", request);
  }

  std::mt19937 random_;
  std::optional<ActiveContour> beginning_;
  std::map<std::string, int> made_, refused_;
  History history_;
};

}  // namespace

TEST_CASE("any corrections with runs between them leave valid meshes, which come again bit for bit",
          "[corrections]") {
  std::map<std::string, int> made, refused;
  const int from = number("HANDLEBODY_CORRECTIONS_FROM", 0);
  const int count = number("HANDLEBODY_CORRECTIONS", kSequences);
  for (int i = from; i < from + count; ++i) {
    const Shape& shape = kShapes[static_cast<std::size_t>(i) % std::size(kShapes)];
    INFO("sequence " << i << ", " << shape.name);
    Sequence sequence(shape, static_cast<unsigned>(i));
    sequence.play();
    REQUIRE(isSame(sequence.mesh(), sequence.replayed()));
    sequence.count(made, refused);
  }
  std::cout << count << " sequences of corrections:";
  for (const auto& [name, n] : made) std::cout << ' ' << name << ' ' << n << ';';
  std::cout << " refused:";
  for (const auto& [name, n] : refused) std::cout << ' ' << name << ' ' << n << ';';
  std::cout << '\n';
}
