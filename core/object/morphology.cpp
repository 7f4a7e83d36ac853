#include "core/object/morphology.h"

#include <algorithm>

namespace handlebody {

namespace {

using Bytes = std::vector<std::uint8_t>;
std::size_t idx(int i) { return static_cast<std::size_t>(i); }

template <bool highest>
std::uint8_t pick(std::uint8_t a, std::uint8_t b) {
  return (highest ? a > b : a < b) ? a : b;
}

template <bool highest>
void combine(Bytes& to, const Bytes& with) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = pick<highest>(to[i], with[i]);
}

}  // namespace

template <bool highest>
void Morphology::alongAxis(const Bytes& in, Bytes& out, std::size_t axis) const {
  std::size_t block = 1;
  for (std::size_t a = 0; a < axis; ++a) block *= idx(size_[a]);
  const int n = size_[axis];
  out.resize(in.size());
  for (std::size_t slab = 0; slab < in.size(); slab += block * idx(n))
    for (int i = 0; i < n; ++i) {
      const std::uint8_t* a = &in[slab + idx(std::max(i - 1, 0)) * block];
      const std::uint8_t* b = &in[slab + idx(std::min(i + 1, n - 1)) * block];
      const std::uint8_t* centre = &in[slab + idx(i) * block];
      std::uint8_t* to = &out[slab + idx(i) * block];
      for (std::size_t j = 0; j < block; ++j) to[j] = pick<highest>(pick<highest>(a[j], b[j]), centre[j]);
    }
}

template <bool highest>
void Morphology::run(Bytes& cells, const OpeningPass& pass) {
  for (std::size_t a = 0; a < 3; ++a)
    if (pass.along[a]) alongAxis<highest>(cells, line_[a], a);
  for (std::size_t a = 0; a < 3; ++a)
    if (pass.along[a]) combine<highest>(cells, line_[a]);
  if (!pass.diagonal) return;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = a + 1; b < 3; ++b)
      if (pass.along[a] && pass.along[b]) {
        alongAxis<highest>(line_[a], pair_, b);
        combine<highest>(cells, pair_);
      }
}

template void Morphology::run<true>(Bytes&, const OpeningPass&);
template void Morphology::run<false>(Bytes&, const OpeningPass&);

}  // namespace handlebody
