#include "core/handles/partial_handle.h"

#include <algorithm>

#include "core/indices.h"

namespace handlebody {

namespace {

//! Two loops become one: from the end of the side round to its start, over to the apex, round the other loop
//! back to the apex.
void join(PartialHandle& p, const HandleBranch& b) {
  Word first = p.loops[b.loop];
  Word second = p.loops[b.otherLoop];
  std::rotate(first.begin(), first.begin() + (b.side + 1) % static_cast<int>(first.size()), first.end());
  std::rotate(second.begin(), second.begin() + b.apex, second.end());
  first.insert(first.end(), second.begin(), second.end());
  first.push_back(second[0]);
  p.loops.erase(p.loops.begin() + std::max(b.loop, b.otherLoop));
  p.loops.erase(p.loops.begin() + std::min(b.loop, b.otherLoop));
  (p.loops.empty() ? p.discs : p.loops).push_back(std::move(first));
}

//! One of the two parts of the loop is a disc (or a mere side), the other stays with the other loops.
void split(PartialHandle& p, const HandleBranch& b) {
  Word word = p.loops[b.loop];
  const int n = static_cast<int>(word.size());
  std::rotate(word.begin(), word.begin() + (b.side + 1) % n, word.end());  // v … w … u
  const auto apex = word.begin() + (b.apex - b.side - 1 + n) % n;
  Word toApex(word.begin(), apex + 1);
  Word fromApex(apex, word.end());
  Word& disc = b.restAfterApex ? toApex : fromApex;
  p.loops[b.loop] = b.restAfterApex ? fromApex : toApex;
  if (disc.size() > 2) p.discs.push_back(std::move(disc));
}

}  // namespace

Triangle faceOf(const PartialHandle& p, const HandleBranch& b) {
  const Word& word = p.loops[b.loop];
  return {word[b.side], word[(idx(b.side) + 1) % word.size()], p.loops[b.otherLoop][b.apex]};
}

void take(PartialHandle& p, const HandleBranch& b) {
  p.taken.push_back(faceOf(p, b));
  if (b.loop == b.otherLoop)
    split(p, b);
  else
    join(p, b);
}

}  // namespace handlebody
