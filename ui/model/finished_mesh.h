#pragma once
// The surface of an object as it is written, and as the wall that it is for the objects after it: rounded to
// single precision and certified, which takes a while and is done once, on whichever thread asks first.

#include <QString>
#include <memory>
#include <mutex>
#include <vector>

#include "core/evolution/constraints.h"
#include "core/io/report/result.h"
#include "ui/model/document.h"

namespace handlebody::ui {

class FinishedMesh {
 public:
  //! Precondition: `shown` has triangles.
  explicit FinishedMesh(std::shared_ptr<const MeshSnapshot> shown);

  //! True if it is made of what `snapshot` shows.
  bool isOf(const MeshSnapshot& snapshot) const;
  //! Any thread; makes it at the first call. Throws as certifiedForExport, every time.
  const CertifiedMesh& get() const;
  //! Its mesh, which is empty before the first get(). One address for all walls that are this mesh.
  std::shared_ptr<const TriangleSoup> mesh() const { return {made_, &made_->mesh}; }
  const std::shared_ptr<const MeshSnapshot>& shown() const { return shown_; }

 private:
  std::shared_ptr<const MeshSnapshot> shown_;
  std::shared_ptr<CertifiedMesh> made_ = std::make_shared<CertifiedMesh>();
  mutable std::once_flag once_;
};

//! An object that comes before another one.
struct FinishedWall {
  QString name;
  std::shared_ptr<const FinishedMesh> mesh;
  //! The same surface, whatever it is called.
  bool operator==(const FinishedWall& other) const { return mesh->isOf(*other.mesh->shown()); }
};

//! For a request: the meshes are there when they have been made (get()).
std::vector<WallObject> wallObjects(const std::vector<FinishedWall>& walls);

}  // namespace handlebody::ui
