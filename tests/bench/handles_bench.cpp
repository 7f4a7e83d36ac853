// The choice of a handle and the handle database.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "core/handles/handle_database.h"
#include "core/handles/shortest_handles.h"

using namespace handlebody;

namespace {

//! Uneven rings that face a common middle, as fronts that meet; edges of about 1 mm.
std::vector<std::vector<Vec3>> facingRings(int loops, int size) {
  std::mt19937 random(1);
  const auto noise = [&] { return 0.3 * (static_cast<double>(random()) / 4294967296.0 - 0.5); };
  std::vector<std::vector<Vec3>> out;
  const double radius = size / (2 * M_PI);
  for (int k = 0; k < loops; ++k) {
    const double turn = 2 * M_PI * k / loops;
    const Vec3 away(std::cos(turn), std::sin(turn), 0), side(-std::sin(turn), std::cos(turn), 0);
    std::vector<Vec3>& loop = out.emplace_back();
    for (int i = 0; i < size; ++i) {
      const double u = 2 * M_PI * i / size;
      const Vec3 ring = std::cos(u) * side - std::sin(u) * Vec3::UnitZ();
      const double x = noise(), y = noise();
      loop.push_back(radius * ((loops == 2 ? 0.3 : 1.3) * away + ring) + Vec3(x, y, noise()));
    }
  }
  return out;
}

void shortestHandle(benchmark::State& state) {
  const auto loops = facingRings(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  bool exact = true;
  for (auto _ : state) {
    ShortestHandles search(loops);
    benchmark::DoNotOptimize(search.next());
    exact = exact && !search.gaveUp();
  }
  state.counters["exact"] = exact;
}
BENCHMARK(shortestHandle)
    ->ArgNames({"k", "size"})
    ->ArgsProduct({{2}, {6, 12, 24, 48, 120}})
    ->ArgsProduct({{3, 4}, {6, 12, 20, 30}})
    ->Unit(benchmark::kMicrosecond);

void firstTwelveHandles(benchmark::State& state) {
  const auto loops = facingRings(static_cast<int>(state.range(0)), 12);
  for (auto _ : state) {
    ShortestHandles search(loops);
    for (int i = 0; i < 12; ++i) benchmark::DoNotOptimize(search.next());
  }
}
BENCHMARK(firstTwelveHandles)->ArgName("k")->DenseRange(2, 4)->Unit(benchmark::kMicrosecond);

void readDatabase(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(HandleDatabase(handleDatabaseText()));
}
BENCHMARK(readDatabase)->Unit(benchmark::kMicrosecond);

void findAndExpandStored(benchmark::State& state) {
  const std::vector<int> sizes{3, 3, 4, 4};
  for (auto _ : state)
    benchmark::DoNotOptimize(expand(*HandleDatabase::stored().find(sizes, Family::balanced)));
}
BENCHMARK(findAndExpandStored)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
