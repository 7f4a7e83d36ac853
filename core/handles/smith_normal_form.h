#pragma once
// Smith normal form of small integer matrices, for homology over the integers (paper, Theorem 7).

#include <cstdint>
#include <vector>

namespace handlebody {

//! A dense integer matrix, row by row.
struct IntegerMatrix {
  int rows = 0;
  int columns = 0;
  std::vector<std::int64_t> entries;  //!< rows × columns

  IntegerMatrix(int rowCount, int columnCount);
  static IntegerMatrix identity(int size);
  std::int64_t& at(int r, int c) { return entries[index(r, c)]; }
  std::int64_t at(int r, int c) const { return entries[index(r, c)]; }

 private:
  std::size_t index(int r, int c) const {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c);
  }
};

struct SmithNormalForm {
  //! The invariant factors: positive, each divides the next; their number is the rank.
  std::vector<std::int64_t> factors;
  //! Unimodular (columns × columns): the matrix times its last columns - rank columns is zero, and those
  //! are a basis of the whole kernel over the integers.
  IntegerMatrix columnTransform;
};

//! Throws UsageError if an intermediate entry leaves 64 bits (cannot happen silently).
SmithNormalForm smithNormalForm(IntegerMatrix matrix);

}  // namespace handlebody
