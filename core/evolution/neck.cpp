#include "core/evolution/neck.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/evolution/thickness_map.h"
#include "core/evolution/wide_runs.h"
#include "core/indices.h"

namespace handlebody {

namespace {

using Voxel = ObjectRegion::Voxel;

struct Rule {
  double narrow;  // radius of the neck / radius of the seeded structure, at most
  double wider;   // radius of the widest ball behind / radius of the seeded structure, at least
  double larger;  // volume behind / volume before, at least
};
// A neck far narrower than the seeded structure that leads to something thicker and several times larger.
constexpr Rule kNecks[] = {{0.6, 2, 4}, {0.6, 1, 20}};
// An opening that hardly narrows but leads to something of quite another size.
constexpr Rule kOpening = {0.95, 4, 500};
// At such an opening the structure ends where it grows this many times wider than it is at the seeds; it goes
// on where it is at least this part as wide.
constexpr double kWidens = 1.3, kNarrows = 0.6;
// What is cut off at an opening is this many times what is kept, at least.
constexpr double kMuchLarger = 20;

// Both sides of a hole in a wall are this many times as wide as the hole, and so is what would be there
// without the wall.
constexpr double kHoleWidens = 3;
// What is cut off at a hole is this part of what is kept, at least: less may be a pocket in the object.
constexpr double kBehindHole = 0.2;

// Necks of one width may lead to several parts. Those of which a ball has more than this part of the radius
// of the widest are cut off, thinner ones hang on the structure as crumbs. Less than 1: of parts that are
// equally wide the grid makes one a fraction of a voxel wider.
constexpr float kAsWide = 0.9f;

constexpr int kBinsPerVoxel = 4;

//! The thickest place within the largest ball around the seed.
std::size_t thickestNear(const Grid& grid, const ThicknessMap& map, std::size_t seed) {
  const Voxel v = map.voxel(seed);
  const double radius = map.distance(seed);
  std::array<int, 3> reach;
  for (std::size_t a = 0; a < 3; ++a)
    reach[a] = std::max(1, static_cast<int>(radius / grid.spacing[static_cast<int>(a)]));
  std::size_t best = seed;
  for (int dz = -reach[2]; dz <= reach[2]; ++dz)
    for (int dy = -reach[1]; dy <= reach[1]; ++dy)
      for (int dx = -reach[0]; dx <= reach[0]; ++dx) {
        const Voxel w{v[0] + dx, v[1] + dy, v[2] + dz};
        if (!map.contains(w) || map.distance(map.at(w)) <= map.distance(best)) continue;
        if (Vec3(dx, dy, dz).cwiseProduct(grid.spacing).norm() <= radius) best = map.at(w);
      }
  return best;
}

//! A step of the flood that goes into thick places first.
struct Stage {
  double neck;              // mm: all that was taken so far is reached through necks at least this wide
  std::size_t first, last;  // range in the order of taking
  float widest;             // mm, of the voxels taken in this stage
  std::size_t widestAt;     // in the order of taking
};

//! In few bytes a voxel, for there may be many millions.
struct WidestPathFlood {
  using Index = std::uint32_t;
  using StageNumber = std::uint16_t;
  std::vector<Index> order;   // voxels of the box as taken
  std::vector<Index> from;    // for each of them: where in the order the one lies that it was reached from
  std::vector<Stage> stages;  // narrower and narrower necks
  std::vector<StageNumber> stageOf;  // of each voxel of the box; kUnreached, kWaits

  static constexpr Index kNone = std::numeric_limits<Index>::max();
  static constexpr StageNumber kUnreached = std::numeric_limits<StageNumber>::max(), kWaits = kUnreached - 1;
  //! The voxel through which a stage came to its widest place.
  std::size_t passage(const Stage& stage) const {
    std::size_t i = stage.widestAt;
    while (from[i] != kNone && from[i] >= stage.first) i = from[i];
    return order[i];
  }
};

WidestPathFlood floodThickFirst(const ThicknessMap& map, const std::vector<std::size_t>& starts, double bin) {
  float highest = 0;
  for (std::size_t s : starts) highest = std::max(highest, map.distance(s));
  const int bins = std::min(static_cast<int>(highest / bin) + 1, int{WidestPathFlood::kWaits});
  using Index = WidestPathFlood::Index;
  struct Waiting {
    Index voxel, from;
  };
  std::vector<std::vector<Waiting>> queue(bins);
  WidestPathFlood flood;
  flood.stageOf.assign(map.count(), WidestPathFlood::kUnreached);
  int now = bins - 1;
  const auto push = [&](std::size_t i, Index from) {
    if (flood.stageOf[i] != WidestPathFlood::kUnreached || map.distance(i) == 0) return;
    flood.stageOf[i] = WidestPathFlood::kWaits;
    queue[std::min(now, static_cast<int>(map.distance(i) / bin))].push_back({static_cast<Index>(i), from});
  };
  for (std::size_t s : starts) push(s, WidestPathFlood::kNone);
  for (; now >= 0; --now) {
    Stage stage{now * bin, flood.order.size(), 0, 0, flood.order.size()};
    for (std::size_t next = 0; next < queue[now].size(); ++next) {
      const Waiting taken = queue[now][next];
      const auto rank = static_cast<Index>(flood.order.size());
      flood.order.push_back(taken.voxel);
      flood.from.push_back(taken.from);
      flood.stageOf[taken.voxel] = static_cast<WidestPathFlood::StageNumber>(flood.stages.size());
      if (map.distance(taken.voxel) > stage.widest) {
        stage.widest = map.distance(taken.voxel);
        stage.widestAt = rank;
      }
      map.forEachFaceNeighbour(taken.voxel, [&](std::size_t i) { push(i, rank); });
    }
    queue[now] = {};
    stage.last = flood.order.size();
    flood.stages.push_back(stage);
  }
  return flood;
}

bool shows(const Rule& rule, const Stage& stage, double structure) {
  const auto before = static_cast<double>(stage.first), more = static_cast<double>(stage.last - stage.first);
  return stage.first > 0 && stage.neck <= rule.narrow * structure && more >= rule.larger * before &&
         stage.widest >= rule.wider * structure;
}

//! Of a passage, per voxel: `outside` is no part of the region, `open` not decided yet.
enum class Side : std::uint8_t { outside, kept, cutOff, open };
using Sides = std::vector<Side>;

//! The side of the seeds: what a ball of the neck's radius covers without passing the neck, and all crumbs
//! that hang on it alone.
Sides splitAt(const ThicknessMap& map, const WidestPathFlood& flood, const Stage& stage) {
  VoxelMarks core(map.count(), 0);
  for (std::size_t i = 0; i < stage.first; ++i) core[flood.order[i]] = 1;
  const std::vector<float> fromCore = map.distanceTo(core);
  Sides side(map.count(), Side::outside);
  std::vector<std::size_t> front;
  for (std::size_t i : flood.order) side[i] = fromCore[i] <= stage.neck ? Side::kept : Side::open;
  for (std::size_t k = stage.first; k < stage.last; ++k) {
    const std::size_t i = flood.order[k];
    if (side[i] == Side::open && map.distance(i) > kAsWide * stage.widest) {
      side[i] = Side::cutOff;
      front.push_back(i);
    }
  }
  while (!front.empty()) {
    const std::size_t i = front.back();
    front.pop_back();
    map.forEachFaceNeighbour(i, [&](std::size_t w) {
      if (side[w] != Side::open) return;
      side[w] = Side::cutOff;
      front.push_back(w);
    });
  }
  std::replace(side.begin(), side.end(), Side::open, Side::kept);
  return side;
}

//! 1 for the voxels that `chosen` picks.
template <typename F>
VoxelMarks marksOf(const ThicknessMap& map, F&& chosen) {
  VoxelMarks marks(map.count());
  for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = chosen(i);
  return marks;
}

//! Everything that `from` reaches by faces over voxels that `open` says are open; marks it 1.
template <typename F>
VoxelMarks reachedFrom(const ThicknessMap& map, std::vector<std::size_t> from, F&& open) {
  VoxelMarks reached(map.count(), 0);
  const auto enter = [&](std::size_t i) {
    if (reached[i] || !open(i)) return false;
    reached[i] = 1;
    return true;
  };
  std::erase_if(from, [&](std::size_t i) { return !enter(i); });
  while (!from.empty()) {
    const std::size_t i = from.back();
    from.pop_back();
    map.forEachFaceNeighbour(i, [&](std::size_t w) {
      if (enter(w)) from.push_back(w);
    });
  }
  return reached;
}

//! The side of the seeds where no neck shows: what balls about as wide as the seeded structure reach without
//! entering the wide part, and all crumbs that do not touch the wide part.
Sides splitByWidth(const ThicknessMap& map, const std::vector<std::size_t>& starts, double structure) {
  const double widest = kWidens * structure, narrowest = kNarrows * structure;
  const auto wide = map.coveredByBalls(marksOf(map, [&](std::size_t i) { return map.distance(i) > widest; }));
  const auto near = map.coveredByBalls(
      reachedFrom(map, starts, [&](std::size_t i) { return !wide[i] && map.distance(i) >= narrowest; }));
  // What is in neither is cut off together with the wide part that it touches.
  std::vector<std::size_t> rim;
  for (std::size_t i = 0; i < wide.size(); ++i)
    if (wide[i]) map.forEachFaceNeighbour(i, [&](std::size_t w) { rim.push_back(w); });
  const auto beside = reachedFrom(map, std::move(rim),
                                  [&](std::size_t i) { return map.distance(i) > 0 && !wide[i] && !near[i]; });
  Sides side(map.count(), Side::outside);
  for (std::size_t i = 0; i < side.size(); ++i)
    if (map.distance(i) > 0) side[i] = wide[i] || beside[i] ? Side::cutOff : Side::kept;
  return side;
}

//! Distance (mm) to the wide part of a side: what balls of `wide` mm around its voxels cover.
std::vector<float> distanceToWide(const ThicknessMap& map, const Sides& side, Side which, double wide) {
  return map.distanceTo(map.coveredByBalls(marksOf(
      map, [&](std::size_t i) { return side[i] == which && static_cast<double>(map.distance(i)) >= wide; })));
}

//! The largest balls (radius in mm) that fit into the region and the thin walls between its two sides: walls
//! no thicker than `neck` is wide, and than the voxel that the smoothing adds or takes away.
std::vector<float> ballsWithoutWall(const ThicknessMap& map, const Sides& side, double neck, double voxel) {
  const auto toKept = distanceToWide(map, side, Side::kept, kHoleWidens * neck);
  const auto toCut = distanceToWide(map, side, Side::cutOff, kHoleWidens * neck);
  // Both distances are measured to centres of voxels: across a wall of one voxel they add up to two.
  const double thickest = 2 * neck + 2 * voxel;
  return map.distanceTo(marksOf(map, [&](std::size_t i) {
    const bool isWall = static_cast<double>(toKept[i] + toCut[i]) <= thickest;
    return side[i] == Side::outside && !isWall && map.isInVolume(i);
  }));
}

//! True if the two sides meet in holes of a wall and nowhere else.
bool meetInHoles(const ThicknessMap& map, const Sides& side, double neck, double voxel) {
  std::vector<float> balls = ballsWithoutWall(map, side, neck, voxel);
  for (float& radius : balls)
    if (static_cast<double>(radius) < kHoleWidens * neck) radius = 0;
  const VoxelMarks wide = map.coveredByBalls(balls);
  for (std::size_t i = 0; i < side.size(); ++i) {
    if (side[i] != Side::kept || wide[i]) continue;
    bool meets = false;
    map.forEachFaceNeighbour(i, [&](std::size_t w) { meets = meets || side[w] == Side::cutOff; });
    if (meets) return false;
  }
  return true;
}

std::shared_ptr<const Barrier> barrierOf(const ThicknessMap& map, const Sides& side) {
  VoxelMarks closed(side.size());
  for (std::size_t i = 0; i < side.size(); ++i) closed[i] = side[i] == Side::cutOff;
  return std::make_shared<Barrier>(map.low(), map.size(), closed);
}

class NeckSearch {
 public:
  NeckSearch(const Grid& grid, const ObjectRegion& region, const std::vector<Vec3>& seeds)
      : grid_(grid), region_(region), map_(grid, region) {
    for (const Vec3& s : seeds) {
      const Voxel v{static_cast<int>(std::lround(s[0])), static_cast<int>(std::lround(s[1])),
                    static_cast<int>(std::lround(s[2]))};
      if (!map_.contains(v)) continue;
      seeds_.push_back(map_.at(v));
      starts_.push_back(thickestNear(grid, map_, seeds_.back()));
      structure_ = std::min(structure_, static_cast<double>(map_.distance(starts_.back())));
    }
  }

  std::optional<NeckCut> run(Passages which) const {
    if (starts_.empty() || structure_ <= 0 || map_.count() >= WidestPathFlood::kNone) return {};
    if (which == Passages::holes && surelyNoHole()) return {};
    const WidestPathFlood flood = floodThickFirst(map_, starts_, grid_.meanSpacing() / kBinsPerVoxel);
    std::optional<NeckCut> cut;
    if (which != Passages::holes) cut = cutAtNeck(flood);
    if (!cut && which != Passages::necks) cut = cutAtHole(flood);
    return cut;
  }

 private:
  std::optional<NeckCut> cutAtNeck(const WidestPathFlood& flood) const {
    for (const Rule& rule : kNecks)
      for (const Stage& stage : flood.stages)
        if (shows(rule, stage, structure_))
          if (auto cut = cutAt(stage, splitAt(map_, flood, stage), rule.larger)) return cut;
    const auto opening = std::find_if(flood.stages.begin(), flood.stages.end(),
                                      [&](const Stage& s) { return shows(kOpening, s, structure_); });
    if (opening == flood.stages.end()) return {};
    auto cut = cutAt(*opening, splitByWidth(map_, starts_, structure_), kMuchLarger);
    if (cut) {
      cut->widens = true;
      cut->neckRadius = kWidens * structure_;
    }
    return cut;
  }

  //! True if no stage of the flood may be a hole, in a fraction of its time. A hole of j bins (its neck) lies
  //! before places 3 j bins wide that no path wider than j + 1 bins leads to from the starts. There are none
  //! if all that is wider than m + 1/2 bins hangs together with a start, for a number m from j + 1 to 3 j -
  //! 1; half a bin, so that rounding decides nothing. Holes that are so wide that the seeded structure is not
  //! three times as wide do not count.
  bool surelyNoHole() const {
    static_assert(kHoleWidens == 3);
    const double bin = grid_.meanSpacing() / kBinsPerVoxel;
    if (grid_.spacing.minCoeff() < bin) return false;  // a hole of no bin at all
    const std::vector<std::uint32_t> starts(starts_.begin(), starts_.end());
    WideRuns wide(map_.size(), map_.distances(), Touching::faces);
    for (double m = 2; (m + 0.5) * bin <= structure_; m = 3 * m - 1)
      if (!wide.allHold(starts, (m + 0.5) * bin)) return false;
    return true;
  }

  std::optional<NeckCut> cutAtHole(const WidestPathFlood& flood) const {
    const double voxel = grid_.meanSpacing();
    for (std::size_t number = 0; number < flood.stages.size(); ++number) {
      const Stage& stage = flood.stages[number];
      if (!mayBeHole(stage) || !isBetweenWideParts(flood, number)) continue;
      const Sides side = splitAt(map_, flood, stage);
      if (!meetInHoles(map_, side, stage.neck, voxel)) continue;
      auto cut = cutAt(stage, side, kBehindHole);
      if (!cut) continue;
      cut->hole = true;
      return cut;
    }
    return {};
  }

  //! A cheap test that every hole passes: wide parts of both sides lie close to it.
  bool isBetweenWideParts(const WidestPathFlood& flood, std::size_t number) const {
    const Stage& stage = flood.stages[number];
    const double wide = kHoleWidens * stage.neck, thickest = 2 * stage.neck + 2 * grid_.meanSpacing();
    const Vec3 reach = Vec3::Constant(wide + thickest).cwiseQuotient(grid_.spacing);
    const Voxel middle = map_.voxel(flood.passage(stage));
    bool before = false, behind = false;
    for (int z = -static_cast<int>(reach[2]); z <= reach[2]; ++z)
      for (int y = -static_cast<int>(reach[1]); y <= reach[1]; ++y)
        for (int x = -static_cast<int>(reach[0]); x <= reach[0]; ++x) {
          const Voxel v{middle[0] + x, middle[1] + y, middle[2] + z};
          if (!map_.contains(v) || static_cast<double>(map_.distance(map_.at(v))) < wide) continue;
          const std::size_t taken = flood.stageOf[map_.at(v)];
          before = before || taken < number;
          behind = behind || taken == number;
        }
    return before && behind;
  }

  bool mayBeHole(const Stage& stage) const {
    const double wide = kHoleWidens * stage.neck;
    const auto before = static_cast<double>(stage.first),
               more = static_cast<double>(stage.last - stage.first);
    return stage.first > 0 && structure_ >= wide && stage.widest >= wide && more >= kBehindHole * before;
  }
  //! None if a seed is cut off, or too little is.
  std::optional<NeckCut> cutAt(const Stage& stage, const Sides& side, double larger) const {
    const auto kept = static_cast<double>(std::count(side.begin(), side.end(), Side::kept));
    const auto cut = static_cast<double>(std::count(side.begin(), side.end(), Side::cutOff));
    const bool seedCut =
        std::any_of(seeds_.begin(), seeds_.end(), [&](std::size_t i) { return side[i] == Side::cutOff; });
    if (seedCut || cut < larger * kept) return {};
    NeckCut out;
    out.neckRadius = stage.neck;
    out.structureRadius = structure_;
    out.widestBehind = stage.widest;
    out.keptVolume = kept * grid_.voxelVolume();
    out.cutVolume = cut * grid_.voxelVolume();
    for (const Voxel& v : region_.voxels) out.kept.push_back(side[map_.at(v)] == Side::kept);
    out.barrier = barrierOf(map_, side);
    return out;
  }

  const Grid& grid_;
  const ObjectRegion& region_;
  ThicknessMap map_;
  std::vector<std::size_t> seeds_, starts_;                // voxels; the thickest places near them
  double structure_ = std::numeric_limits<double>::max();  // mm: of the thinnest start
};

}  // namespace

Barrier::Barrier(const std::array<int, 3>& low, const std::array<int, 3>& size, const VoxelMarks& closed)
    : low_(low), size_(size), values_(closed.size()) {
  for (std::size_t i = 0; i < closed.size(); ++i) values_[i] = closed[i] ? -1.0f : 1.0f;
  // Rounds the steps of the voxels off.
  std::size_t stride = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::vector<float> in = values_;
    for (std::size_t i = 0; i < in.size(); ++i) {
      const int x = static_cast<int>(i / stride % idx(size_[a]));
      const float before = x > 0 ? in[i - stride] : in[i];
      const float after = x + 1 < size_[a] ? in[i + stride] : in[i];
      values_[i] = 0.25f * (before + after) + 0.5f * in[i];
    }
    stride *= idx(size_[a]);
  }
}

double Barrier::openness(const Vec3& index) const {
  std::array<std::size_t, 3> low, next;
  std::array<double, 3> t;
  std::size_t stride = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const double x = std::min(std::max(0.0, index[static_cast<int>(a)] - low_[a]), size_[a] - 1.0);
    const int cell = std::min(static_cast<int>(x), std::max(0, size_[a] - 2));
    t[a] = x - cell;
    low[a] = idx(cell) * stride;
    next[a] = size_[a] > 1 ? stride : 0;
    stride *= idx(size_[a]);
  }
  const auto along = [](double a, double b, double s) { return a + s * (b - a); };
  const float* p = &values_[low[0] + low[1] + low[2]];
  const float* q = p + next[2];
  return along(along(along(p[0], p[next[0]], t[0]), along(p[next[1]], p[next[1] + next[0]], t[0]), t[1]),
               along(along(q[0], q[next[0]], t[0]), along(q[next[1]], q[next[1] + next[0]], t[0]), t[1]),
               t[2]);
}

std::optional<NeckCut> findNeck(const Grid& grid, const ObjectRegion& region, const std::vector<Vec3>& seeds,
                                Passages which) {
  if (region.voxels.empty()) return {};
  return NeckSearch(grid, region, seeds).run(which);
}

}  // namespace handlebody
