#include "ui/model/finished_mesh.h"

namespace handlebody::ui {

FinishedMesh::FinishedMesh(std::shared_ptr<const MeshSnapshot> shown) : shown_(std::move(shown)) {}

bool FinishedMesh::isOf(const MeshSnapshot& snapshot) const {
  const TriangleSoup& mine = shown_->mesh;
  return &snapshot == shown_.get() ||
         (mine.triangles == snapshot.mesh.triangles && mine.points == snapshot.mesh.points);
}

// Filled in place: whoever has its address sees it.
const CertifiedMesh& FinishedMesh::get() const {
  std::call_once(once_, [this] { *made_ = certifiedForExport(shown_->mesh); });
  return *made_;
}

std::vector<WallObject> wallObjects(const std::vector<FinishedWall>& walls) {
  std::vector<WallObject> objects;
  for (const FinishedWall& wall : walls) objects.push_back({wall.name.toStdString(), wall.mesh->mesh()});
  return objects;
}

}  // namespace handlebody::ui
