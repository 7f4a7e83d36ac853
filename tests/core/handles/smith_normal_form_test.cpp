#include "core/handles/smith_normal_form.h"

#include <cstdlib>
#include <limits>
#include <numeric>
#include <random>

#include "core/errors.h"
#include "tests/support/catch.h"

namespace handlebody {
namespace {

IntegerMatrix randomMatrix(int rows, int columns, int largest, std::mt19937& random) {
  std::uniform_int_distribution<int> entry(-largest, largest);
  IntegerMatrix matrix(rows, columns);
  for (std::int64_t& e : matrix.entries) e = entry(random);
  return matrix;
}

std::int64_t minor(const IntegerMatrix& m, int r0, int r1, int c0, int c1) {
  return m.at(r0, c0) * m.at(r1, c1) - m.at(r0, c1) * m.at(r1, c0);
}

std::int64_t determinant(const IntegerMatrix& m) {
  return m.at(0, 0) * minor(m, 1, 2, 1, 2) - m.at(0, 1) * minor(m, 1, 2, 0, 2) +
         m.at(0, 2) * minor(m, 1, 2, 0, 1);
}

//! The greatest common divisors of all minors of order 1, 2 and 3 of a 3 × 3 matrix.
std::vector<std::int64_t> determinantalDivisors(const IntegerMatrix& m) {
  std::int64_t first = 0;
  std::int64_t second = 0;
  for (const std::int64_t e : m.entries) first = std::gcd(first, e);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      second = std::gcd(second, minor(m, (r + 1) % 3, (r + 2) % 3, (c + 1) % 3, (c + 2) % 3));
    }
  }
  return {first, second, std::abs(determinant(m))};
}

}  // namespace

TEST_CASE("Products of invariant factors are the gcds of the minors", "[handles][homology]") {
  std::mt19937 random(11);
  for (int round = 0; round < 2000; ++round) {
    const IntegerMatrix matrix = randomMatrix(3, 3, 1 + round % 9, random);
    std::vector<std::int64_t> products;
    for (const std::int64_t factor : smithNormalForm(matrix).factors) {
      products.push_back(products.empty() ? factor : products.back() * factor);
    }
    products.resize(3, 0);
    CHECK(products == determinantalDivisors(matrix));
  }
}

TEST_CASE("Invariant factors divide each other and the transform's last columns are the kernel",
          "[handles][homology]") {
  std::mt19937 random(12);
  for (int round = 0; round < 300; ++round) {
    const int rows = 1 + round % 5;
    const int columns = 1 + round / 5 % 6;
    const IntegerMatrix matrix = randomMatrix(rows, columns, 4, random);
    const SmithNormalForm form = smithNormalForm(matrix);
    for (std::size_t i = 1; i < form.factors.size(); ++i) CHECK(form.factors[i] % form.factors[i - 1] == 0);
    for (int k = static_cast<int>(form.factors.size()); k < columns; ++k) {
      for (int r = 0; r < rows; ++r) {
        std::int64_t sum = 0;
        for (int c = 0; c < columns; ++c) sum += matrix.at(r, c) * form.columnTransform.at(c, k);
        CHECK(sum == 0);
      }
    }
    const SmithNormalForm transform = smithNormalForm(form.columnTransform);
    CHECK(transform.factors == std::vector<std::int64_t>(columns, 1));
  }
}

TEST_CASE("Entries that leave 64 bits are an error, not a wrong answer", "[handles][homology]") {
  const std::int64_t large = std::numeric_limits<std::int64_t>::max() - 1;
  IntegerMatrix matrix(2, 2);
  matrix.entries = {2, large, large, 3};
  CHECK_THROWS_AS(smithNormalForm(matrix), UsageError);
}

TEST_CASE("A zero or empty matrix has no invariant factors", "[handles][homology]") {
  CHECK(smithNormalForm(IntegerMatrix(3, 2)).factors.empty());
  CHECK(smithNormalForm(IntegerMatrix(0, 0)).factors.empty());
}

}  // namespace handlebody
