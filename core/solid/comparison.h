#pragma once
// Two objects against each other: overlap, distances, topology. docs/compare.md has the definitions.

#include <optional>
#include <string>
#include <vector>

#include "core/solid/overlap.h"
#include "core/solid/surface_distance.h"
#include "core/told_error.h"

namespace handlebody {

//! Of both directions.
struct SurfaceDistances {
  double sampling = 0;  //!< mm
  DirectedDistances ofA, ofB;
  //! Mean over the area of both surfaces together, mm (ASSD).
  double mean() const;
  //! The larger of the two directions, mm.
  double percentile95() const;
  double hausdorff() const;
  //! mm; not above the sampling distance if the surfaces meet
  double smallest() const;
};

struct Comparison {
  std::optional<Overlap> overlap;             //!< none if one has no inside or is empty
  std::optional<double> dice, iou;            //!< none if one has no inside, or both are empty
  std::optional<SurfaceDistances> distances;  //!< none if one is empty
  std::vector<Finding> warnings;              //!< sentences; the objects are called A and B
};

struct ComparisonOptions {
  double sampling = 0;  //!< mm, of the surfaces and of the overlap of two meshes; 0: as many as is useful
  int threads = 1;
};

inline constexpr std::size_t kUsualSamples = 1'000'000;  //!< on both surfaces together, if not told otherwise
inline constexpr std::size_t kMaxSamples = 50'000'000;

//! What was asked for as ComparisonOptions::sampling takes more than kMaxSamples.
class TooManySamples : public Told<UsageError> {
 public:
  explicit TooManySamples(double sampling);
};

//! Throws TooManySamples.
Comparison compare(const Solid& a, const Solid& b, const ComparisonOptions& options);

}  // namespace handlebody
