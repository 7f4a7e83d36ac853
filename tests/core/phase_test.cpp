// What long work says of itself, and that it ends when nobody wants it any more.

#include "core/phase.h"

#include <string>
#include <thread>
#include <vector>

#include "core/cancellation.h"
#include "core/measure/farthest_pair.h"
#include "core/measure/surface_gap.h"
#include "core/polish/polish.h"
#include "core/solid/blurred_mask.h"
#include "core/solid/label_mesh.h"
#include "core/solid/mask_surface.h"
#include "core/solid/rasterize.h"
#include "core/solid/simplify.h"
#include "core/solid/surface_distance.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

using Phases = std::vector<std::string>;

//! A block with a hole.
Mask block() {
  Mask mask;
  mask.grid.size = {8, 8, 4};
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) mask.inside.push_back(x == 4 && y == 4 ? 0 : 1);
  return mask;
}

}  // namespace

TEST_CASE("a phase is told, and when it ends that which it is a part of") {
  Phases told;
  {
    const PhaseScope scope([&](const char* phase) { told.emplace_back(phase); });
    const Phase whole("whole");
    const Phase part("part");
  }
  const Phase unheard("unheard");
  CHECK(told == Phases{"whole", "part", "whole", ""});
}

TEST_CASE("the innermost scope is told, and none of another thread's work") {
  Phases outer, inner;
  const PhaseScope scope([&](const char* phase) { outer.emplace_back(phase); });
  {
    const PhaseScope within([&](const char* phase) { inner.emplace_back(phase); });
    const Phase phase("within");
  }
  {
    const PhaseScope nobody({});
    const Phase phase("unheard");
  }
  std::thread([] { const Phase phase("elsewhere"); }).join();
  const Phase phase("without");
  CHECK(inner == Phases{"within", ""});
  CHECK(outer == Phases{"without"});
}

TEST_CASE("a mesh of a label map tells what it is at", "[solid][label-mesh]") {
  Phases told;
  const PhaseScope scope([&](const char* phase) {
    if (told.empty() || told.back() != phase) told.emplace_back(phase);
  });
  const LabelMesh made = meshOf(block(), {});
  Phases expected{"surface", "", "smoothing"};
  for (int i = 0; i < 5; ++i) expected.insert(expected.end(), {"regulating", "smoothing"});
  expected.insert(expected.end(), {"certifying", "smoothing", ""});
  CHECK(told == expected);
  told.clear();
  polished(made.mesh, {});
  REQUIRE_FALSE(told.empty());
  CHECK(told.front() == "polishing");
  CHECK(told.back().empty());
}

TEST_CASE("long work on voxels and surfaces gives up when it is cancelled", "[solid][measure]") {
  const Mask mask = block();
  const TriangleSoup a = zoo::sphere(40), b = zoo::scaled(a, 2);
  const std::atomic<bool> cancelled = true;
  const CancelScope scope(cancelled);
  CHECK_THROWS_AS(maskSurface(mask), Cancelled);
  CHECK_THROWS_AS(withFewerTunnels(mask, 0), Cancelled);
  CHECK_THROWS_AS(BlurredMask(mask, Vec3::Ones()), Cancelled);
  CHECK_THROWS_AS(rasterize(a, mask.grid), Cancelled);
  CHECK_THROWS_AS(countSamples(a, 0.01, 1000000), Cancelled);
  CHECK_THROWS_AS(farthestPair(a.points), Cancelled);
  CHECK_THROWS_AS(surfaceGap(a, b), Cancelled);
}
