#include "core/handles/shortest_handles.h"

#include <cmath>
#include <limits>
#include <numeric>

#include "core/cancellation.h"
#include "core/handles/handle_enumeration.h"
#include "core/handles/homology.h"
#include "tests/core/handles/handle_loops.h"
#include "tests/core/handles/handle_oracle.h"
#include "tests/support/catch.h"

namespace handlebody {
namespace {

using test::facingRings;
using test::Loops;
using test::randomLoops;
using test::Sizes;

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

std::vector<int> loopOf(const Loops& loops) {
  std::vector<int> out;
  for (std::size_t k = 0; k < loops.size(); ++k)
    out.resize(out.size() + loops[k].size(), static_cast<int>(k));
  return out;
}

Sizes sizesOf(const Loops& loops) {
  Sizes sizes;
  for (const auto& loop : loops) sizes.push_back(static_cast<int>(loop.size()));
  return sizes;
}

//! The edges between loops, each with its smaller vertex first, once per face that holds it that way.
std::vector<VertexPair> crossEdges(const std::vector<int>& loop, const std::vector<Triangle>& faces) {
  std::vector<VertexPair> out;
  for (const Triangle& t : faces)
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] < t[(i + 1) % 3] && loop[t[i]] != loop[t[(i + 1) % 3]]) out.push_back({t[i], t[(i + 1) % 3]});
  std::sort(out.begin(), out.end());
  return out;
}

double lengthOf(const Loops& loops, const std::vector<Triangle>& faces) {
  std::vector<Vec3> points;
  for (const auto& loop : loops) points.insert(points.end(), loop.begin(), loop.end());
  double sum = 0;
  for (const auto& [u, v] : crossEdges(loopOf(loops), faces)) sum += (points[u] - points[v]).norm();
  return sum;
}

Handle sorted(Handle handle) {
  for (Triangle& f : handle) std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  std::sort(handle.begin(), handle.end());
  return handle;
}

std::vector<HandleCandidate> take(ShortestHandles search, std::size_t limit) {
  std::vector<HandleCandidate> out;
  while (out.size() < limit) {
    auto handle = search.next();
    if (!handle) break;
    out.push_back(std::move(*handle));
  }
  return out;
}

//! This part of all edges between loops.
std::vector<VertexPair> longestEdges(const Loops& loops, double part) {
  const std::vector<int> loop = loopOf(loops);
  std::vector<std::pair<double, VertexPair>> edges;
  for (int u = 0; u < static_cast<int>(loop.size()); ++u)
    for (int v = 0; v < u; ++v)
      if (loop[u] != loop[v]) edges.push_back({-lengthOf(loops, {{v, u, v}}), {v, u}});
  std::sort(edges.begin(), edges.end());
  std::vector<VertexPair> out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(part * static_cast<double>(edges.size())); ++i)
    out.push_back(edges[i].second);
  return out;
}

double shortest(const Loops& loops, std::span<const VertexPair> forbidden = {}) {
  return ShortestHandles(loops, forbidden).next().value().length;
}

//! Found in the order of length, each once, with the right length, and exactly those of the list.
void expectEqualsList(const Loops& loops, std::vector<Handle> list) {
  std::vector<Handle> found;
  double last = 0;
  for (const HandleCandidate& h : take(ShortestHandles(loops, {}, kNoLimit), kNoLimit)) {
    REQUIRE(h.length == Approx(lengthOf(loops, h.faces)).epsilon(1e-12));
    REQUIRE(h.length >= last - 1e-9);
    last = h.length;
    found.push_back(sorted(h.faces));
  }
  std::sort(found.begin(), found.end());
  CHECK(found == list);
}

//! The first handles have the lengths of the first of all listed.
void expectFirstOfList(const Loops& loops, const std::vector<Handle>& list, std::size_t count) {
  std::vector<double> lengths;
  for (const Handle& h : list) lengths.push_back(lengthOf(loops, h));
  std::sort(lengths.begin(), lengths.end());
  const auto found = take(ShortestHandles(loops), count);
  REQUIRE(found.size() == std::min(count, list.size()));
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i].length == Approx(lengths[i]).epsilon(1e-12));
}

void expectHandles(const Loops& loops, const std::vector<HandleCandidate>& handles) {
  for (const HandleCandidate& h : handles) {
    const auto whole = withCaps(sizesOf(loops), h.faces);
    CHECK(isSphere(whole));
    CHECK(test::isClosedAndOriented(whole));
  }
}

}  // namespace

TEST_CASE("All handles of two and three loops come out, shortest first", "[handles][shortest]") {
  for (const Sizes& sizes : {Sizes{3, 3}, Sizes{3, 4}, Sizes{4, 3}, Sizes{4, 4}, Sizes{4, 5}, Sizes{5, 5},
                             Sizes{3, 7}, Sizes{3, 3, 3}, Sizes{3, 4, 3}}) {
    const auto list = enumerateHandles(sizes, Family::all);
    for (unsigned seed = 1; seed <= (sizes.size() == 2 ? 5 : 1); ++seed)
      expectEqualsList(randomLoops(sizes, seed), list);
    expectEqualsList(facingRings(sizes, 0.1, 7), list);
  }
}

TEST_CASE("The first handles of three loops are the shortest of all that are listed", "[handles][shortest]") {
  for (const Sizes& sizes : {Sizes{3, 3, 3}, Sizes{3, 3, 4}, Sizes{3, 4, 4}}) {
    const auto list = enumerateHandles(sizes, Family::all);
    for (unsigned seed = 1; seed <= 4; ++seed) {
      expectFirstOfList(randomLoops(sizes, seed), list, 100);
      expectFirstOfList(facingRings(sizes, 0.2, seed), list, 100);
    }
  }
}

TEST_CASE("The first handles of four loops are the shortest of all without the longest edges",
          "[handles][shortest]") {
  // All handles of four loops are tens of millions; those without three tenths of the edges can be listed.
  for (const Sizes& sizes : {Sizes{3, 3, 3, 3}, Sizes{3, 4, 3, 3}}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      CAPTURE(sizes, seed);
      const Loops loops = randomLoops(sizes, seed);
      const auto forbidden = longestEdges(loops, 0.3);
      std::vector<double> lengths;
      forEachHandle(
          sizes, Family::all, [&](const Handle& h) { lengths.push_back(lengthOf(loops, h)); }, forbidden);
      REQUIRE(lengths.size() > 100);
      std::sort(lengths.begin(), lengths.end());
      const auto found = take(ShortestHandles(loops, forbidden, kNoLimit), 100);
      REQUIRE(found.size() == 100);
      for (std::size_t i = 0; i < found.size(); ++i)
        CHECK(found[i].length == Approx(lengths[i]).epsilon(1e-12));
      expectHandles(loops, found);
    }
  }
}

TEST_CASE("Every handle found of three and four loops is a sphere with its caps", "[handles][shortest]") {
  for (const Sizes& sizes : {Sizes{5, 7, 6}, Sizes{12, 9, 14}, Sizes{4, 6, 5, 7}, Sizes{10, 9, 8, 11}}) {
    const Loops loops = facingRings(sizes, 0.2, 3);
    const auto handles = take(ShortestHandles(loops), 20);
    REQUIRE(handles.size() == 20);
    expectHandles(loops, handles);
    const int m = std::accumulate(sizes.begin(), sizes.end(), 0);
    for (const HandleCandidate& h : handles)
      CHECK(h.faces.size() == static_cast<std::size_t>(m) + 2 * sizes.size() - 4);
  }
}

TEST_CASE("Forbidden edges and faces are avoided, and the handle is the shortest of the rest",
          "[handles][shortest]") {
  for (const Sizes& sizes : {Sizes{4, 5}, Sizes{3, 3, 3}}) {
    const auto list = enumerateHandles(sizes, Family::all);
    const Loops loops = randomLoops(sizes, 11);
    std::vector<Triangle> faces;
    std::vector<VertexPair> edges;
    for (int round = 0; round < 6; ++round) {
      ShortestHandles search(loops, edges);
      search.forbid(faces);
      const auto best = search.next();
      std::vector<double> lengths{std::numeric_limits<double>::infinity()};
      for (const Handle& h : list) {
        const auto cross = crossEdges(loopOf(loops), h);
        const bool hasEdge = std::any_of(edges.begin(), edges.end(), [&](const VertexPair& e) {
          return std::binary_search(cross.begin(), cross.end(), e);
        });
        const bool hasFace = std::any_of(faces.begin(), faces.end(), [&](const Triangle& t) {
          return std::binary_search(h.begin(), h.end(), sorted({t})[0]);
        });
        if (!hasEdge && !hasFace) lengths.push_back(lengthOf(loops, h));
      }
      const double expected = *std::min_element(lengths.begin(), lengths.end());
      REQUIRE(best.has_value() == (lengths.size() > 1));
      if (!best) break;
      CHECK(best->length == Approx(expected).epsilon(1e-12));
      if (round % 2 == 0)
        faces.push_back(best->faces.back());
      else
        edges.push_back(crossEdges(loopOf(loops), best->faces)[2]);
    }
  }
}

TEST_CASE("The shortest length does not depend on where the loops start or on their order",
          "[handles][shortest]") {
  for (const Sizes& sizes : {Sizes{8, 11}, Sizes{6, 9, 7}, Sizes{5, 6, 7, 8}}) {
    Loops loops = facingRings(sizes, 0.2, 5);
    const double length = shortest(loops);
    std::rotate(loops[0].begin(), loops[0].begin() + 2, loops[0].end());
    std::rotate(loops[1].begin(), loops[1].begin() + 5, loops[1].end());
    CHECK(shortest(loops) == Approx(length).epsilon(1e-12));
    std::swap(loops[0], loops.back());
    CHECK(shortest(loops) == Approx(length).epsilon(1e-12));
    for (auto& loop : loops) {
      std::reverse(loop.begin(), loop.end());  // the mirror image
      for (Vec3& p : loop) p.z() = -p.z();
    }
    CHECK(shortest(loops) == Approx(length).epsilon(1e-12));
  }
}

TEST_CASE("The same loops give the same handles in the same order", "[handles][shortest]") {
  const Loops loops = facingRings({6, 6, 6, 6}, 0, 1);  // many equal lengths
  const auto one = take(ShortestHandles(loops), 30);
  const auto other = take(ShortestHandles(loops), 30);
  REQUIRE(one.size() == other.size());
  for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i].faces == other[i].faces);
}

TEST_CASE("Facing congruent rings are joined by the straight strip", "[handles][shortest]") {
  // Two rings of 12 on a cylinder, 0.1 apart, the second seen from its own missing side (reversed). Every
  // handle has 24 cross edges; 12 straight ones and 12 shortest diagonals is the least that is possible.
  constexpr int kSize = 12;
  Loops loops(2);
  for (int i = 0; i < kSize; ++i) {
    const double angle = 2 * M_PI * i / kSize;
    loops[0].emplace_back(std::cos(angle), std::sin(angle), 0);
    loops[1].emplace_back(std::cos(-angle), std::sin(-angle), 0.1);
  }
  const double diagonal = (loops[0][0] - loops[1][1]).norm();
  CHECK(shortest(loops) == Approx(kSize * (0.1 + diagonal)));
}

TEST_CASE("Loops too short or not finite have no handle", "[handles][shortest]") {
  Loops loops = randomLoops({5, 2}, 8);
  CHECK(take(ShortestHandles(loops), 1).empty());
  loops = randomLoops({5, 4, 3}, 9);
  CHECK(take(ShortestHandles(loops), 1).size() == 1);
  loops[1][2].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(take(ShortestHandles(loops), 1).empty());
  loops[1][2].x() = std::numeric_limits<double>::infinity();
  CHECK(take(ShortestHandles(loops), 1).empty());
}

TEST_CASE("A search that is cut short says so, and still finds handles in order", "[handles][shortest]") {
  const Loops loops = facingRings({9, 9, 9, 9}, 0.3, 3);
  ShortestHandles search(loops, {}, 10);
  std::vector<HandleCandidate> handles;
  while (handles.size() < 20) handles.push_back(search.next().value());
  CHECK(search.gaveUp());
  expectHandles(loops, handles);
  for (std::size_t i = 1; i < handles.size(); ++i) CHECK(handles[i].length >= handles[i - 1].length - 1e-9);
  CHECK(handles[0].length >= shortest(loops) - 1e-9);
  ShortestHandles all(randomLoops({3, 3}, 3));
  while (all.next()) {
  }
  CHECK_FALSE(all.gaveUp());
}

namespace {

//! The shortest handle of two loops is the shortest closed monotone path over the torus of their edges: one
//! dynamic programme for each edge at the first vertex of the first loop.
double shortestOfTwo(const Loops& loops) {
  const auto n = loops[0].size(), m = loops[1].size();
  const auto length = [&](std::size_t i, std::size_t j) {
    return (loops[0][i % n] - loops[1][(2 * m - j) % m]).norm();  // the loops run against each other
  };
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t start = 0; start < m; ++start) {
    std::vector<double> row(m + 1, std::numeric_limits<double>::infinity());
    row[0] = 0;
    for (std::size_t i = 0; i <= n; ++i)
      for (std::size_t j = 0; j <= m; ++j) {
        const double beside = j > 0 ? row[j - 1] : std::numeric_limits<double>::infinity();
        row[j] = std::min(row[j], beside) + (i + j > 0 ? length(i, start + j) : 0);
      }
    best = std::min(best, row[m]);
  }
  return best;
}

}  // namespace

TEST_CASE("The shortest handle of two long loops is found within the work, and is the shortest of all",
          "[handles][shortest]") {
  for (const Sizes& sizes : {Sizes{9, 7}, Sizes{60, 80}, Sizes{150, 120}}) {
    for (const double noise : {0.2, 2.0}) {
      CAPTURE(sizes, noise);
      const Loops loops = facingRings(sizes, noise, 4);
      ShortestHandles search(loops);
      const auto handle = search.next();
      REQUIRE(handle.has_value());
      CHECK_FALSE(search.gaveUp());
      CHECK(search.workDone() <= ShortestHandles::kMaxWork);
      CHECK(handle->length == Approx(shortestOfTwo(loops)).epsilon(1e-12));
    }
  }
}

TEST_CASE("Of long loops the handle that is found when the search is cut short is within 2 % of the shortest",
          "[handles][shortest]") {
  for (const Sizes& sizes : {Sizes{300, 280}, Sizes{24, 20, 22}, Sizes{14, 12, 13, 15}}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      CAPTURE(sizes, seed);
      const Loops loops = facingRings(sizes, 0.2, seed);
      ShortestHandles cut(loops, {}, 1000);
      const auto handle = cut.next();
      REQUIRE(handle.has_value());
      CHECK(cut.gaveUp());
      CHECK(handle->length <= 1.02 * ShortestHandles(loops, {}, 1'000'000'000).next().value().length);
    }
  }
}

TEST_CASE("Edges forbidden on the way are as those forbidden from the start", "[handles][shortest]") {
  for (const Sizes& sizes : {Sizes{12, 15}, Sizes{7, 8, 6}}) {
    const Loops loops = facingRings(sizes, 0.2, 9);
    ShortestHandles search(loops);
    std::vector<VertexPair> forbidden;
    double last = 0;
    for (int round = 0; round < 8; ++round) {
      const HandleCandidate handle = search.next().value();
      CHECK(handle.length == Approx(shortest(loops, forbidden)).epsilon(1e-12));
      CHECK(handle.length >= last - 1e-9);
      last = handle.length;
      const std::vector<VertexPair> more{crossEdges(loopOf(loops), handle.faces)[round]};
      forbidden.push_back(more[0]);
      search.forbid({}, more);
    }
  }
}

TEST_CASE("A search gives up when it is cancelled", "[handles][shortest]") {
  ShortestHandles search(facingRings({30, 30}, 0.2, 1));
  const std::atomic<bool> cancelled{true};
  const CancelScope scope(cancelled);
  CHECK_THROWS_AS(search.next(), Cancelled);
}

}  // namespace handlebody
