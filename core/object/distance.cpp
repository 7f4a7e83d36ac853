#include "core/object/distance.h"
#include "core/indices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace handlebody {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

//! Lower envelope of the parabolas f(q) + (h (x - q))².
class Envelope {
 public:
  explicit Envelope(int n = 0) : f_(idx(n)), apex_(idx(n)), from_(idx(n) + 1) {}
  std::vector<float>& values() { return f_; }

  void run(double h) {
    if (std::none_of(f_.begin(), f_.end(), [](float x) { return x > 0; })) return;
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

constexpr std::size_t kTogether = 16;  // lines: a cache line of each is read at once

//! Along the first axis there are only steps to count.
void alongRows(std::vector<float>& d, int n, double h) {
  for (std::size_t row = 0; row < d.size(); row += idx(n)) {
    float* f = &d[row];
    int last = -1;
    for (int i = 0; i < n; ++i) {
      if (f[i] == 0)
        last = i;
      else if (last >= 0)
        f[i] = static_cast<float>((i - last) * h * ((i - last) * h));
    }
    for (int i = last - 1; i >= 0; --i) {
      if (f[i] == 0)
        last = i;
      else
        f[i] = std::min(f[i], static_cast<float>((last - i) * h * ((last - i) * h)));
    }
  }
}

//! Along another axis; `step` values lie between neighbours.
void alongLines(std::vector<float>& d, int n, std::size_t step, double h) {
  std::array<Envelope, kTogether> lines;
  for (Envelope& e : lines) e = Envelope(n);
  for (std::size_t slab = 0; slab < d.size(); slab += step * idx(n))
    for (std::size_t j = slab; j < slab + step; j += kTogether) {
      const std::size_t some = std::min(kTogether, slab + step - j);
      for (int i = 0; i < n; ++i)
        for (std::size_t k = 0; k < some; ++k) lines[k].values()[idx(i)] = d[j + k + idx(i) * step];
      for (std::size_t k = 0; k < some; ++k) lines[k].run(h);
      for (int i = 0; i < n; ++i)
        for (std::size_t k = 0; k < some; ++k) d[j + k + idx(i) * step] = lines[k].values()[idx(i)];
    }
}

}  // namespace

std::vector<float> distanceTo(const std::array<int, 3>& size, const Vec3& spacing,
                              const std::vector<std::uint8_t>& mask) {
  std::vector<float> d(mask.size());
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = mask[i] ? 0 : kInfinity;
  alongRows(d, size[0], spacing[0]);
  alongLines(d, size[1], idx(size[0]), spacing[1]);
  alongLines(d, size[2], idx(size[0]) * idx(size[1]), spacing[2]);
  for (float& x : d) x = std::sqrt(x);
  return d;
}

}  // namespace handlebody
