#include "core/collision/near_vertices.h"

namespace handlebody {

namespace {

// A star is measured as larger than its longest edge by no more than this (StarSize, squared).
constexpr double kMeasured = 1 + 0x1p-8;

double longestOf(const DetectionWorkspace& work, const Triangle& t) {
  const Vec3 &a = work.points[t[0]], &b = work.points[t[1]], &c = work.points[t[2]];
  return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

void addInactive(DetectionWorkspace& work, int v) {
  work.stars.need(v);
  if (work.stars.corners(v).empty()) return;  // free, or without a face
  work.sizes[v] = measureStar(work.points, v, work.stars.corners(v));
  work.vertices.push_back(v);
}

}  // namespace

void NearVertices::add(DetectionWorkspace& work) {
  if (work.vertices.empty()) return;
  work.longestSquared = 0;
  for (const Triangle& t : work.faces)
    if (t[0] >= 0) work.longestSquared = std::max(work.longestSquared, longestOf(work, t));
  // Where nearly all are active, looking which of the others are near costs more than it saves.
  const bool nearlyAll = work.vertices.size() > work.points.size() / 4 * 3;
  if (!nearlyAll && work.areLevelsWorth()) return addOfLevels(work);
  if (!nearlyAll) near_.build(work.points, work.vertices, work.reach());
  for (int v = 0; v < static_cast<int>(work.points.size()); ++v)
    if (!work.isActive(v) && (nearlyAll || near_.mayBeNear(work.points[v]))) addInactive(work, v);
}

//! Each of the others by its own size, as its faces tell it.
void NearVertices::addOfLevels(DetectionWorkspace& work) {
  mostAround_.assign(work.points.size(), 0);
  for (const Triangle& t : work.faces) {
    if (t[0] < 0) continue;
    const double longest = longestOf(work, t);
    for (const int v : t) mostAround_[v] = std::max(mostAround_[v], longest);
  }
  nearLevels_.build(work.points, work.vertices, work.starSizes, work.longestSquared * kMeasured);
  for (int v = 0; v < static_cast<int>(work.points.size()); ++v)
    if (!work.isActive(v) && mostAround_[v] > 0 &&
        nearLevels_.mayBeNear(work.points[v], mostAround_[v] * kMeasured))
      addInactive(work, v);
}

}  // namespace handlebody
