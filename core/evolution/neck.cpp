#include "core/evolution/neck.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

constexpr int kBinsPerVoxel = 4;

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

//! The box of a region, one voxel wider on all sides, with the distance of every voxel (mm, chamfer:
//! Borgefors 1986) to the outside. The border of the volume is no wall.
class ThicknessMap {
 public:
  ThicknessMap(const Grid& grid, const ObjectRegion& region) : grid_(grid) {
    low_ = region.voxels[0];
    Voxel high = low_;
    for (const Voxel& v : region.voxels)
      for (std::size_t a = 0; a < 3; ++a) {
        low_[a] = std::min(low_[a], v[a]);
        high[a] = std::max(high[a], v[a]);
      }
    for (std::size_t a = 0; a < 3; ++a) {
      low_[a] -= 1;
      size_[a] = high[a] + 2 - low_[a];
    }
    steps_ = {1, size_[0], static_cast<std::ptrdiff_t>(size_[0]) * size_[1]};
    makeNeighbours();
    distance_.assign(idx(size_[0]) * idx(size_[1]) * idx(size_[2]), 0.0f);
    for (const Voxel& v : region.voxels) distance_[at(v)] = kFar;
    const std::vector<std::size_t> beyond = outsideOfVolume();
    for (std::size_t i : beyond) distance_[i] = kFar;
    sweep(distance_);
    for (std::size_t i : beyond) distance_[i] = 0;
  }

  //! Distance of every voxel of the region to the marked ones.
  std::vector<float> distanceTo(const std::vector<unsigned char>& marked) const {
    std::vector<float> d(distance_.size());
    for (std::size_t i = 0; i < d.size(); ++i) d[i] = marked[i] ? 0.0f : kFar;
    sweep(d);
    return d;
  }

  //! 1 for the voxels within the largest balls around the centres that `isCentre` picks (by place in the
  //! box).
  template <typename F>
  std::vector<unsigned char> coveredByBalls(F&& isCentre) const {
    std::vector<float> d(distance_.size(), kFar);  // to the surface of the nearest ball
    for (std::size_t i = 0; i < d.size(); ++i)
      if (distance_[i] > 0 && isCentre(i)) d[i] = -distance_[i];
    sweep(d);
    std::vector<unsigned char> covered(d.size());
    for (std::size_t i = 0; i < d.size(); ++i) covered[i] = distance_[i] > 0 && d[i] < 0;
    return covered;
  }

  std::size_t at(const Voxel& v) const {
    return (idx(v[2] - low_[2]) * idx(size_[1]) + idx(v[1] - low_[1])) * idx(size_[0]) + idx(v[0] - low_[0]);
  }
  Voxel voxel(std::size_t i) const {
    const auto x = static_cast<int>(i % idx(size_[0])),
               y = static_cast<int>(i / idx(size_[0]) % idx(size_[1])),
               z = static_cast<int>(i / (idx(size_[0]) * idx(size_[1])));
    return {x + low_[0], y + low_[1], z + low_[2]};
  }
  bool contains(const Voxel& v) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (v[a] < low_[a] || v[a] >= low_[a] + size_[a]) return false;
    return true;
  }
  //! 0 outside of the region.
  float distance(std::size_t i) const { return distance_[i]; }
  std::size_t count() const { return distance_.size(); }
  const std::array<int, 3>& low() const { return low_; }
  const std::array<int, 3>& size() const { return size_; }

  //! Of a voxel of the region; they may lie outside of it, but not outside of the box.
  template <typename F>
  void forEachFaceNeighbour(std::size_t i, F&& f) const {
    for (std::ptrdiff_t step : steps_) {
      f(i - static_cast<std::size_t>(step));
      f(i + static_cast<std::size_t>(step));
    }
  }

 private:
  static constexpr float kFar = 1e30f;
  struct Neighbour {
    std::ptrdiff_t offset;
    float length;
  };

  //! The 13 neighbours that come before a voxel in memory.
  void makeNeighbours() {
    for (int dz = -1; dz <= 0; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if (dz == 0 && (dy > 0 || (dy == 0 && dx >= 0))) continue;
          const Vec3 d = Vec3(dx, dy, dz).cwiseProduct(grid_.spacing);
          before_.push_back({dx + dy * steps_[1] + dz * steps_[2], static_cast<float>(d.norm())});
        }
  }

  std::vector<std::size_t> outsideOfVolume() const {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < distance_.size(); ++i) {
      const Voxel v = voxel(i);
      for (std::size_t a = 0; a < 3; ++a)
        if (v[a] < 0 || v[a] >= grid_.size[a]) {
          out.push_back(i);
          break;
        }
    }
    return out;
  }

  //! Two passes over all but the outermost layer.
  void sweep(std::vector<float>& d) const {
    const auto relax = [&](int x, int y, int z, int sign) {
      const std::ptrdiff_t i = x + y * steps_[1] + z * steps_[2];
      float best = d[static_cast<std::size_t>(i)];
      if (best == 0) return;
      for (const Neighbour& n : before_)
        best = std::min(best, d[static_cast<std::size_t>(i + sign * n.offset)] + n.length);
      d[static_cast<std::size_t>(i)] = best;
    };
    for (int z = 1; z < size_[2] - 1; ++z)
      for (int y = 1; y < size_[1] - 1; ++y)
        for (int x = 1; x < size_[0] - 1; ++x) relax(x, y, z, 1);
    for (int z = size_[2] - 2; z > 0; --z)
      for (int y = size_[1] - 2; y > 0; --y)
        for (int x = size_[0] - 2; x > 0; --x) relax(x, y, z, -1);
  }

  Grid grid_;
  Voxel low_, size_;
  std::array<std::ptrdiff_t, 3> steps_;
  std::vector<float> distance_;
  std::vector<Neighbour> before_;
};

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
};

struct WidestPathFlood {
  std::vector<std::size_t> order;  // voxels of the box as taken
  std::vector<Stage> stages;       // narrower and narrower necks
};

WidestPathFlood floodThickFirst(const ThicknessMap& map, const std::vector<std::size_t>& starts, double bin) {
  float highest = 0;
  for (std::size_t s : starts) highest = std::max(highest, map.distance(s));
  const int bins = static_cast<int>(highest / bin) + 1;
  std::vector<std::vector<std::size_t>> queue(idx(bins));
  std::vector<unsigned char> seen(map.count(), 0);
  int now = bins - 1;
  const auto push = [&](std::size_t i) {
    if (seen[i] || map.distance(i) == 0) return;
    seen[i] = 1;
    queue[idx(std::min(now, static_cast<int>(map.distance(i) / bin)))].push_back(i);
  };
  for (std::size_t s : starts) push(s);
  WidestPathFlood flood;
  for (; now >= 0; --now) {
    Stage stage{now * bin, flood.order.size(), 0, 0};
    for (std::size_t next = 0; next < queue[idx(now)].size(); ++next) {
      const std::size_t i = queue[idx(now)][next];
      flood.order.push_back(i);
      stage.widest = std::max(stage.widest, map.distance(i));
      map.forEachFaceNeighbour(i, push);
    }
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

//! The side of the seeds: what a ball of the neck's radius covers without passing the neck, and all crumbs
//! that hang on it alone. Marks: 1 = kept, 2 = cut off, 0 = no part of the region.
std::vector<unsigned char> splitAt(const ThicknessMap& map, const WidestPathFlood& flood,
                                   const Stage& stage) {
  std::vector<unsigned char> core(map.count(), 0);
  for (std::size_t i = 0; i < stage.first; ++i) core[flood.order[i]] = 1;
  const std::vector<float> fromCore = map.distanceTo(core);
  std::vector<unsigned char> side(map.count(), 0);
  std::vector<std::size_t> front;
  for (std::size_t i : flood.order) side[i] = fromCore[i] <= stage.neck ? 1 : 3;
  for (std::size_t k = stage.first; k < stage.last; ++k) {
    const std::size_t i = flood.order[k];
    if (side[i] == 3 && map.distance(i) > 0.9f * stage.widest) {
      side[i] = 2;
      front.push_back(i);
    }
  }
  while (!front.empty()) {
    const std::size_t i = front.back();
    front.pop_back();
    map.forEachFaceNeighbour(i, [&](std::size_t w) {
      if (side[w] != 3) return;
      side[w] = 2;
      front.push_back(w);
    });
  }
  for (unsigned char& s : side)
    if (s == 3) s = 1;
  return side;
}

//! Everything that `from` reaches by faces over voxels that `open` says are open; marks it 1.
template <typename F>
std::vector<unsigned char> reachedFrom(const ThicknessMap& map, std::vector<std::size_t> from, F&& open) {
  std::vector<unsigned char> reached(map.count(), 0);
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
//! entering the wide part, and all crumbs that do not touch the wide part. Marks as splitAt().
std::vector<unsigned char> splitByWidth(const ThicknessMap& map, const std::vector<std::size_t>& starts,
                                        double structure) {
  const double widest = kWidens * structure, narrowest = kNarrows * structure;
  const auto wide = map.coveredByBalls([&](std::size_t i) { return map.distance(i) > widest; });
  const auto core =
      reachedFrom(map, starts, [&](std::size_t i) { return !wide[i] && map.distance(i) >= narrowest; });
  const auto near = map.coveredByBalls([&](std::size_t i) { return core[i] != 0; });
  // What is in neither is cut off together with the wide part that it touches.
  std::vector<std::size_t> rim;
  for (std::size_t i = 0; i < wide.size(); ++i)
    if (wide[i]) map.forEachFaceNeighbour(i, [&](std::size_t w) { rim.push_back(w); });
  const auto beside = reachedFrom(map, std::move(rim),
                                  [&](std::size_t i) { return map.distance(i) > 0 && !wide[i] && !near[i]; });
  std::vector<unsigned char> side(map.count(), 0);
  for (std::size_t i = 0; i < side.size(); ++i)
    if (map.distance(i) > 0) side[i] = wide[i] || beside[i] ? 2 : 1;
  return side;
}

std::shared_ptr<const Barrier> barrierOf(const ThicknessMap& map, const std::vector<unsigned char>& side) {
  std::vector<unsigned char> closed(side.size());
  for (std::size_t i = 0; i < side.size(); ++i) closed[i] = side[i] == 2;
  return std::make_shared<Barrier>(map.low(), map.size(), closed);
}

}  // namespace

Barrier::Barrier(const std::array<int, 3>& low, const std::array<int, 3>& size,
                 const std::vector<unsigned char>& closed)
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

std::optional<NeckCut> findNeck(const Grid& grid, const ObjectRegion& region,
                                const std::vector<Vec3>& seeds) {
  if (region.voxels.empty()) return {};
  const ThicknessMap map(grid, region);
  std::vector<std::size_t> starts, seedVoxels;
  double structure = std::numeric_limits<double>::max();
  for (const Vec3& s : seeds) {
    const Voxel v{static_cast<int>(std::lround(s[0])), static_cast<int>(std::lround(s[1])),
                  static_cast<int>(std::lround(s[2]))};
    if (!map.contains(v)) continue;
    seedVoxels.push_back(map.at(v));
    starts.push_back(thickestNear(grid, map, seedVoxels.back()));
    structure = std::min(structure, static_cast<double>(map.distance(starts.back())));
  }
  if (starts.empty() || structure <= 0) return {};
  const WidestPathFlood flood = floodThickFirst(map, starts, grid.meanSpacing() / kBinsPerVoxel);
  const auto cutAt = [&](const Stage& stage, const std::vector<unsigned char>& side,
                         double larger) -> std::optional<NeckCut> {
    const auto kept = static_cast<double>(std::count(side.begin(), side.end(), 1));
    const auto cut = static_cast<double>(std::count(side.begin(), side.end(), 2));
    const bool seedsKept =
        std::none_of(seedVoxels.begin(), seedVoxels.end(), [&](std::size_t i) { return side[i] == 2; });
    if (!seedsKept || cut < larger * kept) return {};
    NeckCut out;
    out.neckRadius = stage.neck;
    out.structureRadius = structure;
    out.widestBehind = stage.widest;
    out.keptVolume = kept * grid.voxelVolume();
    out.cutVolume = cut * grid.voxelVolume();
    for (const Voxel& v : region.voxels) out.kept.push_back(side[map.at(v)] == 1);
    out.barrier = barrierOf(map, side);
    return out;
  };
  for (const Rule& rule : kNecks)
    for (const Stage& stage : flood.stages)
      if (shows(rule, stage, structure))
        if (auto cut = cutAt(stage, splitAt(map, flood, stage), rule.larger)) return cut;
  const auto opening = std::find_if(flood.stages.begin(), flood.stages.end(),
                                    [&](const Stage& s) { return shows(kOpening, s, structure); });
  if (opening == flood.stages.end()) return {};
  auto cut = cutAt(*opening, splitByWidth(map, starts, structure), kMuchLarger);
  if (cut) cut->neckRadius = kWidens * structure, cut->widens = true;
  return cut;
}

}  // namespace handlebody
