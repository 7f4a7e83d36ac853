#include "tests/bench/peers/systems.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/collision/certify.h"
#include "core/evolution/active_contour.h"
#include "core/io/meshes/mesh_io.h"
#include "tests/bench/peers/child.h"
#include "tests/bench/peers/iso_surface.h"

namespace handlebody::bench {

namespace {

constexpr int kMaxIterations = 1500;
constexpr int kPatience = 200;            // iterations without a better overlap
constexpr double kAsGood = 0.0005;        // of overlap
constexpr double kThresholdRange = 0.45;  // of the contrast, around the half-way level
constexpr double kThresholdStep = 0.025;
constexpr double kFarOff = 0.1;

//! The intensities of the voxel types' own scale (phantom.h).
std::pair<double, double> levels(VoxelType type) {
  if (type == VoxelType::uint8) return {60, 180};
  if (type == VoxelType::int16) return {-200, 800};
  return {0.25, 0.75};
}

PeerImage peerImage(const Phantom& phantom) {
  const Grid& grid = phantom.volume.grid;
  const auto [object, background] = levels(phantom.volume.type);
  PeerImage out;
  out.size = grid.size;
  const Vec3 seed = grid.toIndex(phantom.seed);
  for (std::size_t a = 0; a < 3; ++a) {
    out.spacing[a] = grid.spacing[static_cast<int>(a)];
    out.seed[a] = seed[static_cast<int>(a)];
  }
  out.seedRadius = phantom.seedRadius;
  out.values.reserve(grid.voxelCount());
  const double middle = (object + background) / 2, contrast = background - object;
  visitVoxels(phantom.volume, [&](const auto* voxels) {
    for (std::size_t v = 0; v < grid.voxelCount(); ++v)
      out.values.push_back(static_cast<float>((static_cast<double>(voxels[v]) - middle) / contrast));
  });
  return out;
}

std::vector<unsigned char> labelOf(const float* field, std::size_t count) {
  std::vector<unsigned char> label(count);
  for (std::size_t v = 0; v < count; ++v) label[v] = field[v] <= 0;
  return label;
}

struct Best {
  double dice = 0;
  int iterations = 0;
};

//! Runs a level set to its best overlap and somewhat further.
Best findIterations(Peer peer, PeerSettings settings, const Phantom& phantom) {
  settings.iterations = kMaxIterations;
  std::vector<Best> seen;
  Best best;
  segmentWith(peer, peerImage(phantom), settings, [&](int n, const float* field) {
    seen.push_back({dice(labelOf(field, phantom.volume.grid.voxelCount()), phantom.truth), n});
    if (seen.back().dice > best.dice) best = seen.back();
    return n < best.iterations + kPatience;
  });
  for (const Best& b : seen)
    if (b.dice >= best.dice - kAsGood) return b;
  return best;
}

Best findThreshold(PeerSettings& settings, const Phantom& phantom) {
  const PeerImage image = peerImage(phantom);
  Best best;
  PeerSettings s = settings;
  for (double t = -kThresholdRange; t <= kThresholdRange + 1e-9; t += kThresholdStep) {
    s.threshold = t;
    const std::vector<float> field = segmentWith(Peer::regionGrowing, image, s);
    const double overlap = dice(labelOf(field.data(), field.size()), phantom.truth);
    if (overlap <= best.dice) continue;
    best.dice = overlap;
    settings.threshold = t;
  }
  return best;
}

//! Fills in what is open. A level set may do better with the half-way level than with that of region growing,
//! which must be far off to close a gap.
Best complete(Peer peer, PeerSettings& settings, const Phantom& phantom) {
  Best best;
  if (peer != Peer::geodesicLevelSet) best = findThreshold(settings, phantom);
  if (peer == Peer::regionGrowing) return best;
  best = findIterations(peer, settings, phantom);
  if (std::abs(settings.threshold) > kFarOff) {
    PeerSettings halfWay = settings;
    halfWay.threshold = 0;
    const Best other = findIterations(peer, halfWay, phantom);
    if (other.dice > best.dice) {
      settings = halfWay;
      best = other;
    }
  }
  settings.iterations = best.iterations;
  return best;
}

//! The quickest of `repeat` runs.
Outcome best(int repeat, const std::function<void(Outcome&)>& run) {
  Outcome quickest;
  for (int i = 0; i < repeat; ++i) {
    Outcome outcome;
    runInChild<Outcome>(outcome, run);
    if (i == 0 || outcome.seconds < quickest.seconds) quickest = outcome;
  }
  return quickest;
}

//! On one thread processor time, which other work on the machine hardly changes.
double secondsOf(const Measure& m, int threads) { return threads == 1 ? m.seconds() : m.wallSeconds(); }

}  // namespace

Outcome runOurs(const Phantom& phantom, const PhantomOptions& options, const Parameters& parameters,
                int repeat) {
  return best(repeat, [&](Outcome& out) {
    const Measure measure;
    ActiveContour contour(phantom.volume, {{phantom.seed, phantom.seedRadius}}, parameters);
    while (contour.stopReason() == StopReason::running) contour.step();
    const TriangleSoup mesh = contour.mesh().compact();
    certify(mesh);
    out.seconds = secondsOf(measure, parameters.threads);
    out.peakMegabytes = measure.peakMegabytes();
    const Volume label = rasterize(mesh, phantom.volume.grid);
    const auto* voxels = label.data<std::uint8_t>();
    out.dice = dice({voxels, voxels + phantom.volume.grid.voxelCount()}, phantom.truth);
    judge(out, mesh, phantom, options);
  });
}

PeerSettings completed(Peer peer, PeerSettings settings, const Phantom& phantom) {
  runInChild<PeerSettings>(settings, [&](PeerSettings& s) { complete(peer, s, phantom); });
  return settings;
}

Outcome runPeer(Peer peer, const PeerSettings& settings, const Phantom& phantom,
                const PhantomOptions& options, int repeat) {
  const PeerImage image = peerImage(phantom);
  return best(repeat, [&](Outcome& out) {
    const Measure measure;
    const std::vector<float> field = segmentWith(peer, image, settings);
    const TriangleSoup mesh = isoSurface(field, phantom.volume.grid);
    out.seconds = secondsOf(measure, settings.threads);
    out.peakMegabytes = measure.peakMegabytes();
    out.dice = dice(labelOf(field.data(), field.size()), phantom.truth);
    judge(out, mesh, phantom, options);
  });
}

PeerSettings tune(Peer peer, const Phantom& phantom, const Trials& trials) {
  PeerSettings bestSettings;
  double bestDice = -1;
  for (double sigma : trials.smoothings)
    for (double curvature : trials.curvatures) {
      // Region growing has no curvature.
      if (peer == Peer::regionGrowing && curvature != trials.curvatures.front()) continue;
      PeerSettings s;
      s.sigma = sigma;
      s.curvature = curvature;
      double overlap = 0;
      runInChild<double>(overlap, [&](double& d) { d = complete(peer, s, phantom).dice; });
      std::fprintf(stderr, "  sigma %g, curvature %g: %.4f\n", sigma, curvature, overlap);
      if (overlap <= bestDice) continue;
      bestDice = overlap;
      bestSettings = s;
    }
  return bestSettings;
}

}  // namespace handlebody::bench
