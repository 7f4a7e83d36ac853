// A simulated user on labelled real volumes who corrects a surface that has grown: what going on costs and
// comes to after each click, beside a new growth with the same clicks.

#include <chrono>
#include <cstdio>

#include "core/collision/certify.h"
#include "core/evolution/active_contour.h"
#include "core/io/meshes/mesh_io.h"
#include "core/surgery/topology_adaptation.h"
#include "tests/bench/clicks/labelled_case.h"

using namespace handlebody;
using namespace handlebody::bench;

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Run {
  int iterations = 0;
  double seconds = 0;
  int invalid = 0;  // steps that left a mesh without its certificate
};

//! To the end; `every`: iterations between two certificates, which are not counted in the seconds.
Run grow(ActiveContour& contour, int every) {
  Run run;
  const int first = contour.iteration();
  while (contour.stopReason() == StopReason::running) {
    const auto start = Clock::now();
    contour.step();
    run.seconds += since(start);
    if (contour.iteration() % every == 0) run.invalid += !certify(contour.mesh().compact()).passes();
  }
  run.invalid += contour.mesh().faceCount() > 0 && !certify(contour.mesh().compact()).passes();
  run.iterations = contour.iteration() - first;
  return run;
}

Mask voxelsOf(const ActiveContour& contour, const Grid& grid) {
  const Volume labels = rasterize(contour.mesh().compact(), grid);
  const auto* v = static_cast<const std::uint8_t*>(labels.voxels.get());
  return Mask(v, v + grid.voxelCount());
}

void print(const char* what, const Run& run, const ActiveContour& contour, double dice) {
  const TopologyNumbers n = topologyNumbers(contour.mesh());
  std::printf("    %-6s %4d iterations %6.2f s  Dice %.3f  %s  components %d genus %d%s\n", what,
              run.iterations, run.seconds, dice, stopReasonName(contour.stopReason()), n.components, n.genus,
              run.invalid ? "  INVALID" : "");
}

//! Vertices of `before` that are still where they were.
double partInPlace(const Mesh& before, const Mesh& after) {
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::vector<Vec3> now = after.compact().points;
  std::sort(now.begin(), now.end(), less);
  double stayed = 0;
  const std::vector<Vec3> points = before.compact().points;
  for (const Vec3& p : points) stayed += std::binary_search(now.begin(), now.end(), p, less);
  return stayed / static_cast<double>(points.size());
}

void oneUser(const LabelledVolume& v, const Vec3& place, int clicks, int every) {
  std::vector<Seed> given{{place, {}}};
  Parameters parameters;
  parameters.threads = 2;
  ActiveContour contour(v.volume, given, parameters);
  const Run first = grow(contour, every);
  Mask result = voxelsOf(contour, v.volume.grid);
  print("first", first, contour, diceOf(result, v.truth));
  for (int k = 1; k < clicks; ++k) {
    UserClick next;
    if (!nextClick(v, result, next)) break;
    given.push_back({next.place, {}, !next.isInside});
    auto start = Clock::now();
    ActiveContour fresh(v.volume, given, parameters);
    const double prepared = since(start);
    const Mesh before = contour.mesh();
    start = Clock::now();
    contour.change(fresh);
    const double changed = since(start);
    const Correction c = contour.correction().value();
    const Run on = grow(contour, every), anew = grow(fresh, every);
    result = voxelsOf(contour, v.volume.grid);
    std::printf(
        "  %s: image %.2f s, change %.2f s; common %.2f%s%s, %d deleted, %d fronts; %.0f%% in place\n",
        next.isInside ? "inside" : "outside", prepared, changed, c.common, c.beganAnew ? ", ANEW" : "",
        c.givesGround ? ", gives ground" : "", c.deleted, c.fronts,
        100 * partInPlace(before, contour.mesh()));
    print("on", on, contour, diceOf(result, v.truth));
    print("anew", anew, fresh, diceOf(voxelsOf(fresh, v.volume.grid), v.truth));
    std::fflush(stdout);
  }
}

}  // namespace

//! CASES.json [NAME [CLICKS [USERS [CERTIFY-EVERY]]]]; NAME "all": every case.
int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::string only = argc > 2 ? argv[2] : "all";
  const int clicks = argc > 3 ? std::stoi(argv[3]) : 3, users = argc > 4 ? std::stoi(argv[4]) : 1,
            every = argc > 5 ? std::stoi(argv[5]) : 10;
  for (const LabelledCase& c : readCases(argv[1])) {
    if (only != "all" && only != c.name) continue;
    try {
      const LabelledVolume v = readLabelled(c);
      for (const Vec3& place : firstClicks(v, users, 1)) {
        std::printf("%s\n", c.name.c_str());
        oneUser(v, place, clicks, every);
      }
    } catch (const std::exception& error) {
      std::printf("  %s\n", error.what());
    }
    std::fflush(stdout);
  }
}
