#include "core/object/intensity_shares.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <numeric>

namespace handlebody {

namespace {
constexpr std::array<double, 5> kGaussian{0.266, 0.213, 0.110, 0.036, 0.008};  // of 1.5 bins
constexpr double kEmpty = 0.003;  // share of a bin in which nothing is
}  // namespace

std::vector<double> intensityShares(const std::vector<double>& h) {
  std::vector<double> out(h.size(), 0);
  const int n = static_cast<int>(h.size()), reach = static_cast<int>(kGaussian.size()) - 1;
  for (int i = 0; i < n; ++i)
    for (int k = -reach; k <= reach; ++k) out[i] += kGaussian[std::abs(k)] * h[std::clamp(i + k, 0, n - 1)];
  const double sum = std::accumulate(out.begin(), out.end(), 0.0);
  for (double& x : out) x = x / std::max(sum, 1e-12) + kEmpty;
  return out;
}

}  // namespace handlebody
