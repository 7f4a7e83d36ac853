#pragma once
// Which of the objects that the clicks may mean is chosen, and the way from it to a smaller or a larger one.

#include <optional>
#include <vector>

#include "core/object/candidate.h"

namespace handlebody::ui {

//! Candidates are named as the engine names them: by their place from 1 on, the likeliest first.
struct CandidateChoice {
  std::vector<ObjectCandidate> candidates;  //!< the likeliest first; empty: none are known
  int chosen = 0;                           //!< 0 without candidates
  bool isClose = false;                     //!< the first is hardly likelier than another one
};

enum class SizeStep { smaller, larger };

//! The candidate whose volume comes next to that of the chosen one; none if there is none. Of equal volumes
//! the likelier one counts as the smaller.
std::optional<int> neighbour(const CandidateChoice& choice, SizeStep step);
//! The place of the chosen one by volume, 1 = the smallest; 0 without candidates.
int placeBySize(const CandidateChoice& choice);
//! Precondition: 1 <= candidate <= choice.candidates.size()
double volumeOf(const CandidateChoice& choice, int candidate);  // mm³

}  // namespace handlebody::ui
