#include "core/evolution/transaction.h"

#include <algorithm>

#include "core/cancellation.h"
#include "core/mesh/topology.h"

namespace handlebody {

Attempt Transaction::tryOnce(const StepWork& work) {
  Attempt a = work.attempt();
  if (a.conflicts.empty())
    a.conflicts = check_.faultsOf({before_, work.mesh, work.topology, a.touched, a.events, work.longest,
                                   work.longestAnywhere, a.parts.get()});
  giveUpIfCancelled();  // the check can take as long as the attempt
  if (a.conflicts.empty()) a.held = work.judge(a);
  return a;
}

Attempt Transaction::keptOrNot(const StepWork& work) {
  Attempt a;
  try {
    a = tryOnce(work);
  } catch (...) {
    check_.forgetPlaces();
    work.mesh = before_;
    throw;
  }
  volume_ = check_.volume();
  if (!a.isKept()) {
    check_.forgetPlaces();
    work.mesh = before_;
  }
  return a;
}

Attempt Transaction::runOnce(const StepWork& work) {
  before_ = work.mesh;
  return keptOrNot(work);
}

Attempt Transaction::run(const StepWork& work) {
  before_ = work.mesh;
  for (int tries = 1;; ++tries) {
    Attempt a = keptOrNot(work);
    if (a.isKept()) return a;
    std::for_each(a.conflicts.begin(), a.conflicts.end(), work.lockAt);
    if (tries < (a.isHeldBack() ? kHeldAttempts : kAttempts)) continue;
    volume_ = signedVolume(work.mesh);
    return a;
  }
}

}  // namespace handlebody
