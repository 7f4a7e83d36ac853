#pragma once
// How far a triangle, or the edge between two, is from what a solver asks for.

#include "core/geometry/vec.h"

namespace handlebody {

//! What is wanted, degrees.
struct WantedShape {
  double angle = 15;
  double dihedral = 20;

  //! Part of what is wanted that there is, 0 … 1.
  double ofFace(const Vec3& a, const Vec3& b, const Vec3& c) const;
  double ofEdge(const Vec3& p, const Vec3& q, const Vec3& c, const Vec3& d) const;
};

//! What is bad in some faces and edges, so that one bad one outweighs several that are less so.
struct Badness {
  double sum = 0;
  double worst = 1;  //!< part of what is wanted

  void add(double part);
  //! Clearly less of it, and nothing that is worse than the worst before.
  bool isBetterThan(const Badness& other) const;
};

}  // namespace handlebody
