#pragma once
// Which of the regions that a click may mean to offer: those that are expected to share most with the one
// that is meant, whichever that is (the choice of least Bayes risk).

#include <vector>

#include "core/object/candidates.h"

namespace handlebody {

//! Regions that may be meant, and how likely each is.
struct LikelyRegions {
  std::vector<RankedRegion> regions;         //!< best score first; they differ a little at least
  std::vector<double> likelihood;            //!< of each; the sum is 1
  std::vector<std::vector<double>> overlap;  //!< Dice of any two
};
//! How likely each is whose score is given; the sum is 1. Precondition: there is one.
std::vector<double> likelihoods(const std::vector<double>& scores, const ObjectPolicy& policy);
//! The `likely` best of all, their scores lowered where the click lies near their rims. Orders `ranked` by
//! score.
LikelyRegions likelyRegions(std::vector<RankedRegion>& ranked, const ObjectPolicy& policy);

//! A region with its expected Dice.
struct OfferedRegion {
  RankedRegion region;
  double expected = 0;
};
//! The first has the highest expectation; each further one adds most to the expectation of the best of those
//! offered. No more than `offered`, and they differ.
std::vector<OfferedRegion> offeredRegions(const LikelyRegions& likely, const ObjectPolicy& policy);

}  // namespace handlebody
