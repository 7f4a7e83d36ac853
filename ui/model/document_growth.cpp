// The growth of the Document's active object.

#include "ui/model/document_private.h"

namespace handlebody::ui {

GrowthState Document::state() const { return d_->active().state(); }
StopReason Document::stopReason() const { return d_->active().stopReason(); }
QString Document::growthError() const { return d_->active().error(); }

void Document::Private::goOn(Wanted what) {
  if (mayGoOn()) active().goOn(what);
}

void Document::run() { d_->goOn(Private::Wanted::run); }
void Document::stepForward() { d_->goOn(Private::Wanted::step); }
void Document::goToNextEvent() { d_->goOn(Private::Wanted::toEvent); }
void Document::pause() { d_->active().pause(); }

void Document::goTo(int iteration) {
  if (d_->mayGoOn()) d_->active().goTo(iteration);
}
void Document::stepBack() {
  if (d_->mayGoOn()) d_->active().stepBack();
}
void Document::goToPreviousEvent() {
  if (d_->mayGoOn()) d_->active().goToPreviousEvent();
}
void Document::goToStart() { goTo(0); }

void Document::setStepsPerFrame(int steps) {
  d_->growthChoices.stepsPerFrame = std::max(1, steps);
  for (const auto& object : d_->objects) d_->growthChoices.applyTo(object->growth());
}
int Document::stepsPerFrame() const { return d_->growthChoices.stepsPerFrame; }
void Document::setPausesAtLeaks(bool on) {
  d_->growthChoices.pausesAtLeaks = on;
  for (const auto& object : d_->objects) d_->growthChoices.applyTo(object->growth());
}
bool Document::pausesAtLeaks() const { return d_->growthChoices.pausesAtLeaks; }
const std::vector<FoundLeak>& Document::leaks() const { return d_->active().growth().leaks(); }

int Document::iteration() const { return d_->active().growth().iteration(); }
int Document::lastIteration() const { return static_cast<int>(summaries().size()) - 1; }
std::shared_ptr<const MeshSnapshot> Document::snapshot() const { return d_->shownOf(d_->active()); }
const std::vector<IterationSummary>& Document::summaries() const { return d_->active().growth().summaries(); }
const std::vector<RecordedCorrection>& Document::corrections() const {
  return d_->active().growth().corrections();
}
const std::vector<Event>& Document::events() const { return d_->active().growth().events(); }
std::optional<GrownFrom> Document::grownFrom() const {
  const SurfaceGrowth& growth = d_->active().growth();
  if (!d_->work || !growth.snapshot() || !growth.resolved()) return std::nullopt;
  return GrownFrom{d_->work->volume, d_->active().request(), *growth.resolved()};
}
void Document::requestTrace(int index) {
  if (d_->active().growth().exists()) d_->active().growth().trace(index);
}

}  // namespace handlebody::ui
