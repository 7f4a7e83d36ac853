#include "core/handles/two_front_handle.h"

#include <cmath>
#include <limits>
#include <random>

#include "tests/core/handles/handle_oracle.h"
#include "tests/support/catch.h"

namespace handlebody {
namespace {

using test::allStrips;
using test::crossPairs;
using test::hasRepeatedPair;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr int kNoLimit = 1000;

std::vector<Vec3> randomLoop(int size, std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Vec3> loop;
  for (int i = 0; i < size; ++i) {
    const double x = coordinate(random);
    const double y = coordinate(random);
    loop.emplace_back(x, y, coordinate(random));
  }
  return loop;
}

double sumOfLengths(const std::vector<LoopPair>& pairs, const std::vector<Vec3>& first,
                    const std::vector<Vec3>& second) {
  double sum = 0;
  for (const LoopPair& pair : pairs) {
    sum += (first[static_cast<std::size_t>(pair[0])] - second[static_cast<std::size_t>(pair[1])]).norm();
  }
  return sum;
}

struct Shortest {
  double simplicial = kInfinite;
  double any = kInfinite;  // strips that join a pair twice included
};

Shortest bruteForce(const std::vector<Vec3>& first, const std::vector<Vec3>& second, int start,
                    const std::vector<LoopPair>& forbidden) {
  Shortest shortest;
  const int p = static_cast<int>(first.size());
  for (const auto& strip : allStrips(p, static_cast<int>(second.size()), start)) {
    const auto pairs = crossPairs(strip, p);
    const bool allowed = std::none_of(forbidden.begin(), forbidden.end(), [&](const LoopPair& pair) {
      return std::binary_search(pairs.begin(), pairs.end(), pair);
    });
    if (!allowed) continue;
    const double length = sumOfLengths(pairs, first, second);
    shortest.any = std::min(shortest.any, length);
    if (!hasRepeatedPair(pairs)) shortest.simplicial = std::min(shortest.simplicial, length);
  }
  return shortest;
}

//! The apex of the face on the edge (0, 1) of the first loop, as an index into the second.
int apexOfFirstEdge(const HandleCandidate& handle, int p) {
  for (const Triangle& f : handle.faces) {
    if (f[0] == 0 && f[1] == 1) return f[2] - p;
  }
  return -1;
}

//! Checks every candidate against the shortest strip of its class; returns how many classes have one.
int compareWithBruteForce(const std::vector<Vec3>& first, const std::vector<Vec3>& second,
                          const std::vector<LoopPair>& forbidden) {
  const auto handles = bestTwoFrontHandles(first, second, kNoLimit, forbidden);
  const int p = static_cast<int>(first.size());
  std::vector<double> found(second.size(), kInfinite);
  for (const HandleCandidate& handle : handles) {
    const auto pairs = crossPairs(handle.faces, p);
    CHECK_FALSE(hasRepeatedPair(pairs));
    CHECK(handle.length == Approx(sumOfLengths(pairs, first, second)));
    found.at(static_cast<std::size_t>(apexOfFirstEdge(handle, p))) = handle.length;
  }
  for (std::size_t start = 0; start < second.size(); ++start) {
    const double expected = bruteForce(first, second, static_cast<int>(start), forbidden).simplicial;
    if (expected == kInfinite) {
      CHECK(found[start] == kInfinite);
    } else {
      CHECK(found[start] == Approx(expected).epsilon(1e-12));
    }
  }
  return static_cast<int>(handles.size());
}

const std::vector<Triangle> kOctahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1},
                                           {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};
const std::vector<Triangle> kTetrahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};

std::vector<Triangle> shifted(const std::vector<Triangle>& faces, int by) {
  std::vector<Triangle> result;
  for (const Triangle& f : faces) result.push_back({f[0] + by, f[1] + by, f[2] + by});
  return result;
}

//! Takes the faces around a vertex out; returns the loop in the direction in which they held its edges,
//! which is how the boundary runs when seen from the missing side.
std::vector<int> open(std::vector<Triangle>& faces, int centre) {
  std::map<int, int> following;
  std::vector<Triangle> kept;
  for (const Triangle& f : faces) {
    const auto at = std::find(f.begin(), f.end(), centre);
    if (at == f.end()) {
      kept.push_back(f);
    } else {
      const auto k = static_cast<std::size_t>(at - f.begin());
      following[f[(k + 1) % 3]] = f[(k + 2) % 3];
    }
  }
  faces = kept;
  std::vector<int> loop{following.begin()->first};
  while (following.at(loop.back()) != loop.front()) loop.push_back(following.at(loop.back()));
  return loop;
}

std::vector<Triangle> closed(std::vector<Triangle> faces, std::vector<int> loops,
                             const HandleCandidate& handle) {
  for (const Triangle& f : handle.faces) {
    Triangle g{};
    for (std::size_t k = 0; k < 3; ++k) g[k] = loops.at(static_cast<std::size_t>(f[k]));
    faces.push_back(g);
  }
  return faces;
}

}  // namespace

TEST_CASE("A handle joins two opened spheres to one sphere with consistent orientation", "[handles]") {
  std::mt19937 random(1);
  std::vector<Triangle> faces = kOctahedron;
  const std::vector<Triangle> other = shifted(kTetrahedron, 6);
  faces.insert(faces.end(), other.begin(), other.end());
  std::vector<int> loops = open(faces, 0);
  const std::vector<int> second = open(faces, 6);
  loops.insert(loops.end(), second.begin(), second.end());
  const auto handles = bestTwoFrontHandles(randomLoop(4, random), randomLoop(3, random), kNoLimit);
  REQUIRE(handles.size() == 3);
  for (const HandleCandidate& handle : handles) {
    const auto whole = closed(faces, loops, handle);
    CHECK(test::isClosedAndOriented(whole));
    CHECK(test::eulerNumber(whole) == 2);
  }
}

TEST_CASE("A handle between two openings of one sphere makes a torus", "[handles]") {
  // Two octahedra joined first, so that the two openings have no edge in common.
  std::mt19937 random(2);
  std::vector<Triangle> faces = kOctahedron;
  const std::vector<Triangle> other = shifted(kOctahedron, 6);
  faces.insert(faces.end(), other.begin(), other.end());
  std::vector<int> loops = open(faces, 0);
  std::vector<int> second = open(faces, 6);
  loops.insert(loops.end(), second.begin(), second.end());
  const auto bridge = bestTwoFrontHandles(randomLoop(4, random), randomLoop(4, random), 1);
  faces = closed(faces, loops, bridge.at(0));
  // Subdivide the two far poles' stars so that the new loops are free of the old bridge's vertices.
  const auto inset = [&](int pole, int next) {
    std::vector<int> ring = open(faces, pole);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const int n = static_cast<int>(ring.size());
      const int k = static_cast<int>(i);
      const int after = (k + 1) % n;
      faces.push_back({ring[i], ring[static_cast<std::size_t>(after)], next + k});
      faces.push_back({ring[static_cast<std::size_t>(after)], next + after, next + k});
    }
    ring.clear();
    for (int k = 0; k < 4; ++k) ring.push_back(next + k);
    return ring;
  };
  loops = inset(5, 20);
  second = inset(11, 30);
  loops.insert(loops.end(), second.begin(), second.end());
  const auto handles = bestTwoFrontHandles(randomLoop(4, random), randomLoop(4, random), kNoLimit);
  REQUIRE(handles.size() == 4);
  for (const HandleCandidate& handle : handles) {
    const auto whole = closed(faces, loops, handle);
    CHECK(test::isClosedAndOriented(whole));
    CHECK(test::eulerNumber(whole) == 0);
  }
}

TEST_CASE("The best handles are the shortest of all strips with the same first apex", "[handles]") {
  std::mt19937 random(3);
  for (int p = 3; p <= 6; ++p) {
    for (int q = 3; q <= 6; ++q) {
      for (int round = 0; round < 4; ++round) {
        CHECK(compareWithBruteForce(randomLoop(p, random), randomLoop(q, random), {}) == q);
      }
    }
  }
}

TEST_CASE("Forbidden pairs are never joined, and the handle is the shortest of the rest", "[handles]") {
  std::mt19937 random(4);
  std::bernoulli_distribution isForbidden(0.25);
  int some = 0;
  int fewer = 0;
  for (int round = 0; round < 200; ++round) {
    const int p = 3 + round % 3;
    const int q = 3 + round / 3 % 3;
    std::vector<LoopPair> forbidden;
    for (int i = 0; i < p; ++i) {
      for (int j = 0; j < q; ++j) {
        if (isForbidden(random)) forbidden.push_back({i, j});
      }
    }
    const int classes = compareWithBruteForce(randomLoop(p, random), randomLoop(q, random), forbidden);
    some += classes > 0 ? 1 : 0;
    fewer += classes < q ? 1 : 0;
  }
  CHECK(some > 0);
  CHECK(fewer > 0);
}

TEST_CASE("No handle is found when a vertex may not be joined to anything", "[handles]") {
  std::mt19937 random(5);
  const std::vector<LoopPair> forbidden = {{1, 0}, {1, 1}, {1, 2}, {1, 3}};
  CHECK(bestTwoFrontHandles(randomLoop(5, random), randomLoop(4, random), kNoLimit, forbidden).empty());
}

TEST_CASE("A strip that would join a pair twice is refused even where it is the shortest", "[handles]") {
  // One vertex of each loop lies between the other loops' rests: two fans around them are shortest.
  const std::vector<Vec3> first = {{0, 0, 0}, {1, 0, 0}, {1, 0.1, 0}, {1, 0.2, 0}};
  const std::vector<Vec3> second = {{0, 0, 0.1}, {-1, 0, 0}, {-1, 0.1, 0}, {-1, 0.2, 0}};
  int refused = 0;
  for (int start = 0; start < 4; ++start) {
    const Shortest shortest = bruteForce(first, second, start, {});
    refused += shortest.any < shortest.simplicial - 1e-9 ? 1 : 0;
  }
  CHECK(refused > 0);
  CHECK(compareWithBruteForce(first, second, {}) == 4);
}

TEST_CASE("Handles come shortest first, distinct, and no more than the limit", "[handles]") {
  std::mt19937 random(6);
  const auto first = randomLoop(9, random);
  const auto second = randomLoop(17, random);
  const auto all = bestTwoFrontHandles(first, second, kNoLimit);
  REQUIRE(all.size() == 17);
  std::set<std::vector<LoopPair>> distinct;
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i].faces.size() == 26);
    if (i > 0) CHECK(all[i - 1].length <= all[i].length);
    distinct.insert(crossPairs(all[i].faces, 9));
  }
  CHECK(distinct.size() == all.size());
  const auto few = bestTwoFrontHandles(first, second, 5);
  REQUIRE(few.size() == 5);
  for (std::size_t i = 0; i < few.size(); ++i) CHECK(few[i].faces == all[i].faces);
  CHECK(bestTwoFrontHandles(first, second, 0).empty());
}

TEST_CASE("The shortest length does not depend on where the loops start or which is first", "[handles]") {
  std::mt19937 random(7);
  auto first = randomLoop(8, random);
  auto second = randomLoop(11, random);
  const double length = bestTwoFrontHandles(first, second, 1).at(0).length;
  CHECK(bestTwoFrontHandles(second, first, 1).at(0).length == Approx(length).epsilon(1e-12));
  std::rotate(first.begin(), first.begin() + 3, first.end());
  std::rotate(second.begin(), second.begin() + 5, second.end());
  CHECK(bestTwoFrontHandles(first, second, 1).at(0).length == Approx(length).epsilon(1e-12));
}

TEST_CASE("Facing congruent rings are joined by the straight strip", "[handles]") {
  // Two rings of 12 on a cylinder, 0.1 apart, the second seen from its own missing side (reversed). Every
  // handle has 24 cross edges; 12 straight ones and 12 shortest diagonals is the least that is possible.
  constexpr int kSize = 12;
  constexpr double kPi = 3.14159265358979323846;
  std::vector<Vec3> first;
  std::vector<Vec3> second;
  for (int i = 0; i < kSize; ++i) {
    const double angle = 2 * kPi * i / kSize;
    first.emplace_back(std::cos(angle), std::sin(angle), 0);
    second.emplace_back(std::cos(-angle), std::sin(-angle), 0.1);
  }
  const double diagonal = (first[0] - second[1]).norm();
  CHECK(bestTwoFrontHandles(first, second, 1).at(0).length == Approx(kSize * (0.1 + diagonal)));
}

TEST_CASE("Loops too short or not finite have no handle", "[handles]") {
  std::mt19937 random(8);
  auto loop = randomLoop(5, random);
  CHECK(bestTwoFrontHandles(loop, randomLoop(2, random), 1).empty());
  CHECK(bestTwoFrontHandles({}, loop, 1).empty());
  const auto other = randomLoop(4, random);
  loop[2].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(bestTwoFrontHandles(loop, other, 1).empty());
  loop[2].x() = kInfinite;
  CHECK(bestTwoFrontHandles(loop, other, 1).empty());
}

}  // namespace handlebody
