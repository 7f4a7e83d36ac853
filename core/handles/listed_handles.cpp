#include "core/handles/listed_handles.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include "core/handles/handle_database.h"
#include "core/handles/handle_sizes.h"

namespace handlebody {

namespace {

// Of a length. Sums of the same few dozen edges in another order differ by less than 100 roundings of 1e-16.
constexpr double kAsShort = 1e-12;

//! The stored sizes of two loops, ascending, of which all handles are listed.
using Lists = std::map<std::vector<int>, std::vector<Handle>>;

const Lists& lists() {
  static const Lists all = [] {
    Lists out;
    for (const StoredHandles& entry : HandleDatabase::stored().entries())
      if (entry.family == Family::all && entry.sizes.size() == 2) out.emplace(entry.sizes, expand(entry));
    return out;
  }();
  return all;
}

//! Each edge between the loops has two faces, which hold it in the two directions. `number`: of each vertex
//! of the list.
double lengthOf(const Handle& listed, const std::vector<int>& number, const CrossEdges& edges) {
  double sum = 0;
  for (const Triangle& f : listed) {
    const Triangle face{number[idx(f[0])], number[idx(f[1])], number[idx(f[2])]};
    if (!edges.allows(face)) return CrossEdges::kNone;
    for (std::size_t i = 0; i < 3; ++i) {
      const int u = face[i], v = face[(i + 1) % 3];
      if (edges.loopOf(u) < edges.loopOf(v)) sum += edges.length(u, v);
    }
  }
  return sum;
}

//! A lower bound of all triangulations that have an edge uv twice: between the two, u is joined to all of the
//! loop of v, and v to all of the loop of u.
double shortestWithEdgeTwice(const CrossEdges& edges) {
  double sum = 0;
  for (int loop = 0; loop < 2; ++loop) {
    double least = CrossEdges::kNone;
    for (int u = edges.firstOf(loop); u < edges.firstOf(loop + 1); ++u) {
      double fan = 0;
      for (int v = edges.firstOf(1 - loop); v < edges.firstOf(2 - loop); ++v) fan += edges.length(u, v);
      least = std::min(least, fan);
    }
    sum += least;
  }
  return sum;
}

}  // namespace

std::optional<Handle> shortestListed(const CrossEdges& edges) {
  if (edges.loopCount() != 2) return std::nullopt;
  const int first = edges.firstOf(1), second = edges.vertexCount() - first;
  const auto list = lists().find({std::min(first, second), std::max(first, second)});
  if (list == lists().end()) return std::nullopt;
  // The list has the smaller loop first.
  std::vector<int> number(idx(edges.vertexCount()));
  std::iota(number.begin(), number.end(), 0);
  if (first > second) std::rotate(number.begin(), number.begin() + first, number.end());
  const Handle* best = nullptr;
  double least = CrossEdges::kNone, next = shortestWithEdgeTwice(edges);
  for (const Handle& listed : list->second) {
    const double length = lengthOf(listed, number, edges);
    next = std::min(next, std::max(length, least));
    if (length >= least) continue;
    least = length;
    best = &listed;
  }
  if (!best || next <= least * (1 + kAsShort)) return std::nullopt;
  Handle out = *best;
  for (Triangle& f : out)
    for (int& v : f) v = number[idx(v)];
  return normalised(std::move(out));
}

}  // namespace handlebody
