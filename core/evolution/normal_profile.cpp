#include "core/evolution/normal_profile.h"

#include <algorithm>
#include <cmath>

namespace handlebody {

namespace {

// What the image says around a vertex corrects what it says at the vertex by up to this much; less the
// clearer that is, by nothing from kClear on. Units of the contrast.
constexpr double kMaxCorrection = 0.3, kClear = 0.5;
// Noise lets a vertex stand out by up to so many edge lengths; what is more is a crease.
constexpr double kMaxProtrusion = 0.05;

}  // namespace

double RingHeights::of(int v) {
  const double known = at(v).load(std::memory_order_relaxed);
  if (!std::isnan(known)) return known;
  const double height = examineRing(mesh_, v).height();
  set(v, height);
  return height;
}

NormalProfile::NormalProfile(const ObjectImage& image, const Mesh& mesh, RingHeights& heights, int v,
                             const Vec3& from, const Vec3& normal, double edgeLength)
    : image_(image),
      mesh_(mesh),
      heights_(heights),
      v_(v),
      from_(from),
      normal_(normal),
      edgeLength_(edgeLength) {}

double NormalProfile::at(double along) {
  const auto [intensity, limits] = image_.read(from_ + along * normal_);
  const double own = limits.inside(intensity);
  const double most = kMaxCorrection * (1 - std::abs(own) / kClear);
  if (most <= 0) return own;
  return own + std::clamp(limits.inside(meanAround(along, intensity)) - own, -most, most);
}

double NormalProfile::crossing(double reach, double here, double there) {
  const double t = reach * here / (here - there);
  const double value = at(t);
  if (value * here > 0) return t + (reach - t) * value / (value - there);
  return here == value ? t : t * here / (here - value);
}

double NormalProfile::meanAround(double along, double own) {
  if (neighbours_ == 0) lookAround();
  double sum = own;
  for (std::size_t i = 0; i < neighbours_; ++i) sum += image_.intensity(places_[i] + along * normal_);
  return sum / static_cast<double>(neighbours_ + 1);
}

//! Half-way to each neighbour, on the paraboloid through vertex and neighbour.
void NormalProfile::lookAround() {
  const Vec3 p = mesh_.position(v_), from = from_ + 0.5 * protrusion() * normal_;
  mesh_.forEachOutgoing(v_, [&](int h) {
    if (neighbours_ == kMaxNeighbours) return;
    const Vec3 to = mesh_.position(mesh_.target(h)) - p;
    places_[neighbours_++] = from + 0.5 * to - 0.25 * to.dot(normal_) * normal_;
  });
}

//! How far the vertex stands out of the surface around it: its ring lies lower than those of its neighbours
//! do. By its own ring alone such a vertex would seem to stand where it should. At a crease the rings differ
//! by more than noise makes them: there it is bounded.
double NormalProfile::protrusion() {
  const double own = heights_.of(v_);
  double sum = own, n = 1;
  mesh_.forEachOutgoing(v_, [&](int h) {
    sum += heights_.of(mesh_.target(h));
    n += 1;
  });
  return std::clamp(sum / n - own, -kMaxProtrusion * edgeLength_, kMaxProtrusion * edgeLength_);
}

}  // namespace handlebody
