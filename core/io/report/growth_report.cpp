#include "core/io/report/growth_report.h"

#include <algorithm>
#include <iterator>
#include <memory>

#include "core/evolution/clicked_object.h"
#include "core/phase.h"
#include "core/told_error.h"

namespace handlebody {

void tellBeginning(const ActiveContour& contour, RunReport& report) {
  report.session.resolved = contour.parameters();
}

void tellCandidates(const ActiveContour& contour, bool asked, RunReport& report) {
  const std::shared_ptr<const AskedChoices> choices = contour.choices();
  if (!asked && !choices->areKnown()) return;
  const Phase phase(kFindingPhase);
  report.candidates = choices->get().candidates;
  report.isCloseChoice = choices->get().isCloseChoice;
}

void tellState(const ActiveContour& contour, RunReport& report) {
  report.iterations = contour.iteration();
  report.stopped = contour.stopReason();
  report.held = contour.held();
  report.pinned = contour.pinned();
}

void requireNothingWaiting(const ActiveContour& contour) {
  if (contour.stopReason() == StopReason::running) return;
  const auto refuse = [&](FindingKind kind, std::string_view name, const FindingValue& which) {
    throw Told<UsageError>(Finding(kind, {{name, which}, {"now", contour.iteration()}}));
  };
  if (const auto veto = contour.waitingVeto())
    refuse(FindingKind::vetoLeftOver, "iteration", veto->iteration);
  if (const auto pin = contour.waitingPin()) refuse(FindingKind::pinLeftOver, "pin", written(*pin));
  if (const auto edit = contour.waitingEdit())
    refuse(FindingKind::editLeftOver, "iteration", edit->iteration);
}

namespace {

//! Of vetoes and edits, where the growth was stopped before their iterations (pins: pinWarnings).
std::vector<Finding> waitingWarnings(const Constraints& constraints, int now) {
  std::vector<Finding> warnings;
  const auto add = [&](FindingKind kind, const auto& all) {
    for (const auto& one : all)
      if (one.iteration > now)
        warnings.push_back({kind, {{"iteration", one.iteration}, {"mesh_iteration", now}}});
  };
  add(FindingKind::vetoNotReached, constraints.vetoes);
  add(FindingKind::editNotReached, constraints.edits);
  return warnings;
}

}  // namespace

CertifiedMesh grownMesh(const ActiveContour& contour) {
  if (contour.stopReason() == StopReason::empty)
    throw Told<SeedError>(Finding(FindingKind::surfaceVanished, {{"iterations", contour.iteration()}}));
  try {
    return certifiedForExport(contour.mesh().compact());
  } catch (const std::runtime_error&) {  // it was certified as it grew: what fails then is the rounding
    throw Told<InputError>(FindingKind::surfaceTooFar);
  }
}

void addWarnings(const ActiveContour& contour, const TriangleSoup& mesh, RunReport& report) {
  const auto add = [&report](std::vector<Finding> found) {
    std::move(found.begin(), found.end(), std::back_inserter(report.warnings));
  };
  add(resultWarnings(report, mesh));
  const SurfaceSupport support = contour.support();
  add(contour.warnings(support));
  add(leakWarnings(report));
  add(questionWarnings(report));
  add(pinWarnings(report));
  add(waitingWarnings(contour.constraints(), contour.iteration()));
  if (support.covers(contour.mesh().faceCount())) report.unsupportedSurface = support.withoutEdge;
}

}  // namespace handlebody
