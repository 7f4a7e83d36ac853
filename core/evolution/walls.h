#pragma once
// Walls as a front meets them: how near one is, and whether a face would lie in one. Bricks of a few voxels
// tell which of them are near, so that a thousand cost little more than one.

#include <array>
#include <memory>
#include <vector>

#include "core/evolution/hollow_sizes.h"
#include "core/evolution/wall_disc.h"
#include "core/evolution/wall_surface.h"

namespace handlebody {

class Walls {
 public:
  //! `edgeLength`: the mesh's target, `largestStep`: how far a vertex goes in one step, both mm. The margin
  //! that a front keeps follows from both, so that it neither steps over a small wall, nor has faces that
  //! cut through one between their corners.
  //! Precondition: requireSensible(constraints.h).
  Walls(const WallList& list, const Grid& grid, double edgeLength, double largestStep);

  //! mm from a place to where a vertex should come to rest before a wall: negative within. What is further
  //! than kFarVoxels is told as that. `index`: the same place as a continuous voxel index.
  double room(const Vec3& world, const Vec3& index) const;
  //! mm to the nearest wall itself, 0 or less within one; `limit` if there is none within that distance.
  double distance(const Vec3& world, double limit) const;
  //! How long edges may be there, in parts of the target (hollow_sizes.h).
  double edgePart(const Vec3& world) const;
  //! False if no face of usual size with a corner there comes near a wall.
  bool isNear(const Vec3& world) const;
  //! True if no point of the triangle lies in a wall or within the margin of one. Costs next to nothing where
  //! no wall is near.
  bool clears(const Vec3& a, const Vec3& b, const Vec3& c) const { return !meets(a, b, c, true, nullptr); }

  //! What of the walls a triangle touches.
  struct Touched {
    std::vector<int> balls;           // by index of the list
    std::vector<std::size_t> voxels;  // of the map
    std::vector<int> objects;         // by index of the list
    std::vector<int> discs;           // the same
  };
  //! True if a point of the triangle lies in a wall; which ones, if wanted.
  bool touches(const Vec3& a, const Vec3& b, const Vec3& c, Touched* which = nullptr) const {
    return meets(a, b, c, false, which);
  }

  //! A point of each wall within so many mm of a place: the middle of each ball, the nearest of each disc,
  //! the middle of one voxel of each part of the map that hangs together there, and of each part of an object
  //! a vertex there.
  std::vector<Vec3> places(const Vec3& world, double within) const;

  //! The objects; null: there are none.
  const WallSurface* objects() const { return objects_.get(); }
  //! A vertex of each part of an object that is so small that a front may pass over it between two looks at
  //! its faces.
  const std::vector<Vec3>& smallParts() const { return smallParts_; }

  const WallList& list() const { return list_; }
  const Grid& grid() const { return grid_; }

 private:
  using Index = std::array<int, 3>;
  struct Range {
    Index low, high;  // both included
  };
  struct Reach {
    double guard, rest;  // mm from the centre: no face within, vertices come to rest
  };

  void chooseBricks();
  void fillBalls();
  void fillDiscs();
  void fillMap();
  void fillObjects();
  int brickAt(const Index& b) const { return (b[2] * bricks_[1] + b[1]) * bricks_[0] + b[0]; }
  Index brickOf(const Vec3& index) const;
  //! Continuous brick index of a place in mm.
  Vec3 inBricks(const Vec3& world) const { return toBricks_ * world + brickOrigin_; }
  Index clampedBrick(const Vec3& bricks) const;
  void limitFree(const Index& b, const Vec3& ball, double guard);
  //! Of all bricks between two continuous indices, widened by mm.
  Range bricksWithin(const Vec3& low, const Vec3& high, double mm) const;
  Range voxelsWithin(const Vec3& low, const Vec3& high, double mm) const;
  void dilate(std::vector<bool>& flags, double mm) const;
  bool meets(const Vec3& a, const Vec3& b, const Vec3& c, bool withMargin, Touched* which) const;
  //! `size`: no less than from the first corner to the others, mm.
  bool meetsBalls(const std::array<Vec3, 3>& world, double size, const Range& bricks, bool withMargin,
                  Touched* which) const;
  bool meetsDiscs(const std::array<Vec3, 3>& world, bool withMargin, Touched* which) const;
  bool meetsObjects(const std::array<Vec3, 3>& world, bool withMargin, Touched* which) const;
  bool meetsVoxels(const std::array<Vec3, 3>& index, bool withMargin, Touched* which) const;
  bool isWall(const Index& v) const;
  double roomToVoxels(const Vec3& index) const;

  WallList list_;
  Grid grid_;
  double edgeLength_, largestStep_;
  double far_ = 0;        // mm
  double margin_ = 0;     // mm, of the map's voxels
  double clearance_ = 0;  // mm, of the objects
  double reach_ = 0;      // mm: longer than any face
  std::vector<Reach> reaches_;
  std::array<int, 3> brickSize_{1, 1, 1}, bricks_{1, 1, 1};  // voxels; number
  Eigen::Matrix3d toBricks_;                                 // from mm
  Vec3 brickOrigin_;
  std::vector<float> free_;         // per brick: mm from any place in it to the next guarded place, at least
  std::vector<int> first_, balls_;  // which balls a brick holds: first_[b] … first_[b + 1]
  std::vector<DiscShape> discs_;
  double discGuard_ = 0;         // mm: no face nearer to a disc
  double discRest_ = 0;          // mm: fronts rest there
  std::vector<bool> nearDiscs_;  // per brick
  std::shared_ptr<const WallSurface> objects_{};
  std::shared_ptr<const HollowSizes> hollowSizes_{};  // if there are objects
  std::vector<Vec3> smallParts_{};
  std::vector<bool> near_, hasVoxels_, nearVoxels_;  // per brick
};

//! Beyond this many voxels (of mean size) a wall is far.
inline constexpr double kFarVoxels = 1.0;

}  // namespace handlebody
