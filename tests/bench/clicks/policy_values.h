#pragma once
// The thresholds of ObjectPolicy by name, for measurements that change one.

#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/object/policy.h"

namespace handlebody::bench {

using PolicyMember = std::variant<double ObjectPolicy::*, std::size_t ObjectPolicy::*, int ObjectPolicy::*>;

inline const std::vector<std::pair<std::string, PolicyMember>>& policyMembers() {
  using P = ObjectPolicy;
  static const std::vector<std::pair<std::string, PolicyMember>> members{
#define HANDLEBODY_MEMBER(name) {#name, &P::name}
      HANDLEBODY_MEMBER(reach),          HANDLEBODY_MEMBER(wideCells),
      HANDLEBODY_MEMBER(nearCells),      HANDLEBODY_MEMBER(smoothing),
      HANDLEBODY_MEMBER(rangeCells),     HANDLEBODY_MEMBER(outliers),
      HANDLEBODY_MEMBER(noiseCells),     HANDLEBODY_MEMBER(firstRung),
      HANDLEBODY_MEMBER(lastRung),       HANDLEBODY_MEMBER(largestPart),
      HANDLEBODY_MEMBER(mostBorder),     HANDLEBODY_MEMBER(fewest),
      HANDLEBODY_MEMBER(sameSize),       HANDLEBODY_MEMBER(sameRegion),
      HANDLEBODY_MEMBER(starSmoothing),  HANDLEBODY_MEMBER(starRays),
      HANDLEBODY_MEMBER(smallestStart),  HANDLEBODY_MEMBER(nextStart),
      HANDLEBODY_MEMBER(largestStart),   HANDLEBODY_MEMBER(starInner),
      HANDLEBODY_MEMBER(starOuter),      HANDLEBODY_MEMBER(starBend),
      HANDLEBODY_MEMBER(starShell),      HANDLEBODY_MEMBER(starEdge),
      HANDLEBODY_MEMBER(starBeyond),     HANDLEBODY_MEMBER(starMargin),
      HANDLEBODY_MEMBER(starMoves),      HANDLEBODY_MEMBER(starMove),
      HANDLEBODY_MEMBER(starRounds),     HANDLEBODY_MEMBER(stability),
      HANDLEBODY_MEMBER(edge),           HANDLEBODY_MEMBER(contrast),
      HANDLEBODY_MEMBER(shape),          HANDLEBODY_MEMBER(compact),
      HANDLEBODY_MEMBER(ragged),         HANDLEBODY_MEMBER(agreement),
      HANDLEBODY_MEMBER(clearContrast),  HANDLEBODY_MEMBER(clearEdge),
      HANDLEBODY_MEMBER(border),         HANDLEBODY_MEMBER(size),
      HANDLEBODY_MEMBER(largePart),      HANDLEBODY_MEMBER(tried),
      HANDLEBODY_MEMBER(corrected),      HANDLEBODY_MEMBER(mixed),
      HANDLEBODY_MEMBER(weighed),        HANDLEBODY_MEMBER(sure),
      HANDLEBODY_MEMBER(logGrowth),      HANDLEBODY_MEMBER(logPlateau),
      HANDLEBODY_MEMBER(logFloor),       HANDLEBODY_MEMBER(likely),
      HANDLEBODY_MEMBER(crisp),          HANDLEBODY_MEMBER(likelySame),
      HANDLEBODY_MEMBER(likelyScore),    HANDLEBODY_MEMBER(correctionReach),
      HANDLEBODY_MEMBER(makeshiftReach), HANDLEBODY_MEMBER(edgesLost),
      HANDLEBODY_MEMBER(tooDeep),        HANDLEBODY_MEMBER(against),
      HANDLEBODY_MEMBER(againstDeep),    HANDLEBODY_MEMBER(refineOuter),
      HANDLEBODY_MEMBER(refineInner),    HANDLEBODY_MEMBER(cavity),
      HANDLEBODY_MEMBER(passLength),     HANDLEBODY_MEMBER(close),
      HANDLEBODY_MEMBER(logTop),         HANDLEBODY_MEMBER(tubeBonus),
      HANDLEBODY_MEMBER(tubeSmooth),     HANDLEBODY_MEMBER(tubeAround),
      HANDLEBODY_MEMBER(tubeRounds),     HANDLEBODY_MEMBER(tubeStart),
      HANDLEBODY_MEMBER(tubeKeep),       HANDLEBODY_MEMBER(tubeShell),
      HANDLEBODY_MEMBER(tubeEdge),       HANDLEBODY_MEMBER(tubeStep),
      HANDLEBODY_MEMBER(tubeTurn),       HANDLEBODY_MEMBER(tubeGrowth),
      HANDLEBODY_MEMBER(tubeWeak),       HANDLEBODY_MEMBER(tubeMissed),
      HANDLEBODY_MEMBER(tubeLong),       HANDLEBODY_MEMBER(tubeSmallest),
      HANDLEBODY_MEMBER(tubeNext),       HANDLEBODY_MEMBER(tubeLargest),
      HANDLEBODY_MEMBER(tubeDirections), HANDLEBODY_MEMBER(thinPart),
      HANDLEBODY_MEMBER(rival),          HANDLEBODY_MEMBER(central),
      HANDLEBODY_MEMBER(centralDepth),   HANDLEBODY_MEMBER(leastCentral),
      HANDLEBODY_MEMBER(renewed),        HANDLEBODY_MEMBER(displaced),
      HANDLEBODY_MEMBER(displacedWidth), HANDLEBODY_MEMBER(otherPart),
      HANDLEBODY_MEMBER(displacedEdge),  HANDLEBODY_MEMBER(shallow),
      HANDLEBODY_MEMBER(core),           HANDLEBODY_MEMBER(coreCells),
      HANDLEBODY_MEMBER(coreCut),        HANDLEBODY_MEMBER(leastNoise),
      HANDLEBODY_MEMBER(mostNoise),      HANDLEBODY_MEMBER(offered),
      HANDLEBODY_MEMBER(workCells),      HANDLEBODY_MEMBER(tubeSections),
      HANDLEBODY_MEMBER(relabelZone),    HANDLEBODY_MEMBER(relabelBall),
      HANDLEBODY_MEMBER(relabelEdge),    HANDLEBODY_MEMBER(relabelPrior),
      HANDLEBODY_MEMBER(relabelClick),   HANDLEBODY_MEMBER(relabelSure),
      HANDLEBODY_MEMBER(growth),         HANDLEBODY_MEMBER(growthApart),
      HANDLEBODY_MEMBER(left),           HANDLEBODY_MEMBER(settled),
      HANDLEBODY_MEMBER(settledShape),   HANDLEBODY_MEMBER(settledNear),
      HANDLEBODY_MEMBER(slices),         HANDLEBODY_MEMBER(fewSlices)};
#undef HANDLEBODY_MEMBER
  return members;
}

//! Sets a threshold to f(what it is), rounded where it is a whole number; false if there is no such one.
template <typename F>
bool changePolicy(ObjectPolicy& policy, const std::string& name, F&& f) {
  for (const auto& [known, member] : policyMembers())
    if (known == name) {
      std::visit(
          [&](auto m) {
            using T = std::remove_reference_t<decltype(policy.*m)>;
            const double value = f(static_cast<double>(policy.*m));
            policy.*m = static_cast<T>(std::is_integral_v<T> ? std::round(value) : value);
          },
          member);
      return true;
    }
  return false;
}

}  // namespace handlebody::bench
