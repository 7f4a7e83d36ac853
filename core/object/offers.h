#pragma once
// What may have made the user click: regions that are tried, and the choice among them.

#include <functional>
#include <optional>
#include <vector>

#include "core/object/corrections.h"

namespace handlebody {

//! A region that a click may ask for.
struct Offer {
  Region region;
  double worth = 0;
  bool isLocal = false;  //!< it changes what is near the click only
};

//! What is tried for one click on the wrong side of a region, and what it is worth.
class Offers {
 public:
  //! Makes of what is tried what can be offered; none if the click is still on the wrong side.
  using Fit = std::function<std::optional<Region>(Region)>;
  //! All must outlive this.
  Offers(const WorkImage& work, const Region& from, const WantedChange& wanted, const ObjectPolicy& policy,
         Fit fit)
      : work_(work), from_(from), wanted_(wanted), policy_(policy), fit_(std::move(fit)) {}

  //! `region` is called once, on any thread; `score`: what speaks for it besides the change itself.
  void add(std::function<Region()> region, double score, bool isLocal) {
    tasks_.push_back({std::move(region), score, isLocal});
  }
  //! Makes what was added.
  void weigh(int threads);
  bool any() const { return !best_.empty(); }
  //! The one that is expected to share most with what is meant. Precondition: there are any.
  Offer take();

 private:
  struct Task {
    std::function<Region()> region;
    double score;
    bool isLocal;
  };
  std::optional<Offer> offerOf(const Task& task) const;
  void keep(Offer offer);

  const WorkImage& work_;
  const Region& from_;
  WantedChange wanted_;
  const ObjectPolicy& policy_;
  Fit fit_;
  std::vector<Task> tasks_;
  std::vector<Offer> best_;  // the best first
};

}  // namespace handlebody
