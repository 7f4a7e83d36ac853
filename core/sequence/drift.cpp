#include "core/sequence/drift.h"

#include "core/solid/comparison.h"

namespace handlebody {

namespace {

constexpr double kSampling = 0.5;  // edge lengths

}  // namespace

Drift driftBetween(const TriangleSoup& there, const TriangleSoup& back, double edgeLength) {
  const Solid a = solidOf(there), b = solidOf(back);
  ComparisonOptions options;
  options.sampling = kSampling * edgeLength;
  const Comparison c = compare(a, b, options);
  Drift drift;
  drift.isBack = true;
  drift.dice = c.dice.value_or(0);
  if (c.distances) {
    drift.mean = c.distances->mean();
    drift.percentile95 = c.distances->percentile95();
  }
  drift.volumeRatio = a.volume() > 0 ? b.volume() / a.volume() : 0;
  return drift;
}

}  // namespace handlebody
