#pragma once
// When a surface has come to rest.

namespace handlebody {

//! Counts the steps in which nothing, or next to nothing, moves and nothing happens.
class Stillness {
 public:
  //! A step after which the mesh has that many vertices, of which `moved` moved. `calm`: nothing happened in
  //! it, and nothing that rests will wake.
  void count(bool calm, int moved, int vertices);
  //! True if the surface would rest on, whatever steps were made.
  bool isAtRest() const;

 private:
  int quiet_ = 0;        // steps in a row
  int nearlyStill_ = 0;  // the same
};

}  // namespace handlebody
