#include "core/object/region.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

#include "core/indices.h"
#include "core/object/distance.h"
#include "core/volume/voxel_walk.h"

namespace handlebody {

namespace {

using Cell = std::array<int, 3>;
//! Which cell of `to` each cell of `from` has its centre in, along one axis; -1 = none.
std::vector<int> cellMap(const CellGrid& from, const CellGrid& to, std::size_t axis) {
  std::vector<int> out(from.grid.size[axis], -1);
  for (int i = 0; i < from.grid.size[axis]; ++i) {
    // Twice the voxel index of the centre, so that it is whole.
    const int twice = 2 * (from.low[axis] + from.factor[axis] * i) + from.factor[axis] - 1;
    const int voxel = (twice >= 0 ? twice / 2 : -1) - to.low[axis];
    const int cell = voxel >= 0 ? voxel / to.factor[axis] : -1;
    if (cell >= 0 && cell < to.grid.size[axis]) out[i] = cell;
  }
  return out;
}

enum class CellSide : std::uint8_t { outside, inside, surface };

//! Of each cell of a search: well inside, well outside, or with a neighbour of the other kind.
std::vector<CellSide> sidesOf(const RankedRegion& r) {
  const CellGrid& cells = r.search->image.cells;
  const auto& n = cells.grid.size;
  std::vector<CellSide> out(cells.count());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = r.holds(i) ? CellSide::inside : CellSide::outside;
  const std::array<std::size_t, 3> steps{1, idx(n[0]), idx(n[0]) * idx(n[1])};
  std::size_t i = 0;
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x, ++i) {
        const Cell c{x, y, z};
        for (std::size_t a = 0; a < 3; ++a)
          if (c[a] + 1 < n[a] && r.holds(i) != r.holds(i + steps[a]))
            out[i] = out[i + steps[a]] = CellSide::surface;
      }
  return out;
}

constexpr std::uint8_t kOut = 0, kIn = 1, kFarOut = 2;

//! The cells (1) that hang together with the starts.
std::vector<std::uint8_t> partsOf(const std::array<int, 3>& n, const std::vector<std::uint8_t>& inside,
                                  std::vector<std::size_t> starts) {
  std::vector<std::uint8_t> out(inside.size(), kOut);
  const auto enter = [&](std::size_t i) {
    if (out[i] == kIn || !inside[i]) return false;
    out[i] = kIn;
    return true;
  };
  std::erase_if(starts, [&](std::size_t i) { return !enter(i); });
  while (!starts.empty()) {
    const std::size_t v = starts.back();
    starts.pop_back();
    forFaceNeighbours(n, v, [&](std::size_t w, std::size_t) {
      if (enter(w)) starts.push_back(w);
    });
  }
  return out;
}

//! Parts of what is outside with fewer cells than `cavity` come in. Most cells lie in rows that are too long
//! for that; only what is left is followed from neighbour to neighbour, until it is too much or meets them.
void fillCavities(const std::array<int, 3>& n, std::vector<std::uint8_t>& cells, std::size_t cavity) {
  for (std::size_t row = 0; row < cells.size(); row += idx(n[0])) {
    const auto end = cells.begin() + static_cast<std::ptrdiff_t>(row + idx(n[0]));
    for (auto from = cells.begin() + static_cast<std::ptrdiff_t>(row); from != end;) {
      from = std::find(from, end, kOut);
      const auto last = std::find(from, end, kIn);
      if (last - from >= static_cast<std::ptrdiff_t>(cavity)) std::fill(from, last, kFarOut);
      from = last;
    }
  }
  std::vector<std::size_t> part;
  for (std::size_t start = 0; start < cells.size(); ++start) {
    if (cells[start] != kOut) continue;
    part.assign(1, start);
    cells[start] = kIn;
    bool isFar = false;
    for (std::size_t k = 0; k < part.size() && part.size() < cavity && !isFar; ++k)
      forFaceNeighbours(n, part[k], [&](std::size_t w, std::size_t) {
        isFar |= cells[w] == kFarOut;
        if (cells[w] != kOut) return;
        cells[w] = kIn;
        part.push_back(w);
      });
    if (isFar || part.size() >= cavity)
      for (const std::size_t i : part) cells[i] = kFarOut;
  }
}

}  // namespace

std::size_t Region::count() const {
  return static_cast<std::size_t>(std::count(inside.begin(), inside.end(), std::uint8_t{1}));
}

bool isSame(const RegionInCells* a, const RegionInCells* b) {
  if (!a || !b) return a == b;
  return isSame(a->cells, b->cells) && a->region.inside == b->region.inside;
}

Region regionOn(const WorkImage& work, const RegionInCells& other) {
  const CellGrid& to = work.cells();
  std::array<std::vector<int>, 3> map;
  for (std::size_t a = 0; a < 3; ++a) map[a] = cellMap(to, other.cells, a);
  Region out{std::vector<std::uint8_t>(to.count(), 0)};
  std::size_t i = 0;
  for (const int z : map[2])
    for (const int y : map[1])
      for (const int x : map[0]) {
        out.inside[i] = x >= 0 && y >= 0 && z >= 0 ? other.region.inside[other.cells.at(x, y, z)] : 0;
        ++i;
      }
  return out;
}

Region regionOn(const WorkImage& work, const RankedRegion& r) {
  const CellGrid& to = work.cells();
  const CellGrid& from = r.search->image.cells;
  Region out{std::vector<std::uint8_t>(to.count(), 0)};
  const auto [low, high] = r.scaledBounds();  // as the values are
  const bool same = from.factor == to.factor;
  const std::vector<CellSide> sides = same || r.isStar() ? std::vector<CellSide>{} : sidesOf(r);
  std::array<std::vector<int>, 3> map;
  for (std::size_t a = 0; a < 3; ++a) map[a] = cellMap(to, from, a);
  std::size_t i = 0;
  for (int z = 0; z < to.grid.size[2]; ++z)
    for (int y = 0; y < to.grid.size[1]; ++y)
      for (int x = 0; x < to.grid.size[0]; ++x, ++i) {
        const Cell c{map[0][x], map[1][y], map[2][z]};
        if (c[0] < 0 || c[1] < 0 || c[2] < 0) continue;
        const std::size_t there = from.at(c);
        if (same || r.isStar())
          out.inside[i] = r.holds(there);
        else if (sides[there] == CellSide::surface)
          out.inside[i] = work.values[i] >= low && work.values[i] <= high && !work.image.padding[i];
        else
          out.inside[i] = sides[there] == CellSide::inside;
      }
  return out;
}

void keepParts(const WorkImage& work, Region& region, const std::vector<std::size_t>& holding,
               std::size_t cavity) {
  const CellGrid& cells = work.cells();
  CellBox box = boxOf(cells, region);
  if (box.empty()) return;
  box = box.grown(1, cells.grid.size);  // so that what is outside hangs together
  const std::vector<std::uint8_t> inside = cutOut(cells, region.inside, box);
  std::vector<std::size_t> starts;
  for (const std::size_t i : holding)
    if (const Cell c = cells.cellOf(i); box.holds(c)) starts.push_back(box.at(c));
  std::vector<std::uint8_t> kept = partsOf(box.size(), inside, std::move(starts));
  fillCavities(box.size(), kept, cavity);
  std::size_t from = 0;
  for (int z = box.low[2]; z <= box.high[2]; ++z)
    for (int y = box.low[1]; y <= box.high[1]; ++y)
      for (int x = box.low[0]; x <= box.high[0]; ++x) region.inside[cells.at(x, y, z)] = kept[from++] == kIn;
}

std::vector<Vec3> deepestOfParts(const WorkImage& work, const Region& region) {
  const CellGrid& cells = work.cells();
  CellBox box = boxOf(cells, region);
  std::vector<Vec3> places;
  if (box.empty()) return places;
  box = box.grown(1, cells.grid.size);
  std::vector<std::uint8_t> left = cutOut(cells, region.inside, box), outside(left.size());
  std::transform(left.begin(), left.end(), outside.begin(), [](std::uint8_t in) { return in == 0; });
  const std::vector<float> depth = distanceTo(box.size(), cells.grid.spacing, outside);
  for (std::size_t first = 0; first < left.size(); ++first) {
    if (!left[first]) continue;
    std::size_t deepest = first;
    std::vector<std::size_t> front{first};
    left[first] = 0;
    while (!front.empty()) {
      const std::size_t at = front.back();
      front.pop_back();
      if (depth[at] > depth[deepest]) deepest = at;
      forFaceNeighbours(box.size(), at, [&](std::size_t w, std::size_t) {
        if (left[w]) front.push_back(w);
        left[w] = 0;
      });
    }
    const std::size_t nx = idx(box.size()[0]), ny = idx(box.size()[1]);
    const std::size_t x = deepest % nx, y = deepest / nx % ny, z = deepest / (nx * ny);
    const Vec3 low(box.low[0], box.low[1], box.low[2]);
    places.push_back(cells.grid.toWorld(
        low + Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z))));
  }
  return places;
}

void CellBox::widen(const Cell& cell) {
  for (std::size_t a = 0; a < 3; ++a) {
    low[a] = std::min(low[a], cell[a]);
    high[a] = std::max(high[a], cell[a]);
  }
}

CellBox CellBox::grown(int by, const std::array<int, 3>& size) const {
  CellBox out = *this;
  for (std::size_t a = 0; a < 3; ++a) {
    out.low[a] = std::max(0, low[a] - by);
    out.high[a] = std::min(size[a] - 1, high[a] + by);
  }
  return out;
}

std::size_t CellBox::count() const {
  if (empty()) return 0;
  const auto n = size();
  return idx(n[0]) * idx(n[1]) * idx(n[2]);
}

CellBox boxAround(const CellGrid& cells, const Cell& centre, double reach) {
  CellBox box{centre, centre};
  for (std::size_t a = 0; a < 3; ++a) {
    const int r = static_cast<int>(std::ceil(reach / cells.grid.spacing[static_cast<Eigen::Index>(a)]));
    box.low[a] = std::max(0, centre[a] - r);
    box.high[a] = std::min(cells.grid.size[a] - 1, centre[a] + r);
  }
  return box;
}

bool isCutOff(const CellGrid& cells, const Region& region) {
  const CellBox box = boxOf(cells, region);
  if (box.empty()) return false;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto [below, above] = cells.goesOn[a];
    if ((below && box.low[a] == 0) || (above && box.high[a] == cells.grid.size[a] - 1)) return true;
  }
  return false;
}

CellBox boxOf(const CellGrid& cells, const Region& region) {
  const auto& n = cells.grid.size;
  CellBox box{{n[0], n[1], n[2]}, {-1, -1, -1}};
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y) {
      const std::uint8_t* row = &region.inside[cells.at(0, y, z)];
      const auto* first = static_cast<const std::uint8_t*>(std::memchr(row, 1, idx(n[0])));
      if (!first) continue;
      int last = n[0] - 1;
      while (!row[last]) --last;
      box.widen({static_cast<int>(first - row), y, z});
      box.widen({last, y, z});
    }
  return box;
}

double overlapOf(const Region& a, const Region& b) {
  std::size_t both = 0, sum = 0;
  for (std::size_t i = 0; i < a.inside.size(); ++i) {
    both += a.inside[i] & b.inside[i];
    sum += static_cast<std::size_t>(a.inside[i]) + b.inside[i];
  }
  return sum > 0 ? 2 * static_cast<double>(both) / static_cast<double>(sum) : 1;
}

CellBox boxOfChange(const CellGrid& cells, const Region& a, const Region& b) {
  const auto& n = cells.grid.size;
  CellBox box{{n[0], n[1], n[2]}, {-1, -1, -1}};
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y) {
      const std::uint8_t *rowA = &a.inside[cells.at(0, y, z)], *rowB = &b.inside[cells.at(0, y, z)];
      if (std::memcmp(rowA, rowB, idx(n[0])) == 0) continue;
      int first = 0, last = n[0] - 1;
      while (rowA[first] == rowB[first]) ++first;
      while (rowA[last] == rowB[last]) --last;
      box.widen({first, y, z});
      box.widen({last, y, z});
    }
  return box;
}

}  // namespace handlebody
