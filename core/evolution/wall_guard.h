#pragma once
// Keeps a surface out of walls: its motion is cut short before them, and what still came to lie in one is
// found before a step is accepted.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/evolution/parameters.h"
#include "core/evolution/walls.h"
#include "core/mesh/forbidden.h"
#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"
#include "core/surgery/event.h"

namespace handlebody {

class WallGuard {
 public:
  //! Other walls, or for another mesh (see Walls). They hold from putUp on.
  void choose(const WallList& list, const Grid& grid, double edgeLength, double largestStep);
  //! From here on no step may carry the mesh into one. Where it lies in one already, and that wall is not of
  //! `known`, whose walls it does not enclose: UsageError, unless `mayPush`. Such a wall holds as soon as the
  //! mesh has given ground. No object pushes, and no disc.
  void putUp(const Mesh& mesh, const WallList& known, bool mayPush);

  //! All that were chosen, for the image; null: there are none.
  const std::shared_ptr<const Walls>& all() const { return all_; }
  //! Where remeshing and surgery may put no faces.
  Forbidden forbidden() const;

  //! Before motion: moves of vertices near a wall are cut to the largest step, on which the margin rests.
  void bound(const Mesh& mesh, std::span<const int> moving, double largestStep,
             std::vector<Vec3>& moves) const;
  //! After motion: where a face came too near to a wall its corners take a part of their moves, or none.
  //! `before`: the mesh before that motion.
  void holdBack(Mesh& mesh, const Mesh& before, std::span<const int> moving, std::vector<Vec3>& moves) const;
  //! A place where the mesh has come into a wall, or has swallowed one by one of the events. Precondition:
  //! faces without a touched vertex are as they were before the step.
  std::optional<Vec3> broken(const Mesh& mesh, VertexMarkSpan touched, std::span<const Event> events) const;
  //! A place of a wall that the mesh has come into or swallowed, wherever it is. For changes that may have
  //! come anywhere: each looks at every face and every wall.
  std::optional<Vec3> brokenAnywhere(const Mesh& mesh) const;
  //! Walls that the mesh has been pushed out of hold from now on.
  void release(const Mesh& mesh);
  //! True while the mesh still lies in walls that were put over it.
  bool isPushing() const { return pushing_ != nullptr; }

 private:
  void setPushing(const WallList& pushing);

  std::shared_ptr<const Walls> all_, holding_, pushing_;
  double edgeLength_ = 0, largestStep_ = 0;  // mm
};

//! The balls of seeds, made smaller where a wall is near. Throws SeedError if a wall lies over one, or leaves
//! it less than `smallest` (mm).
std::vector<Seed> clearOfWalls(std::vector<Seed> fitted, const std::vector<Seed>& asked, const Walls& walls,
                               double smallest);

//! True if the surface encloses no part of the walls and touches none.
bool isFree(const Mesh& mesh, const WallList& walls, const Grid& grid);

}  // namespace handlebody
