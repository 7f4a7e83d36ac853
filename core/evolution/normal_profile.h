#pragma once
// What the image says along the normal of a vertex, at the vertex and on the surface around it.

#include <Eigen/Geometry>
#include <array>
#include <atomic>
#include <limits>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! A vertex and its neighbours.
struct Ring {
  Vec3 normal{0, 0, 0};
  Vec3 umbrella{0, 0, 0};  //!< mean of the neighbours less the vertex
  double meanSquare = 0;   //!< of the distances to the neighbours
  //! Of the neighbours' mean above the vertex, along the normal: negative where the surface bulges.
  double height() const { return normal.dot(umbrella); }
};

inline Ring examineRing(const Mesh& mesh, int v) {
  Ring r;
  const Vec3 p = mesh.position(v);
  double n = 0;
  // On a closed mesh the ring goes on where a face ends.
  Vec3 a = mesh.position(mesh.target(mesh.outgoing(v))) - p;
  mesh.forEachOutgoing(v, [&](int h) {
    const Vec3 b = mesh.position(mesh.apex(h)) - p;
    r.normal += a.cross(b);
    r.umbrella += a;
    r.meanSquare += a.squaredNorm();
    n += 1;
    a = b;
  });
  const double length = r.normal.norm();
  if (length > 0) r.normal /= length;
  r.umbrella /= n;
  r.meanSquare /= n;
  return r;
}

//! The heights of rings of one mesh, each looked at once. Any number of threads may ask.
class RingHeights {
 public:
  explicit RingHeights(const Mesh& mesh)
      : mesh_(mesh),
        known_(static_cast<std::size_t>(mesh.vertexSlots()), std::numeric_limits<double>::quiet_NaN()) {}
  void set(int v, double height) { at(v).store(height, std::memory_order_relaxed); }
  double of(int v);

 private:
  std::atomic_ref<double> at(int v) { return std::atomic_ref(known_[v]); }

  const Mesh& mesh_;
  std::vector<double> known_;
};

//! The image along the normal of a vertex v. Noise of the image at one place says less about where the
//! boundary lies than its mean over the surface around it; so near the boundary what the image says at v is
//! corrected by that mean. The correction is bounded, and the smaller the clearer the image speaks at v:
//! corners and thin parts stay what they are.
class NormalProfile {
 public:
  //! `from`: where v asks the image, `normal`: its unit normal (both mm).
  NormalProfile(const ObjectImage& image, const Mesh& mesh, RingHeights& heights, int v, const Vec3& from,
                const Vec3& normal, double edgeLength);

  //! As ObjectImage::inside, at `along` (mm) from `from`.
  double at(double along);
  //! Where it is zero between 0 and `reach`, where it is `here` and `there`, of opposite signs: one step of
  //! regula falsi, improved once.
  double crossing(double reach, double here, double there);

 private:
  static constexpr std::size_t kMaxNeighbours = 12;  // of more the first ones are asked

  double meanAround(double along, double own);  // intensities
  void lookAround();
  double protrusion();

  const ObjectImage& image_;
  const Mesh& mesh_;
  RingHeights& heights_;
  int v_;
  Vec3 from_, normal_;
  double edgeLength_;
  std::size_t neighbours_ = 0;               // 0: not looked at yet
  std::array<Vec3, kMaxNeighbours> places_;  // where the image is asked for them, from v's place on
};

}  // namespace handlebody
