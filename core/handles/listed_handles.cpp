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

struct Listed {
  Handle faces;
  std::vector<int> edges;  // between the loops: numbers in a table with a row for each vertex of the smaller
};

//! Each edge between the loops has two faces, which hold it in the two directions.
std::vector<int> edgesBetween(const Handle& handle, int smaller, int larger) {
  std::vector<int> out;
  for (const Triangle& f : handle)
    for (std::size_t i = 0; i < 3; ++i) {
      const int u = f[i], v = f[(i + 1) % 3];
      if (u < smaller && v >= smaller) out.push_back(u * larger + v - smaller);
    }
  return out;
}

//! The stored sizes of two loops, ascending, of which all handles are listed.
using Lists = std::map<std::vector<int>, std::vector<Listed>>;

const Lists& lists() {
  static const Lists all = [] {
    Lists out;
    for (const StoredHandles& entry : HandleDatabase::stored().entries()) {
      if (entry.family != Family::all || entry.sizes.size() != 2) continue;
      std::vector<Listed>& list = out[entry.sizes];
      for (Handle& handle : expand(entry)) {
        std::vector<int> edges = edgesBetween(handle, entry.sizes[0], entry.sizes[1]);
        list.push_back({std::move(handle), std::move(edges)});
      }
    }
    return out;
  }();
  return all;
}

//! The edges of a call, by the numbers of the list, whose smaller loop is the first.
class Lengths {
 public:
  explicit Lengths(const CrossEdges& edges) : edges_(edges), number_(idx(edges.vertexCount())) {
    const int first = edges.firstOf(1), second = edges.vertexCount() - first;
    std::iota(number_.begin(), number_.end(), 0);
    if (first > second) std::rotate(number_.begin(), number_.begin() + first, number_.end());
    const auto larger = number_.begin() + std::min(first, second);
    for (auto u = number_.begin(); u != larger; ++u)
      for (auto v = larger; v != number_.end(); ++v) length_.push_back(edges.length(*u, *v));
  }
  //! kNone if the handle is forbidden or longer than the limit.
  double of(const Listed& listed, double limit) const {
    double sum = 0;
    for (const int edge : listed.edges) {
      sum += length_[edge];
      if (sum > limit) return CrossEdges::kNone;
    }
    if (!edges_.anyFaceForbidden()) return sum;
    const bool isAllowed = std::all_of(listed.faces.begin(), listed.faces.end(),
                                       [&](const Triangle& f) { return edges_.allows(renumbered(f)); });
    return isAllowed ? sum : CrossEdges::kNone;
  }
  Handle renumbered(const Handle& listed) const {
    Handle out;
    for (const Triangle& f : listed) out.push_back(renumbered(f));
    return normalised(std::move(out));
  }

 private:
  Triangle renumbered(const Triangle& f) const { return {number_[f[0]], number_[f[1]], number_[f[2]]}; }
  const CrossEdges& edges_;
  std::vector<int> number_;  // of each vertex of the list
  std::vector<double> length_;
};

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
  const Lengths lengths(edges);
  const Listed* best = nullptr;
  double least = CrossEdges::kNone, next = shortestWithEdgeTwice(edges);
  for (const Listed& listed : list->second) {
    const double length = lengths.of(listed, next);
    next = std::min(next, std::max(length, least));
    if (length >= least) continue;
    least = length;
    best = &listed;
  }
  const bool isTold = best && next > least * (1 + kAsShort);
  return isTold ? std::optional(lengths.renumbered(best->faces)) : std::nullopt;
}

}  // namespace handlebody
