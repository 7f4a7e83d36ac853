// The numbers of handles. For two caps a handle is a cyclic sequence of p steps along the first and q along
// the second cap, placed on the p · q pairs of vertices (see countAllOfTwo).

#include <algorithm>
#include <array>
#include <numeric>
#include <string>

#include "core/errors.h"
#include "core/handles/handle_database.h"
#include "core/handles/handle_enumeration.h"
#include "core/handles/handle_sizes.h"

namespace handlebody {
namespace {

using Number = std::uint64_t;

[[noreturn]] void throwTooMany() {
  throw UsageError("The handles for caps of these sizes are too many to count in 64 bits; use smaller caps.");
}

Number product(Number a, Number b) {
  Number result = 0;
  if (__builtin_mul_overflow(a, b, &result)) throwTooMany();
  return result;
}

Number sum(Number a, Number b) {
  Number result = 0;
  if (__builtin_add_overflow(a, b, &result)) throwTooMany();
  return result;
}

Number binomial(Number n, Number k) {
  k = std::min(k, n - k);
  Number result = 1;
  for (Number i = 1; i <= k; ++i) {
    const Number common = std::gcd(result, i);  // i / common divides n - k + i
    result = product(result / common, (n - k + i) / (i / common));
  }
  return result;
}

Number totient(Number n) {
  Number result = n;
  for (Number d = 2; d * d <= n; ++d) {
    if (n % d != 0) continue;
    result -= result / d;
    while (n % d == 0) n /= d;
  }
  return n > 1 ? result - result / n : result;
}

//! The sum over the common divisors d of p and q of totient(d) · term(d): Burnside's lemma for rotations.
template <typename Term>
Number sumOverDivisors(Number p, Number q, Term&& term) {
  const Number common = std::gcd(p, q);
  Number total = 0;
  for (Number d = 1; d * d <= common; ++d) {
    if (common % d != 0) continue;
    total = sum(total, product(totient(d), term(d)));
    if (d * d < common) total = sum(total, product(totient(common / d), term(common / d)));
  }
  return total;
}

//! All sequences of p and q steps from all pairs, p · C(p+q-1, p), less the p · q in which each cap's steps
//! are made in one run (they join a pair twice). Orbits are cyclic words of p and q letters; the exchange
//! reverses a word and swaps the letters, which fixes 2^p words in half of its combinations with rotations.
HandleCount countAllOfTwo(Number p, Number q) {
  HandleCount count;
  count.handles = product(p, binomial(p + q - 1, p) - q);
  const Number words =
      sumOverDivisors(p, q, [&](Number d) { return binomial((p + q) / d, p / d); }) / (p + q);
  count.generators = words - 1;
  if (p == q) count.generators = (words + (Number{1} << (p - 1))) / 2 - 1;
  return count;
}

//! Cyclic sequences without two successive steps along the smaller cap, that is the ways to divide a
//! circle of `larger` edges among the vertices of the smaller cap. Equal sizes: one orbit, so the exchange
//! adds nothing.
HandleCount countMonotone(Number larger, Number smaller) {
  const Number fixed =
      sumOverDivisors(larger, smaller, [&](Number d) { return binomial(larger / d - 1, smaller / d - 1); });
  return {product(larger, binomial(larger - 1, smaller - 1)), fixed / smaller};
}

//! The two faces of Type 2 cut each pair of caps' strip out. Where every vertex is an apex once, the steps
//! of a strip alternate, and at each of the two faces the strips on it start all on their first or all on
//! their second cap, in cyclic order: 2 · 2 kinds. Two of them need an even sum of the sizes, the other two
//! an odd one, and the lengths of the strips follow; they are positive if the largest size is at most the
//! sum of the others less 2. One face of Type 2 can be at any m1 · m2 · m3 triples and fixes the rest. An
//! exchange turns the two kinds into each other if the sum is odd, and keeps them if it is even.
HandleCount countBalancedOfThree(std::span<const int> sizes) {
  std::array<Number, 3> m{};
  std::copy(sizes.begin(), sizes.end(), m.begin());
  std::sort(m.begin(), m.end());
  if (m[2] + 2 > m[0] + m[1]) return {};
  const bool exchange = m[0] == m[1] || m[1] == m[2];
  const bool odd = (m[0] + m[1] + m[2]) % 2 == 1;
  return {product(2 * m[0], product(m[1], m[2])), exchange && odd ? Number{1} : Number{2}};
}

HandleCount countOfTwo(std::span<const int> sizes, Family family) {
  const auto smaller = static_cast<Number>(std::min(sizes[0], sizes[1]));
  const auto larger = static_cast<Number>(std::max(sizes[0], sizes[1]));
  if (family == Family::all) return countAllOfTwo(smaller, larger);
  if (family == Family::monotone) return countMonotone(larger, smaller);
  return smaller == larger ? HandleCount{larger, 1} : HandleCount{};  // strictly alternating steps
}

}  // namespace

void checkSizes(std::span<const int> sizes, Family family) {
  const std::size_t k = sizes.size();
  if (family == Family::monotone && k != 2) {
    throw UsageError("The monotone family is defined for 2 caps, not for " + std::to_string(k) + ".");
  }
  if (k < 2 || k > 4) {
    throw UsageError("Handles are supported for 2, 3 or 4 caps, not for " + std::to_string(k) + ".");
  }
  for (const int size : sizes) {
    if (size < 3) {
      throw UsageError("A cap has at least 3 boundary vertices, not " + std::to_string(size) + ".");
    }
  }
}

HandleCount countHandles(std::span<const int> sizes, Family family) {
  checkSizes(sizes, family);
  if (sizes.size() == 2) return countOfTwo(sizes, family);
  if (sizes.size() == 3 && family == Family::balanced) return countBalancedOfThree(sizes);
  if (const auto* stored = HandleDatabase::stored().find(sizes, family))
    return {stored->handles, stored->generators.size()};
  const std::vector<Handle> handles = enumerateHandles(sizes, family);
  return {handles.size(), countGenerators(sizes, handles)};
}

}  // namespace handlebody
