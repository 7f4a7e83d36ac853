#pragma once
// Work that is bounded by a count, not by a clock: the same on every machine.

#include <algorithm>
#include <cstddef>

#include "core/cancellation.h"

namespace handlebody {

//! So many units of work may be done; one is about an addition in an inner loop, a nanosecond or two. Whoever
//! works says so in portions of a millisecond at most: there a stop token that is set is noticed, too.
class WorkBudget {
 public:
  explicit WorkBudget(std::size_t units) : all_(units), left_(units) {}
  //! At least so many units may be done from now on.
  void allowAtLeast(std::size_t units) { left_ = std::max(left_, units); }
  //! Throws Cancelled (cancellation.h).
  void spend(std::size_t units) {
    left_ -= std::min(left_, units);
    giveUpIfCancelled();
  }
  std::size_t all() const { return all_; }
  std::size_t left() const { return left_; }
  bool isSpent() const { return left_ == 0; }

 private:
  std::size_t all_;
  std::size_t left_;
};

}  // namespace handlebody
