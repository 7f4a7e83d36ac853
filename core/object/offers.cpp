#include "core/object/offers.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/cancellation.h"
#include "core/object/expected_overlap.h"
#include "core/threads.h"

namespace handlebody {

void Offers::weigh(int threads) {
  std::vector<std::optional<Offer>> made(tasks_.size());
  forEachOnThreads(tasks_.size(), threads, [&](std::size_t i) { made[i] = offerOf(tasks_[i]); });
  tasks_.clear();
  for (auto& o : made)
    if (o) keep(std::move(*o));
}

Offer Offers::take() {
  std::vector<double> worth;
  std::vector<std::vector<double>> overlap(best_.size(), std::vector<double>(best_.size(), 1));
  for (const Offer& o : best_) worth.push_back(o.worth);
  for (std::size_t i = 0; i < best_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      overlap[i][j] = overlap[j][i] = overlapOf(best_[i].region, best_[j].region);
  const auto likelihood = likelihoods(worth, policy_);
  std::vector<double> expected;
  for (const auto& row : overlap)
    expected.push_back(std::inner_product(row.begin(), row.end(), likelihood.begin(), 0.0));
  return std::move(best_[std::max_element(expected.begin(), expected.end()) - expected.begin()]);
}

std::optional<Offer> Offers::offerOf(const Task& task) const {
  giveUpIfCancelled();
  std::optional<Region> region = fit_(task.region());
  if (!region) return {};
  const double worth = task.score - costOfChange(work_, from_, *region, wanted_, policy_);
  return Offer{std::move(*region), worth, task.isLocal};
}

void Offers::keep(Offer offer) {
  const auto place =
      std::find_if(best_.begin(), best_.end(), [&](const Offer& o) { return offer.worth > o.worth; });
  best_.insert(place, std::move(offer));
  if (best_.size() > policy_.weighed) best_.pop_back();
}

}  // namespace handlebody
