#include "core/handles/homology.h"

#include <algorithm>
#include <random>

#include "tests/support/catch.h"

namespace handlebody {
namespace {

using Faces = std::vector<Triangle>;
using Betti = std::array<int, 3>;
using Torsion = std::vector<std::int64_t>;

const Faces kTetrahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
const Faces kOctahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1},
                           {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};
//! Möbius' torus of seven vertices.
Faces sevenVertexTorus() {
  Faces faces;
  for (int i = 0; i < 7; ++i) {
    faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
    faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return faces;
}
//! The icosahedron with opposite points identified.
const Faces kProjectivePlane = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                                {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};

//! A size × size grid of squares, wrapped straight in x, and with a flip of x in y.
Faces kleinBottle(int size) {
  const auto vertex = [size](int x, int y) {
    if (y == size) return (size - x % size) % size;
    return y * size + x % size;
  };
  Faces faces;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      faces.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)});
      faces.push_back({vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
    }
  }
  return faces;
}

//! A sphere of two rings of `size` vertices and two poles: rings 0 … size-1 and size … 2·size-1, poles after.
Faces drum(int size) {
  Faces faces;
  for (int i = 0; i < size; ++i) {
    const int j = (i + 1) % size;
    faces.push_back({2 * size, i, j});
    faces.push_back({i, size + i, j});
    faces.push_back({j, size + i, size + j});
    faces.push_back({2 * size + 1, size + j, size + i});
  }
  return faces;
}

Faces identified(Faces faces, int from, int to) {
  for (Triangle& f : faces) std::replace(f.begin(), f.end(), from, to);
  return faces;
}

Faces together(Faces a, const Faces& b, int shift) {
  for (const Triangle& f : b) a.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
  return a;
}

bool hasUnitCoefficients(const std::vector<std::int64_t>& generator) {
  return std::all_of(generator.begin(), generator.end(), [](auto c) { return c == 1 || c == -1; });
}

}  // namespace

TEST_CASE("Spheres are recognised, however their faces are turned", "[handles][homology]") {
  std::mt19937 random(21);
  for (Faces faces : {kTetrahedron, kOctahedron, drum(6)}) {
    const Homology h = homology(faces);
    CHECK(h.betti == Betti{1, 0, 1});
    CHECK(h.torsion.empty());
    REQUIRE(h.generator.size() == faces.size());
    // All faces are oriented alike, so the generator is the sum of all or its negative.
    CHECK(std::all_of(h.generator.begin(), h.generator.end(),
                      [&](auto c) { return c == h.generator[0] && (c == 1 || c == -1); }));
    CHECK(isSphere(faces));
    for (Triangle& f : faces) {
      if (std::bernoulli_distribution()(random)) std::swap(f[1], f[2]);
    }
    CHECK(hasUnitCoefficients(homology(faces).generator));
    CHECK(isSphere(faces));
  }
}

TEST_CASE("The generator of H_2 is a cycle", "[handles][homology]") {
  Faces faces = kOctahedron;
  std::swap(faces[3][0], faces[3][1]);
  const auto generator = homology(faces).generator;
  std::array<std::array<std::int64_t, 6>, 6> boundary{};
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto u = static_cast<std::size_t>(faces[f][k]);
      const auto v = static_cast<std::size_t>(faces[f][(k + 1) % 3]);
      boundary[u][v] += generator.at(f);
      boundary[v][u] -= generator.at(f);
    }
  }
  for (const auto& row : boundary) {
    CHECK(std::all_of(row.begin(), row.end(), [](auto c) { return c == 0; }));
  }
}

TEST_CASE("A torus has two loops in H_1 and is no sphere", "[handles][homology]") {
  const Homology h = homology(sevenVertexTorus());
  CHECK(h.betti == Betti{1, 2, 1});
  CHECK(h.torsion.empty());
  CHECK(hasUnitCoefficients(h.generator));
  CHECK_FALSE(isSphere(sevenVertexTorus()));
}

TEST_CASE("The projective plane has torsion Z/2 and no H_2", "[handles][homology]") {
  const Homology h = homology(kProjectivePlane);
  CHECK(h.betti == Betti{1, 0, 0});
  CHECK(h.torsion == Torsion{2});
  CHECK(h.generator.empty());
  CHECK_FALSE(isSphere(kProjectivePlane));
}

TEST_CASE("The Klein bottle has one free loop and torsion Z/2", "[handles][homology]") {
  const Homology h = homology(kleinBottle(5));
  CHECK(h.betti == Betti{1, 1, 0});
  CHECK(h.torsion == Torsion{2});
  CHECK_FALSE(isSphere(kleinBottle(5)));
}

TEST_CASE("Two disjoint spheres have two components", "[handles][homology]") {
  const Faces both = together(kOctahedron, kTetrahedron, 6);
  CHECK(homology(both).betti == Betti{2, 0, 2});
  CHECK_FALSE(isSphere(both));
}

TEST_CASE("Two spheres that touch in a vertex have two cycles in H_2", "[handles][homology]") {
  const Faces touching = identified(together(kOctahedron, kTetrahedron, 6), 6, 0);
  CHECK(homology(touching).betti == Betti{1, 0, 2});
  CHECK_FALSE(isSphere(touching));
}

TEST_CASE("A sphere pinched in a vertex has a loop in H_1", "[handles][homology]") {
  const Faces pinched = identified(drum(6), 13, 12);
  CHECK(homology(pinched).betti == Betti{1, 1, 1});
  CHECK_FALSE(isSphere(pinched));
}

TEST_CASE("A disc is no sphere", "[handles][homology]") {
  const Faces disc(kOctahedron.begin(), kOctahedron.begin() + 4);
  CHECK(homology(disc).betti == Betti{1, 0, 0});
  CHECK_FALSE(isSphere(disc));
}

TEST_CASE("A sphere with two edges glued at a vertex has the homology of one but is refused",
          "[handles][homology]") {
  // The pole 12 has the neighbours 0 and 3, which share no other: with 3 = 0 four faces meet in edge 12-0.
  const Faces folded = identified(drum(6), 3, 0);
  const Homology h = homology(folded);
  CHECK(h.betti == Betti{1, 0, 1});
  CHECK(h.torsion.empty());
  CHECK(hasUnitCoefficients(h.generator));
  CHECK_FALSE(isSphere(folded));
}

TEST_CASE("Nothing and a face counted twice are no spheres", "[handles][homology]") {
  CHECK_FALSE(isSphere({}));
  CHECK_FALSE(isSphere(Faces{{0, 1, 2}, {0, 2, 1}}));
}

}  // namespace handlebody
