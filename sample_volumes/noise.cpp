#include "sample_volumes/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handlebody::phantoms {
namespace {

// The output function of SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t scramble(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

// In (0, 1], so that its logarithm is finite.
double unitInterval(std::uint64_t bits) { return (static_cast<double>(bits >> 11) + 1) * 0x1p-53; }

// Sampled Gaussian with sum of squares 1: white noise keeps its variance.
std::vector<float> gaussianKernel(double sigmaVoxels) {
  const int radius = static_cast<int>(std::ceil(3 * sigmaVoxels));
  std::vector<double> weights;
  double squares = 0;
  for (int i = -radius; i <= radius; ++i) {
    weights.push_back(std::exp(-0.5 * i * i / (sigmaVoxels * sigmaVoxels)));
    squares += weights.back() * weights.back();
  }
  std::vector<float> kernel;
  for (double w : weights) kernel.push_back(static_cast<float>(w / std::sqrt(squares)));
  return kernel;
}

// Periodic convolution along one axis, row by row of the faster axes.
void convolve(std::vector<float>& field, std::vector<float>& scratch, const Grid& grid, std::size_t axis,
              const std::vector<float>& kernel) {
  const int n = grid.size[axis];
  std::size_t row = 1;
  for (std::size_t a = 0; a < axis; ++a) row *= static_cast<std::size_t>(grid.size[a]);
  const std::size_t block = row * static_cast<std::size_t>(n);
  const int radius = static_cast<int>(kernel.size() / 2);
  std::fill(scratch.begin(), scratch.end(), 0.0F);
  for (std::size_t start = 0; start < field.size(); start += block)
    for (int i = 0; i < n; ++i) {
      float* out = scratch.data() + start + static_cast<std::size_t>(i) * row;
      for (int j = -radius; j <= radius; ++j) {
        const int from = ((i + j) % n + n) % n;
        const float weight = kernel[j + radius];
        const float* in = field.data() + start + static_cast<std::size_t>(from) * row;
        for (std::size_t k = 0; k < row; ++k) out[k] += weight * in[k];
      }
    }
  field.swap(scratch);
}

}  // namespace

std::pair<double, double> normalPair(std::uint64_t seed, std::uint64_t counter) {
  const std::uint64_t key = scramble(scramble(seed) ^ counter);
  const double radius = std::sqrt(-2 * std::log(unitInterval(key)));
  const double angle = 2 * std::numbers::pi * unitInterval(scramble(key));
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

std::vector<float> speckleEnvelope(const Grid& grid, const Vec3& spread, std::uint64_t seed) {
  const std::size_t count = grid.voxelCount();
  std::vector<float> real(count), imaginary(count), scratch(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [x, y] = normalPair(seed, i);
    real[i] = static_cast<float>(x);
    imaginary[i] = static_cast<float>(y);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<float> kernel =
        gaussianKernel(spread[static_cast<int>(axis)] / grid.spacing[static_cast<int>(axis)]);
    convolve(real, scratch, grid, axis, kernel);
    convolve(imaginary, scratch, grid, axis, kernel);
  }
  for (std::size_t i = 0; i < count; ++i)
    real[i] = std::sqrt((real[i] * real[i] + imaginary[i] * imaginary[i]) / 2);
  return real;
}

double compressedSpeckle(double envelope) {
  // ln(A²) of a Rayleigh amplitude has mean -γ (Euler's constant) and variance π²/6.
  const double logIntensity = 2 * std::log(std::max(envelope, 1e-6));
  return (logIntensity + std::numbers::egamma) * std::sqrt(6.0) / std::numbers::pi;
}

}  // namespace handlebody::phantoms
