// The handle database against the search: the same choice to the last bit.

#include "core/handles/listed_handles.h"

#include <random>

#include "core/handles/shortest_handles.h"
#include "tests/core/handles/handle_loops.h"
#include "tests/support/catch.h"

namespace handlebody {
namespace {

using test::facingRings;
using test::Loops;
using test::randomLoops;
using test::Sizes;

std::vector<Sizes> storedSizes() {
  std::vector<Sizes> out;
  for (int first = 3; first <= 6; ++first)
    for (int second = 3; second <= 6; ++second) out.push_back({first, second});
  return out;
}

//! Polygons that face each other across a gap that is small beside them, as fronts that collide do.
Loops facingFronts(const Sizes& sizes, double turn, double noise, unsigned seed) {
  std::mt19937 random(seed);
  const auto coordinate = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  Loops loops(2);
  for (std::size_t k = 0; k < 2; ++k)
    for (int i = 0; i < sizes[k]; ++i) {
      const double angle = (k == 0 ? 1 : -1) * 2 * M_PI * i / sizes[k] + (k == 0 ? turn : 0);
      const double x = coordinate(), y = coordinate();
      loops[k].push_back(Vec3(std::cos(angle), std::sin(angle), k == 0 ? 0 : 0.4) +
                         noise * Vec3(x, y, coordinate()));
    }
  return loops;
}

//! Of the questions that begin a search.
struct Told {
  int byDatabase = 0, bySearch = 0;
};

//! Forbids a random face or edge of the handle; false: nothing.
bool forbidSome(const HandleCandidate& handle, std::mt19937& random,
                const std::vector<ShortestHandles*>& searches) {
  const Triangle face = handle.faces[random() % handle.faces.size()];
  const std::vector<VertexPair> edge{{face[0], face[1]}};
  const auto what = random() % 3;
  for (ShortestHandles* search : searches) {
    if (what == 0) search->forbid(std::vector<Triangle>{face});
    if (what == 1) search->forbid({}, edge);
  }
  return what < 2;
}

//! Handle after handle, as when the ones before do not fit.
Told expectSameHandles(const Loops& loops, unsigned seed, std::size_t maxWork = ShortestHandles::kMaxWork) {
  std::mt19937 random(seed);
  Told told;
  ShortestHandles asked(loops, {}, maxWork), searched(loops, {}, maxWork);
  bool begins = true;
  for (int tries = 0; tries < 12; ++tries) {
    auto handle = asked.nextListed();
    if (begins) handle ? ++told.byDatabase : ++told.bySearch;
    if (!handle) handle = asked.next();
    const auto expected = searched.next();
    REQUIRE(handle.has_value() == expected.has_value());
    REQUIRE(asked.workDone() == searched.workDone());
    REQUIRE(asked.gaveUp() == searched.gaveUp());
    if (!handle) break;
    REQUIRE(handle->faces == expected->faces);
    REQUIRE(handle->length == expected->length);
    begins = forbidSome(*handle, random, {&asked, &searched});
  }
  return told;
}

}  // namespace

TEST_CASE(
    "The database tells the handle that the search finds, to the bit, with what is forbidden on the way",
    "[handles][database]") {
  for (const Sizes& sizes : storedSizes()) {
    CAPTURE(sizes);
    Told fronts;
    for (unsigned seed = 1; seed <= 40; ++seed) {
      CAPTURE(seed);
      expectSameHandles(randomLoops(sizes, seed), seed);
      expectSameHandles(facingRings(sizes, 0.1, seed), seed);
      const Told told = expectSameHandles(facingFronts(sizes, 0.37 * seed, 0.1, seed), seed);
      fronts.byDatabase += told.byDatabase;
      fronts.bySearch += told.bySearch;
    }
    CHECK(fronts.byDatabase > fronts.bySearch);
  }
}

TEST_CASE("Of handles of equal length the database tells none, and the search's order decides",
          "[handles][database]") {
  for (const Sizes& sizes : storedSizes()) {
    CAPTURE(sizes);
    const Loops straight = facingFronts(sizes, 0, 0, 1);
    for (unsigned seed = 1; seed <= 10; ++seed) {
      expectSameHandles(straight, seed);
      expectSameHandles(facingFronts(sizes, M_PI / 6, 0, 1), seed);
      expectSameHandles(facingRings(sizes, 0, 1), seed);
    }
    if (sizes[0] == sizes[1]) CHECK_FALSE(ShortestHandles(straight).nextListed());  // either diagonal
  }
  const Loops points(2, std::vector<Vec3>(4, Vec3(0, 0, 0)));  // all of them
  CHECK_FALSE(ShortestHandles(points).nextListed());
  expectSameHandles(points, 1);
}

TEST_CASE("Where a vertex is beside all of the other loop, what has an edge twice is not taken for a handle",
          "[handles][database]") {
  for (const Sizes& sizes : storedSizes()) {
    CAPTURE(sizes);
    for (unsigned seed = 1; seed <= 20; ++seed) {
      Loops loops = randomLoops(sizes, seed);
      for (Vec3& p : loops[1]) p *= 1e-3;
      for (std::size_t i = 1; i < loops[0].size(); ++i) loops[0][i] *= 10;
      loops[0][0] *= 0.01;
      expectSameHandles(loops, seed);
    }
  }
}

TEST_CASE("Where the work is cut short, the database tells nothing else than the search",
          "[handles][database]") {
  for (std::size_t maxWork = 1; maxWork < 4000; maxWork += 37)
    expectSameHandles(randomLoops({5, 6}, static_cast<unsigned>(maxWork)), 3, maxWork);
}

TEST_CASE("The database tells no handle of loops whose handles are not all listed", "[handles][database]") {
  for (const Sizes& sizes : {Sizes{3, 7}, Sizes{7, 7}, Sizes{3, 3, 3}, Sizes{3, 4, 5}, Sizes{3, 3, 4, 4}})
    CHECK_FALSE(ShortestHandles(randomLoops(sizes, 5)).nextListed());
  CHECK(ShortestHandles(randomLoops({6, 5}, 5)).nextListed());
}

TEST_CASE("Once the search goes on, the database is not asked before something is forbidden",
          "[handles][database]") {
  ShortestHandles handles(facingFronts({5, 6}, 0.2, 0.1, 2));
  const auto first = handles.nextListed();
  REQUIRE(first);
  CHECK_FALSE(handles.nextListed());
  const auto second = handles.next();
  REQUIRE(second);
  CHECK(second->length > first->length);
  CHECK_FALSE(handles.nextListed());
  handles.forbid(std::vector<Triangle>{first->faces[0]});
  CHECK(handles.nextListed());
}

}  // namespace handlebody
