#include "core/mesh/linking.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "core/geometry/predicates.h"
#include "core/indices.h"

namespace handlebody {

namespace {

//! A piece of loops, with those that hold it and how often they run along it.
struct Piece {
  Vec3 from, to;
  std::vector<std::pair<int, int>> loops;
};

constexpr int kProjections = 4;  // a random direction is degenerate for one mesh in very many
constexpr double kPush = 1e-3;   // of the edge that the dual loop crosses together with its primal loop

//! Everything is turned first, so that no axis of the mesh is the direction of the projection.
Eigen::Matrix3d turning(int attempt) {
  const Vec3 axis = Vec3(0.3271 + attempt, 0.5613, -0.7411 + 0.37 * attempt).normalized();
  return Eigen::AngleAxisd(1.0473 + 0.71 * attempt, axis).toRotationMatrix();
}

std::vector<Piece> primalPieces(const Mesh& mesh, const TreeCotree& trees, const Eigen::Matrix3d& turn) {
  std::map<int, Piece> pieces;  // by the lower of the two half-edges
  for (int k = 0; k < static_cast<int>(trees.generators.size()); ++k)
    for (const int h : primalLoop(mesh, trees, k)) {
      const int low = std::min(h, mesh.opposite(h));
      Piece& p = pieces[low];
      p.from = turn * mesh.position(mesh.origin(low));
      p.to = turn * mesh.position(mesh.target(low));
      p.loops.emplace_back(k, h == low ? 1 : -1);
    }
  std::vector<Piece> out;
  for (auto& [h, p] : pieces) out.push_back(std::move(p));
  return out;
}

//! Where a dual loop crosses the edge of h: its middle, or above it where a primal loop runs along it.
Vec3 crossingPlace(const Mesh& mesh, int h, bool pushed) {
  const Vec3 &a = mesh.position(mesh.origin(h)), &b = mesh.position(mesh.target(h));
  const Vec3 middle = (a + b) / 2;
  if (!pushed) return middle;
  const Vec3 normal = mesh.areaVector(Mesh::faceOf(h)).stableNormalized() +
                      mesh.areaVector(Mesh::faceOf(mesh.opposite(h))).stableNormalized();
  return middle + kPush * (b - a).norm() * normal.stableNormalized();
}

std::vector<Piece> dualPieces(const Mesh& mesh, const TreeCotree& trees, const Eigen::Matrix3d& turn) {
  std::map<std::pair<int, int>, Piece> pieces;  // by face, and the half-edge of it that is crossed
  const auto centre = [&](int f) {
    const Triangle& t = mesh.face(f);
    return Vec3((mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3);
  };
  for (int k = 0; k < static_cast<int>(trees.generators.size()); ++k)
    for (const int h : dualLoop(mesh, trees, k)) {
      const Vec3 place = crossingPlace(mesh, h, h == trees.generators[k]);
      const int g = mesh.opposite(h);
      for (const auto& [side, sign] : {std::pair(h, 1), std::pair(g, -1)}) {
        Piece& p = pieces[{Mesh::faceOf(side), side}];
        p.from = turn * centre(Mesh::faceOf(side));
        p.to = turn * place;
        p.loops.emplace_back(k, sign);
      }
    }
  std::vector<Piece> out;
  for (auto& [at, p] : pieces) out.push_back(std::move(p));
  return out;
}

//! 1 or -1 where `over` crosses over `under` seen along the third axis, by the sense; 0 elsewhere; none where
//! that cannot be told.
std::optional<int> passesOver(const Piece& over, const Piece& under) {
  const Vec3 &a = under.from, &b = under.to, &p = over.from, &q = over.to;
  const int sideP = orient2d(a, b, p, 2), sideQ = orient2d(a, b, q, 2);
  if (sideP != 0 && sideP == sideQ) return 0;
  const int sideA = orient2d(p, q, a, 2), sideB = orient2d(p, q, b, 2);
  if (sideA != 0 && sideA == sideB) return 0;
  const int height = -orient3d(a, b, p, q) * sideQ;
  if (sideP == 0 || sideQ == 0 || sideA == 0 || sideB == 0 || height == 0) return std::nullopt;
  return height > 0 ? sideQ : 0;
}

//! The pieces by the cells of a plane grid that their boxes meet.
class PlaneGrid {
 public:
  explicit PlaneGrid(const std::vector<Piece>& pieces) : pieces_(pieces) {
    double total = 0;
    for (const Piece& p : pieces) {
      box_.extend(low(p));
      box_.extend(high(p));
      total += (high(p) - low(p)).maxCoeff();
    }
    // As large as the mean piece, and no more cells than a few per piece.
    const Eigen::Vector2d extent = box_.sizes();
    const double n = static_cast<double>(pieces.size());
    cell_ =
        std::max({total / n, std::sqrt(extent.x() * extent.y() / (4 * n)), extent.maxCoeff() / 4096, 1e-300});
    width_ = static_cast<std::int64_t>(extent.x() / cell_) + 1;
    height_ = static_cast<std::int64_t>(extent.y() / cell_) + 1;
    cells_.resize(static_cast<std::size_t>(width_ * height_));
    for (std::size_t i = 0; i < pieces.size(); ++i)
      forCells(pieces[i], [&](std::int64_t x, std::int64_t y) { at(x, y).push_back(static_cast<int>(i)); });
  }
  //! Calls f(piece) for each piece whose box meets that of p, once; stops when f gives false.
  template <typename F>
  bool forEachNear(const Piece& p, F&& f) {
    bool go = true;
    forCells(p, [&](std::int64_t x, std::int64_t y) {
      for (const int i : at(x, y)) {
        const Piece& q = pieces_[i];
        const Eigen::Vector2d corner = low(p).cwiseMax(low(q)), far = high(p).cwiseMin(high(q));
        if (!go || (corner.array() > far.array()).any()) continue;
        if (column(corner.x()) == x && row(corner.y()) == y) go = f(q);
      }
    });
    return go;
  }

 private:
  static Eigen::Vector2d low(const Piece& p) { return p.from.head<2>().cwiseMin(p.to.head<2>()); }
  static Eigen::Vector2d high(const Piece& p) { return p.from.head<2>().cwiseMax(p.to.head<2>()); }
  std::int64_t column(double x) const { return clamped((x - box_.min().x()) / cell_, width_); }
  std::int64_t row(double y) const { return clamped((y - box_.min().y()) / cell_, height_); }
  static std::int64_t clamped(double cells, std::int64_t n) {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(cells)), 0, n - 1);
  }
  std::vector<int>& at(std::int64_t x, std::int64_t y) { return cells_[y * width_ + x]; }
  template <typename F>
  void forCells(const Piece& p, F&& f) {
    const Eigen::Vector2d a = low(p), b = high(p);
    for (std::int64_t y = row(a.y()); y <= row(b.y()); ++y)
      for (std::int64_t x = column(a.x()); x <= column(b.x()); ++x) f(x, y);
  }

  const std::vector<Piece>& pieces_;
  Eigen::AlignedBox2d box_;
  double cell_ = 1;
  std::int64_t width_ = 1, height_ = 1;
  std::vector<std::vector<int>> cells_;
};

//! How often each dual loop (row) crosses over each primal one, signed: their linking numbers.
std::optional<std::vector<int>> linkingNumbers(const Mesh& mesh, const TreeCotree& trees, int attempt) {
  const std::size_t n = trees.generators.size();
  const Eigen::Matrix3d turn = turning(attempt);
  const std::vector<Piece> primal = primalPieces(mesh, trees, turn);
  PlaneGrid grid(primal);
  std::vector<int> out(n * n, 0);
  for (const Piece& dual : dualPieces(mesh, trees, turn)) {
    const bool told = grid.forEachNear(dual, [&](const Piece& edge) {
      const std::optional<int> sign = passesOver(dual, edge);
      if (!sign) return false;
      if (*sign != 0)
        for (const auto& [i, s] : dual.loops)
          for (const auto& [j, t] : edge.loops) out[idx(i) * n + idx(j)] += *sign * s * t;
      return true;
    });
    if (!told) return std::nullopt;
  }
  return out;
}

//! Turns the sign so that the trace is g and asks whether the square is the matrix itself.
bool makeProjection(std::vector<int>& p, std::size_t n) {
  std::int64_t trace = 0;
  for (std::size_t i = 0; i < n; ++i) trace += p[i * n + i];
  if (2 * std::abs(trace) != static_cast<std::int64_t>(n)) return false;
  if (trace < 0)
    for (int& x : p) x = -x;
  std::vector<std::int64_t> row(n);
  for (std::size_t i = 0; i < n; ++i) {
    std::fill(row.begin(), row.end(), 0);
    for (std::size_t k = 0; k < n; ++k)
      if (const std::int64_t x = p[i * n + k]; x != 0)
        for (std::size_t j = 0; j < n; ++j) row[j] += x * p[k * n + j];
    for (std::size_t j = 0; j < n; ++j)
      if (row[j] != p[i * n + j]) return false;
  }
  return true;
}

}  // namespace

std::optional<std::vector<int>> outerProjection(const Mesh& mesh, const TreeCotree& trees) {
  const std::size_t n = trees.generators.size();
  if (n == 0) return std::vector<int>{};
  for (int attempt = 0; attempt < kProjections; ++attempt)
    if (auto p = linkingNumbers(mesh, trees, attempt); p && makeProjection(*p, n)) return p;
  return std::nullopt;
}

}  // namespace handlebody
