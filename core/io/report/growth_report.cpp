#include "core/io/report/growth_report.h"

#include <algorithm>
#include <iterator>

#include "core/cancellation.h"
#include "core/evolution/clicked_object.h"
#include "core/phase.h"
#include "core/told_error.h"

namespace handlebody {

void tellBeginning(const ActiveContour& contour, RunReport& report) {
  report.session.resolved = contour.parameters();
}

CandidateSearch::CandidateSearch(const ActiveContour& contour) : choices_(contour.choices()) {
  if (choices_->areKnown()) return;
  thread_ = std::jthread([choices = choices_, cancelled = CancelScope::current()] {
    const CancelScope scope(cancelled);
    try {
      choices->get();
    } catch (...) {  // tell() tries again, and throws it where it is heard
    }
  });
}

void CandidateSearch::tell(RunReport& report) {
  if (thread_.joinable()) {
    const Phase phase(kFindingPhase);  // the thread tells nobody
    thread_.join();
  }
  report.candidates = choices_->get().candidates;
  report.isCloseChoice = choices_->get().isCloseChoice;
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
  report.unsupportedSurface = support.withoutEdge;
}

}  // namespace handlebody
