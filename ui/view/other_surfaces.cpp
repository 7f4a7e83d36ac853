#include "ui/view/other_surfaces.h"

#include "ui/model/document.h"
#include "ui/view/other_outlines.h"

namespace handlebody::ui {

std::vector<SurfaceScene::Other> otherSurfaces(const Document& document) {
  std::vector<SurfaceScene::Other> others;
  for (int i = 0; i < document.objectCount(); ++i) {
    const ObjectInfo info = document.objectInfo(i);
    if (i != document.activeObject() && info.visible && info.snapshot &&
        !info.snapshot->mesh.triangles.empty())
      others.push_back({info.snapshot, colourOf(document, i)});
  }
  return others;
}

std::optional<Sight> sightOfSurfaces(const Document& document) {
  const std::shared_ptr<const MeshSnapshot> mesh = document.snapshot();
  const std::vector<SurfaceScene::Other> others = otherSurfaces(document);
  if (others.empty()) return mesh ? sightOf(mesh->mesh.points) : std::nullopt;
  std::vector<Vec3> points = mesh ? mesh->mesh.points : std::vector<Vec3>();
  for (const auto& other : others)
    points.insert(points.end(), other.mesh->mesh.points.begin(), other.mesh->mesh.points.end());
  return sightOf(points);
}

}  // namespace handlebody::ui
