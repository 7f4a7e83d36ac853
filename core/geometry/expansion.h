#pragma once
// A number as an exact, unevaluated sum of doubles (an expansion in Shewchuk's sense: components do not
// overlap and grow in magnitude). Only what the predicates need; speed does not matter here.

#include <array>
#include <cstddef>

namespace handlebody::detail {

//! A sum of two doubles, exact: high is the rounded value, low the rounding error.
struct DoubleDouble {
  double high;
  double low;
};

//! a + b without error (Knuth).
inline DoubleDouble twoSum(double a, double b) {
  const double high = a + b;
  const double bVirtual = high - a;
  const double aVirtual = high - bVirtual;
  return {high, (a - aVirtual) + (b - bVirtual)};
}

//! Halves of a with at most 26 bits each (Veltkamp, Dekker).
inline DoubleDouble split(double a) {
  constexpr double kSplitter = 134217729.0;  // 2^27 + 1
  const double c = kSplitter * a;
  const double high = c - (c - a);
  return {high, a - high};
}

//! a · b without error (Dekker).
inline DoubleDouble twoProduct(double a, double b) {
  const double high = a * b;
  const DoubleDouble x = split(a);
  const DoubleDouble y = split(b);
  const double rest = ((high - x.high * y.high) - x.low * y.high) - x.high * y.low;
  return {high, x.low * y.low - rest};
}

//! At most N non-zero components.
template <std::size_t N>
class Expansion {
 public:
  Expansion() = default;
  //! a - b.
  static Expansion difference(double a, double b) {
    const DoubleDouble d = twoSum(a, -b);
    Expansion e;
    e.grow(d.low);
    e.grow(d.high);
    return e;
  }

  //! Adds one double (Shewchuk's grow-expansion with elimination of zeros).
  void grow(double b) {
    double q = b;
    std::size_t n = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const DoubleDouble s = twoSum(q, component_[i]);
      if (s.low != 0) component_[n++] = s.low;
      q = s.high;
    }
    if (q != 0) component_[n++] = q;
    size_ = n;
  }

  //! Adds factor · a · b.
  template <std::size_t A, std::size_t B>
  void addProduct(const Expansion<A>& a, const Expansion<B>& b, double factor = 1) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        const DoubleDouble p = twoProduct(a[i], b[j]);
        grow(factor * p.low);
        grow(factor * p.high);
      }
    }
  }

  std::size_t size() const { return size_; }
  double operator[](std::size_t i) const { return component_[i]; }
  int sign() const { return size_ == 0 ? 0 : (component_[size_ - 1] > 0 ? 1 : -1); }

 private:
  std::array<double, N> component_;
  std::size_t size_ = 0;
};

}  // namespace handlebody::detail
