#pragma once
// When a surface has converged.

namespace handlebody {

//! Counts the steps in which nothing, or next to nothing, moves and nothing happens.
class Convergence {
 public:
  //! A step after which the mesh has that many vertices, of which `moved` moved. `isUneventful`: nothing
  //! happened in it, and no region is locked for a time only.
  void count(bool isUneventful, int moved, int vertices);
  //! True if nothing would move, whatever steps were made.
  bool isReached() const;

 private:
  int unmovedSteps_ = 0;        // steps in a row
  int nearlyUnmovedSteps_ = 0;  // the same
};

}  // namespace handlebody
