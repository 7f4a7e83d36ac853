#include "core/object/distance.h"
#include "core/indices.h"
#include "core/threads.h"

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
  explicit Envelope(int n = 0) : f_(idx(n)), result_(idx(n)), apex_(idx(n)), from_(idx(n) + 1) {}
  std::vector<float>& values() { return f_; }

  //! Where f is 0 the envelope is 0, too, and no parabola is the lowest beyond it: what lies between two such
  //! places is done by itself.
  void run(double h) {
    const int n = static_cast<int>(f_.size());
    for (int first = 0, zero = -1; first < n; ++first) {
      if (f_[first] == 0) {
        zero = first;
        continue;
      }
      int end = first;
      while (end < n && f_[end] != 0) ++end;
      if (zero >= 0 && end < n && end - first == 1)
        f_[first] = std::min(f_[first], static_cast<float>(h * h));
      else
        runWithin(std::max(0, zero), std::min(end, n - 1), h);
      first = zero = end;
    }
  }

 private:
  //! Both ends included; places where f is 0 lie nowhere between them.
  void runWithin(int first, int last, double h) {
    int k = -1;
    for (int q = first; q <= last; ++q) {
      if (f_[q] == kInfinity) continue;
      double s = -std::numeric_limits<double>::infinity();
      while (k >= 0) {
        s = crossing(apex_[k], q, h);
        if (s > from_[k]) break;
        --k;
      }
      if (k < 0) s = -std::numeric_limits<double>::infinity();
      apex_[++k] = q;
      from_[k] = s;
    }
    if (k < 0) return;
    for (int x = first, j = 0; x <= last; ++x) {
      while (j < k && from_[j + 1] < x) ++j;
      const double d = h * (x - apex_[j]);
      result_[x] = static_cast<float>(d * d) + f_[apex_[j]];
    }
    std::copy(result_.begin() + first, result_.begin() + last + 1, f_.begin() + first);
  }

  double crossing(int a, int b, double h) const {
    const double fa = f_[a], fb = f_[b];
    return ((fb - fa) / (h * h) + static_cast<double>(b) * b - static_cast<double>(a) * a) / (2.0 * (b - a));
  }
  std::vector<float> f_, result_;
  std::vector<int> apex_;
  std::vector<double> from_;
};

// Below this many values a thread costs more than it saves.
constexpr std::size_t kValuesPerThread = 100'000;
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

//! The least and the largest value of each of some lines beside each other.
struct Extremes {
  std::array<float, kTogether> least, most;
};
Extremes extremesOf(const float* at, int n, std::size_t step, std::size_t some) {
  Extremes out;
  out.least.fill(kInfinity);
  out.most.fill(0);
  for (int i = 0; i < n; ++i)
    for (std::size_t k = 0; k < some; ++k) {
      const float value = at[k + idx(i) * step];
      out.least[k] = std::min(out.least[k], value);
      out.most[k] = std::max(out.most[k], value);
    }
  return out;
}

//! What is larger than this counts no more.
void forget(std::vector<float>& d, float most) {
  for (float& x : d) x = x > most ? kInfinity : x;
}

//! Along another axis; `step` values lie between neighbours. Lines in which all is 0 or nothing counts stay.
void alongLines(std::vector<float>& d, int n, std::size_t step, double h, int threads) {
  const std::size_t across = (step + kTogether - 1) / kTogether, all = d.size() / (step * idx(n)) * across;
  forRangesOnThreads(
      all, threads, kValuesPerThread / (idx(n) * kTogether) + 1, [&](std::size_t from, std::size_t to) {
        Envelope line(n);
        for (std::size_t bundle = from; bundle < to; ++bundle) {
          const std::size_t first = bundle % across * kTogether, some = std::min(kTogether, step - first);
          float* const at = &d[bundle / across * step * idx(n) + first];
          const Extremes lines = extremesOf(at, n, step, some);
          for (std::size_t k = 0; k < some; ++k) {
            if (lines.most[k] == 0 || lines.least[k] == kInfinity) continue;
            for (int i = 0; i < n; ++i) line.values()[i] = at[k + idx(i) * step];
            line.run(h);
            for (int i = 0; i < n; ++i) at[k + idx(i) * step] = line.values()[i];
          }
        }
      });
}

//! The same where only distances up to `reach` steps count: rows of memory, beside each other in the plane of
//! the axis, are compared as they are.
void alongLinesWithin(std::vector<float>& d, int n, std::size_t step, std::size_t row, double h, int reach) {
  std::vector<float> lines(idx(n) * row);
  for (std::size_t slab = 0; slab < d.size(); slab += step * idx(n))
    for (std::size_t j = slab; j < slab + step; j += row) {
      for (int i = 0; i < n; ++i) std::copy_n(&d[j + idx(i) * step], row, &lines[idx(i) * row]);
      for (int i = 0; i < n; ++i) {
        float* to = &d[j + idx(i) * step];
        for (int k = -std::min(reach, i); k <= std::min(reach, n - 1 - i); ++k) {
          const float* from = &lines[idx(i + k) * row];
          const auto far = static_cast<float>(h * k * (h * k));
          for (std::size_t x = 0; x < row; ++x) to[x] = std::min(to[x], from[x] + far);
        }
      }
    }
}

constexpr double kRounding = 1e-5;  // of a squared limit: more than squares are rounded by
constexpr int kFewSteps = 16;       // up to here comparing takes less than the envelope

std::vector<float> squaredDistanceTo(const std::array<int, 3>& size, const Vec3& spacing,
                                     const std::vector<std::uint8_t>& mask, double limit, int threads) {
  std::vector<float> d(mask.size());
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = mask[i] ? 0 : kInfinity;
  alongRows(d, size[0], spacing[0]);
  std::size_t step = idx(size[0]);
  const auto most = static_cast<float>(limit * limit * (1 + kRounding));
  for (std::size_t a = 1; a < 3; ++a) {
    const double h = spacing[static_cast<Eigen::Index>(a)];
    if (limit <= kFewSteps * h)
      alongLinesWithin(d, size[a], step, idx(size[0]), h, static_cast<int>(std::ceil(limit / h)));
    else {
      if (most < kInfinity) forget(d, most);
      alongLines(d, size[a], step, h, threads);
    }
    step *= idx(size[a]);
  }
  return d;
}

}  // namespace

std::vector<float> distanceTo(const std::array<int, 3>& size, const Vec3& spacing,
                              const std::vector<std::uint8_t>& mask, double limit, int threads) {
  std::vector<float> d = squaredDistanceTo(size, spacing, mask, limit, threads);
  for (float& x : d) x = std::sqrt(x);
  return d;
}

double greatestDistanceTo(const std::array<int, 3>& size, const Vec3& spacing,
                          const std::vector<std::uint8_t>& mask) {
  float most = 0;
  for (const float d : squaredDistanceTo(size, spacing, mask, kInfinity, 1))
    if (d < kInfinity) most = std::max(most, d);
  return static_cast<double>(std::sqrt(most));
}

}  // namespace handlebody
