#include "core/handles/smith_normal_form.h"

#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "core/errors.h"

namespace handlebody {
namespace {

//! a - factor · b, or UsageError if that, or its negative, does not fit.
std::int64_t minusTimes(std::int64_t a, std::int64_t factor, std::int64_t b) {
  std::int64_t product = 0;
  std::int64_t result = 0;
  if (__builtin_mul_overflow(factor, b, &product) || __builtin_sub_overflow(a, product, &result) ||
      result == std::numeric_limits<std::int64_t>::min()) {
    throw UsageError("The complex is too large for its homology to be computed in 64-bit integers.");
  }
  return result;
}

void subtractRow(IntegerMatrix& m, int target, std::int64_t factor, int source) {
  for (int c = 0; c < m.columns; ++c) m.at(target, c) = minusTimes(m.at(target, c), factor, m.at(source, c));
}

void subtractColumn(IntegerMatrix& m, int target, std::int64_t factor, int source) {
  for (int r = 0; r < m.rows; ++r) m.at(r, target) = minusTimes(m.at(r, target), factor, m.at(r, source));
}

void swapRows(IntegerMatrix& m, int a, int b) {
  for (int c = 0; c < m.columns; ++c) std::swap(m.at(a, c), m.at(b, c));
}

void swapColumns(IntegerMatrix& m, int a, int b) {
  for (int r = 0; r < m.rows; ++r) std::swap(m.at(r, a), m.at(r, b));
}

using Pivot = std::pair<int, int>;

//! The entry of least absolute value, not zero, in the rows and columns from k on: small pivots keep the
//! entries small.
std::optional<Pivot> smallestEntry(const IntegerMatrix& m, int k) {
  std::optional<Pivot> best;
  std::int64_t least = 0;
  for (int r = k; r < m.rows; ++r) {
    for (int c = k; c < m.columns; ++c) {
      const std::int64_t size = std::abs(m.at(r, c));
      if (size == 0 || (best && size >= least)) continue;
      best = Pivot{r, c};
      least = size;
      if (size == 1) return best;
    }
  }
  return best;
}

//! Reduces row and column k modulo the pivot (k, k); true if that leaves nothing but the pivot.
bool clearCross(IntegerMatrix& m, IntegerMatrix& transform, int k) {
  const std::int64_t pivot = m.at(k, k);
  bool clear = true;
  for (int r = k + 1; r < m.rows; ++r) {
    if (m.at(r, k) != 0) subtractRow(m, r, m.at(r, k) / pivot, k);
    clear = clear && m.at(r, k) == 0;
  }
  for (int c = k + 1; c < m.columns; ++c) {
    const std::int64_t factor = m.at(k, c) / pivot;
    if (factor != 0) {
      subtractColumn(m, c, factor, k);
      subtractColumn(transform, c, factor, k);
    }
    clear = clear && m.at(k, c) == 0;
  }
  return clear;
}

//! A row below k with an entry that the pivot does not divide, or -1.
int rowNotDivided(const IntegerMatrix& m, int k) {
  for (int r = k + 1; r < m.rows; ++r) {
    for (int c = k + 1; c < m.columns; ++c) {
      if (m.at(r, c) % m.at(k, k) != 0) return r;
    }
  }
  return -1;
}

//! Makes (k, k) the next invariant factor; false if nothing is left. Ends because each round that does not
//! finish leaves a remainder smaller than the pivot.
bool eliminate(IntegerMatrix& m, IntegerMatrix& transform, int k) {
  while (const auto place = smallestEntry(m, k)) {
    swapRows(m, k, place->first);
    swapColumns(m, k, place->second);
    swapColumns(transform, k, place->second);
    if (!clearCross(m, transform, k)) continue;
    const int row = rowNotDivided(m, k);
    if (row < 0) return true;
    subtractRow(m, k, -1, row);
    clearCross(m, transform, k);
  }
  return false;
}

}  // namespace

IntegerMatrix::IntegerMatrix(int rowCount, int columnCount)
    : rows(rowCount),
      columns(columnCount),
      entries(static_cast<std::size_t>(rowCount) * static_cast<std::size_t>(columnCount), 0) {}

IntegerMatrix IntegerMatrix::identity(int size) {
  IntegerMatrix result(size, size);
  for (int i = 0; i < size; ++i) result.at(i, i) = 1;
  return result;
}

SmithNormalForm smithNormalForm(IntegerMatrix matrix) {
  SmithNormalForm result{{}, IntegerMatrix::identity(matrix.columns)};
  int k = 0;
  while (eliminate(matrix, result.columnTransform, k)) {
    result.factors.push_back(std::abs(matrix.at(k, k)));
    ++k;
  }
  return result;
}

}  // namespace handlebody
