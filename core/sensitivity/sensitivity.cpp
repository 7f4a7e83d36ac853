#include "core/sensitivity/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

#include "core/errors.h"
#include "core/mesh/validity.h"
#include "core/solid/surface_distance.h"
#include "core/threads.h"
#include "core/told_error.h"
#include "core/units.h"

namespace handlebody {

namespace {

constexpr double kMuch = 0.1;  // of a volume

int genusOf(const Certificate& c) { return std::accumulate(c.genus.begin(), c.genus.end(), 0); }

//! A run and how far each vertex of the result is from its surface.
struct Grown {
  PerturbedRun run;
  std::vector<double> distances;
};

//! Of the first click inside; where a surface stands for it, within that.
Vec3 placeInside(const Request& request) {
  const std::vector<Seed> inside = seedsOfSide(request.seeds, false);
  return inside.empty() ? request.constraints.start->inside : inside.front().centre;
}

TriangleSoup grownAgain(const GrownFrom& from, const Perturbation& by, std::mt19937_64& random) {
  Request request = perturbed(from.request, from.used, from.volume.grid, by, random);
  ActiveContour contour(withNoise(from.volume, by.noise, random), request.seeds, request.parameters,
                        request.constraints);
  while (contour.stopReason() == StopReason::running) contour.step();
  if (contour.stopReason() == StopReason::empty) throw Told<SeedError>(FindingKind::sensitivityVanished);
  return contour.mesh().compact();
}

template <typename Error>
void failWith(const Error& error, PerturbedRun& run) {
  run.failure = error.what();
  run.why = findingOf(error);
}

Grown oneRun(const TriangleSoup& mesh, const GrownFrom& from, const Perturbation& by, std::size_t number) {
  std::mt19937_64 random(number + 1);  // each run has its own numbers, whichever thread it is on
  Grown out;
  try {
    const TriangleSoup surface = grownAgain(from, by, random);
    const Certificate c = examine(surface);
    out.run.volume = c.volume;
    out.run.components = c.components;
    out.run.genus = genusOf(c);
    out.distances = vertexDistances(mesh, surface, false, 1);
    const double sum = std::accumulate(out.distances.begin(), out.distances.end(), 0.0);
    out.run.distance = sum / static_cast<double>(out.distances.size());
  } catch (const SeedError& error) {
    failWith(error, out.run);
  } catch (const UsageError& error) {  // a wall or a range that does not go with where the click is now
    failWith(error, out.run);
  }
  return out;
}

void summarizeVolumes(Sensitivity& s) {
  std::vector<double> volumes;
  for (const PerturbedRun& r : s.runs)
    if (r.failure.empty()) volumes.push_back(r.volume);
  s.grown = static_cast<int>(volumes.size());
  if (volumes.empty()) return;
  s.mean = std::accumulate(volumes.begin(), volumes.end(), 0.0) / s.grown;
  double squares = 0;
  for (const double v : volumes) squares += (v - s.mean) * (v - s.mean);
  s.deviation = s.grown > 1 ? std::sqrt(squares / (s.grown - 1)) : 0;
  const auto [least, most] = std::minmax_element(volumes.begin(), volumes.end());
  s.least = *least;
  s.most = *most;
}

void summarizeSpread(Sensitivity& s, const std::vector<Grown>& all, std::size_t vertices) {
  s.spread.assign(vertices, 0);
  for (const Grown& g : all)
    for (std::size_t v = 0; v < g.distances.size(); ++v) s.spread[v] += g.distances[v] * g.distances[v];
  if (s.grown == 0) return;
  for (double& d : s.spread) d = std::sqrt(d / s.grown);
  std::vector<double> sorted = s.spread;
  std::sort(sorted.begin(), sorted.end());
  s.meanSpread = std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
  s.spread95 = sorted[(sorted.size() - 1) * 95 / 100];
  s.largestSpread = sorted.back();
}

}  // namespace

std::vector<Finding> sensitivityWarnings(const Sensitivity& s) {
  std::vector<Finding> out;
  const int count = static_cast<int>(s.runs.size());
  if (s.grown < count)
    out.push_back({FindingKind::runsWithoutSurface, {{"runs", count - s.grown}, {"of", count}}});
  if (s.sameTopology < s.grown)
    out.push_back({FindingKind::otherTopology, {{"runs", s.grown - s.sameTopology}, {"of", count}}});
  if (s.deviation > kMuch * s.mean)
    out.push_back({FindingKind::volumeVaries, {{"percent", std::round(100 * s.deviation / s.mean)}}});
  if (s.grown > 0 && std::max(s.least - s.result, s.result - s.most) > kMuch * s.result)
    out.push_back({FindingKind::volumeBesideRuns,
                   {{"volume_ml", s.result / kMillilitre},
                    {"least_ml", s.least / kMillilitre},
                    {"most_ml", s.most / kMillilitre}}});
  return out;
}

void requireRepeatable(const Constraints& c) {
  if (c.start && c.start->isDone) throw Told<UsageError>(FindingKind::sensitivityGiven);
  if (c.vetoes.empty() && c.pins.empty() && c.edits.empty()) return;
  throw Told<UsageError>(FindingKind::sensitivityNames);
}

Sensitivity sensitivityOf(const TriangleSoup& mesh, const GrownFrom& from, int count, int threads,
                          const std::function<void(int)>& progress) {
  requireRepeatable(from.request.constraints);
  Sensitivity out;
  out.by.noise = noiseNear(from.volume, placeInside(from.request));
  std::vector<Grown> all(count);
  std::mutex guard;
  int ended = 0;
  forEachOnThreads(all.size(), threads, [&](std::size_t i) {
    all[i] = oneRun(mesh, from, out.by, i);
    const std::lock_guard lock(guard);
    ++ended;
    if (progress) progress(ended);
  });
  const Certificate result = examine(mesh);
  out.result = result.volume;
  for (const Grown& g : all) {
    out.runs.push_back(g.run);
    out.sameTopology +=
        g.run.failure.empty() && g.run.components == result.components && g.run.genus == genusOf(result);
  }
  summarizeVolumes(out);
  summarizeSpread(out, all, mesh.points.size());
  return out;
}

}  // namespace handlebody
