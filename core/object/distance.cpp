#include "core/object/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handlebody {

namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }
constexpr float kInfinity = std::numeric_limits<float>::infinity();

//! Lower envelope of the parabolas f(q) + (h (x - q))².
class Envelope {
 public:
  explicit Envelope(int n) : f_(idx(n)), apex_(idx(n)), from_(idx(n) + 1) {}
  std::vector<float>& values() { return f_; }

  void run(double h) {
    int k = -1;
    for (int q = 0; q < static_cast<int>(f_.size()); ++q) {
      if (f_[idx(q)] == kInfinity) continue;
      double s = -std::numeric_limits<double>::infinity();
      while (k >= 0) {
        s = crossing(apex_[idx(k)], q, h);
        if (s > from_[idx(k)]) break;
        --k;
      }
      if (k < 0) s = -std::numeric_limits<double>::infinity();
      apex_[idx(++k)] = q;
      from_[idx(k)] = s;
    }
    if (k < 0) return;
    result_.resize(f_.size());
    for (int x = 0, j = 0; x < static_cast<int>(f_.size()); ++x) {
      while (j < k && from_[idx(j + 1)] < x) ++j;
      const double d = h * (x - apex_[idx(j)]);
      result_[idx(x)] = static_cast<float>(d * d) + f_[idx(apex_[idx(j)])];
    }
    f_.swap(result_);
  }

 private:
  double crossing(int a, int b, double h) const {
    const double fa = f_[idx(a)], fb = f_[idx(b)];
    return ((fb - fa) / (h * h) + static_cast<double>(b) * b - static_cast<double>(a) * a) / (2.0 * (b - a));
  }
  std::vector<float> f_, result_;
  std::vector<int> apex_;
  std::vector<double> from_;
};

}  // namespace

std::vector<float> distanceTo(const std::array<int, 3>& size, const Vec3& spacing,
                              const std::vector<std::uint8_t>& mask) {
  std::vector<float> d(mask.size());
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = mask[i] ? 0 : kInfinity;
  std::size_t step = 1;
  for (int a = 0; a < 3; ++a) {
    const int n = size[idx(a)];
    Envelope line(n);
    const std::size_t slab = step * idx(n);
    for (std::size_t from = 0; from < d.size(); from += slab)
      for (std::size_t j = from; j < from + step; ++j) {
        auto& f = line.values();
        f.resize(idx(n));
        for (int i = 0; i < n; ++i) f[idx(i)] = d[j + idx(i) * step];
        line.run(spacing[a]);
        for (int i = 0; i < n; ++i) d[j + idx(i) * step] = line.values()[idx(i)];
      }
    step = slab;
  }
  for (float& x : d) x = std::sqrt(x);
  return d;
}

}  // namespace handlebody
