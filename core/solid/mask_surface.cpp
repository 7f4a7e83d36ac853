#include "core/solid/mask_surface.h"

#include <Eigen/LU>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/indices.h"
#include "core/phase.h"
#include "core/solid/cell_cases.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

//! Goes through the cells plane by plane. Cell (x, y, z) has the voxel (x, y, z) as its corner 0, and -1 is
//! the first one.
class Marching {
 public:
  Marching(const Mask& mask, std::size_t most)
      : mask_(mask), most_(most), row_(static_cast<std::size_t>(mask.grid.size[0]) + 2) {
    const std::size_t plane = row_ * (static_cast<std::size_t>(mask.grid.size[1]) + 2);
    for (auto& lower : vertices_) lower.assign(plane, kNone);
    upper_ = {std::vector<int>(plane, kNone), std::vector<int>(plane, kNone)};
  }

  TriangleSoup run() {
    for (int z = -1; z < mask_.grid.size[2]; ++z) {
      giveUpIfCancelled();
      for (int y = -1; y < mask_.grid.size[1]; ++y) addRow(y, z);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        std::swap(vertices_[axis], upper_[axis]);
        upper_[axis].assign(upper_[axis].size(), kNone);
      }
      vertices_[2].assign(vertices_[2].size(), kNone);
    }
    // Seen in a mirror, counter-clockwise is clockwise.
    if (mask_.grid.direction.determinant() < 0)
      for (Triangle& t : mesh_.triangles) std::swap(t[1], t[2]);
    return std::move(mesh_);
  }

 private:
  static constexpr int kNone = -1;

  void addRow(int y, int z) {
    // Corners with x = 1 of one cell are those with x = 0 of the next.
    int inside = 0;
    for (int x = -1; x < mask_.grid.size[0]; ++x) {
      inside = inside >> 1 & 0x55;
      for (int k = 0; k < 4; ++k)
        if (mask_.holds(x + 1, y + (k & 1), z + (k >> 1))) inside |= 2 << (2 * k);
      if (inside != 0 && inside != 0xFF) addCell({x, y, z}, inside);
    }
  }

  void addCell(const std::array<int, 3>& cell, int inside) {
    const CellCase& c = cellCases()[inside];
    for (const auto& t : c.triangles)
      mesh_.triangles.push_back({vertex(cell, t[0]), vertex(cell, t[1]), vertex(cell, t[2])});
    for (const auto& loop : c.fans) addFan(cell, loop);
    if (mesh_.triangles.size() > most_)
      throw Told<InputError>(Finding(FindingKind::surfaceTooLarge, {{"most", most_}}));
  }

  void addFan(const std::array<int, 3>& cell, const std::vector<int>& loop) {
    std::vector<int> ring;
    Vec3 middle = Vec3::Zero();
    for (const int e : loop) {
      ring.push_back(vertex(cell, e));
      middle += mesh_.points[ring.back()];
    }
    const int apex = static_cast<int>(mesh_.points.size());
    mesh_.points.push_back(middle / static_cast<double>(loop.size()));
    for (std::size_t i = 0; i < ring.size(); ++i)
      mesh_.triangles.push_back({ring[i], ring[(i + 1) % ring.size()], apex});
  }

  //! The vertex midway on an edge of the grid.
  int vertex(const std::array<int, 3>& cell, int edge) {
    const int start = cellEdgeStart(edge), axis = edge / 4;
    const int x = cell[0] + (start & 1), y = cell[1] + (start >> 1 & 1), z = cell[2] + (start >> 2);
    const bool isUpper = z > cell[2];
    auto& plane = isUpper ? upper_[axis] : vertices_[axis];
    int& v = plane[idx(y + 1) * row_ + idx(x + 1)];
    if (v == kNone) {
      v = static_cast<int>(mesh_.points.size());
      Vec3 index(x, y, z);
      index[axis] += 0.5;
      mesh_.points.push_back(mask_.grid.toWorld(index));
    }
    return v;
  }

  const Mask& mask_;
  std::size_t most_;
  std::size_t row_;                           // of a plane, with a voxel more at both ends
  std::array<std::vector<int>, 3> vertices_;  // per edge along x, y in the plane z, and z from there
  std::array<std::vector<int>, 2> upper_;     // in the plane z + 1
  TriangleSoup mesh_;
};

}  // namespace

TriangleSoup maskSurface(const Mask& mask, std::size_t most) {
  if (mask.inside.empty()) return {};
  const Phase phase("surface");
  return Marching(mask, most).run();
}

}  // namespace handlebody
