#include "ui/model/candidate_choice.h"

#include <algorithm>
#include <numeric>

namespace handlebody::ui {

namespace {

//! The candidates from the smallest to the largest.
std::vector<int> bySize(const CandidateChoice& choice) {
  std::vector<int> order(choice.candidates.size());
  std::iota(order.begin(), order.end(), 1);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return volumeOf(choice, a) < volumeOf(choice, b); });
  return order;
}

}  // namespace

double volumeOf(const CandidateChoice& choice, int candidate) {
  return choice.candidates.at(static_cast<std::size_t>(candidate - 1)).volume;
}

std::optional<int> neighbour(const CandidateChoice& choice, SizeStep step) {
  const std::vector<int> order = bySize(choice);
  const auto at = std::find(order.begin(), order.end(), choice.chosen);
  if (at == order.end()) return std::nullopt;
  if (step == SizeStep::smaller) return at == order.begin() ? std::nullopt : std::optional(*(at - 1));
  return at + 1 == order.end() ? std::nullopt : std::optional(*(at + 1));
}

int placeBySize(const CandidateChoice& choice) {
  const std::vector<int> order = bySize(choice);
  const auto at = std::find(order.begin(), order.end(), choice.chosen);
  return at == order.end() ? 0 : static_cast<int>(at - order.begin()) + 1;
}

}  // namespace handlebody::ui
