// Our engine beside its peers, in one run: detection beside CGAL, the whole job beside ITK's level sets and
// region growing. Times are processor times on one thread, wall-clock times on several, each the least of
// --repeat runs; compare ratios, for absolute times drift with the machine's load.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <tuple>

#include "tests/bench/peers/child.h"
#include "tests/bench/peers/systems.h"
#include "tests/bench/peers/tuning.h"
#include "tests/collision_oracle/oracle.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;
using namespace handlebody::bench;
using nlohmann::json;

namespace {

struct Options {
  std::vector<std::string> phantoms;
  PhantomOptions phantom;
  std::vector<double> gaps{0}, curvatures, edges, smoothings;
  Trials trials;
  std::string peers;  // what their names hold
  std::vector<int> threads{1};
  int repeat = 3;
  bool json = false, tune = false, detection = false, alone = false;
};

struct Row {
  std::string system;
  Outcome outcome;
};

json asJson(const Outcome& o) {
  return {{"seconds", o.seconds},   {"peak_mb", o.peakMegabytes},   {"dice", o.dice},
          {"distance", o.distance}, {"vertices", o.vertices},       {"components", o.components},
          {"genus", o.genus},       {"pairs", o.selfIntersections}, {"right_topology", o.rightTopology}};
}

void print(const std::string& phantom, const std::vector<Row>& rows) {
  std::printf("\n%s\n%-22s %9s %8s %9s %7s %9s %9s %6s %6s  %s\n", phantom.c_str(), "", "seconds", "x ours",
              "peak MB", "Dice", "distance", "vertices", "parts", "genus", "topology");
  for (const auto& [system, o] : rows)
    std::printf("%-22s %9.3f %8.2f %9.1f %7.4f %9.3f %9d %6d %6d  %s\n", system.c_str(), o.seconds,
                o.seconds / rows[0].outcome.seconds, o.peakMegabytes, o.dice, o.distance, o.vertices,
                o.components, o.genus, o.rightTopology ? "right" : "WRONG");
  std::fflush(stdout);
}

const std::pair<std::string, Peer> kPeers[] = {{"level set, threshold", Peer::thresholdLevelSet},
                                               {"level set, geodesic", Peer::geodesicLevelSet},
                                               {"region growing", Peer::regionGrowing}};

//! Our engine with nothing told, adaptive, and with each value that was asked for, one at a time.
std::vector<Row> oursOn(const Phantom& phantom, const PhantomOptions& options, const Options& o,
                        int threads) {
  Parameters untold;
  untold.threads = threads;
  std::vector<Row> rows{{"handlebody", runOurs(phantom, options, untold, o.repeat)}};
  const auto add = [&](const char* what, double value, Parameters told) {
    told.threads = threads;
    char label[40];
    std::snprintf(label, sizeof label, "  with %s %g", what, value);
    rows.push_back({label, runOurs(phantom, options, told, o.repeat)});
  };
  Parameters adaptive = untold;
  adaptive.resolution = Resolution::adaptive;
  rows.push_back({"  adaptive", runOurs(phantom, options, adaptive, o.repeat)});
  for (double weight : o.curvatures) add("curvature", weight, {.curvature = weight});
  for (double sigma : o.smoothings) add("smoothing", sigma, {.smoothing = sigma});
  for (double edge : o.edges) {
    add("edge length", edge, {.edgeLength = edge});
    for (double sigma : o.smoothings)
      add("that and smoothing", sigma, {.smoothing = sigma, .edgeLength = edge});
  }
  return rows;
}

using Chosen = std::vector<std::tuple<std::string, Peer, PeerSettings>>;

//! The peers that are asked for, with all that they must be told.
Chosen peersFor(const Phantom& phantom, const Options& o) {
  Chosen out;
  if (o.alone) return out;
  for (const auto& [label, peer] : kPeers) {
    if (label.find(o.peers) == std::string::npos) continue;
    const PeerSettings s = o.tune ? tune(peer, phantom, o.trials) : tunedSettings(peer, phantom.name);
    out.emplace_back(label, peer, completed(peer, s, phantom));
    if (o.tune)
      std::fprintf(stderr, "%s, %s: sigma %g, curvature %g\n", phantom.name.c_str(), label.c_str(), s.sigma,
                   s.curvature);
  }
  return out;
}

json compare(const std::string& title, const std::string& name, const PhantomOptions& options,
             const Options& o) {
  const Phantom phantom = makePhantom(name, options);
  const Chosen peers = peersFor(phantom, o);
  json out;
  for (const int threads : o.threads) {
    std::vector<Row> rows = oursOn(phantom, options, o, threads);
    for (auto [label, peer, settings] : peers) {
      settings.threads = threads;
      rows.push_back({label, runPeer(peer, settings, phantom, options, o.repeat)});
    }
    const std::string suffix = threads == 1 ? "" : ", " + std::to_string(threads) + " threads";
    if (!o.json) print(title + suffix, rows);
    for (const Row& row : rows) out[row.system + suffix] = asJson(row.outcome);
  }
  return out;
}

//! Every phantom with every gap.
json compareAll(const Options& o) {
  json out;
  for (const std::string& name : o.phantoms)
    for (double gap : o.gaps) {
      PhantomOptions options = o.phantom;
      options.gapVoxels = gap;
      char title[80];
      std::snprintf(title, sizeof title, gap > 0 ? "%s, gap %g" : "%s", name.c_str(), gap);
      out[title] = compare(title, name, options, o);
    }
  return out;
}

//! Processor time (ms) of the quickest of several calls that take half a second together.
template <typename F>
double milliseconds(F&& f) {
  double least = 1e300;
  const Measure all;
  do {
    const Measure one;
    f();
    least = std::min(least, one.seconds());
  } while (all.seconds() < 0.5);
  return 1e3 * least;
}

json compareDetection(const char* name, const TriangleSoup& s, bool quiet) {
  const oracle::PreparedMesh prepared(s);
  CollisionDetector detector;
  std::size_t pairs = 0, theirPairs = 0;
  const double warm = milliseconds([&] { pairs = detector.detectAll(s.points, s.triangles).size(); });
  const double cold = milliseconds([&] { findSelfIntersections(s.points, s.triangles); });
  const double cgal = milliseconds([&] { theirPairs = prepared.countSelfIntersections(); });
  if (!quiet)
    std::printf("%-28s %9zu %7zu%s %9.2f %9.2f %9.2f %8.1f %8.1f\n", name, s.triangles.size(), pairs,
                pairs == theirPairs ? "" : " WRONG", warm, cold, cgal, cgal / warm, cgal / cold);
  std::fflush(stdout);
  return {{"triangles", s.triangles.size()},
          {"pairs", pairs},
          {"cgal_pairs", theirPairs},
          {"warm_ms", warm},
          {"cold_ms", cold},
          {"cgal_ms", cgal}};
}

json compareDetections(bool quiet) {
  if (!quiet)
    std::printf("%-28s %9s %7s %9s %9s %9s %8s %8s\n", "detection", "triangles", "pairs", "warm ms",
                "cold ms", "CGAL ms", "warm x", "cold x");
  json out;
  out["sphere 20 k"] = compareDetection("sphere", zoo::sphere(32), quiet);
  out["overlapping 20 k"] = compareDetection("overlapping bumpy spheres", zoo::overlappingSpheres(22), quiet);
  out["sphere 200 k"] = compareDetection("sphere", zoo::sphere(100), quiet);
  out["sphere 1 M"] = compareDetection("sphere", zoo::sphere(224), quiet);
  return out;
}

void addOptions(CLI::App& app, Options& o) {
  app.add_option("--phantom", o.phantoms, "Names (default: all of the paper's experiments)")->delimiter(',');
  app.add_option("--bias", o.phantom.bias, "Largest over smallest gain");
  app.add_option("--gap", o.gaps, "Widths of a hole in the wall, voxels (only for the phantom wall)")
      ->delimiter(',');
  app.add_option("--curvature", o.curvatures, "Weights that our engine is told, in rows of their own")
      ->delimiter(',');
  app.add_option("--smoothing", o.smoothings, "Likewise, mm")->delimiter(',');
  app.add_option("--edge-length", o.edges, "Likewise, mm; with each smoothing, too")->delimiter(',');
  app.add_option("--noise", o.phantom.noise, "Part of the contrast (default: the phantom's own)");
  app.add_option_function<double>(
      "--spacing", [&o](double s) { o.phantom.spacing = Vec3::Constant(s); }, "mm");
  app.add_option("--repeat", o.repeat, "Runs of each system; the quickest counts")->check(CLI::Range(1, 100));
  app.add_option("--threads", o.threads, "Numbers of threads, each in a table of its own")
      ->delimiter(',')
      ->check(CLI::Range(1, 64));
  app.add_flag("--alone", o.alone, "Our engine without the peers");
  app.add_option("--peers", o.peers, "Only peers with this in their name, such as threshold");
  app.add_flag("--json", o.json, "Results as JSON on standard output");
  app.add_flag("--tune", o.tune, "Look for the peers' best settings first (takes long)");
  app.add_option("--try-smoothings", o.trials.smoothings, "With --tune: voxels")->delimiter(',');
  app.add_option("--try-curvatures", o.trials.curvatures, "With --tune: weights")->delimiter(',');
  app.add_flag("--detection", o.detection, "Compare detection with CGAL's, too");
}

int run(const Options& o) {
  json all;
  // Children first: this process must not have held much memory before they are made.
  all["phantoms"] = compareAll(o);
  if (o.detection) all["detection"] = compareDetections(o.json);
  if (o.json) std::cout << all.dump(2) << '\n';
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Our engine beside its peers, in one run"};
  Options o;
  o.phantoms = {"cyst", "cube", "genus3", "torus"};
  addOptions(app, o);
  CLI11_PARSE(app, argc, argv);
  try {
    return run(o);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_peers: %s\n", e.what());
    return 1;
  }
}
