#include "core/handles/homology.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/handles/smith_normal_form.h"

namespace handlebody {
namespace {

using Edge = std::array<int, 2>;

Edge edgeOf(int u, int v) { return {std::min(u, v), std::max(u, v)}; }

template <typename Cells>
auto numbered(const Cells& cells) {
  std::map<typename Cells::value_type, int> numbers;
  for (const auto& cell : cells) numbers.emplace(cell, static_cast<int>(numbers.size()));
  return numbers;
}

struct Complex {
  std::map<int, int> vertices;  // label to row
  std::map<Edge, int> edges;    // to row or column
  std::span<const Triangle> faces;
};

Complex complexOf(std::span<const Triangle> faces) {
  std::set<int> vertices;
  std::set<Edge> edges;
  for (const Triangle& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      vertices.insert(f[k]);
      edges.insert(edgeOf(f[k], f[(k + 1) % 3]));
    }
  }
  return {numbered(vertices), numbered(edges), faces};
}

//! Edges to vertices.
IntegerMatrix firstBoundary(const Complex& complex) {
  IntegerMatrix matrix(static_cast<int>(complex.vertices.size()), static_cast<int>(complex.edges.size()));
  for (const auto& [edge, column] : complex.edges) {
    matrix.at(complex.vertices.at(edge[0]), column) = -1;
    matrix.at(complex.vertices.at(edge[1]), column) = 1;
  }
  return matrix;
}

//! Faces to edges.
IntegerMatrix secondBoundary(const Complex& complex) {
  IntegerMatrix matrix(static_cast<int>(complex.edges.size()), static_cast<int>(complex.faces.size()));
  for (int column = 0; column < matrix.columns; ++column) {
    const Triangle& f = complex.faces[column];
    for (std::size_t k = 0; k < 3; ++k) {
      const int u = f[k];
      const int v = f[(k + 1) % 3];
      matrix.at(complex.edges.at(edgeOf(u, v)), column) += u < v ? 1 : -1;
    }
  }
  return matrix;
}

std::vector<std::int64_t> lastColumn(const IntegerMatrix& matrix) {
  std::vector<std::int64_t> column;
  column.reserve(matrix.rows);
  for (int r = 0; r < matrix.rows; ++r) column.push_back(matrix.at(r, matrix.columns - 1));
  return column;
}

bool everyEdgeHasTwoFaces(std::span<const Triangle> faces) {
  std::map<Edge, int> count;
  for (const Triangle& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) ++count[edgeOf(f[k], f[(k + 1) % 3])];
  }
  return std::all_of(count.begin(), count.end(), [](const auto& entry) { return entry.second == 2; });
}

bool hasRepeatedFace(std::span<const Triangle> faces) {
  std::set<Triangle> distinct;
  for (Triangle f : faces) {
    std::sort(f.begin(), f.end());
    distinct.insert(f);
  }
  return distinct.size() < faces.size();
}

bool isUnit(std::int64_t coefficient) { return coefficient == 1 || coefficient == -1; }

}  // namespace

Homology homology(std::span<const Triangle> faces) {
  const Complex complex = complexOf(faces);
  const SmithNormalForm first = smithNormalForm(firstBoundary(complex));
  const SmithNormalForm second = smithNormalForm(secondBoundary(complex));
  const int firstRank = static_cast<int>(first.factors.size());
  const int secondRank = static_cast<int>(second.factors.size());
  Homology result;
  result.betti = {static_cast<int>(complex.vertices.size()) - firstRank,
                  static_cast<int>(complex.edges.size()) - firstRank - secondRank,
                  static_cast<int>(faces.size()) - secondRank};
  std::copy_if(second.factors.begin(), second.factors.end(), std::back_inserter(result.torsion),
               [](std::int64_t factor) { return factor > 1; });
  if (result.betti[2] == 1) result.generator = lastColumn(second.columnTransform);
  return result;
}

bool isSphere(std::span<const Triangle> faces) {
  if (faces.empty() || hasRepeatedFace(faces) || !everyEdgeHasTwoFaces(faces)) return false;
  const Homology h = homology(faces);
  return h.betti == std::array<int, 3>{1, 0, 1} && h.torsion.empty() &&
         std::all_of(h.generator.begin(), h.generator.end(), isUnit);
}

}  // namespace handlebody
