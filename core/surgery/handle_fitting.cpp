#include "core/surgery/handle_fitting.h"

#include <algorithm>

#include "core/handles/shortest_handles.h"

namespace handlebody {

namespace {

//! The polygons as the search for handles numbers them, and back.
class HandleLoops {
 public:
  HandleLoops(const Mesh& mesh, std::span<const Opening> openings, std::span<const std::vector<int>> loops)
      : mesh_(mesh) {
    for (const std::vector<int>& loop : loops) {
      std::vector<Vec3>& points = points_.emplace_back();
      for (const int v : loop) points.push_back(mesh.position(v));
      forbidJoined(openings, loop);
      vertices_.insert(vertices_.end(), loop.begin(), loop.end());
    }
  }
  ShortestHandles handles() const { return ShortestHandles(points_, forbiddenEdges_); }
  Patch patch(const HandleCandidate& handle) const {
    Patch out;
    out.firstNew = mesh_.vertexSlots();
    out.length = handle.length;
    for (Triangle t : handle.faces) {
      for (int& v : t) v = vertices_[static_cast<std::size_t>(v)];
      out.faces.push_back(t);
    }
    return out;
  }

 private:
  //! Edges that the opened mesh has between this loop and those before it.
  void forbidJoined(std::span<const Opening> openings, const std::vector<int>& loop) {
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      for (std::size_t j = 0; j < loop.size(); ++j)
        if (staysOpenOn(mesh_, openings, vertices_[i], loop[j]))
          forbiddenEdges_.push_back({static_cast<int>(i), static_cast<int>(vertices_.size() + j)});
  }

  const Mesh& mesh_;
  std::vector<std::vector<Vec3>> points_;
  std::vector<int> vertices_;
  std::vector<VertexPair> forbiddenEdges_;
};

}  // namespace

std::vector<Patch> handlesBetween(const Mesh& mesh, std::span<const Opening> openings,
                                  std::span<const std::vector<int>> loops, std::size_t limit) {
  const HandleLoops polygons(mesh, openings, loops);
  ShortestHandles search = polygons.handles();
  std::vector<Patch> out;
  while (out.size() < limit) {
    const auto handle = search.next();
    if (!handle) break;
    out.push_back(polygons.patch(*handle));
  }
  return out;
}

FittingHandle shortestFittingHandle(const Mesh& mesh, std::span<const Opening> openings,
                                    std::span<const std::vector<int>> loops, const Patch& caps,
                                    const Surroundings& surroundings) {
  FittingHandle out;
  if (!surroundings.fits(caps)) return out;
  const HandleLoops polygons(mesh, openings, loops);
  ShortestHandles search = polygons.handles();
  for (; out.tried < kFitTries; ++out.tried) {
    const auto handle = search.next();
    out.shortest = out.shortest && !search.gaveUp();
    if (!handle) return out;
    out.patch = polygons.patch(*handle);
    const std::vector<std::size_t> hits = surroundings.hits(out.patch, caps);
    std::vector<Triangle> faults;
    for (const std::size_t f : hits) faults.push_back(handle->faces[f]);
    if (!faults.empty()) {
      search.forbid(faults);
    } else if (!surroundings.intersectsItself(out.patch)) {
      out.patch.append(caps);
      out.found = !surroundings.sweepsOver(out.patch);
      if (out.found) return out;
    }
  }
  return out;
}

}  // namespace handlebody
