#pragma once
// What a user forbids the surface: places where it may not go, changes of topology that are not to happen,
// parts of it that are to stay as they are; what is to be done to it by hand; and a surface that is there
// already.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/evolution/mesh_edit.h"
#include "core/finding.h"
#include "core/geometry/vec.h"
#include "core/volume/volume.h"

namespace handlebody {

struct TriangleSoup;

//! A ball that the surface may not enter.
struct WallBall {
  Vec3 centre{0, 0, 0};  //!< mm, LPS
  double radius = 0;     //!< mm, > 0
  bool operator==(const WallBall&) const = default;
};

//! A flat disc that the surface may not pass: it has no thickness.
struct WallDisc {
  Vec3 centre{0, 0, 0};  //!< mm, LPS
  Vec3 normal{0, 0, 1};  //!< LPS, of any length above 0
  double radius = 0;     //!< mm, > 0
  bool operator==(const WallDisc&) const = default;
};

//! Voxels that the surface may not enter: those of a label map that are not 0.
struct WallMap {
  std::string path{};    //!< of the label map
  std::string sha256{};  //!< of that file; empty: not known
  //! One per voxel of the volume, x fastest; null: not read yet (loadWalls).
  std::shared_ptr<const std::vector<bool>> voxels{};
  std::vector<Finding> warnings{};  //!< of the file, which they name; known once it was read
  //! The same voxels, or what is to be read from the same file.
  bool operator==(const WallMap& other) const;
};

//! An object that is done: the surface may not enter what its mesh encloses, and does not touch it.
struct WallObject {
  std::string name{};  //!< for messages
  //! mm LPS: closed, oriented, without intersections, apart from the other objects (bodyContact).
  std::shared_ptr<const TriangleSoup> mesh{};
  bool operator==(const WallObject&) const = default;  // the same mesh in memory
};

struct WallList {
  std::vector<WallBall> balls{};
  std::optional<WallMap> map{};
  std::vector<WallObject> objects{};
  std::vector<WallDisc> discs{};
  bool empty() const { return balls.empty() && !map && objects.empty() && discs.empty(); }
  bool operator==(const WallList&) const = default;
};

//! The change of topology that happened nearest to `place` in the step to `iteration` does not happen.
struct Veto {
  int iteration = 0;
  Vec3 place{0, 0, 0};  //!< mm, LPS
  bool operator==(const Veto&) const = default;
};

//! Never more than this many components, or than this genus (of all components together).
struct TopologyLimits {
  std::optional<int> components{};
  std::optional<int> genus{};
  std::vector<Vec3> allowed{};  //!< mm, LPS: changes at these places may break the limits
  //! Each change that is held is put to somebody (StepReport::questions). The mesh is the same either way.
  bool asks = false;
  std::vector<Vec3> kept{};  //!< mm, LPS: held on, as somebody has answered
  bool empty() const { return !components && !genus && allowed.empty() && kept.empty() && !asks; }
  bool operator==(const TopologyLimits&) const = default;
};

//! From the step after `iteration` on, the vertices that lie in the ball at that iteration stay where they
//! are, and so do the faces between them.
struct Pin {
  Vec3 centre{0, 0, 0};  //!< mm, LPS
  double radius = 0;     //!< mm, > 0
  int iteration = 0;     //!< 0: the spheres at the seeds
  bool operator==(const Pin&) const = default;
};

//! How the voxels of a label become a surface.
struct LabelShape {
  std::optional<double> smoothing{};  //!< mm, standard deviation, 0: none; not given: a voxel along each axis
  std::optional<int> genus{};         //!< no more tunnels than these, by the fewest voxels
  bool keepsLargest = false;          //!< only its largest 6-connected part
  auto operator<=>(const LabelShape&) const = default;  // NOLINT(modernize-use-nullptr): the compiler's own 0
};

//! A surface from a file: what the growth begins with in place of spheres, or the object itself.
struct StartSurface {
  std::string path{};          //!< of a mesh or a label map
  std::string sha256{};        //!< of that file; empty: not known
  std::optional<int> label{};  //!< number of the label that is meant (LabelFile); none: all that are not 0
  std::string called{};        //!< its name in the file instead, until it is read
  //! Labels of the same map that become surfaces together, so that no two of them meet; empty: this one
  //! alone.
  std::vector<int> among{};
  LabelShape shape{};
  bool isDone = false;  //!< it is the object as it is: nothing grows
  bool isMesh = false;  //!< the file holds a mesh, as was seen when it was read
  //! mm LPS, in single precision, passes the certificate; null: not read yet (loadStarts).
  std::shared_ptr<const TriangleSoup> mesh{};
  Vec3 inside{0, 0, 0};    //!< mm LPS, a place deep inside: the click where there is none
  std::size_t shared = 0;  //!< voxels of the label that were left to smaller ones, which hold them, too
  std::vector<Finding> warnings{};  //!< of the file, which they name; known once it was read
  //! The same surface, or what is to be read from the same file.
  bool operator==(const StartSurface& other) const;
};

struct Constraints {
  WallList walls{};
  std::vector<Veto> vetoes{};
  TopologyLimits topology{};
  std::vector<Pin> pins{};
  std::vector<MeshEdit> edits{};
  std::optional<StartSurface> start{};  //!< the same at all iterations
  bool empty() const {
    return walls.empty() && vetoes.empty() && topology.empty() && pins.empty() && edits.empty() && !start;
  }
  bool operator==(const Constraints&) const = default;
};

//! "X,Y,Z", as in the options.
std::string written(const Vec3& place);

//! "X,Y,Z,NX,NY,NZ,R", as in --wall-disc.
std::string written(const WallDisc& disc);

//! "X,Y,Z,R@ITERATION", as in --pin.
std::string written(const Pin& pin);

//! Throws UsageError if one has no meaning: a wall or a pin without a radius or (a disc) without a normal, or
//! outside of the volume, a label map of another size, a start that has not been read or lies outside of the
//! volume, a veto or an edit before the first step,
//! two edits of one step or a veto of an edit's step, a limit that no surface keeps.
void requireSensible(const Constraints& constraints, const Grid& grid);

}  // namespace handlebody
