#include "core/handles/handle_enumeration.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "core/errors.h"
#include "core/handles/homology.h"
#include "tests/core/handles/handle_oracle.h"
#include "tests/support/catch.h"

namespace handlebody {
namespace {

using Sizes = std::vector<int>;
constexpr int kLargestOfTwo = 6;

Handle sorted(Handle handle) {
  for (Triangle& f : handle) std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  std::sort(handle.begin(), handle.end());
  return handle;
}

//! Counts and lists agree, the list has no handle twice, and every handle is one by Theorem 7.
void expectExact(const Sizes& sizes, Family family) {
  const auto handles = enumerateHandles(sizes, family);
  const HandleCount count = countHandles(sizes, family);
  CHECK(count.handles == handles.size());
  CHECK(count.generators == countGenerators(sizes, handles));
  CHECK(std::adjacent_find(handles.begin(), handles.end()) == handles.end());
  for (const Handle& handle : handles) {
    const auto faces = withCaps(sizes, handle);
    REQUIRE(isSphere(faces));
    REQUIRE(test::isClosedAndOriented(faces));
  }
}

//! The next choice, as the digits of a counter; false after the last.
bool advance(std::vector<int>& digits, const std::vector<int>& bases) {
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (++digits[i] < bases[i]) return true;
    digits[i] = 0;
  }
  return false;
}

//! The paper's own procedure for k = 2: every choice of an apex for every boundary edge, kept if Theorem 7
//! holds with the caps.
std::vector<Handle> byTheorem7(int p, int q) {
  std::vector<int> bases(p, q);
  bases.resize(p + q, p);
  std::vector<int> apex(bases.size(), 0);
  std::vector<Handle> found;
  do {
    Handle faces;
    for (int i = 0; i < p; ++i) faces.push_back({i, (i + 1) % p, p + apex[i]});
    for (int j = 0; j < q; ++j) {
      faces.push_back({p + j, p + (j + 1) % q, apex[p + j]});
    }
    const auto whole = withCaps(Sizes{p, q}, faces);
    if (isSphere(whole) && test::isClosedAndOriented(whole)) found.push_back(sorted(faces));
  } while (advance(apex, bases));
  std::sort(found.begin(), found.end());
  return found;
}

enum class Choice { greatest, least };

//! Example 8 for a map that sends vertex i of p to images[i] of q, monotone decreasing and onto, with the
//! greatest or the least of each preimage as the apex of the edge that starts at the image.
std::vector<Triangle> example8(int p, int q, const std::vector<int>& images, Choice choice) {
  std::vector<Triangle> faces;
  for (int i = 0; i < p; ++i) faces.push_back({i, (i + 1) % p, p + images[i]});
  for (int j = 0; j < q; ++j) {
    int apex = -1;
    for (int i = 0; i < p; ++i) {
      const bool wanted = choice == Choice::greatest || apex < 0;
      if (images[i] == j && wanted) apex = i;
    }
    faces.push_back({p + j, p + (j + 1) % q, apex});
  }
  return faces;
}

std::vector<std::vector<int>> decreasingSurjections(int p, int q) {
  std::vector<std::vector<int>> maps;
  std::vector<int> images(p, 0);
  const std::vector<int> bases(p, q);
  do {
    const bool decreasing = std::is_sorted(images.rbegin(), images.rend());
    const bool onto = std::set<int>(images.begin(), images.end()).size() == static_cast<std::size_t>(q);
    if (decreasing && onto) maps.push_back(images);
  } while (advance(images, bases));
  return maps;
}

Handle rotated(Handle handle, int p, int q, int byFirst, int bySecond) {
  for (Triangle& f : handle) {
    for (int& v : f) v = v < p ? (v + byFirst) % p : p + (v - p + bySecond) % q;
  }
  return sorted(handle);
}

//! The handle in a mirror: every cap is run through the other way, and the faces are turned over.
Handle mirrored(Handle handle, const Sizes& sizes) {
  std::vector<int> image;
  for (const int size : sizes) {
    const int first = static_cast<int>(image.size());
    for (int v = 0; v < size; ++v) image.push_back(first + (size - v) % size);
  }
  for (Triangle& f : handle) f = {image[f[0]], image[f[2]], image[f[1]]};
  return sorted(handle);
}

Handle renumbered(Handle handle, const std::vector<int>& image) {
  for (Triangle& f : handle) {
    for (int& v : f) v = image[v];
  }
  return sorted(handle);
}

//! What the refusal says; empty if there is none.
std::string refusal(const Sizes& sizes, Family family) {
  try {
    countHandles(sizes, family);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("Table 1 of the paper counts the balanced handles", "[handles][enumeration]") {
  CHECK(countHandles(Sizes{3, 3, 4}, Family::balanced).handles == 72);
  CHECK(countHandles(Sizes{3, 4, 5}, Family::balanced).handles == 120);
  CHECK(countHandles(Sizes{4, 4, 6}, Family::balanced).handles == 192);
  CHECK(countHandles(Sizes{3, 3, 4, 4}, Family::balanced).handles == 576);
}

TEST_CASE("Each size of Table 1 has two generators, which are each other's mirror image",
          "[handles][enumeration]") {
  for (const Sizes& sizes : {Sizes{3, 3, 4}, Sizes{3, 4, 5}, Sizes{4, 4, 6}, Sizes{3, 3, 4, 4}}) {
    const auto generators = generatorsOf(sizes, enumerateHandles(sizes, Family::balanced));
    REQUIRE(generators.size() == 2);
    const auto orbit = orbitOf(sizes, generators[0]);
    CHECK_FALSE(std::binary_search(orbit.begin(), orbit.end(), mirrored(generators[0], sizes)));
    const auto other = orbitOf(sizes, generators[1]);
    CHECK(std::binary_search(other.begin(), other.end(), mirrored(generators[0], sizes)));
  }
}

TEST_CASE("An exchange of two caps turns the rotation of one into that of the other; they do not commute",
          "[handles][enumeration]") {
  const Sizes sizes{3, 3, 4};
  const std::vector<int> exchange{3, 4, 5, 0, 1, 2, 6, 7, 8, 9};
  const std::vector<int> rotateFirst{1, 2, 0, 3, 4, 5, 6, 7, 8, 9};
  const std::vector<int> rotateSecond{0, 1, 2, 4, 5, 3, 6, 7, 8, 9};
  bool commute = true;
  for (const Handle& handle : enumerateHandles(sizes, Family::balanced)) {
    const Handle exchanged = renumbered(handle, exchange);
    const Handle rotatedAndExchanged = renumbered(renumbered(handle, rotateFirst), exchange);
    CHECK(rotatedAndExchanged == renumbered(exchanged, rotateSecond));
    commute = commute && rotatedAndExchanged == renumbered(exchanged, rotateFirst);
  }
  CHECK_FALSE(commute);
}

TEST_CASE("All handles of two caps are those that Theorem 7 accepts", "[handles][enumeration]") {
  CHECK(byTheorem7(3, 3) == enumerateHandles(Sizes{3, 3}, Family::all));
  CHECK(byTheorem7(3, 4) == enumerateHandles(Sizes{3, 4}, Family::all));
  CHECK(byTheorem7(4, 4) == enumerateHandles(Sizes{4, 4}, Family::all));
  CHECK(countHandles(Sizes{3, 3}, Family::all).handles == 21);
  CHECK(countHandles(Sizes{3, 4}, Family::all).handles == 48);
  CHECK(countHandles(Sizes{4, 4}, Family::all).handles == 124);
}

TEST_CASE("Handles of two caps are the strips that join no pair twice", "[handles][enumeration]") {
  for (int p = 3; p <= kLargestOfTwo; ++p) {
    for (int q = 3; q <= kLargestOfTwo; ++q) {
      std::vector<Handle> strips;
      for (int start = 0; start < q; ++start) {
        for (const auto& strip : test::allStrips(p, q, start)) {
          if (!test::hasRepeatedPair(test::crossPairs(strip, p))) strips.push_back(sorted(strip));
        }
      }
      std::sort(strips.begin(), strips.end());
      CHECK(strips == enumerateHandles(Sizes{p, q}, Family::all));
    }
  }
}

TEST_CASE("Closed formulas for two caps equal the lists, and every handle is a sphere with its caps",
          "[handles][enumeration]") {
  for (const Family family : {Family::balanced, Family::monotone, Family::all}) {
    for (int p = 3; p <= kLargestOfTwo; ++p) {
      for (int q = 3; q <= kLargestOfTwo; ++q) expectExact({p, q}, family);
    }
  }
  expectExact({3, 9}, Family::monotone);
  expectExact({4, 8}, Family::monotone);
  expectExact({3, 9}, Family::all);
}

TEST_CASE("Closed formulas for three balanced caps equal the lists", "[handles][enumeration]") {
  for (int a = 3; a <= 5; ++a) {
    for (int b = a; b <= 6; ++b) {
      for (int c = b; c <= 7; ++c) expectExact({c, a, b}, Family::balanced);
    }
  }
}

TEST_CASE("Balanced handles of four caps are spheres with their caps", "[handles][enumeration]") {
  expectExact({3, 3, 4, 4}, Family::balanced);
  expectExact({3, 3, 3, 3}, Family::balanced);
  CHECK(countHandles(Sizes{3, 3, 4, 4}, Family::balanced).generators == 2);
}

TEST_CASE("Balanced handles have every vertex as an apex once and in one face of Type 2 at most",
          "[handles][enumeration]") {
  for (const Sizes& sizes : {Sizes{5, 5}, Sizes{3, 4, 5}, Sizes{3, 3, 4, 4}}) {
    for (const Handle& handle : enumerateHandles(sizes, Family::balanced)) {
      std::map<int, int> facesOf;
      for (const Triangle& f : handle) {
        for (const int v : f) ++facesOf[v];
      }
      CHECK(std::all_of(facesOf.begin(), facesOf.end(),
                        [](const auto& entry) { return entry.second == 3 || entry.second == 4; }));
    }
  }
}

TEST_CASE("The order of the sizes does not matter", "[handles][enumeration]") {
  for (const Family family : {Family::monotone, Family::all}) {
    const HandleCount one = countHandles(Sizes{4, 7}, family);
    const HandleCount other = countHandles(Sizes{7, 4}, family);
    CHECK(one.handles == other.handles);
    CHECK(one.generators == other.generators);
  }
  expectExact({4, 3, 4, 3}, Family::balanced);
  CHECK(countHandles(Sizes{4, 3, 4, 3}, Family::balanced).handles == 576);
}

TEST_CASE("Example 8 gives handles with the least of each preimage, not with the greatest as printed",
          "[handles][enumeration]") {
  for (int p = 3; p <= 6; ++p) {
    for (int q = 3; q <= p; ++q) {
      for (const auto& images : decreasingSurjections(p, q)) {
        CHECK(isSphere(withCaps(Sizes{p, q}, example8(p, q, images, Choice::least))));
        CHECK(isSphere(withCaps(Sizes{p, q}, example8(p, q, images, Choice::greatest))) == (p == q));
      }
    }
  }
}

TEST_CASE("The monotone family is Example 8 and its rotations", "[handles][enumeration]") {
  for (int p = 3; p <= 6; ++p) {
    for (int q = 3; q <= p; ++q) {
      std::set<Handle> expected;
      for (const auto& images : decreasingSurjections(p, q)) {
        const auto handle = example8(p, q, images, Choice::least);
        for (int i = 0; i < p; ++i) {
          for (int j = 0; j < q; ++j) expected.insert(rotated(handle, p, q, i, j));
        }
      }
      const auto handles = enumerateHandles(Sizes{p, q}, Family::monotone);
      CHECK(std::vector<Handle>(expected.begin(), expected.end()) == handles);
    }
  }
}

TEST_CASE("Large sizes of two caps are counted exactly or refused", "[handles][enumeration]") {
  // p · C(p+q-1, p) - p · q for q = 3 is p · ((p+2)(p+1)/2 - 3).
  CHECK(countHandles(Sizes{1000, 3}, Family::all).handles == 1000ull * (1002ull * 1001ull / 2 - 3));
  const HandleCount huge = countHandles(Sizes{2'000'000'000, 2'000'000'000}, Family::monotone);
  CHECK(huge.handles == 2'000'000'000);
  CHECK(huge.generators == 1);
  CHECK_THROWS_AS(countHandles(Sizes{100, 100}, Family::all), UsageError);
}

TEST_CASE("Sizes and numbers of caps that have no handles are refused with a reason",
          "[handles][enumeration]") {
  CHECK(contains(refusal(Sizes{2, 5}, Family::all), "at least 3"));
  CHECK(contains(refusal(Sizes{-1, 5}, Family::all), "at least 3"));
  CHECK(contains(refusal(Sizes{4}, Family::all), "2, 3 or 4"));
  CHECK(contains(refusal(Sizes{}, Family::balanced), "2, 3 or 4"));
  CHECK(contains(refusal(Sizes{3, 3, 3, 3, 3}, Family::all), "2, 3 or 4"));
  CHECK(contains(refusal(Sizes{3, 3, 4}, Family::monotone), "for 2 caps"));
  CHECK(contains(refusal(Sizes{3, 3, 3, 3}, Family::all), "200000"));
  CHECK(contains(refusal(Sizes{3, 3, 3, 1000}, Family::all), "200 vertices"));
}

}  // namespace handlebody
