// What the paper says of single events in its experiments (section 5).

#include "tests/experiments/experiment_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

std::vector<Event> changesOf(const char* name) {
  const Phantom phantom = makePhantom(name);
  ActiveContour contour(phantom.volume, {{phantom.seed, phantom.seedRadius}}, {});
  std::vector<Event> changes;
  while (contour.stopReason() == StopReason::running)
    for (Event& e : contour.step().events)
      if (changesTopology(e.kind)) changes.push_back(std::move(e));
  return changes;
}

}  // namespace

TEST_CASE("the four fronts of genus3 meet in one step and are joined by one handle", "[experiments]") {
  const std::vector<Event> changes = changesOf("genus3");
  REQUIRE(changes.size() == 1);
  CHECK(changes[0].kind == EventKind::handleInserted);
  CHECK(changes[0].fronts == 4);
  CHECK(changes[0].loopSizes.size() == 4);
  CHECK(changes[0].before.genus == 0);
  CHECK(changes[0].after == TopologyNumbers{1, -4, 3});
}

TEST_CASE("the torus meets itself once and each of its four balls is cut off once", "[experiments]") {
  int handles = 0, cutOff = 0;
  for (const Event& e : changesOf("torus")) {
    handles += e.kind == EventKind::handleInserted;
    cutOff += e.kind == EventKind::enclosedPartCutOff;
  }
  CHECK(handles == 1);
  CHECK(cutOff == 4);
}
