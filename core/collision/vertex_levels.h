#pragma once
// The broad phase for graded meshes: edges of very different lengths, each met at its own scale.

#include <array>
#include <span>
#include <vector>

#include "core/collision/near_points.h"
#include "core/collision/vertex_pairs.h"

namespace handlebody {

//! Levels of vertices by the octave of their size: level 0 holds those above half the largest size, level 1
//! those above a quarter, and so on; the last one all that is smaller. Two vertices are within reach of each
//! other if they are not farther apart than kReach times the larger size, hence than the reach of the coarser
//! level of the two.
class VertexLevels {
 public:
  static constexpr int kLevels = 4;
  //! Squared: reach in parts of the size. See SeparateFaces for why 7/12.
  static constexpr double kReachSquared = 7.0 / 12.0;

  //! `largestSquared`: of the sizes, mm².
  explicit VertexLevels(double largestSquared = 0) : largestSquared_(largestSquared) {}
  int levelOf(double sizeSquared) const {
    int level = 0;
    for (double bound = largestSquared_ / 4; level + 1 < kLevels && sizeSquared <= bound; bound /= 4) ++level;
    return level;
  }
  //! mm: no two vertices of which the coarser has this level reach farther.
  double reachOf(int level) const;
  //! True if the sizes (squared, mm²) differ so much that levels cost less than one table for all.
  static bool areWorth(std::span<const double> sizesSquared, double largestSquared);

 private:
  double largestSquared_;
};

//! The pairs of vertices within reach of each other, one table per level: of its own vertices and the finer
//! ones near them.
class LevelPairs {
 public:
  void use(BroadPhase phase) {
    for (VertexPairs& p : pairs_) p.use(phase);
  }
  //! `sizesSquared[i]`: mm², of vertices[i]. False as VertexPairs::build. The points must stay as they are
  //! until the last forEachPair.
  bool build(std::span<const Vec3> points, std::span<const int> vertices,
             std::span<const double> sizesSquared, double largestSquared);
  //! Calls f(u, v, squared distance) once for each pair within reach, in either order, and for some others.
  //! Shares as in VertexPairs.
  template <typename F>
  void forEachPair(F&& f, const Share& share = {}) {
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      if (isUsed_[k])
        pairs_[k].forEachPair(
            [&](int u, int v, double d) {
              if (std::min(level_[u], level_[v]) == k) f(u, v, d);
            },
            share);
  }

 private:
  std::array<VertexPairs, VertexLevels::kLevels> pairs_;
  std::array<bool, VertexLevels::kLevels> isUsed_{};
  std::vector<unsigned char> level_;  // per point; of the others it means nothing
  std::vector<int> own_;
  NearPoints near_;
};

//! Which points may be within reach of some of a few.
class NearLevels {
 public:
  //! Of `vertices` (not empty), with sizes as above; sizes of the points that are asked for later are not
  //! above the largest.
  void build(std::span<const Vec3> points, std::span<const int> vertices,
             std::span<const double> sizesSquared, double largestSquared);
  //! True for every point of that size within reach of one of them, and for some others.
  bool mayBeNear(const Vec3& p, double sizeSquared) const;

 private:
  VertexLevels levels_;
  //! At each level: marks of those of that level and all finer ones, and of those of that level alone.
  std::array<NearPoints, VertexLevels::kLevels> upTo_, of_;
  std::array<bool, VertexLevels::kLevels> anyUpTo_{}, anyOf_{};
};

}  // namespace handlebody
