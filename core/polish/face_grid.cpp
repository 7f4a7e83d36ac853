#include "core/polish/face_grid.h"

#include <algorithm>
#include <cmath>

#include "core/indices.h"

namespace handlebody {

namespace {

constexpr int kFinest = -40;       // 2^-40 mm: points
constexpr double kMaxCells = 512;  // above that all faces of a level are looked at

}  // namespace

std::size_t FaceGrid::Hash::operator()(const Cell& c) const {
  const auto u = [](int i) { return static_cast<std::size_t>(static_cast<unsigned>(i)); };
  return u(c[0]) * 73856093U ^ u(c[1]) * 19349663U ^ u(c[2]) * 83492791U;
}

double FaceGrid::Range::count() const {
  double n = 1;
  for (std::size_t a = 0; a < 3; ++a) n *= static_cast<double>(high[a]) - low[a] + 1;
  return n;
}

//! Cells at least as large as the box, so that it meets eight at most; and so large that their numbers are
//! integers.
int FaceGrid::levelOf(const Box& box) {
  const double far = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  const double size = std::max((box.high - box.low).maxCoeff(), std::ldexp(far, -28));
  return size > 0 ? std::max(kFinest, static_cast<int>(std::ceil(std::log2(size)))) : kFinest;
}

FaceGrid::Range FaceGrid::rangeOf(const Box& box, int level) {
  Range range{};
  const double size = std::ldexp(1.0, level);
  constexpr double kMaxCell = 1 << 30;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<int>(a);
    range.low[a] = static_cast<int>(std::clamp(std::floor(box.low[axis] / size), -kMaxCell, kMaxCell));
    range.high[a] = static_cast<int>(std::clamp(std::floor(box.high[axis] / size), -kMaxCell, kMaxCell));
  }
  return range;
}

template <typename F>
void FaceGrid::forEachCell(const Range& range, F&& f) {
  for (int x = range.low[0]; x <= range.high[0]; ++x)
    for (int y = range.low[1]; y <= range.high[1]; ++y)
      for (int z = range.low[2]; z <= range.high[2]; ++z) f(Cell{x, y, z});
}

void FaceGrid::add(int face, const Box& box) {
  const int level = levelOf(box);
  Cells& cells = levels_[level];
  forEachCell(rangeOf(box, level), [&](const Cell& c) { cells[c].push_back(face); });
}

void FaceGrid::remove(int face, const Box& box) {
  const int level = levelOf(box);
  Cells& cells = levels_[level];
  forEachCell(rangeOf(box, level), [&](const Cell& c) { std::erase(cells[c], face); });
}

void FaceGrid::findNear(const Box& box, std::vector<int>& found) const {
  found.clear();
  const auto take = [&](const std::vector<int>& faces) {
    found.insert(found.end(), faces.begin(), faces.end());
  };
  for (const auto& [level, cells] : levels_) {
    const Range range = rangeOf(box, level);
    if (range.count() > kMaxCells) {
      for (const auto& [cell, faces] : cells) {
        bool meets = true;
        for (std::size_t a = 0; a < 3; ++a)
          meets = meets && cell[a] >= range.low[a] && cell[a] <= range.high[a];
        if (meets) take(faces);
      }
      continue;
    }
    forEachCell(range, [&, &here = cells](const Cell& c) {
      if (const auto at = here.find(c); at != here.end()) take(at->second);
    });
  }
  sortUnique(found);
}

}  // namespace handlebody
