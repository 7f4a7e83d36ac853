// The worker by itself, without an event loop: nothing here needs Qt's own synchronisation.

#include <atomic>
#include <random>
#include <thread>

#include "tests/core/evolution/contour_support.h"
#include "ui/model/growth_worker.h"

using namespace handlebody;
using namespace handlebody::testing;
using namespace handlebody::ui;

namespace {

const Seed kSeed{kMiddle + Vec3(kTorusR, 0, 0), 3.0};

std::shared_ptr<const ActiveContour> torusContour() {
  return std::make_shared<const ActiveContour>(torusVolume(), std::vector<Seed>{kSeed}, Parameters{});
}

//! The torus with these parameters.
Request with(const Parameters& parameters = {}) { return {{kSeed}, parameters}; }

//! What a window knows, put together from the updates.
struct Mirror {
  GrowthUpdate last;
  std::shared_ptr<const MeshSnapshot> snapshot;
  std::vector<IterationSummary> summaries;
  std::vector<Event> events;
  int traces = 0;

  void take(GrowthUpdate update) {
    REQUIRE(update.summariesFrom <= summaries.size());
    REQUIRE(update.eventsFrom <= events.size());
    summaries.resize(update.summariesFrom);
    summaries.insert(summaries.end(), update.summaries.begin(), update.summaries.end());
    events.resize(update.eventsFrom);
    events.insert(events.end(), update.events.begin(), update.events.end());
    if (update.snapshot) snapshot = update.snapshot;
    traces += static_cast<int>(update.traces.size());
    last = std::move(update);
  }
};

struct Rig {
  std::atomic<int> notified{0};
  Mirror mirror;
  GrowthWorker worker{[this] { ++notified; }};

  bool waitFor(const std::function<bool()>& done) {
    for (int i = 0; i < 60'000; ++i) {
      if (notified.exchange(0) > 0) mirror.take(worker.collect());
      if (mirror.last.processed >= worker.sent() && done()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }
  bool waitForRest() {
    return waitFor([&] { return !mirror.last.running; });
  }
};

}  // namespace

TEST_CASE("updates put together are the whole growth, however often they are fetched", "[worker]") {
  Rig rig;
  const auto start = torusContour();
  rig.worker.start(start);
  rig.worker.run(with());
  REQUIRE(rig.waitForRest());
  ActiveContour straight = *start;
  std::size_t events = 0;
  while (straight.stopReason() == StopReason::running) events += straight.step().events.size();
  CHECK(rig.mirror.last.stopReason == StopReason::converged);
  CHECK(rig.mirror.summaries.size() == static_cast<std::size_t>(straight.iteration()) + 1);
  CHECK(rig.mirror.events.size() == events);
  CHECK(rig.mirror.snapshot->mesh.points == straight.mesh().compact().points);
}

TEST_CASE("a dropped tail is replaced even if nothing was fetched in between", "[worker]") {
  Rig rig;
  rig.worker.start(torusContour());
  for (int i = 0; i < 30; ++i) rig.worker.step(with());
  REQUIRE(rig.waitForRest());
  const double volume = rig.mirror.summaries[25].volume;
  Parameters slow;
  slow.balloon = 0.3;
  rig.worker.goTo(20);
  for (int i = 0; i < 6; ++i) rig.worker.step(with(slow));
  REQUIRE(rig.waitForRest());
  REQUIRE(rig.mirror.summaries.size() == 27);
  CHECK(rig.mirror.summaries[25].volume < volume);
  CHECK(rig.mirror.snapshot->iteration == 26);
  CHECK(rig.mirror.snapshot->certificate.volume == Approx(rig.mirror.summaries[26].volume));
}

TEST_CASE("random commands leave the shown iteration in step with the lists", "[worker]") {
  Rig rig;
  rig.worker.start(torusContour());
  std::mt19937 random(11);
  const auto any = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  for (int i = 0; i < 150; ++i) {
    Request p = with();
    p.parameters.curvature = 0.1 * any(3);
    if (any(4) == 0) p.seeds.push_back({kMiddle - Vec3(kTorusR, 0, 0), {}});
    switch (any(8)) {
      case 0:
        rig.worker.run(p);
        break;
      case 1:
        rig.worker.pause();
        break;
      case 2:
        rig.worker.goTo(any(60));
        break;
      case 3:
        rig.worker.stepBack();
        break;
      case 4:
        rig.worker.runToEvent(p);
        break;
      case 5:
        rig.worker.trace(any(4));
        break;
      case 6:
        rig.worker.goToPreviousEvent();
        break;
      default:
        rig.worker.step(p);
    }
    if (any(4) == 0) std::this_thread::sleep_for(std::chrono::milliseconds(any(15)));
    if (rig.notified.exchange(0) > 0) rig.mirror.take(rig.worker.collect());
  }
  rig.worker.pause();
  REQUIRE(rig.waitForRest());
  const Mirror& m = rig.mirror;
  REQUIRE(m.snapshot);
  REQUIRE(m.snapshot->iteration < static_cast<int>(m.summaries.size()));
  CHECK(m.snapshot->certificate.passes());
  const auto shown = static_cast<std::size_t>(m.snapshot->iteration);
  CHECK(m.snapshot->certificate.volume == Approx(m.summaries[shown].volume));
  for (std::size_t i = 0; i < m.summaries.size(); ++i) CHECK(m.summaries[i].iteration == static_cast<int>(i));
  for (const Event& e : m.events) CHECK(e.iteration < static_cast<int>(m.summaries.size()));
}

TEST_CASE("parameters that are refused end in a sentence, and the growth stays", "[worker]") {
  Rig rig;
  rig.worker.start(torusContour());
  rig.worker.step(with());
  Parameters wrong;
  wrong.range = IntensityRange{5000, 6000};
  rig.worker.run(with(wrong));
  REQUIRE(rig.waitForRest());
  CHECK(rig.mirror.last.error.contains(QStringLiteral("holds no voxel")));
  CHECK(rig.mirror.summaries.size() == 2);
  rig.worker.step(with());
  REQUIRE(rig.waitForRest());
  CHECK(rig.mirror.last.error.isEmpty());
  CHECK(rig.mirror.snapshot->iteration == 2);
}

TEST_CASE("a worker ends while it is at work", "[worker]") {
  for (int milliseconds : {0, 1, 10}) {
    Rig rig;
    rig.worker.start(torusContour());
    rig.worker.run(with());
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  }
  SUCCEED();
}

TEST_CASE("a pause does not wait for the end of the step that is being made", "[worker]") {
  // A ball of which most is there, with edges so short that a step takes a hundred times what a pause needs.
  Parameters fine;
  fine.edgeLength = 0.2;
  const Seed seed{kMiddle, 8.0};
  Rig rig;
  rig.worker.start(std::make_shared<const ActiveContour>(ballVolume(), std::vector<Seed>{seed}, fine));
  constexpr int kPauses = 10;
  int takenBack = 0;
  for (int i = 0; i < kPauses; ++i) {
    rig.worker.run({{seed}, fine});
    const std::size_t known = rig.mirror.summaries.size();
    REQUIRE(rig.waitFor([&] { return rig.mirror.summaries.size() > std::max<std::size_t>(known, 1); }));
    // It is told when a step is done, and the next one begins at once.
    const std::size_t done = rig.mirror.summaries.size();
    const double step = rig.mirror.last.seconds / static_cast<double>(done - 1);
    std::this_thread::sleep_for(std::chrono::duration<double>(step / 4));
    rig.worker.pause();
    REQUIRE(rig.waitForRest());
    takenBack += rig.mirror.summaries.size() == done;
  }
  CHECK(rig.mirror.last.stopReason == StopReason::running);
  // All are, but for a machine so busy that it lets this thread wait for most of a step. A worker that waits
  // for the end of a step takes none back.
  CHECK(takenBack > kPauses / 2);
}

TEST_CASE("a pause in the middle of a step takes it back, and the growth goes on as if nothing had been",
          "[worker]") {
  Rig rig;
  const auto start = torusContour();
  rig.worker.start(start);
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    rig.worker.run(with());
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 3000));
    rig.worker.pause();
    REQUIRE(rig.waitForRest());
    CHECK(rig.mirror.last.error.isEmpty());
  }
  rig.worker.run(with());
  REQUIRE(rig.waitForRest());
  ActiveContour straight = *start;
  while (straight.stopReason() == StopReason::running) straight.step();
  CHECK(rig.mirror.snapshot->mesh.points == straight.mesh().compact().points);
  CHECK(rig.mirror.summaries.size() == static_cast<std::size_t>(straight.iteration()) + 1);
}
