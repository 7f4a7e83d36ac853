#include "core/io/growth_report.h"

#include <algorithm>
#include <iterator>

#include "core/told_error.h"

namespace handlebody {

void tellBeginning(const ActiveContour& contour, RunReport& report, bool looksForCandidates) {
  report.session.resolved = contour.parameters();
  if (!looksForCandidates && !contour.knowsCandidates()) return;
  report.candidates = contour.candidates();
  report.isCloseChoice = contour.isCloseChoice();
}

void tellState(const ActiveContour& contour, RunReport& report) {
  report.iterations = contour.iteration();
  report.stopped = contour.stopReason();
  report.held = contour.held();
  report.pinned = contour.pinned();
}

void requireNothingWaiting(const ActiveContour& contour) {
  if (contour.stopReason() == StopReason::running) return;
  const std::string ended = ": the growth ended at iteration " + std::to_string(contour.iteration()) + ".";
  if (const auto veto = contour.waitingVeto())
    throw UsageError("The veto of iteration " + std::to_string(veto->iteration) + " has nothing to forbid" +
                     ended);
  if (const auto pin = contour.waitingPin())
    throw UsageError("The pin " + written(*pin) + " holds nothing" + ended);
  if (const auto edit = contour.waitingEdit())
    throw UsageError("The edit of iteration " + std::to_string(edit->iteration) + " is never made" + ended);
}

CertifiedMesh grownMesh(const ActiveContour& contour) {
  if (contour.stopReason() == StopReason::empty)
    throw Told<SeedError>(Finding(FindingKind::surfaceVanished, {{"iterations", contour.iteration()}}));
  return certifiedForExport(contour.mesh().compact());
}

void tellDoubts(const ActiveContour& contour, const TriangleSoup& mesh, RunReport& report) {
  const auto add = [&report](std::vector<Finding> found) {
    std::move(found.begin(), found.end(), std::back_inserter(report.doubts));
  };
  add(doubts(report, mesh));
  const SurfaceSupport support = contour.support();
  add(contour.doubts(support));
  add(leakDoubts(report));
  add(questionDoubts(report));
  add(pinDoubts(report));
  report.unsupportedSurface = support.withoutEdge;
}

}  // namespace handlebody
