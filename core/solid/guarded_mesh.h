#pragma once
// A mesh whose vertices and edges are changed only so far that it does not intersect itself, and has no
// sharper folds than at first, and whose vertices are moved only so far that no triangle becomes thin.

#include <functional>
#include <span>
#include <vector>

#include "core/collision/self_intersection.h"
#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"
#include "core/mesh/remesh.h"

namespace handlebody {

//! Components are told apart by a number per vertex that stays when the mesh changes.
class GuardedMesh {
 public:
  //! Precondition: closed, manifold, without self-intersections, the components in each other as those of a
  //! body.
  explicit GuardedMesh(Mesh mesh);
  const Mesh& mesh() const { return mesh_; }
  //! Of a vertex: as findComponents numbered them at first.
  int component(int v) const { return component_[v]; }
  struct Measure {
    double volume = 0, area = 0;  //!< mm³, signed; mm²
  };
  //! Per component.
  std::vector<Measure> measures() const;

  //! Puts every vertex at its target. Those whose faces then intersect, meet in a fold (kSharpest) or have
  //! become thin (kThinnest), and what lies around them, go back until none do; so do the components that
  //! have lost too much of their volume (kMinVolume) or lie where they cannot.
  void move(std::span<const Vec3> targets);
  //! Regulates the edges, but not those of components of fewer than kFewestFaces. Where something is wrong
  //! then, as above, or a vertex lies where it may not, all is taken back and done anew without the
  //! surroundings. False, with the mesh unchanged, if that fails again and again.
  bool regulate(const RemeshLimits& limits, const std::function<bool(const Vec3&)>& mayLie);

 private:
  struct Faults {
    std::vector<int> vertices;    // of faces that intersect, are folded or have become thin
    std::vector<char> component;  // 1: its volume is not what it may be, or it is misplaced
    bool any = false;
  };
  Faults faultsOf(const Mesh& mesh, const std::vector<int>& component, const std::vector<FacePair>& pairs);
  void addFolds(const Mesh& mesh, Faults& faults) const;
  void addThinned(std::span<const Vec3> before, Faults& faults) const;
  void putBack(const Faults& faults, std::span<const Vec3> before, bool withRing);
  VertexStates restOf(const Faults& faults, const Mesh& changed, double reach, VertexStates allowed) const;
  std::vector<int> componentsOf(const Mesh& changed) const;
  void take(const Mesh& changed);

  Mesh mesh_;
  std::vector<int> component_;  // per vertex
  std::vector<double> volume_;  // mm³ at first, per component, signed
  double sharpest_;             // cosine between the normals of two faces, at least
  CollisionDetector detector_;
  VertexMarks moved_;  // per vertex
};

inline constexpr double kMinVolume = 0.6;  //!< of what it was at first
inline constexpr int kFewestFaces = 60;
//! Degrees between two faces that share an edge, inside or outside, at least; where the first mesh has less,
//! that. A little above what polishing asks for (kWantedShape).
inline constexpr double kSharpest = 21;
//! Degrees: a triangle with a smaller angle than this may not lose of it. As for folds, a little more than
//! polishing asks for. Where edges are regulated nothing is said of it: that mends more than it makes.
inline constexpr double kThinnest = 15.5;

}  // namespace handlebody
