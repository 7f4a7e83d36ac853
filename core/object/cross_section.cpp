#include "core/object/cross_section.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/indices.h"
#include "core/object/intensity_shares.h"
#include "core/volume/intensity_statistics.h"

namespace handlebody {

namespace {

constexpr int kBins = 32;                      // of the intensities
constexpr double kInner = 0.25, kOuter = 2.2;  // of the expected radius, where the places lie

std::size_t at(std::size_t angle, std::size_t place) { return angle * CrossSection::kRadii + place; }

}  // namespace

CrossSection CrossSection::across(const Vec3& centre, const Vec3& along, double radius, const Vec3& right) {
  CrossSection s;
  s.centre = centre;
  s.along = along.normalized();
  Vec3 side = right - right.dot(s.along) * s.along;
  if (side.norm() < 0.1) side = s.along.unitOrthogonal();
  s.right = side.normalized();
  s.up = s.along.cross(s.right);
  s.radius = radius;
  return s;
}

const std::array<double, CrossSection::kRadii>& CrossSection::radii() {
  static const auto all = [] {
    std::array<double, kRadii> out{};
    for (std::size_t k = 0; k < kRadii; ++k)
      out[k] = kInner * std::pow(kOuter / kInner, static_cast<double>(k) / (kRadii - 1));
    return out;
  }();
  return all;
}

namespace {

//! What the places of all rays have in common.
struct PlaceTables {
  std::array<double, CrossSection::kRadii> logs, areas;  // of radii; of discs, in parts of the outermost
};
const PlaceTables& placeTables() {
  static const auto all = [] {
    PlaceTables out{};
    for (std::size_t k = 0; k < CrossSection::kRadii; ++k) {
      out.logs[k] = std::log(CrossSection::radii()[k]);
      out.areas[k] = std::pow(CrossSection::radii()[k] / kOuter, 2);
    }
    return out;
  }();
  return all;
}

}  // namespace

Vec3 CrossSection::direction(std::size_t angle) const {
  const double a = 2 * std::numbers::pi * static_cast<double>(angle) / kAngles;
  return std::cos(a) * right + std::sin(a) * up;
}

double CrossSection::radiusBetween(double angle) const {
  const double before = std::floor(angle), part = angle - before;
  const std::size_t n = static_cast<std::size_t>(before) % kAngles;
  return (1 - part) * radiusAt(n) + part * radiusAt((n + 1) % kAngles);
}

double CrossSection::meanRadius() const {
  double sum = 0;
  for (std::size_t a = 0; a < kAngles; ++a) sum += radiusAt(a) * radiusAt(a);
  return std::sqrt(sum / kAngles);
}

Vec3 CrossSection::middle() const {
  Vec3 moment(0, 0, 0);
  double area = 0;
  for (std::size_t a = 0; a < kAngles; ++a) {
    moment += std::pow(radiusAt(a), 3) / 3 * direction(a);
    area += std::pow(radiusAt(a), 2) / 2;
  }
  return centre + moment / area;
}

void CrossSection::takeCircle() {
  const auto end = std::upper_bound(radii().begin(), radii().end(), 1.0);
  last.fill(static_cast<std::size_t>(end - radii().begin()) - 1);
}

void CrossSection::read(const WorkImage& work) {
  const Grid& grid = work.cells().grid;
  for (std::size_t a = 0; a < kAngles; ++a) {
    const Vec3 to = radius * direction(a);
    for (std::size_t k = 0; k < kRadii; ++k) {
      const Vec3 index = grid.toIndex(centre + radii()[k] * to);
      values[at(a, k)] = static_cast<float>(interpolated(grid, work.values, index));
      beyond[at(a, k)] = !grid.contains(index);
    }
  }
}

double CrossSection::fall(std::size_t angle, std::size_t place) const {
  if (place == 0 || place + 1 == kRadii) return 0;
  return (values[at(angle, place - 1)] - values[at(angle, place + 1)]) /
         (radii()[place + 1] - radii()[place - 1]);
}

void CrossSection::takeOutline(const Costs& costs) {
  constexpr std::size_t kRound = 2 * kAngles;  // twice around: the middle of it closes
  std::array<double, kRound * kRadii> sum;
  std::array<std::uint8_t, kRound * kRadii> from;
  for (std::size_t t = 0; t < kRound; ++t)
    for (std::size_t k = 0; k < kRadii; ++k) {
      std::size_t best = k;
      if (t > 0)
        for (const std::size_t j : {k - 1, k + 1})
          if (j < kRadii && sum[at(t - 1, j)] < sum[at(t - 1, best)]) best = j;
      from[at(t, k)] = static_cast<std::uint8_t>(best);
      sum[at(t, k)] = costs[at(t % kAngles, k)] + (t > 0 ? sum[at(t - 1, best)] : 0);
    }
  const auto end = sum.end() - kRadii;
  std::size_t k = static_cast<std::size_t>(std::min_element(end, sum.end()) - end);
  for (std::size_t t = kRound; t-- > kAngles / 2;) {
    if (t < kAngles + kAngles / 2) last[t % kAngles] = k;
    k = from[at(t, k)];
  }
}

TubeLook::TubeLook(const std::vector<CrossSection>& sections, const ObjectPolicy& policy) {
  std::vector<double> all, falls;
  for (const CrossSection& s : sections) all.insert(all.end(), s.values.begin(), s.values.end());
  low_ = quantile(all, 0.01);
  step_ = std::max((quantile(all, 0.99) - low_) / kBins, 1e-12);
  std::vector<double> in(kBins, 0), out(kBins, 0);
  double meanIn = 0, meanOut = 0, allIn = 0, allOut = 0;
  const auto& radii = CrossSection::radii();
  for (const CrossSection& s : sections)
    for (std::size_t a = 0; a < CrossSection::kAngles; ++a)
      for (std::size_t k = 0; k < CrossSection::kRadii; ++k) {
        const double w = radii[k] * radii[k];
        const float v = s.values[at(a, k)];
        falls.push_back(std::abs(s.fall(a, k)));
        if (k <= s.last[a])
          in[binOf(v)] += w, meanIn += w * v, allIn += w;
        else if (radii[k] <= policy.tubeShell * radii[s.last[a]] && !s.beyond[at(a, k)])
          out[binOf(v)] += w, meanOut += w * v, allOut += w;
      }
  const std::vector<double> shareIn = intensityShares(in), shareOut = intensityShares(out);
  for (std::size_t b = 0; b < kBins; ++b) odds_.push_back(std::log(shareOut[b] / shareIn[b]));
  sign_ = allOut > 0 && meanIn / allIn < meanOut / allOut ? -1 : 1;
  strong_ = quantile(std::move(falls), 0.9) + 1e-12;
}

std::size_t TubeLook::binOf(float value) const {
  return idx(std::clamp(static_cast<int>((value - low_) / step_), 0, kBins - 1));
}

double TubeLook::edgeAt(const CrossSection& s, std::size_t angle, std::size_t place) const {
  return sign_ * s.fall(angle, place) / strong_;
}

CrossSection::Costs TubeLook::costs(const CrossSection& s, double keep, const ObjectPolicy& policy) const {
  CrossSection::Costs out;
  const auto& radii = CrossSection::radii();
  const auto& [logs, areas] = placeTables();
  for (std::size_t a = 0; a < CrossSection::kAngles; ++a) {
    double region = 0;
    for (std::size_t k = 0; k < CrossSection::kRadii; ++k) {
      const double odds = s.beyond[at(a, k)] ? policy.starBeyond : odds_[binOf(s.values[at(a, k)])];
      region += odds * 2 * areas[k];
      const double edge = std::clamp(edgeAt(s, a, k), -1.0, 2.0);
      out[at(a, k)] =
          region - policy.tubeEdge * edge * radii[k] + keep * std::pow(logs[k] - s.expected[a], 2);
    }
  }
  return out;
}

double TubeLook::edgeOf(const CrossSection& s) const {
  double sum = 0;
  for (std::size_t a = 0; a < CrossSection::kAngles; ++a)
    sum += std::clamp(edgeAt(s, a, s.last[a]), -1.0, 1.0);
  return sum / CrossSection::kAngles;
}

}  // namespace handlebody
