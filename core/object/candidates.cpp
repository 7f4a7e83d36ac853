#include "core/object/candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/cancellation.h"
#include "core/indices.h"
#include "core/object/eight_cells.h"
#include "core/object/star_surface.h"
#include "core/threads.h"

namespace handlebody {

namespace {

// Gradients are kept in half octaves of the noise per cell.
constexpr int kGradients = 24;
constexpr int kNoiseGradient = 8;
constexpr double kAtEnd = 1e-9;  // of an octave: far more than roots and logarithms are rounded by
// A part of the surface on a cut side that is an accident of a cell or two.
constexpr double kHardlyCut = 0.005;

std::uint8_t gradientBin(double perNoise) {
  const double bin = 2 * std::log2(std::max(perNoise, 1e-9)) + kNoiseGradient;
  return static_cast<std::uint8_t>(std::clamp(static_cast<int>(std::floor(bin)), 0, kGradients - 1));
}

//! The same of the square of it, whose octaves the bins are: only next to the end of one it takes a logarithm
//! to tell which side it falls on.
std::uint8_t gradientBinOfSquare(double squared) {
  int octave = 0;
  const double part = std::frexp(squared, &octave);  // 1/2 to 1
  if (!(squared > 1e-17) || part < 0.5 + kAtEnd || part > 1 - kAtEnd) return gradientBin(std::sqrt(squared));
  return static_cast<std::uint8_t>(std::clamp(octave - 1 + kNoiseGradient, 0, kGradients - 1));
}

//! Gradient of the values over a cell's mean spacing.
std::vector<std::uint8_t> gradientBins(const ClickSearch& s) {
  const Grid& g = s.image.cells.grid;
  std::vector<std::uint8_t> out(s.values.size());
  const double mean = g.meanSpacing() / s.intensities.noise;
  std::size_t i = 0;
  for (int z = 0; z < g.size[2]; ++z)
    for (int y = 0; y < g.size[1]; ++y)
      for (int x = 0; x < g.size[0]; ++x, ++i) {
        const std::array<int, 3> c{x, y, z};
        double sum = 0;
        std::size_t step = 1;
        for (std::size_t a = 0; a < 3; ++a) {
          const std::size_t before = c[a] > 0 ? step : 0, after = c[a] + 1 < g.size[a] ? step : 0;
          if (before + after > 0) {
            const double wide = (before > 0 ? 1 : 0) + (after > 0 ? 1 : 0);
            const double d = (static_cast<double>(s.values[i + after]) - s.values[i - before]) / wide;
            sum += std::pow(d * mean / g.spacing[static_cast<Eigen::Index>(a)], 2);
          }
          step *= idx(g.size[a]);
        }
        out[i] = gradientBinOfSquare(sum);
      }
  return out;
}

//! Sums over regions, kept as what each rung adds.
struct Sums {
  double voxels = 0, inside = 0, inside2 = 0;   // of cells
  double faces = 0, outside = 0, outside2 = 0;  // of the surface within the box
  double border = 0, cut = 0;                   // of the surface on its sides
  double area = 0;                              // mm², of the faces
  std::array<double, kGradients> gradients{};

  void add(const Sums& o) {
    voxels += o.voxels, inside += o.inside, inside2 += o.inside2;
    faces += o.faces, outside += o.outside, outside2 += o.outside2;
    border += o.border, cut += o.cut, area += o.area;
    for (std::size_t g = 0; g < gradients.size(); ++g) gradients[g] += o.gradients[g];
  }
};
using SumsPerRung = std::array<Sums, kNever + 1>;

void addFaceTo(SumsPerRung& sums, int inner, int outer, double outside, std::size_t gradient, double area) {
  for (const auto& [rung, sign] : {std::pair{inner, 1.0}, std::pair{outer, -1.0}}) {
    Sums& s = sums[rung];
    s.faces += sign;
    s.outside += sign * outside;
    s.outside2 += sign * outside * outside;
    s.gradients[gradient] += sign;
    s.area += sign * area;
  }
}

//! Where cells that join lie in a row: the first and the last of them.
struct RowSpan {
  int first, last;
};

std::vector<RowSpan> spansOf(const ArrivalMap& map, std::size_t row) {
  const std::vector<std::uint8_t> none(row, kNever);
  const int n = static_cast<int>(row);
  std::vector<RowSpan> out;
  for (std::size_t i = 0; i < map.level.size(); i += row) {
    const std::uint8_t* level = &map.level[i];
    RowSpan span{n, -1};
    if (std::memcmp(level, none.data(), row) != 0) {
      span = {0, n - 1};
      while (level[span.first] == kNever) ++span.first;
      while (level[span.last] == kNever) --span.last;
    }
    out.push_back(span);
  }
  return out;
}

//! One pass over the cells: a face between cells that join at l < m lies on the surface of the regions of the
//! rungs l to m - 1. Row by row, and in a row cell by cell: each sum is made in this order.
class Gathering {
 public:
  Gathering(const ClickSearch& s, const ArrivalMap& map) : s_(s), map_(map), n_(s.image.cells.grid.size) {
    const Grid& grid = s.image.cells.grid;
    for (std::size_t a = 0; a < 3; ++a)
      areas_[a] = grid.voxelVolume() / grid.spacing[static_cast<Eigen::Index>(a)];
  }

  SumsPerRung run() {
    const std::vector<RowSpan> spans = spansOf(map_, idx(n_[0]));
    for (int z = 0; z < n_[2]; ++z) {
      giveUpIfCancelled();
      for (int y = 0; y < n_[1]; ++y) {
        const std::size_t row = idx(z) * idx(n_[1]) + idx(y);
        const RowSpan none{n_[0], -1}, own = spans[row], nextRow = y + 1 < n_[1] ? spans[row + 1] : none,
                                       nextPlane = z + 1 < n_[2] ? spans[row + idx(n_[1])] : none;
        addCells(own, y, z);
        // With the cell before them, which has a face to the first.
        addFaces({std::max(0, std::min({own.first, nextRow.first, nextPlane.first}) - 1),
                  std::max({own.last, nextRow.last, nextPlane.last})},
                 y, z);
      }
    }
    return sums_;
  }

 private:
  void addCells(const RowSpan& span, int y, int z) {
    const std::size_t start = s_.image.cells.at(0, y, z);
    const std::uint8_t* level = &map_.level[start];
    const float* values = &s_.values[start];
    for (int x = span.first, end = x; x <= span.last; x = end) {
      while (end <= span.last && level[end] == level[x]) ++end;
      if (level[x] == kNever) continue;
      Sums& of = sums_[level[x]];
      of.voxels += end - x;
      double inside = of.inside, inside2 = of.inside2;
      for (int i = x; i < end; ++i) {
        const double d = values[i] - s_.intensities.level;
        inside += d, inside2 += d * d;
      }
      of.inside = inside, of.inside2 = inside2;
      addSides(of, {x, end - 1}, y, z);
    }
  }
  //! Faces on the sides of the box.
  void addSides(Sums& of, const RowSpan& run, int y, int z) const {
    const std::array<std::array<int, 2>, 3> counts{
        {{run.first == 0, run.last == n_[0] - 1}, {y == 0, y == n_[1] - 1}, {z == 0, z == n_[2] - 1}}};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t side = 0; side < 2; ++side)
        if (n_[a] > 1)
          (s_.image.cells.goesOn[a][side] ? of.cut : of.border) +=
              counts[a][side] * (a == 0 ? 1 : run.last - run.first + 1);
  }

  void addFaces(const RowSpan& span, int y, int z) {
    const std::size_t start = s_.image.cells.at(0, y, z), row = idx(n_[0]), plane = row * idx(n_[1]);
    const std::uint8_t* level = &map_.level[start];
    // Where the box ends there is no face: a cell is compared with itself.
    const std::array<std::size_t, 3> steps{1, y + 1 < n_[1] ? row : 0, z + 1 < n_[2] ? plane : 0};
    for (int x = span.first; x <= span.last; ++x) {
      while (x + 8 < n_[0] && x + 7 <= span.last && areSame(level + x, steps)) x += 8;
      if (x > span.last) break;
      for (std::size_t a = 0; a < 3; ++a)
        if (a > 0 || x + 1 < n_[0]) addFace(start + idx(x), start + idx(x) + steps[a], areas_[a]);
    }
  }
  //! Eight cells, all as those after them along each axis.
  static bool areSame(const std::uint8_t* level, const std::array<std::size_t, 3>& steps) {
    const std::uint64_t own = eightCells(level);
    return own == eightCells(level + steps[0]) && own == eightCells(level + steps[1]) &&
           own == eightCells(level + steps[2]);
  }
  void addFace(std::size_t i, std::size_t j, double area) {
    const int level = map_.level[i], other = map_.level[j];
    if (other == level) return;
    const std::size_t outer = level < other ? j : i;
    addFaceTo(sums_, std::min(level, other), std::max(level, other), s_.values[outer] - s_.intensities.level,
              (s_.gradients[i] + std::size_t{s_.gradients[j]}) / 2, area);
  }

  const ClickSearch& s_;
  const ArrivalMap& map_;
  const std::array<int, 3>& n_;
  std::array<double, 3> areas_{};
  SumsPerRung sums_;
};

double median(const std::array<double, kGradients>& histogram, double total) {
  double before = 0;
  for (int g = 0; g < kGradients; ++g) {
    const double here = histogram[g];
    if (here > 0 && before + here >= 0.5 * total) return g + (0.5 * total - before) / here;
    before += here;
  }
  return kGradients;
}

RankedRegion describe(const ClickSearch& s, const ArrivalMap& map, int rung, const Sums& sum) {
  RankedRegion r;
  r.search = &s;
  r.map = &map;
  r.rung = rung;
  r.volume = sum.voxels * s.image.cells.grid.voxelVolume();
  const double faces = std::max(sum.faces, 1.0), surface = sum.faces + sum.border + sum.cut;
  r.border = surface > 0 ? sum.border / surface : 0;
  r.cut = surface > 0 ? sum.cut / surface : 0;
  r.edge = median(sum.gradients, faces);
  const double in = sum.inside / sum.voxels, out = sum.outside / faces;
  const double spread = std::sqrt(std::max(0.0, sum.inside2 / sum.voxels - in * in)) +
                        std::sqrt(std::max(0.0, sum.outside2 / faces - out * out));
  r.shape = std::log(std::max(std::pow(sum.area, 3) / (36 * std::numbers::pi * r.volume * r.volume), 1.0));
  r.rise = out - in;
  r.contrast = std::abs(out - in) / (spread + 0.3 * s.intensities.noise + std::numeric_limits<double>::min());
  return r;
}

//! Voters that contain a region for sure (wider bounds, narrower opening) or are contained, and differ little
//! in size.
void countVotes(std::vector<RankedRegion>& regions, const std::vector<RankedRegion>& voters,
                const ObjectPolicy& policy) {
  std::vector<std::pair<double, const RankedRegion*>> sizes;
  for (const RankedRegion& v : voters) sizes.emplace_back(std::log(v.volume), &v);
  std::sort(sizes.begin(), sizes.end());
  for (RankedRegion& a : regions) {
    const double size = std::log(a.volume);
    auto voter = std::partition_point(sizes.begin(), sizes.end(),
                                      [&](const auto& v) { return size - v.first >= policy.sameSize; });
    for (; voter != sizes.end() && voter->first - size < policy.sameSize; ++voter) {
      const RankedRegion& b = *voter->second;
      const bool wider = b.map->band >= a.map->band && b.rung >= a.rung && b.map->passes <= a.map->passes;
      const bool narrower = b.map->band <= a.map->band && b.rung <= a.rung && b.map->passes >= a.map->passes;
      a.votes += wider || narrower;
    }
  }
}

std::vector<RankedRegion> regionsOf(const ClickSearch& s, const std::vector<ArrivalMap>& maps,
                                    const ObjectPolicy& policy, int threads) {
  std::vector<SumsPerRung> sums(maps.size());
  forEachOnThreads(maps.size(), threads, [&](std::size_t m) { sums[m] = Gathering(s, maps[m]).run(); });
  std::vector<RankedRegion> out;
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const ArrivalMap& map = maps[m];
    Sums upTo;
    for (int rung = 0; rung < map.end; ++rung) {
      upTo.add(sums[m][rung]);
      if (upTo.voxels < static_cast<double>(policy.fewest)) continue;
      if (upTo.voxels > policy.largestPart * static_cast<double>(s.image.cells.count())) break;
      out.push_back(describe(s, map, rung, upTo));
    }
  }
  return out;
}

//! What the clicks do not change.
void learn(ClickSearch& s, const ObjectPolicy& policy, int threads) {
  if (!s.gradients.empty() || (s.maps.empty() && s.stars.empty())) return;
  s.gradients = gradientBins(s);
  s.known = regionsOf(s, s.maps, policy, threads);
  countVotes(s.known, s.known, policy);
}

//! Rank from 0 to 1 among the regions but tubes, so that these change nothing in the order of the others;
//! equal values have equal ranks.
std::vector<double> ranks(const std::vector<RankedRegion>& regions, double RankedRegion::*of) {
  std::vector<double> sorted;
  for (const RankedRegion& r : regions)
    if (!r.isTube()) sorted.push_back(r.*of);
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> out;
  const double last = std::max(1.0, static_cast<double>(sorted.size()) - 1);
  for (const RankedRegion& r : regions) {
    const auto [first, end] = std::equal_range(sorted.begin(), sorted.end(), r.*of);
    const double middle =
        (static_cast<double>(first - sorted.begin()) + static_cast<double>(end - sorted.begin()) - 1) / 2;
    out.push_back(std::clamp(middle / last, 0.0, 1.0));
  }
  return out;
}

void setScores(std::vector<RankedRegion>& regions, double searched, const ObjectPolicy& p) {
  const auto votes = ranks(regions, &RankedRegion::votes), edges = ranks(regions, &RankedRegion::edge),
             contrasts = ranks(regions, &RankedRegion::contrast);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    RankedRegion& r = regions[i];
    const double large = std::max(0.0, std::log(r.volume / (p.largePart * searched)));
    const double stable = r.isStar() ? p.agreement * r.map->agreement : p.stability * votes[i];
    r.score = stable + p.edge * edges[i] + p.contrast * contrasts[i] - p.border * (r.border + r.cut) -
              p.size * large -
              (r.isTube() ? 0.0 : p.shape) * std::clamp(r.shape - p.compact, 0.0, p.ragged - p.compact);
  }
}

const RankedRegion* bestByIntensity(const std::vector<RankedRegion>& regions) {
  const RankedRegion* best = nullptr;
  for (const RankedRegion& r : regions)
    if (!r.isStar() && (!best || r.score > best->score)) best = &r;
  return best;
}

//! True if intensities alone tell inside from outside, or the edges stand out of the noise: of the best
//! region that is not star-shaped.
bool decidesAlone(const std::vector<RankedRegion>& regions, const ObjectPolicy& p) {
  const RankedRegion* best = bestByIntensity(regions);
  const double clearEdge = kNoiseGradient + 2 * std::log2(p.clearEdge);
  return best && (best->contrast >= p.clearContrast || best->edge >= clearEdge);
}

//! Where the image decides alone shape is second.
void putStarsBehind(std::vector<RankedRegion>& regions, const ObjectPolicy& p) {
  if (!decidesAlone(regions, p)) return;
  const double most = bestByIntensity(regions)->score - p.close;
  for (RankedRegion& r : regions)
    if (r.isStar()) r.score = std::min(r.score, most);
}

//! Intersection over union; of regions of different searches, or of sizes too different, only by their
//! volumes.
double likeness(const RankedRegion& a, const RankedRegion& b, const ObjectPolicy& policy) {
  const double sizes = std::min(a.volume, b.volume) / std::max(a.volume, b.volume);
  if (a.search != b.search || sizes < policy.sameRegion) return sizes;
  std::size_t both = 0, any = 0;
  const std::uint8_t ra = static_cast<std::uint8_t>(a.rung), rb = static_cast<std::uint8_t>(b.rung);
  for (std::size_t i = 0; i < a.map->level.size(); ++i) {
    const bool inA = a.map->level[i] <= ra, inB = b.map->level[i] <= rb;
    both += inA && inB;
    any += inA || inB;
  }
  return static_cast<double>(both) / static_cast<double>(std::max<std::size_t>(1, any));
}

}  // namespace

ClickSearch searchAround(const Volume& volume, const CellGrid& cells, const Vec3& click,
                         const FieldOfView* view, const ObjectPolicy& policy, int threads,
                         const IntensityScale& scale) {
  ClickSearch s{scale, makeCells(volume, cells, view), {}, cells.nearest(click), {}, {}, {}, {}, {}, false,
                {}};
  scale.apply(s.image.values);
  s.values = smoothed(cells, s.image.values, policy.smoothing * cells.grid.meanSpacing());
  s.intensities = readClick(cells, s.image.values, s.values, s.click, policy);
  if (!(s.intensities.range > 0)) return s;  // constant: nothing to find
  s.maps = arrivalMaps(cells, rungsOf(s.image, s.values, s.click, s.intensities), s.click, policy, threads);
  return s;
}

void addStars(ClickSearch& s, const std::vector<CellClick>& inside, const std::vector<CellClick>& outside,
              const ObjectPolicy& policy, int threads) {
  if (!(s.intensities.range > 0)) return;
  s.stars.clear();
  for (const StarRegion& star : starRegions(s.image, s.values, inside, outside, policy, threads)) {
    ArrivalMap map{kRungs, 0, 0, 1, star.agreement, {}};
    map.level.resize(star.inside.size());
    std::transform(star.inside.begin(), star.inside.end(), map.level.begin(),
                   [](std::uint8_t in) { return in ? std::uint8_t{0} : kNever; });
    s.stars.push_back(std::move(map));
  }
}

bool RankedRegion::holds(const Vec3& world) const {
  const CellGrid& cells = search->image.cells;
  return cells.contains(world) && holds(cells.at(cells.nearest(world)));
}

std::vector<Vec3> cutSides(const RankedRegion& region) {
  const CellGrid& cells = region.search->image.cells;
  const auto& n = cells.grid.size;
  std::vector<Vec3> out;
  for (std::size_t a = 0; a < 3; ++a)
    for (const std::size_t side : {0, 1}) {
      if (!cells.goesOn[a][side]) continue;
      CellBox box{{0, 0, 0}, {n[0] - 1, n[1] - 1, n[2] - 1}};
      (side == 0 ? box.high : box.low)[a] = side == 0 ? 0 : n[a] - 1;
      Vec3 sum = Vec3::Zero();
      double held = 0;
      forBox(box, [&](const std::array<int, 3>& c) {
        if (region.holds(cells.at(c))) sum += Vec3(c[0], c[1], c[2]), ++held;
      });
      if (held > 0) out.push_back(cells.grid.toWorld(sum / held));
    }
  return out;
}

bool RankedRegion::isTube() const { return search->isTube; }

std::array<double, 2> RankedRegion::bounds() const {
  const auto [low, high] = scaledBounds();
  return {search->scale.from(low), search->scale.from(high)};
}

std::array<double, 2> RankedRegion::scaledBounds() const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (isStar()) return {-kInfinity, kInfinity};
  const auto& in = search->intensities;
  const auto distance = [&](int r) {
    return r < kRungs ? static_cast<double>(in.ladder[r]) : std::numeric_limits<double>::infinity();
  };
  return {in.level - distance(rung), in.level + distance(map->band)};
}

std::vector<RankedRegion> rankRegions(const std::vector<std::unique_ptr<ClickSearch>>& searches,
                                      const ObjectPolicy& policy, int threads) {
  std::vector<RankedRegion> all;
  double searched = 0;  // mm³
  for (const auto& s : searches) {
    const CellGrid& cells = s->image.cells;
    const bool last = s == searches.back();
    searched = std::max(searched, static_cast<double>(cells.count()) * cells.grid.voxelVolume());
    learn(*s, policy, threads);
    std::vector<RankedRegion> stars = regionsOf(*s, s->stars, policy, threads);
    countVotes(stars, s->known, policy);
    for (const auto* own : {&s->known, &stars})
      std::copy_if(own->begin(), own->end(), std::back_inserter(all),
                   [&](const RankedRegion& r) { return last || r.cut <= kHardlyCut; });
  }
  setScores(all, searched, policy);
  putStarsBehind(all, policy);
  return all;
}

std::vector<RankedRegion> distinctRegions(std::vector<RankedRegion>& regions, std::size_t most,
                                          const ObjectPolicy& policy) {
  std::stable_sort(regions.begin(), regions.end(),
                   [](const RankedRegion& a, const RankedRegion& b) { return a.score > b.score; });
  std::vector<RankedRegion> out;
  for (const RankedRegion& r : regions) {
    if (out.size() == most) break;
    giveUpIfCancelled();
    if (std::none_of(out.begin(), out.end(),
                     [&](const RankedRegion& o) { return likeness(r, o, policy) > policy.sameRegion; }))
      out.push_back(r);
  }
  return out;
}

}  // namespace handlebody
