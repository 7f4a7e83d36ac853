#include "sample_volumes/curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handlebody::phantoms {

namespace {
constexpr double kTurn = 2 * std::numbers::pi;
}

CurveDistance::CurveDistance(const ClosedCurve& curve) : curve_(curve) {
  for (std::size_t i = 0; i < kSamples; ++i)
    points_[i] = curve.point(kTurn * static_cast<double>(i) / kSamples);
  for (std::size_t i = 0; i < kSamples; ++i)
    spacing_ = std::max(spacing_, (points_[(i + 1) % kSamples] - points_[i]).norm());
}

// The root of (c(t) - p)·c'(t) between the neighbours of a sample that is nearer than both; a step of
// Newton's that leaves the bracket is replaced by halving it.
double CurveDistance::footDistance(const Vec3& p, std::size_t sample) const {
  const double middle = kTurn * static_cast<double>(sample) / kSamples;
  double low = middle - kTurn / kSamples, high = middle + kTurn / kSamples, t = middle;
  for (int turn = 0; turn < 60; ++turn) {
    const Vec3 away = curve_.point(t) - p, along = curve_.first(t);
    const double slope = away.dot(along), bend = along.squaredNorm() + away.dot(curve_.second(t));
    (slope > 0 ? high : low) = t;
    double next = t - slope / bend;
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (std::abs(next - t) * along.norm() < 1e-9) return away.norm();
    t = next;
  }
  return (curve_.point(t) - p).norm();
}

double CurveDistance::operator()(const Vec3& p) const {
  std::array<double, kSamples> squared;
  for (std::size_t i = 0; i < kSamples; ++i) squared[i] = (points_[i] - p).squaredNorm();
  double nearest = std::sqrt(*std::min_element(squared.begin(), squared.end()));
  // A strand whose best sample is a little farther away may still be the nearest strand.
  const double reach = (nearest + spacing_) * (nearest + spacing_);
  for (std::size_t i = 0; i < kSamples; ++i)
    if (squared[i] < reach && squared[i] <= squared[(i + 1) % kSamples] &&
        squared[i] < squared[(i + kSamples - 1) % kSamples])
      nearest = std::min(nearest, footDistance(p, i));
  return nearest;
}

double implicitDistance(SmoothFunction function, const Vec3& p, double band) {
  constexpr double kPrecise = 1e-7;  // mm
  Vec3 gradient;
  double value = function(p, &gradient);
  const double estimate = value / std::max(gradient.norm(), 1e-2);  // 1e-2 per mm: met near centres only
  if (std::abs(estimate) > band) return estimate;
  Vec3 foot = p;
  for (int turn = 0; turn < 60; ++turn) {
    const Vec3 better = p - gradient * ((value + gradient.dot(p - foot)) / gradient.squaredNorm());
    const double moved = (better - foot).norm();
    foot = better;
    if (moved < kPrecise) return std::copysign((p - foot).norm(), estimate);
    value = function(foot, &gradient);
  }
  return estimate;
}

}  // namespace handlebody::phantoms
