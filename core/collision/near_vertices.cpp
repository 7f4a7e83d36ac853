#include "core/collision/near_vertices.h"

#include <algorithm>

#include "core/threads.h"

namespace handlebody {

namespace {

// A star is measured as larger than its longest edge by no more than this (StarSize, squared).
constexpr double kMeasured = 1 + 0x1p-8;
// Below this many faces or vertices, of which little is asked, a thread costs more than it saves.
constexpr std::size_t kFacesPerThread = 10000;

double longestOf(const DetectionWorkspace& work, const Triangle& t) {
  const Vec3 &a = work.points[t[0]], &b = work.points[t[1]], &c = work.points[t[2]];
  return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

//! Adds the inactive vertices for which isNear(v), and measures their stars.
template <typename F>
void addInactive(DetectionWorkspace& work, F&& isNear) {
  const std::size_t count = work.points.size();
  std::vector<std::vector<int>> near(sharesOf(count, work.threads, kFacesPerThread));
  forSharesOnThreads(count, work.threads, kFacesPerThread, [&](const Share& share) {
    const auto [from, to] = share.of(count);
    for (std::size_t i = from; i < to; ++i) {
      const int v = static_cast<int>(i);
      if (!work.isActive(v) && isNear(v)) near[share.part].push_back(v);
    }
  });
  for (std::vector<int>& some : near) {
    work.stars.need(some, work.threads);
    for (const int v : some) {
      if (work.stars.corners(v).empty()) continue;  // free, or without a face
      work.sizes[v] = measureStar(work.points, v, work.stars.corners(v));
      work.vertices.push_back(v);
    }
  }
}

}  // namespace

//! Returns that of all faces.
double NearVertices::measureFaces(const DetectionWorkspace& work) {
  const std::size_t count = work.faces.size();
  longest_.resize(count);
  std::vector<double> most(sharesOf(count, work.threads, kFacesPerThread), 0);
  forSharesOnThreads(count, work.threads, kFacesPerThread, [&](const Share& share) {
    const auto [from, to] = share.of(count);
    double of = 0;
    for (std::size_t f = from; f < to; ++f) {
      const Triangle& t = work.faces[f];
      longest_[f] = t[0] < 0 ? 0 : longestOf(work, t);
      of = std::max(of, longest_[f]);
    }
    most[share.part] = of;
  });
  return *std::max_element(most.begin(), most.end());
}

void NearVertices::add(DetectionWorkspace& work) {
  if (work.vertices.empty()) return;
  work.longestSquared = measureFaces(work);
  // Where nearly all are active, looking which of the others are near costs more than it saves.
  const bool nearlyAll = work.vertices.size() > work.points.size() / 4 * 3;
  if (!nearlyAll && work.areLevelsWorth()) return addOfLevels(work);
  if (!nearlyAll) near_.build(work.points, work.vertices, work.reach());
  addInactive(work, [&](int v) { return nearlyAll || near_.mayBeNear(work.points[v]); });
}

//! Each of the others by its own size, as its faces tell it.
void NearVertices::addOfLevels(DetectionWorkspace& work) {
  mostAround_.assign(work.points.size(), 0);
  for (std::size_t f = 0; f < work.faces.size(); ++f) {
    const Triangle& t = work.faces[f];
    if (t[0] < 0) continue;
    for (const int v : t) mostAround_[v] = std::max(mostAround_[v], longest_[f]);
  }
  nearLevels_.build(work.points, work.vertices, work.starSizes, work.longestSquared * kMeasured);
  addInactive(work, [&](int v) {
    return mostAround_[v] > 0 && nearLevels_.mayBeNear(work.points[v], mostAround_[v] * kMeasured);
  });
}

}  // namespace handlebody
