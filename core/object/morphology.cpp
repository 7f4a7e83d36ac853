#include "core/object/morphology.h"

#include <algorithm>

#include "core/indices.h"

namespace handlebody {

namespace {

using Bytes = std::vector<std::uint8_t>;
template <bool highest>
std::uint8_t pick(std::uint8_t a, std::uint8_t b) {
  return (highest ? a > b : a < b) ? a : b;
}

//! Cell by cell with those of the other.
template <bool highest>
void take(const std::uint8_t* other, std::uint8_t* to, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) to[i] = pick<highest>(to[i], other[i]);
}

//! A plane with each cell's neighbours along its row. All rows at once: only the ends of each are then other
//! than in one long row.
template <bool highest>
void alongRows(const std::uint8_t* plane, std::uint8_t* to, std::size_t n, std::size_t rows) {
  const std::size_t last = n * rows - 1;
  const auto best = [&](std::size_t a, std::size_t b, std::size_t c) {
    return pick<highest>(pick<highest>(plane[a], plane[b]), plane[c]);
  };
  for (std::size_t i = 1; i < last; ++i) to[i] = best(i, i - 1, i + 1);
  for (std::size_t first = 0; first < n * rows; first += n) {
    const std::size_t end = first + n - 1;
    to[first] = best(first, first, std::min(first + 1, end));
    to[end] = best(end, end, std::max(first + 1, end) - 1);
  }
}

//! The cells of a plane with those of another, or of the same, in the rows before and after.
template <bool highest>
void takeAcrossRows(const std::uint8_t* other, std::uint8_t* to, std::size_t n, std::size_t rows) {
  take<highest>(other, to + n, n * (rows - 1));
  take<highest>(other + n, to, n * (rows - 1));
}

}  // namespace

//! Plane by plane, and in a plane all rows at once: single rows are too short for the processor.
template <bool highest>
void Morphology::run(Bytes& cells, const OpeningPass& pass) {
  const std::size_t n = idx(size_[0]), rows = idx(size_[1]), plane = n * rows;
  result_.resize(cells.size());
  if (pass.along[0]) {
    wide_.resize(cells.size());
    for (int z = 0; z < size_[2]; ++z)
      alongRows<highest>(&cells[idx(z) * plane], &wide_[idx(z) * plane], n, rows);
  }
  const Bytes& own = pass.along[0] ? wide_ : cells;
  const Bytes& beside = pass.diagonal ? own : cells;  // across a face
  for (int z = 0; z < size_[2]; ++z) {
    std::uint8_t* to = &result_[idx(z) * plane];
    std::copy_n(&own[idx(z) * plane], plane, to);
    if (pass.along[1]) takeAcrossRows<highest>(&beside[idx(z) * plane], to, n, rows);
    if (!pass.along[2]) continue;
    for (const int other : {z - 1, z + 1}) {
      if (other < 0 || other >= size_[2]) continue;
      take<highest>(&beside[idx(other) * plane], to, plane);
      if (pass.along[1] && pass.diagonal) takeAcrossRows<highest>(&cells[idx(other) * plane], to, n, rows);
    }
  }
  cells.swap(result_);
}

template void Morphology::run<true>(Bytes&, const OpeningPass&);
template void Morphology::run<false>(Bytes&, const OpeningPass&);

}  // namespace handlebody
