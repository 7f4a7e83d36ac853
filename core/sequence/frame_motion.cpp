#include "core/sequence/frame_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/cancellation.h"

namespace handlebody {

namespace {

constexpr std::size_t kCells = 12'000;
constexpr double kRoom = 0.3;    // around the surface's box, in parts of its longest side
constexpr int kIterations = 60;  // the last of them move by less than a hundredth of a cell
constexpr double kNearby = 2;    // cells, standard deviation: where intensities are compared
constexpr double kFlat = 0.2;    // of the deviation of all cells: what varies by less shows nothing
constexpr double kSmooth = 1;    // cells, standard deviation: of each step, and of all of them

CellGrid cellsNear(const TriangleSoup& surface, const Grid& volume) {
  using Box = Eigen::AlignedBox3d;
  Box box;
  for (const Vec3& p : surface.points) box.extend(p);
  std::vector<Reach> corners;
  for (int c = Box::BottomLeftFloor; c <= Box::TopRightCeil; ++c)
    corners.push_back({box.corner(static_cast<Box::CornerType>(c)), kRoom * box.sizes().maxCoeff()});
  return cellsAround(volume, corners, kCells);
}

//! Sets the mean to 0 and returns the standard deviation.
double centred(std::vector<float>& values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const float v : values) sum += double{v};
  for (float& v : values) {
    v -= static_cast<float>(sum / n);
    squares += double{v} * double{v};
  }
  return std::sqrt(squares / n);
}

//! Less the mean nearby, in units of the deviation nearby.
std::vector<float> standardised(const CellImage& image) {
  const double sigma = kNearby * image.cells.grid.meanSpacing();
  std::vector<float> values = image.values;
  const double flat = kFlat * centred(values);  // centred, so that squares keep their digits
  std::vector<float> squares(values.size());
  std::transform(values.begin(), values.end(), squares.begin(), [](float v) { return v * v; });
  const std::vector<float> mean = smoothed(image.cells, values, sigma);
  squares = smoothed(image.cells, std::move(squares), sigma);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double m = double{mean[i]}, unit = std::sqrt(std::max(0.0, double{squares[i]} - m * m)) + flat;
    values[i] = unit > 0 ? static_cast<float>((double{values[i]} - m) / unit) : 0;
  }
  return values;
}

//! Per mm, along an axis; at the border from one side.
double slope(const CellGrid& cells, const std::vector<float>& values, std::array<int, 3> cell,
             std::size_t axis) {
  const int at = cell[axis], last = cells.grid.size[axis] - 1;
  const int before = std::max(at - 1, 0), after = std::min(at + 1, last);
  if (before == after) return 0;
  cell[axis] = after;
  const double high = double{values[cells.at(cell)]};
  cell[axis] = before;
  const double way = (after - before) * cells.grid.spacing[static_cast<int>(axis)];
  return (high - double{values[cells.at(cell)]}) / way;
}

Vec3 indexOf(const std::array<int, 3>& cell) { return Vec3(cell[0], cell[1], cell[2]); }

}  // namespace

FrameMotion::FrameMotion(const Volume& from, const Volume& to, const TriangleSoup& surface)
    : cells_(cellsNear(surface, from.grid)) {
  for (auto& a : along_) a.assign(cells_.count(), 0.0f);
  follow(standardised(makeCells(from, cells_, nullptr)), standardised(makeCells(to, cells_, nullptr)));
}

void FrameMotion::follow(const std::vector<float>& from, const std::vector<float>& to) {
  std::vector<float> here(cells_.count());  // the other frame, where the cells have moved to
  for (int i = 0; i < kIterations; ++i) {
    giveUpIfCancelled();
    for (std::size_t c = 0; c < here.size(); ++c) {
      const Vec3 way = Vec3(double{along_[0][c]}, double{along_[1][c]}, double{along_[2][c]});
      here[c] = static_cast<float>(
          interpolated(cells_.grid, to, indexOf(cells_.cellOf(c)) + way.cwiseQuotient(cells_.grid.spacing)));
    }
    step(from, here);
  }
}

void FrameMotion::step(const std::vector<float>& from, const std::vector<float>& here) {
  const double h = cells_.grid.meanSpacing(), sigma = kSmooth * h;
  std::array<std::vector<float>, 3> steps;
  for (auto& s : steps) s.resize(here.size());
  for (std::size_t c = 0; c < here.size(); ++c) {
    const std::array<int, 3> cell = cells_.cellOf(c);
    std::array<double, 3> g;
    for (std::size_t a = 0; a < 3; ++a)
      g[a] = (slope(cells_, from, cell, a) + slope(cells_, here, cell, a)) / 2;
    const double apart = double{from[c]} - double{here[c]};
    // No step is longer than a cell.
    const double norm = g[0] * g[0] + g[1] * g[1] + g[2] * g[2] + apart * apart / (4 * h * h);
    for (std::size_t a = 0; a < 3; ++a) steps[a][c] = norm > 0 ? static_cast<float>(apart * g[a] / norm) : 0;
  }
  for (std::size_t a = 0; a < 3; ++a) {
    const std::vector<float> smooth = smoothed(cells_, std::move(steps[a]), sigma);
    for (std::size_t c = 0; c < here.size(); ++c) along_[a][c] += smooth[c];
    along_[a] = smoothed(cells_, std::move(along_[a]), sigma);
  }
}

TriangleSoup FrameMotion::moved(TriangleSoup surface) const {
  const Grid& grid = cells_.grid;
  for (Vec3& p : surface.points) {
    const Vec3 index = grid.toIndex(p);
    Vec3 way;
    for (std::size_t a = 0; a < 3; ++a) way[static_cast<int>(a)] = interpolated(grid, along_[a], index);
    p = grid.toWorld(index + way.cwiseQuotient(grid.spacing)).cast<float>().cast<double>();
  }
  return surface;
}

}  // namespace handlebody
