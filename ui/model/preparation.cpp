#include "ui/model/preparation.h"

#include <chrono>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/evolution/clicked_object.h"
#include "core/told_error.h"
#include "ui/model/error_sentence.h"

namespace handlebody::ui {

namespace {
constexpr std::size_t kMaxKnown = 4;

//! Throws UsageError.
std::shared_ptr<const ActiveContour> startedFrom(const ActiveContour& made, const Request& request,
                                                 const CarriedStart& surface) {
  for (const Pin& pin : request.constraints.pins)
    if (pin.iteration == 0) throw Told<UsageError>(FindingKind::pinBeforeStep);
  auto contour = std::make_shared<ActiveContour>(made);
  contour->startFrom(Mesh(surface.mesh), surface.holdTopology);
  return contour;
}

}  // namespace

ActiveContour Preparation::make(const Volume& volume, const Request& request) {
  const auto& [seeds, parameters, constraints] = request;
  for (const Known& known : known_)
    if (known.contour->requestedSeeds() == seeds && chooseSameImage(known.contour->requested(), parameters))
      return known.contour->restarted(parameters, constraints);
  if (!memory_) memory_ = std::make_shared<ObjectMemory>();
  return {volume, seeds, parameters, constraints, memory_.get()};
}

Prepared Preparation::prepare(const Volume& volume, const Request& request, const CarriedStart* surface) {
  const auto start = std::chrono::steady_clock::now();
  if (!known_.empty() && known_.front().volume.voxels != volume.voxels) {
    known_.clear();
    memory_.reset();
  }
  Prepared prepared;
  const auto made = std::make_shared<const ActiveContour>(make(volume, request));
  prepared.contour = surface ? startedFrom(*made, request, *surface) : made;
  prepared.contour->candidates();  // here, and not on the window's thread, which shows them
  prepared.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  known_.push_front({volume, made});
  if (known_.size() > kMaxKnown) known_.pop_back();
  return prepared;
}

Preparation::~Preparation() { cancel(); }

void Preparation::cancel() { *cancelled_ = true; }

void Preparation::forget() {
  cancel();
  background_.postInstead([this] {
    known_.clear();
    memory_.reset();
  });
}

void Preparation::request(const Volume& volume, const Request& request,
                          const std::vector<FinishedWall>& walls,
                          const std::shared_ptr<const CarriedStart>& start,
                          std::function<void(Prepared)> done) {
  cancel();
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  background_.postInstead([=, this, stop = cancelled_, done = std::move(done)] {
    const CancelScope scope(*stop);
    try {
      for (const FinishedWall& wall : walls) wall.mesh->get();
      done(prepare(volume, request, start.get()));
    } catch (const Cancelled&) {  // nobody waits for it
    } catch (...) {
      done({nullptr, errorSentence(), 0});
    }
  });
}

}  // namespace handlebody::ui
