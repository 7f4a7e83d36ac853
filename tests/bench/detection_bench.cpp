// Detection of all self-intersections, beside CGAL's in the same run. For medians on a busy machine:
// --benchmark_repetitions=9 --benchmark_report_aggregates_only=true
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <numeric>

#include "core/collision/self_intersection.h"
#include "core/collision/vertex_pairs.h"
#include "tests/collision_oracle/oracle.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

enum Kind { kSphere, kOverlapping, kRough, kShuffled };

//! About 20·n² triangles.
const TriangleSoup& meshOf(int kind, int n) {
  static std::map<std::pair<int, int>, TriangleSoup> made;
  TriangleSoup& s = made[{kind, n}];
  if (!s.points.empty()) return s;
  if (kind == kSphere) s = zoo::sphere(n);
  if (kind == kOverlapping) s = zoo::overlappingSpheres(static_cast<int>(n * 0.7071));
  if (kind == kRough) s = zoo::perturbed(zoo::sphere(n), 0.2 / n, 1);
  if (kind == kShuffled) s = zoo::shuffled(zoo::sphere(n), 1);
  return s;
}

void report(benchmark::State& state, const TriangleSoup& s, std::size_t pairs) {
  state.counters["triangles"] = static_cast<double>(s.triangles.size());
  state.counters["pairs"] = static_cast<double>(pairs);
}

//! As inside an evolution: positions change, faces mostly do not.
void warm(benchmark::State& state) {
  const TriangleSoup& s = meshOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  CollisionDetector detector;
  std::size_t pairs = detector.detectAll(s.points, s.triangles).size();
  for (auto _ : state) pairs = detector.detectAll(s.points, s.triangles).size();
  report(state, s, pairs);
}

//! As in `check`: everything from nothing.
void cold(benchmark::State& state) {
  const TriangleSoup& s = meshOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  std::size_t pairs = 0;
  for (auto _ : state) pairs = findSelfIntersections(s.points, s.triangles).size();
  report(state, s, pairs);
}

//! As inside an evolution: one cap of the mesh has moved, its share of the vertices in percent.
void moved(benchmark::State& state) {
  const TriangleSoup& s = meshOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  std::vector<unsigned char> flags(s.points.size());
  const double height = 1 - 2 * static_cast<double>(state.range(2)) / 100;
  for (std::size_t v = 0; v < flags.size(); ++v) flags[v] = s.points[v].z() > height;
  const Mesh mesh(s);
  CollisionDetector detector;
  std::size_t pairs = 0;
  for (auto _ : state) pairs = detector.detectMoved(mesh, flags).size();
  report(state, s, pairs);
}

void cgal(benchmark::State& state) {
  const oracle::PreparedMesh mesh(meshOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
  std::size_t pairs = 0;
  for (auto _ : state) pairs = mesh.countSelfIntersections();
  state.counters["pairs"] = static_cast<double>(pairs);
}

//! Vertex pairs alone: the radius of the detection, for this mesh.
double radiusOf(const TriangleSoup& s) {
  double longest = 0;
  for (const Triangle& t : s.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& a = s.points[t[i]];
      longest = std::max(longest, (a - s.points[t[(i + 1) % 3]]).norm());
    }
  }
  return longest * std::sqrt(7.0 / 12.0);
}

//! Builds and visits, as a detection does.
template <typename Pairs>
std::size_t countPairs(Pairs& near, const TriangleSoup& s, std::span<const int> vertices, double radius) {
  std::size_t pairs = 0;
  near.build(s.points, vertices, radius);
  near.forEachPair([&](int, int, double) { ++pairs; });
  return pairs;
}

std::vector<int> allOf(const TriangleSoup& s) {
  std::vector<int> vertices(s.points.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  return vertices;
}

void pairsBy(benchmark::State& state, BroadPhase phase) {
  const TriangleSoup& s = meshOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const std::vector<int> vertices = allOf(s);
  VertexPairs near;
  near.use(phase);
  std::size_t pairs = 0;
  for (auto _ : state) pairs = countPairs(near, s, vertices, radiusOf(s));
  state.counters["pairs"] = static_cast<double>(pairs);
}
void pairsSorted(benchmark::State& state) { pairsBy(state, BroadPhase::sorted); }
void pairsHashed(benchmark::State& state) { pairsBy(state, BroadPhase::hashing); }

//! The paper's study in section 2: a mesh of about 10,000 vertices and 20,000 faces, tables of different
//! sizes (in hundredths of the number of vertices). broad_phase_study.py draws it.
void tableSize(benchmark::State& state) {
  const TriangleSoup& s = meshOf(kSphere, 32);
  const std::vector<int> vertices = allOf(s);
  SpatialHash hash(static_cast<double>(state.range(0)) / 100);
  std::size_t pairs = 0;
  for (auto _ : state) pairs = countPairs(hash, s, vertices, radiusOf(s));
  state.counters["vertices"] = static_cast<double>(s.points.size());
  state.counters["pairs"] = static_cast<double>(pairs);
  state.counters["candidates"] = static_cast<double>(hash.countCandidates());
}

void sizes(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMillisecond)->ArgNames({"kind", "n"});
  for (const int n : {32, 100, 224}) b->Args({kSphere, n});
  for (const int n : {32, 100, 224}) b->Args({kOverlapping, n});
  for (const int n : {32, 100}) b->Args({kRough, n});
  b->Args({kShuffled, 224});
}

}  // namespace

BENCHMARK(warm)->Apply(sizes);
BENCHMARK(cold)->Apply(sizes);
BENCHMARK(moved)
    ->Unit(benchmark::kMillisecond)
    ->ArgNames({"kind", "n", "percent"})
    ->ArgsProduct({{kSphere}, {32, 100, 224}, {0, 5, 100}})
    ->ArgsProduct({{kOverlapping}, {32}, {5, 100}});
BENCHMARK(pairsSorted)->Apply(sizes);
BENCHMARK(pairsHashed)->Apply(sizes);
BENCHMARK(tableSize)
    ->Unit(benchmark::kMillisecond)
    ->ArgName("hundredths")
    ->Arg(1)
    ->Arg(3)
    ->Arg(6)
    ->Arg(12)
    ->Arg(25)
    ->Arg(50)
    ->Arg(100)
    ->Arg(200)
    ->Arg(400)
    ->Arg(800)
    ->Arg(1600);
BENCHMARK(cgal)->Apply(sizes);
BENCHMARK_MAIN();
