#include "core/evolution/image_warnings.h"

#include "core/evolution/object_image.h"

namespace handlebody {

namespace {

constexpr double kNoEdge = 0.25;      // of the step from the object to its boundary
constexpr double kMuch = 0.1;         // of the surface
constexpr double kMuchBorder = 0.15;  // of the volume, or of the field of view

//! Calls f(middle, outward normal, size) for every face, in order; size is twice the area (mm²), and without
//! one the normal is zero.
template <typename F>
void forEachFacet(const Mesh& mesh, F&& f) {
  for (int face = 0; face < mesh.faceSlots(); ++face) {
    if (!mesh.isFace(face)) continue;
    const Triangle& t = mesh.face(face);
    const Vec3 area = mesh.areaVector(face);
    f((mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3, area.normalized(), area.norm());
  }
}

FaceSupport supportAt(const ObjectImage& image, const Vec3& middle, const Vec3& normal) {
  const Grid& grid = image.volume().grid();
  const Vec3 reach = grid.meanSpacing() * normal, beyond = middle + reach;
  if (!grid.contains(grid.toIndex(beyond))) return FaceSupport::border;
  const double rise = image.insideByIntensity(middle - reach) - image.insideByIntensity(beyond);
  return rise < kNoEdge ? FaceSupport::none : FaceSupport::edge;
}

bool isPadding(const FieldOfView& view, const Grid& grid, const Vec3& world) {
  const Vec3 index = grid.toIndex(world);
  return grid.contains(index) && view.isPaddingNear(index);
}

}  // namespace

SurfaceSupport surfaceSupport(const Mesh& mesh, const ObjectImage& image) {
  SurfaceSupport support;
  support.faces.reserve(mesh.faceCount());
  double without = 0, border = 0, all = 0;
  forEachFacet(mesh, [&](const Vec3& middle, const Vec3& normal, double size) {
    const FaceSupport face = supportAt(image, middle, normal);
    support.faces.push_back(face);
    (face == FaceSupport::border ? border : all) += size;
    if (face == FaceSupport::none) without += size;
  });
  support.withoutEdge = all > 0 ? without / all : 0;
  support.atBorder = all + border > 0 ? border / (all + border) : 0;
  return support;
}

double partAtPadding(const Mesh& mesh, const ObjectImage& image) {
  if (!image.view()) return 0;
  const Grid& grid = image.volume().grid();
  const double voxel = grid.meanSpacing();
  double at = 0, all = 0;
  forEachFacet(mesh, [&](const Vec3& middle, const Vec3& normal, double size) {
    all += size;
    if (isPadding(*image.view(), grid, middle + voxel * normal) ||
        isPadding(*image.view(), grid, middle + 2 * voxel * normal))
      at += size;
  });
  return all > 0 ? at / all : 0;
}

std::vector<Finding> imageWarnings(const Mesh& mesh, const ObjectImage& image,
                                   const SurfaceSupport& support) {
  std::vector<Finding> out;
  if (const NeckCut* neck = image.neck())
    out.push_back({neck->widens ? FindingKind::heldWhereItWidens
                   : neck->hole ? FindingKind::heldAtHole
                                : FindingKind::heldAtNeck,
                   {{"radius_mm", neck->neckRadius},
                    {"behind_ml", neck->cutVolume / 1000},
                    {"in_front_ml", neck->keptVolume / 1000}}});
  const auto tell = [&out](FindingKind kind, double part, double least) {
    if (part > least) out.push_back({kind, {{"percent", 100 * part}}});
  };
  tell(FindingKind::noEdge, support.withoutEdge, kMuch);
  tell(FindingKind::atVolumeBorder, support.atBorder, kMuchBorder);
  tell(FindingKind::atViewBorder, partAtPadding(mesh, image), kMuchBorder);
  return out;
}

}  // namespace handlebody
