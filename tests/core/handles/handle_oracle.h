#pragma once
// Brute force for handles of two loops: every strip, by every order of its faces.

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody::test {

//! How often each directed edge occurs in the faces.
inline std::map<std::array<int, 2>, int> directedEdges(const std::vector<Triangle>& faces) {
  std::map<std::array<int, 2>, int> count;
  for (const Triangle& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) ++count[{f[k], f[(k + 1) % 3]}];
  }
  return count;
}

//! Every directed edge once, and its reverse once: closed, oriented, no edge with more than two faces.
inline bool isClosedAndOriented(const std::vector<Triangle>& faces) {
  const auto edges = directedEdges(faces);
  return std::all_of(edges.begin(), edges.end(), [&](const auto& entry) {
    return entry.second == 1 && edges.count({entry.first[1], entry.first[0]}) == 1;
  });
}

//! Vertices less edges plus faces.
inline int eulerNumber(const std::vector<Triangle>& faces) {
  std::set<int> vertices;
  std::set<std::array<int, 2>> edges;
  for (const Triangle& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      vertices.insert(f[k]);
      edges.insert({std::min(f[k], f[(k + 1) % 3]), std::max(f[k], f[(k + 1) % 3])});
    }
  }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + static_cast<int>(faces.size());
}

//! Pairs (vertex of the first loop, vertex of the second) that the handle joins, one entry per face that
//! runs from the first loop to the second along the pair: a pair that occurs twice is entered twice.
inline std::vector<std::array<int, 2>> crossPairs(const std::vector<Triangle>& faces, int p) {
  std::vector<std::array<int, 2>> pairs;
  for (const Triangle& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = f[k];
      const int b = f[(k + 1) % 3];
      if (a < p && b >= p) pairs.push_back({a, b - p});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

inline bool hasRepeatedPair(const std::vector<std::array<int, 2>>& pairs) {
  return std::adjacent_find(pairs.begin(), pairs.end()) != pairs.end();
}

//! All strips between loops of p and q vertices whose face on the edge (0, 1) of the first has the apex
//! `start` of the second, those that join a pair twice included.
inline std::vector<std::vector<Triangle>> allStrips(int p, int q, int start) {
  std::vector<bool> up(p + q - 1, false);
  std::fill(up.end() - q, up.end(), true);
  std::vector<std::vector<Triangle>> strips;
  do {
    std::vector<Triangle> faces{{0, 1, p + start}};
    int i = 1;
    int j = start;
    for (const bool step : up) {
      if (step) {
        const int below = (j + q - 1) % q;
        faces.push_back({p + below, p + j, i % p});
        j = below;
      } else {
        faces.push_back({i, (i + 1) % p, p + j});
        ++i;
      }
    }
    strips.push_back(faces);
  } while (std::next_permutation(up.begin(), up.end()));
  return strips;
}

}  // namespace handlebody::test
