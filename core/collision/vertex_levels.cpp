#include "core/collision/vertex_levels.h"

#include <algorithm>
#include <cmath>

namespace handlebody {

namespace {

// Room for rounding: relative errors are below 2^-48.
constexpr double kRounding = 1 + 0x1p-40;
// Mean of (largest size / size)² above which one table for all looks at more than levels do: on a surface,
// the number of vertices within the largest reach grows with it. An even mesh is below 3.
constexpr double kUneven = 4;

}  // namespace

double VertexLevels::reachOf(int level) const {
  return std::sqrt(largestSquared_ * kReachSquared) / (1 << level) * kRounding;
}

bool VertexLevels::areWorth(std::span<const double> sizesSquared, double largestSquared) {
  double sum = 0;
  for (const double s : sizesSquared) sum += std::min(largestSquared / s, 1e6);  // a size may be zero
  return sum > kUneven * static_cast<double>(sizesSquared.size());
}

bool LevelPairs::build(std::span<const Vec3> points, std::span<const int> vertices,
                       std::span<const double> sizesSquared, double largestSquared) {
  const VertexLevels levels(largestSquared);
  level_.resize(points.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    level_[vertices[i]] = static_cast<unsigned char>(levels.levelOf(sizesSquared[i]));
  for (int k = 0; k < VertexLevels::kLevels; ++k) {
    own_.clear();
    for (const int v : vertices)
      if (level_[v] == k) own_.push_back(v);
    isUsed_[k] = !own_.empty();
    if (own_.empty()) continue;
    const double reach = levels.reachOf(k);
    if (!(reach > 0)) return false;
    near_.build(points, own_, reach);
    for (const int v : vertices)
      if (level_[v] > k && near_.mayBeNear(points[v])) own_.push_back(v);
    if (!pairs_[k].build(points, own_, reach)) return false;
  }
  return true;
}

void NearLevels::build(std::span<const Vec3> points, std::span<const int> vertices,
                       std::span<const double> sizesSquared, double largestSquared) {
  levels_ = VertexLevels(largestSquared);
  std::array<std::vector<int>, VertexLevels::kLevels> of;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    of[levels_.levelOf(sizesSquared[i])].push_back(vertices[i]);
  std::vector<int> upTo;
  for (int k = VertexLevels::kLevels - 1; k >= 0; --k) {
    const std::vector<int>& own = of[k];
    upTo.insert(upTo.end(), own.begin(), own.end());
    anyOf_[k] = !own.empty();
    anyUpTo_[k] = !upTo.empty();
    if (!own.empty()) of_[k].build(points, own, levels_.reachOf(k));
    if (!upTo.empty()) upTo_[k].build(points, upTo, levels_.reachOf(k));
  }
}

//! With one that is not coarser it is a matter of the point's own reach, with a coarser one of the other's.
bool NearLevels::mayBeNear(const Vec3& p, double sizeSquared) const {
  const int level = levels_.levelOf(sizeSquared);
  if (anyUpTo_[level] && upTo_[level].mayBeNear(p)) return true;
  for (int k = 0; k < level; ++k)
    if (anyOf_[k] && of_[k].mayBeNear(p)) return true;
  return false;
}

}  // namespace handlebody
