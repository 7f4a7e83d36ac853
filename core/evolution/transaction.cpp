#include "core/evolution/transaction.h"

#include <algorithm>

#include "core/mesh/topology.h"

namespace handlebody {

Attempt Transaction::run(const StepWork& work) {
  before_ = work.mesh;
  Attempt a;
  for (int tries = 0; tries < kAttempts; ++tries) {
    a = work.attempt();
    if (a.troubles.empty())
      a.troubles = check_.faultsOf({before_, work.mesh, work.topology, a.touched, a.events, work.longest});
    volume_ = check_.volume();
    if (a.troubles.empty()) return a;
    work.mesh = before_;
    std::for_each(a.troubles.begin(), a.troubles.end(), work.restAt);
  }
  volume_ = signedVolume(work.mesh);
  return a;
}

}  // namespace handlebody
