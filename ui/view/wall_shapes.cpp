#include "ui/view/wall_shapes.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/mesh/shapes.h"

namespace handlebody::ui {

namespace {

void append(TriangleSoup& all, const TriangleSoup& more) {
  const int first = static_cast<int>(all.points.size());
  all.points.insert(all.points.end(), more.points.begin(), more.points.end());
  for (const Triangle& t : more.triangles)
    all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

//! A regular lattice of numbers, negative within a shape.
struct Field {
  std::array<int, 3> size{2, 2, 2};
  vtkNew<vtkImageData> image;
  float* values = nullptr;

  Field(const std::array<int, 3>& n, float outside) : size(n) {
    image->SetDimensions(n.data());
    image->AllocateScalars(VTK_FLOAT, 1);
    values = static_cast<float*>(image->GetScalarPointer());
    std::fill_n(values, image->GetNumberOfPoints(), outside);
  }
  float& at(int x, int y, int z) {
    const auto row =
        static_cast<std::size_t>(z) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(y);
    return values[row * static_cast<std::size_t>(size[0]) + static_cast<std::size_t>(x)];
  }
  //! Where it is 0; `place` makes mm of an index.
  TriangleSoup surface(const std::function<Vec3(const Vec3&)>& place) {
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(image);
    contour->SetValue(0, 0);
    contour->ComputeNormalsOff();
    contour->ComputeScalarsOff();
    contour->Update();
    TriangleSoup soup;
    vtkPolyData* found = contour->GetOutput();
    for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
      soup.points.push_back(place(Vec3(found->GetPoint(i))));
    const auto cells = vtk::TakeSmartPointer(found->GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
      vtkIdType count = 0;
      const vtkIdType* corners = nullptr;
      cells->GetCurrentCell(count, corners);
      soup.triangles.push_back(
          {static_cast<int>(corners[0]), static_cast<int>(corners[1]), static_cast<int>(corners[2])});
    }
    return soup;
  }
};

TriangleSoup eachBall(const std::vector<WallBall>& balls) {
  TriangleSoup all;
  for (const WallBall& ball : balls) append(all, icosphere(ball.centre, ball.radius, ball.radius / 4));
  return all;
}

//! The smallest box around all balls.
std::array<Vec3, 2> boxOf(const std::vector<WallBall>& balls) {
  std::array<Vec3, 2> box{Vec3::Constant(1e300), Vec3::Constant(-1e300)};
  for (const WallBall& ball : balls) {
    box[0] = box[0].cwiseMin(ball.centre - Vec3::Constant(ball.radius));
    box[1] = box[1].cwiseMax(ball.centre + Vec3::Constant(ball.radius));
  }
  return box;
}

TriangleSoup unionOf(const std::vector<WallBall>& balls) {
  constexpr double kCells = 100, kCellsPerRadius = 3, kFewest = 1.5;
  if (balls.empty()) return {};
  const auto [low, high] = boxOf(balls);
  double smallest = balls.front().radius;
  for (const WallBall& ball : balls) smallest = std::min(smallest, ball.radius);
  const double cell = std::max(smallest / kCellsPerRadius, (high - low).maxCoeff() / kCells);
  if (smallest < kFewest * cell) return eachBall(balls);  // far apart for their size
  const Vec3 origin = low - Vec3::Constant(cell);
  std::array<int, 3> size{};
  for (std::size_t a = 0; a < 3; ++a)
    size[a] = static_cast<int>(std::ceil((high - low)[static_cast<int>(a)] / cell)) + 3;
  Field field(size, static_cast<float>(cell));
  for (const WallBall& ball : balls) {
    const Vec3 middle = (ball.centre - origin) / cell;
    const double reach = ball.radius / cell + 1;
    std::array<int, 3> from{}, to{};
    for (std::size_t a = 0; a < 3; ++a) {
      from[a] = std::max(0, static_cast<int>(std::floor(middle[static_cast<int>(a)] - reach)));
      to[a] = std::min(size[a] - 1, static_cast<int>(std::ceil(middle[static_cast<int>(a)] + reach)));
    }
    for (int z = from[2]; z <= to[2]; ++z)
      for (int y = from[1]; y <= to[1]; ++y)
        for (int x = from[0]; x <= to[0]; ++x) {
          const double distance = (Vec3(x, y, z) - middle).norm() * cell - ball.radius;
          field.at(x, y, z) = std::min(field.at(x, y, z), static_cast<float>(distance));
        }
  }
  return field.surface([&](const Vec3& index) { return Vec3(origin + cell * index); });
}

//! Cells of several voxels are within if one of theirs is.
TriangleSoup voxelsOf(const std::vector<bool>& voxels, const Grid& grid) {
  constexpr int kMaxCells = 128;
  std::array<int, 3> step{}, size{};
  for (std::size_t a = 0; a < 3; ++a) {
    step[a] = (grid.size[a] + kMaxCells - 1) / kMaxCells;
    size[a] = (grid.size[a] + step[a] - 1) / step[a] + 2;  // and a rim, so that it is closed
  }
  Field field(size, 1);
  std::size_t at = 0;
  for (int z = 0; z < grid.size[2]; ++z)
    for (int y = 0; y < grid.size[1]; ++y)
      for (int x = 0; x < grid.size[0]; ++x)
        if (voxels[at++]) field.at(x / step[0] + 1, y / step[1] + 1, z / step[2] + 1) = -1;
  const Vec3 wide(step[0], step[1], step[2]);
  return field.surface(
      [&](const Vec3& index) { return grid.toWorld(Vec3((index.array() - 0.5) * wide.array() - 0.5)); });
}

//! Both sides, a little apart: lit from either.
TriangleSoup plateOf(const WallDisc& disc) {
  constexpr int kCorners = 48;
  const Vec3 normal = disc.normal.normalized(), a = normal.unitOrthogonal(), b = normal.cross(a);
  TriangleSoup plate;
  for (const double side : {1.0, -1.0}) {
    const int middle = static_cast<int>(plate.points.size());
    const Vec3 centre = disc.centre + side * 0.01 * disc.radius * normal;
    plate.points.push_back(centre);
    for (int i = 0; i < kCorners; ++i) {
      const double angle = side * 2 * std::numbers::pi * i / kCorners;
      plate.points.push_back(centre + disc.radius * (std::cos(angle) * a + std::sin(angle) * b));
      plate.triangles.push_back({middle, middle + 1 + i, middle + 1 + (i + 1) % kCorners});
    }
  }
  return plate;
}

}  // namespace

TriangleSoup shapesOf(const WallList& walls, const Grid& grid) {
  TriangleSoup all = unionOf(walls.balls);
  if (walls.map && walls.map->voxels) append(all, voxelsOf(*walls.map->voxels, grid));
  for (const WallDisc& disc : walls.discs) append(all, plateOf(disc));
  return all;
}

}  // namespace handlebody::ui
