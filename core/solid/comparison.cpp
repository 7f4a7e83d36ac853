#include "core/solid/comparison.h"

#include <algorithm>
#include <cmath>

#include "core/phase.h"

namespace handlebody {

namespace {

std::size_t samplesAt(const Solid& a, const Solid& b, double h) {
  const std::size_t n = countSamples(a.surface, h, kMaxSamples);
  return n > kMaxSamples ? n : n + countSamples(b.surface, h, kMaxSamples - n);
}

//! Pieces whose longest edge is at most h have some h²/8 of area each.
double samplingFor(const Solid& a, const Solid& b, double wanted) {
  if (wanted > 0) {
    if (samplesAt(a, b, wanted) > kMaxSamples) throw TooManySamples(wanted);
    return wanted;
  }
  const double area = areaOf(a.surface) + areaOf(b.surface);
  double h = std::sqrt(8 * area / static_cast<double>(kUsualSamples));
  const std::size_t fewest = a.surface.triangles.size() + b.surface.triangles.size();
  while (samplesAt(a, b, h) > std::max(4 * kUsualSamples, 2 * fewest)) h *= 2;
  return h;
}

SurfaceDistances distancesOf(const Solid& a, const Solid& b, const ComparisonOptions& options) {
  const Phase phase("distances");
  SurfaceDistances d;
  d.sampling = samplingFor(a, b, options.sampling);
  d.ofA = directedDistances(a.surface, b.surface, d.sampling, options.threads);
  d.ofB = directedDistances(b.surface, a.surface, d.sampling, options.threads);
  return d;
}

struct Bounds {
  Vec3 low, high;
  explicit Bounds(const TriangleSoup& mesh) {
    low = high = mesh.points[mesh.triangles[0][0]];
    for (const Triangle& t : mesh.triangles)
      for (const int v : t) {
        low = low.cwiseMin(mesh.points[v]);
        high = high.cwiseMax(mesh.points[v]);
      }
  }
  bool meets(const Bounds& o) const {
    return (low.array() <= o.high.array()).all() && (o.low.array() <= high.array()).all();
  }
  Bounds turned() const {  // LPS ↔ RAS
    Bounds t = *this;
    t.low.head<2>() = -high.head<2>();
    t.high.head<2>() = -low.head<2>();
    return t;
  }
  Vec3 centre() const { return (low + high) / 2; }
};

void warnOfDistance(const Solid& a, const Solid& b, Comparison& c) {
  const Bounds ba(a.surface), bb(b.surface);
  const bool apart = c.overlap ? c.overlap->both == 0 : !ba.meets(bb);
  if (!apart) return;
  const bool turned = !ba.meets(bb) && ba.meets(bb.turned());
  c.warnings.push_back(
      {turned ? FindingKind::objectsTurned : FindingKind::objectsApart,
       {{"apart_mm", c.distances->smallest()}, {"centres_mm", (ba.centre() - bb.centre()).norm()}}});
}

void warnOf(const Solid& solid, const std::string& name, std::vector<Finding>& warnings) {
  const auto warn = [&](FindingKind kind) { warnings.push_back({kind, {{"object", name}}}); };
  if (solid.empty())
    warn(FindingKind::objectEmpty);
  else if (!solid.certificate.closed)
    warn(FindingKind::objectOpen);
  else if (!solid.certificate.oriented)
    warn(FindingKind::objectNotAlike);
  else if (solid.isMisplaced())
    warn(FindingKind::objectMisplaced);
  else if (!solid.certificate.manifold)
    warn(FindingKind::objectBranches);
  if (solid.wasInsideOut) warn(FindingKind::objectInsideOut);
}

}  // namespace

TooManySamples::TooManySamples(double sampling)
    : Told(Finding(FindingKind::tooManySamples, {{"sampling_mm", sampling}, {"most", kMaxSamples}})) {}

double SurfaceDistances::mean() const {
  return (ofA.mean * ofA.area + ofB.mean * ofB.area) / (ofA.area + ofB.area);
}
double SurfaceDistances::percentile95() const { return std::max(ofA.percentile95, ofB.percentile95); }
double SurfaceDistances::hausdorff() const { return std::max(ofA.largest, ofB.largest); }
double SurfaceDistances::smallest() const { return std::min(ofA.smallest, ofB.smallest); }

Comparison compare(const Solid& a, const Solid& b, const ComparisonOptions& options) {
  Comparison c;
  warnOf(a, "A", c.warnings);
  warnOf(b, "B", c.warnings);
  if (!a.empty() && !b.empty()) c.distances = distancesOf(a, b, options);
  if (!a.isClosed() || !b.isClosed() || (a.empty() && b.empty())) {
    if (c.distances) warnOfDistance(a, b, c);
    return c;
  }
  if (!c.distances) {
    c.dice = c.iou = 0;
    return c;
  }
  c.overlap = overlapOf(a, b, options.sampling);
  const double sum = c.overlap->a + c.overlap->b;
  if (sum > 0) {
    c.dice = 2 * c.overlap->both / sum;
    c.iou = c.overlap->both / (sum - c.overlap->both);
  } else {
    c.warnings.push_back(FindingKind::noLatticePoint);
  }
  warnOfDistance(a, b, c);
  return c;
}

}  // namespace handlebody
