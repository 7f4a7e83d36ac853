#include "core/solid/cell_cases.h"

#include <algorithm>

namespace handlebody {

namespace {

constexpr int kNone = -1;

int axisBit(int axis) { return 1 << (axis % 3); }

//! The edge between two corners beside each other.
int edgeBetween(int a, int b) {
  const int axis = (a ^ b) >> 1;  // 1, 2, 4 → 0, 1, 2
  return cellEdge(std::min(a, b), axis);
}

//! The corners of a side, counter-clockwise seen from outside of the cell.
std::array<int, 4> sideCorners(int axis, int upper) {
  const int base = upper * axisBit(axis), b = axisBit(axis + 1), c = axisBit(axis + 2);
  if (upper == 1) return {base, base + b, base + b + c, base + c};
  return {base, base + c, base + b + c, base + b};
}

//! Per crossed edge the one that follows it around the object's part. Two inside corners of a side that are
//! diagonal to each other are kept apart: the object is 6-connected.
std::array<int, 12> successors(int inside) {
  std::array<int, 12> next{};
  next.fill(kNone);
  for (int axis = 0; axis < 3; ++axis)
    for (int upper = 0; upper < 2; ++upper) {
      const auto corner = sideCorners(axis, upper);
      const auto in = [&](std::size_t i) { return (inside >> corner[i % 4] & 1) != 0; };
      for (std::size_t i = 0; i < 4; ++i) {
        if (in(i) || !in(i + 1)) continue;  // not where a run of inside corners begins
        std::size_t end = i + 1;
        while (in(end + 1)) ++end;
        next[edgeBetween(corner[i], corner[(i + 1) % 4])] =
            edgeBetween(corner[end % 4], corner[(end + 1) % 4]);
      }
    }
  return next;
}

std::vector<std::vector<int>> loopsOf(int inside) {
  std::array<int, 12> next = successors(inside);
  std::vector<std::vector<int>> loops;
  for (int start = 0; start < 12; ++start) {
    std::vector<int> loop;
    for (int e = start; next[e] != kNone;) {
      loop.push_back(e);
      const int following = next[e];
      next[e] = kNone;
      e = following;
    }
    if (!loop.empty()) loops.push_back(loop);
  }
  return loops;
}

//! True if all corners but two at the ends of a diagonal of the cell are inside. Those two are connected (the
//! background is 26-connected), and the object around them is a ring.
bool isRing(int inside) {
  for (int corner = 0; corner < 4; ++corner)
    if ((inside ^ 0xFF) == (1 << corner | 1 << (7 - corner))) return true;
  return false;
}

//! The band between two triangles around opposite corners: every edge of one is joined with the point of the
//! other that lies along the third axis.
void addBand(const std::vector<int>& from, const std::vector<int>& to, CellCase& made) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int a = from[i], b = from[(i + 1) % 3], third = 3 - a / 4 - b / 4;
    const auto apex = std::find_if(to.begin(), to.end(), [third](int e) { return e / 4 == third; });
    made.triangles.push_back({a, b, *apex});
  }
}

CellCase caseOf(int inside) {
  CellCase made;
  const auto loops = loopsOf(inside);
  if (isRing(inside)) {
    addBand(loops[0], loops[1], made);
    addBand(loops[1], loops[0], made);
    return made;
  }
  for (const auto& loop : loops) {
    if (loop.size() > 4) {
      made.fans.push_back(loop);
      continue;
    }
    for (std::size_t i = 2; i < loop.size(); ++i) made.triangles.push_back({loop[0], loop[i - 1], loop[i]});
  }
  return made;
}

}  // namespace

int cellEdge(int corner, int axis) {
  return 4 * axis + ((corner & axisBit(axis + 1)) != 0 ? 1 : 0) + ((corner & axisBit(axis + 2)) != 0 ? 2 : 0);
}

int cellEdgeStart(int edge) {
  const int axis = edge / 4;
  return ((edge & 1) != 0 ? axisBit(axis + 1) : 0) + ((edge & 2) != 0 ? axisBit(axis + 2) : 0);
}

const std::array<CellCase, 256>& cellCases() {
  static const std::array<CellCase, 256> cases = [] {
    std::array<CellCase, 256> all;
    for (std::size_t inside = 0; inside < 256; ++inside) all[inside] = caseOf(static_cast<int>(inside));
    return all;
  }();
  return cases;
}

}  // namespace handlebody
