#include "core/surgery/handle_fitting.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "core/handles/shortest_handles.h"

namespace handlebody {

namespace {

// In units of WorkBudget: for the square of the vertices of all polygons, and for each vertex of a handle.
constexpr std::size_t kLoopWork = 8;
constexpr std::size_t kFaceWork = 200;
constexpr std::size_t kMaxBeside = 4000;  // edges that are looked at beside one that is blocked

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
      ends_.push_back(static_cast<int>(vertices_.size()));
    }
  }
  std::size_t size() const { return vertices_.size(); }
  ShortestHandles handles(std::size_t maxWork = ShortestHandles::kMaxWork) const {
    return ShortestHandles(points_, forbiddenEdges_, maxWork);
  }
  //! The next vertex on the same loop, or the one before, by its number in the search.
  int beside(int v, int step) const {
    const auto end = std::upper_bound(ends_.begin(), ends_.end(), v);
    const int first = end == ends_.begin() ? 0 : *(end - 1), size = *end - first;
    return first + (v - first + step + size) % size;
  }
  //! Of the mesh, by its number in the search.
  int vertex(int v) const { return vertices_[v]; }
  Patch patch(const HandleCandidate& handle) const {
    Patch out;
    out.firstNew = mesh_.vertexSlots();
    out.length = handle.length;
    for (Triangle t : handle.faces) {
      for (int& v : t) v = vertices_[v];
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
  std::vector<int> ends_;  // of the loops in it
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

namespace {

//! What no handle that fits can have. Each face and edge is looked at once, however often it comes up.
class Faults {
 public:
  Faults(const HandleLoops& polygons, const Surroundings& surroundings, const Patch& caps)
      : polygons_(polygons), surroundings_(surroundings), caps_(caps) {}

  std::vector<Triangle> faces;  //!< of the last handle
  std::vector<VertexPair> edges;

  //! Looks for those of a handle; false if it has none.
  bool find(const HandleCandidate& handle, const Patch& patch) {
    faces.clear();
    edges.clear();
    for (std::size_t f = 0; f < patch.faces.size(); ++f) {
      if (!hits(patch, patch.faces[f])) continue;
      bool blocked = false;
      for (std::size_t i = 0; i < 3; ++i)
        blocked = addIfBlocked({handle.faces[f][i], handle.faces[f][(i + 1) % 3]}) || blocked;
      if (!blocked) faces.push_back(handle.faces[f]);
    }
    return !faces.empty() || !edges.empty();
  }

 private:
  bool hits(const Patch& patch, Triangle face) {
    Triangle key = face;
    std::sort(key.begin(), key.end());
    const auto [known, isNew] = hits_.try_emplace(key, false);
    if (isNew) known->second = surroundings_.hits(patch, face, caps_);
    return known->second;
  }
  //! What blocks an edge blocks those beside it, too: all that hang together with it are found at once, else
  //! each would cost a search of its own.
  bool addIfBlocked(const VertexPair& edge) {
    std::vector<VertexPair> open{edge};
    for (std::size_t i = 0; i < open.size() && i < kMaxBeside; ++i) {
      if (!isBlocked(open[i]) || !added_.insert(open[i]).second) continue;
      const auto [u, v] = open[i];
      edges.push_back(open[i]);
      for (const int step : {-1, 1}) {
        open.push_back({polygons_.beside(u, step), v});
        open.push_back({u, polygons_.beside(v, step)});
      }
    }
    return isBlocked(edge);
  }
  bool isBlocked(VertexPair edge) {
    if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
    const auto [known, isNew] = blocked_.try_emplace(edge, false);
    if (isNew) known->second = surroundings_.isBlocked(polygons_.vertex(edge[0]), polygons_.vertex(edge[1]));
    return known->second;
  }

  const HandleLoops& polygons_;
  const Surroundings& surroundings_;
  const Patch& caps_;
  std::map<Triangle, bool> hits_;
  std::map<VertexPair, bool> blocked_;
  std::set<VertexPair> added_;
};

}  // namespace

FittingHandle shortestFittingHandle(const Mesh& mesh, std::span<const Opening> openings,
                                    std::span<const std::vector<int>> loops, const Patch& caps,
                                    const Surroundings& surroundings, WorkBudget* work) {
  FittingHandle out;
  WorkBudget unbounded(std::numeric_limits<std::size_t>::max());
  WorkBudget& budget = work ? *work : unbounded;
  if (!surroundings.fits(caps)) return out;
  const HandleLoops polygons(mesh, openings, loops);
  budget.spend(kLoopWork * polygons.size() * polygons.size());
  const std::size_t most = std::min(ShortestHandles::kMaxWork, budget.left());
  ShortestHandles search = polygons.handles(most);
  Faults faults(polygons, surroundings, caps);
  std::size_t done = 0;
  for (; out.tried < kFitTries && !budget.isSpent(); ++out.tried) {
    auto handle = search.nextListed();
    out.isListed = handle.has_value();
    if (!handle) handle = search.next();
    budget.spend(search.workDone() - done + kFaceWork * polygons.size());
    done = search.workDone();
    if (search.gaveUp() && most < ShortestHandles::kMaxWork) return out;  // it would be found with more
    out.shortest = out.shortest && !search.gaveUp();
    if (!handle) return out;
    out.patch = polygons.patch(*handle);
    if (faults.find(*handle, out.patch)) {
      search.forbid(faults.faces, faults.edges);
    } else if (!surroundings.intersectsItself(out.patch)) {
      out.patch.append(caps);
      out.found = !surroundings.sweepsOver(out.patch);
      if (out.found) return out;
    }
  }
  return out;
}

}  // namespace handlebody
