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

//! The row itself.
template <bool highest>
void takeRow(const std::uint8_t* row, std::uint8_t* to, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) to[i] = pick<highest>(to[i], row[i]);
}

//! The row with each cell's neighbours along it.
template <bool highest>
void takeNeighbours(const std::uint8_t* row, std::uint8_t* to, std::size_t n) {
  takeRow<highest>(row, to, n);
  for (std::size_t i = 1; i < n; ++i) to[i] = pick<highest>(to[i], row[i - 1]);
  for (std::size_t i = 0; i + 1 < n; ++i) to[i] = pick<highest>(to[i], row[i + 1]);
}

}  // namespace

//! Row by row: those beside a row are in the cache still.
template <bool highest>
void Morphology::run(Bytes& cells, const OpeningPass& pass) {
  const std::size_t n = idx(size_[0]);
  result_ = cells;
  const auto row = [&](int y, int z) { return (idx(z) * idx(size_[1]) + idx(y)) * n; };
  for (int z = 0; z < size_[2]; ++z)
    for (int y = 0; y < size_[1]; ++y) {
      std::uint8_t* to = &result_[row(y, z)];
      for (int dz = pass.along[2] ? -1 : 0; dz <= (pass.along[2] ? 1 : 0); ++dz)
        for (int dy = pass.along[1] ? -1 : 0; dy <= (pass.along[1] ? 1 : 0); ++dy) {
          const int aside = (dz != 0 ? 1 : 0) + (dy != 0 ? 1 : 0);
          if (y + dy < 0 || y + dy >= size_[1] || z + dz < 0 || z + dz >= size_[2]) continue;
          if (aside == 2 && !pass.diagonal) continue;
          const std::uint8_t* from = &cells[row(y + dy, z + dz)];
          if (pass.along[0] && (aside == 0 || (aside == 1 && pass.diagonal)))
            takeNeighbours<highest>(from, to, n);
          else
            takeRow<highest>(from, to, n);
        }
    }
  cells.swap(result_);
}

template void Morphology::run<true>(Bytes&, const OpeningPass&);
template void Morphology::run<false>(Bytes&, const OpeningPass&);

}  // namespace handlebody
