#include "core/mesh/loop_classes.h"

#include <algorithm>
#include <cstdlib>
#include <random>

#include "core/indices.h"
#include "core/mesh/linking.h"

namespace handlebody {

namespace {

constexpr std::int64_t kPrime = 2147483647;  // 2^31 - 1: products fit into 64 bits

std::int64_t reduced(std::int64_t x) { return ((x % kPrime) + kPrime) % kPrime; }

std::int64_t power(std::int64_t x, std::int64_t exponent) {
  std::int64_t out = 1;
  for (; exponent > 0; exponent /= 2, x = x * x % kPrime)
    if (exponent % 2 == 1) out = out * x % kPrime;
  return out;
}

//! The inverse modulo kPrime of an n × n matrix; none if it has none. Gauss and Jordan.
std::optional<std::vector<std::int64_t>> inverse(std::vector<std::int64_t> a, std::size_t n) {
  std::vector<std::int64_t> b(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) b[i * n + i] = 1;
  const auto subtract = [n](std::vector<std::int64_t>& m, std::size_t row, std::size_t pivot,
                            std::int64_t factor) {
    for (std::size_t j = 0; j < n; ++j)
      m[row * n + j] = reduced(m[row * n + j] - factor * m[pivot * n + j] % kPrime);
  };
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    while (pivot < n && a[pivot * n + c] == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    const std::int64_t scale = power(a[pivot * n + c], kPrime - 2);
    for (std::size_t j = 0; j < n; ++j) {
      std::swap(a[pivot * n + j], a[c * n + j]);
      std::swap(b[pivot * n + j], b[c * n + j]);
      a[c * n + j] = a[c * n + j] * scale % kPrime;
      b[c * n + j] = b[c * n + j] * scale % kPrime;
    }
    for (std::size_t r = 0; r < n; ++r)
      if (const std::int64_t factor = a[r * n + c]; r != c && factor != 0) {
        subtract(a, r, c, factor);
        subtract(b, r, c, factor);
      }
  }
  return b;
}

}  // namespace

std::optional<LoopClasses> LoopClasses::of(const Mesh& mesh) {
  const TreeCotree trees = treeCotree(mesh);
  LoopClasses out;
  out.rank_ = static_cast<int>(trees.generators.size());
  auto projection = outerProjection(mesh, trees);
  if (!projection) return std::nullopt;
  out.projection_ = std::move(*projection);
  out.setCrossings(mesh, trees);
  out.setKeys(mesh);
  if (!out.setIntersections(mesh, trees)) return std::nullopt;
  return out;
}

void LoopClasses::setCrossings(const Mesh& mesh, const TreeCotree& trees) {
  std::vector<std::vector<int>> loops;
  first_.assign(3 * idx(mesh.faceSlots()) + 1, 0);
  for (int k = 0; k < rank_; ++k) {
    loops.push_back(dualLoop(mesh, trees, k));
    for (const int h : loops.back()) {
      ++first_[idx(h) + 1];
      ++first_[idx(mesh.opposite(h)) + 1];
    }
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  crossings_.resize(first_.back());
  std::vector<std::size_t> fill(first_.begin(), first_.end() - 1);
  for (int k = 0; k < rank_; ++k)
    for (const int h : loops[k]) {
      crossings_[fill[h]++] = {k, 1};
      crossings_[fill[mesh.opposite(h)]++] = {k, -1};
    }
}

std::span<const LoopClasses::Crossing> LoopClasses::crossings(int halfedge) const {
  return {crossings_.data() + first_[halfedge], crossings_.data() + first_[idx(halfedge) + 1]};
}

void LoopClasses::setKeys(const Mesh& mesh) {
  const std::size_t n = idx(rank_);
  std::mt19937_64 random(20070607);
  std::vector<ClassKey> ofGenerator(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint64_t weight = random() | 1;
    ofGenerator[i].inner += weight;
    for (std::size_t j = 0; j < n; ++j) {
      const std::uint64_t part = weight * static_cast<std::uint64_t>(std::int64_t{projection_[i * n + j]});
      ofGenerator[j].outer += part;
      ofGenerator[j].inner -= part;
    }
  }
  keys_.assign(3 * idx(mesh.faceSlots()), {});
  for (int h = 0; h < 3 * mesh.faceSlots(); ++h)
    for (const Crossing& c : crossings(h)) {
      if (c.sign > 0)
        keys_[h] += ofGenerator[c.loop];
      else
        keys_[h] -= ofGenerator[c.loop];
    }
}

void LoopClasses::addTo(std::span<std::int64_t> coordinates, int halfedge) const {
  for (const Crossing& c : crossings(halfedge)) coordinates[c.loop] += c.sign;
}

bool LoopClasses::isOfKind(std::span<const std::int64_t> coordinates, LoopKind kind) const {
  const std::size_t n = idx(rank_);
  for (std::size_t i = 0; i < n; ++i) {
    std::int64_t outer = 0;
    for (std::size_t j = 0; j < n; ++j) outer += projection_[i * n + j] * coordinates[j];
    if (outer != (kind == LoopKind::handle ? 0 : coordinates[i])) return false;
  }
  return true;
}

//! Dual loop i, moved into the edges beside it, has coordinates too: row i of a matrix that is the inverse of
//! the intersection numbers of the primal loops, because the dual loops meet those in the unit matrix.
bool LoopClasses::setIntersections(const Mesh& mesh, const TreeCotree& trees) {
  const std::size_t n = idx(rank_);
  std::vector<std::int64_t> rows(n * n, 0);
  for (int k = 0; k < rank_; ++k) {
    const std::vector<int> loop = dualLoop(mesh, trees, k);
    const std::span<std::int64_t> row(rows.data() + idx(k) * n, n);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      // From the origin of this crossing to that of the next: both are corners of the face between them.
      const int u = mesh.origin(loop[i]), v = mesh.origin(loop[(i + 1) % loop.size()]);
      if (u != v) addTo(row, mesh.findHalfedge(u, v));
    }
  }
  for (std::int64_t& x : rows) x = reduced(x);
  auto inverted = inverse(std::move(rows), n);
  if (!inverted) return false;
  intersection_ = std::move(*inverted);
  return true;
}

std::int64_t LoopClasses::intersections(std::span<const std::int64_t> a,
                                        std::span<const std::int64_t> b) const {
  const std::size_t n = idx(rank_);
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (a[i] == 0) continue;
    std::int64_t row = 0;
    for (std::size_t j = 0; j < n; ++j)
      if (b[j] != 0) row = reduced(row + intersection_[i * n + j] * reduced(b[j]) % kPrime);
    sum = reduced(sum + reduced(a[i]) * row % kPrime);
  }
  return sum > kPrime / 2 ? kPrime - sum : sum;
}

}  // namespace handlebody
