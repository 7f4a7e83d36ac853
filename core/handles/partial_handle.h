#pragma once
// Internal to the search for handles: some faces of a handle, and what is left of it without them.

#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

//! A boundary polygon of what is left of the handle; its faces hold the sides in this direction.
using Word = std::vector<int>;

struct PartialHandle {
  std::vector<Triangle> taken;
  std::vector<Word> loops;  //!< of the part that is no disc; none: there are only discs
  std::vector<Word> discs;
};

//! The face on the side of loops.back() or of a whole loop that is to be joined next, by its third corner.
struct HandleBranch {
  int partial = 0;  //!< index of what it continues
  int loop = 0;     //!< with the side
  int side = 0;     //!< its place
  int otherLoop = 0;
  int apex = 0;  //!< its place in otherLoop
  bool restAfterApex =
      true;  //!< apex on the same loop: the other loops lie between apex and side, not between side and apex
};

Triangle faceOf(const PartialHandle& p, const HandleBranch& b);

//! Takes the face of the branch out of what is left.
void take(PartialHandle& p, const HandleBranch& b);

}  // namespace handlebody
