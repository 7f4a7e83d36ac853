#include <array>
#include <random>

#include "core/collision/face_pair.h"
#include "tests/collision_oracle/oracle.h"
#include "tests/support/catch.h"

using namespace handlebody;

namespace {

struct Counts {
  int yes = 0;
  int no = 0;
};

//! Draws `rounds` pairs whose second face uses the given indices, on a lattice of `size` points per axis.
Counts compareOnLattice(const Triangle& second, int size, int rounds, unsigned seed) {
  std::mt19937 random(seed);
  Counts counts;
  for (int i = 0; i < rounds; ++i) {
    TriangleSoup s;
    for (int v = 0; v < 6; ++v) {
      const auto c = [&] { return static_cast<double>(random() % static_cast<unsigned>(size)); };
      const double x = c(), y = c(), z = i % 4 == 0 ? 0 : c();  // a quarter of them coplanar
      s.points.emplace_back(x, y, z);
    }
    const Triangle first{0, 1, 2};
    const bool expected = oracle::facesIntersect(s, first, second);
    INFO("round " << i);
    REQUIRE(facesIntersect(s.points, first, second) == expected);
    REQUIRE(facesIntersect(s.points, second, first) == expected);
    ++(expected ? counts.yes : counts.no);
  }
  return counts;
}

}  // namespace

TEST_CASE("triangle pairs on a small lattice agree with exact construction, whatever they share") {
  const Triangle disjoint{3, 4, 5}, vertex{3, 1, 4}, edge{3, 2, 1}, same{1, 0, 2};
  const Triangle repeated{3, 3, 4}, repeatedShared{1, 1, 3}, repeatedEdge{1, 2, 2};
  for (const Triangle& t : {disjoint, vertex, edge, same, repeated, repeatedShared, repeatedEdge}) {
    Counts all;
    for (const int size : {2, 3, 4, 7}) {
      const Counts c = compareOnLattice(t, size, 2000, static_cast<unsigned>(size));
      all.yes += c.yes;
      all.no += c.no;
    }
    if (t != same) CHECK(all.no > 100);
    if (t != repeatedEdge) CHECK(all.yes > 100);
  }
}

TEST_CASE("triangle pairs that nearly touch agree with exact construction") {
  std::mt19937 random(5);
  const auto unit = [&] { return 2.0 * static_cast<double>(random()) / 4294967295.0 - 1; };
  for (int i = 0; i < 6000; ++i) {
    TriangleSoup s;
    for (int v = 0; v < 6; ++v) s.points.emplace_back(unit(), unit(), unit());
    // A corner of the second triangle on the first one, but for rounding: inside, on an edge or a corner.
    const double u = i % 3 == 2 ? 0 : std::abs(unit()) / 2;
    const double w = i % 3 == 1 ? 0 : std::abs(unit()) / 2;
    s.points[3] = s.points[0] + u * (s.points[1] - s.points[0]) + w * (s.points[2] - s.points[0]);
    for (const Triangle& second : {Triangle{3, 4, 5}, Triangle{0, 3, 4}, Triangle{1, 0, 3}}) {
      REQUIRE(facesIntersect(s.points, {0, 1, 2}, second) == oracle::facesIntersect(s, {0, 1, 2}, second));
    }
  }
}
