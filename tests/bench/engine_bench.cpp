// One whole step of the evolution, and the preparation of the image. For the least of several runs on a busy
// machine: --benchmark_repetitions=5, and look at the fastest.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>

#include "core/collision/self_intersection.h"
#include "core/evolution/active_contour.h"
#include "core/evolution/image_warnings.h"
#include "core/evolution/motion.h"
#include "core/evolution/object_image.h"
#include "core/evolution/object_range.h"
#include "core/mesh/remesh.h"
#include "sample_volumes/phantom.h"

using namespace handlebody;

namespace {

double processorSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

//! A volume so dark everywhere that nothing but its border stops a front.
Volume openField(int size) {
  Grid grid;
  grid.size = {size, size, size};
  void* buffer = nullptr;
  Volume v = makeVolume(grid, VoxelType::float32, &buffer);
  auto* voxels = static_cast<float*>(buffer);
  std::fill(voxels, voxels + grid.voxelCount(), 0.25f);
  voxels[0] = 1;  // a range needs an end
  return v;
}

struct Field {
  Volume volume;
  std::vector<Seed> seeds;
};

//! One seed, or eight in the corners of a cube: their fronts meet along twelve edges.
Field makeField(int seeds) {
  constexpr int kSize = 140;
  Field f{openField(kSize), {}};
  const double middle = kSize / 2.0, away = 22;
  if (seeds == 1) f.seeds.push_back({Vec3::Constant(middle), 6});
  for (int i = 0; i < 8 && seeds == 8; ++i)
    f.seeds.push_back({Vec3(middle + (i & 1 ? away : -away), middle + (i & 2 ? away : -away),
                            middle + (i & 4 ? away : -away)),
                       6});
  return f;
}

//! Mean processor time of the steps in which the mesh has 9,000 to 11,000 vertices, nearly all moving.
void stepAt10k(benchmark::State& state) {
  const Field field = makeField(static_cast<int>(state.range(0)));
  Parameters parameters;
  parameters.threads = 1;
  parameters.range = IntensityRange{0, 0.5};
  parameters.smoothing = 0;
  parameters.edgeLength = 2;
  double moved = 0, vertices = 0, events = 0, longest = 0;
  int steps = 0;
  for (auto _ : state) {
    ActiveContour contour(field.volume, field.seeds, parameters);
    double seconds = 0;
    steps = 0;
    while (contour.stopReason() == StopReason::running && contour.mesh().vertexCount() < 11'000) {
      const double start = processorSeconds();
      const StepReport report = contour.step();
      const double took = processorSeconds() - start;
      if (contour.mesh().vertexCount() < 9'000) continue;
      seconds += took;
      longest = std::max(longest, took);
      moved += report.movedVertices;
      vertices += contour.mesh().vertexCount();
      events += static_cast<double>(report.events.size());
      ++steps;
    }
    state.SetIterationTime(seconds / std::max(1, steps));
  }
  state.counters["moving"] = moved / vertices;
  state.counters["events"] = events / static_cast<double>(state.iterations());
  state.counters["longest_ms"] = 1e3 * longest;
  state.counters["steps"] = steps;
}

//! A contour in the open field when it has 10,000 vertices, as the steps above meet it.
struct GrownField {
  Parameters parameters;
  Mesh mesh;
  std::vector<int> vertices;
  std::shared_ptr<const SmoothedVolume> volume;
};

const GrownField& grownField() {
  static const GrownField made = [] {
    const Field field = makeField(1);
    GrownField g;
    g.parameters.range = IntensityRange{0, 0.5};
    g.parameters.smoothing = 0;
    g.parameters.edgeLength = 2;
    ActiveContour contour(field.volume, field.seeds, g.parameters);
    while (contour.mesh().vertexCount() < 10'000) contour.step();
    g.mesh = contour.mesh();
    for (int v = 0; v < g.mesh.vertexSlots(); ++v)
      if (g.mesh.isVertex(v)) g.vertices.push_back(v);
    g.volume = std::make_shared<SmoothedVolume>(field.volume, 0);
    return g;
  }();
  return made;
}

// The parts of such a step, all vertices moving.

void partMotion(benchmark::State& state) {
  const GrownField& g = grownField();
  const ObjectImage image(g.volume, *g.parameters.range, 0.25);
  MotionSettings settings;
  settings.edgeLength = *g.parameters.edgeLength;
  settings.largestStep = 0.28 * settings.edgeLength;
  settings.outwardOnly = true;
  settings.threads = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(computeMotion(g.mesh, image, settings, g.vertices));
}

void partDetection(benchmark::State& state) {
  const GrownField& g = grownField();
  CollisionDetector detector;
  const std::vector<unsigned char> moved(g.mesh.vertexSlots(), 1);
  for (auto _ : state) benchmark::DoNotOptimize(detector.detectMoved(g.mesh, moved).size());
}

//! Of a mesh that has been regulated, but blown up by two per cent since.
void partRegulation(benchmark::State& state) {
  const GrownField& g = grownField();
  Mesh grown = g.mesh;
  for (const int v : g.vertices) grown.setPosition(v, 1.02 * (g.mesh.position(v) - Vec3::Constant(70)));
  const double edge = *g.parameters.edgeLength;
  for (auto _ : state) {
    Mesh mesh = grown;
    std::vector<unsigned char> active(mesh.vertexSlots(), 1);
    const double start = processorSeconds();
    regulate(mesh, {1.4 * edge, 0.55 * edge}, active);
    state.SetIterationTime(processorSeconds() - start);
  }
}

//! Where the image shows an edge: what a frame of the window costs more. By a range, and by a region that was
//! chosen from a click.
void partSupport(benchmark::State& state) {
  const GrownField& g = grownField();
  const ObjectImage image(g.volume, *g.parameters.range, 0.25);
  for (auto _ : state) benchmark::DoNotOptimize(surfaceSupport(g.mesh, image).withoutEdge);
  state.counters["triangles"] = g.mesh.faceCount();
}

void partSupportOfRegion(benchmark::State& state) {
  const Phantom phantom = makePhantom("sphere");
  Parameters parameters;
  parameters.threads = 1;
  parameters.edgeLength = 0.014 * phantom.volume.grid.spacing[0] * phantom.volume.grid.size[0];
  ActiveContour contour(phantom.volume, {{phantom.seed, phantom.seedRadius}}, parameters);
  while (contour.stopReason() == StopReason::running) contour.step();
  for (auto _ : state) benchmark::DoNotOptimize(contour.support().withoutEdge);
  state.counters["triangles"] = contour.mesh().faceCount();
}

void partCopy(benchmark::State& state) {
  const GrownField& g = grownField();
  Mesh copy;
  for (auto _ : state) {
    copy = g.mesh;
    benchmark::DoNotOptimize(&copy);
  }
}

//! Everything between reading the file and the first step.
void prepare(benchmark::State& state, const char* name) {
  const Phantom phantom = makePhantom(name);
  for (auto _ : state)
    benchmark::DoNotOptimize(chooseObject(phantom.volume, {{phantom.seed, phantom.seedRadius}}, {}));
}

//! Smoothing of a whole volume of 4 million voxels, sigma in tenths of a voxel.
void smoothing(benchmark::State& state) {
  const Volume volume = openField(160);
  for (auto _ : state) {
    const SmoothedVolume smoothed(volume, static_cast<double>(state.range(0)) / 10);
    const auto& n = smoothed.bricks();
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i) benchmark::DoNotOptimize(smoothed.brick(i, j, k));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(volume.grid.voxelCount()));
}

}  // namespace

BENCHMARK(stepAt10k)->ArgName("seeds")->Arg(1)->Arg(8)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(partMotion)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(partDetection)->Unit(benchmark::kMillisecond);
BENCHMARK(partRegulation)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(partSupport)->Unit(benchmark::kMillisecond);
BENCHMARK(partSupportOfRegion)->Unit(benchmark::kMillisecond);
BENCHMARK(partCopy)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(prepare, cyst, "cyst")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(prepare, cube, "cube")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(prepare, genus3, "genus3")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(prepare, torus, "torus")->Unit(benchmark::kMillisecond);
BENCHMARK(smoothing)->ArgName("sigma_tenths")->Arg(7)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
