#include "core/collision/moved_faces.h"

#include <algorithm>

#include "core/indices.h"

namespace handlebody {

void MovedFaces::mark(std::size_t pointCount, std::span<const Triangle> faces,
                      std::span<const unsigned char> moved, VertexStars& stars, std::vector<int>& vertices,
                      int threads) {
  isFace_.resize(faces.size(), 0);
  isVertex_.resize(pointCount, 0);
  faces_.clear();
  vertices.clear();
  const auto some = std::count_if(moved.begin(), moved.end(), [](unsigned char m) { return m != 0; });
  // Where many have moved, a look at all faces is quicker than one at each vertex's.
  const bool many = idx(static_cast<int>(some)) > pointCount / 8;
  if (many)
    listAmongAll(faces, moved);
  else if (some > 0)
    listAtVertices(moved, stars);
  for (const int f : faces_)
    for (const int v : faces[f]) {
      if (isVertex_[v] != 0) continue;
      isVertex_[v] = 1;
      if (!many) vertices.push_back(v);
    }
  for (int v = 0; many && v < static_cast<int>(isVertex_.size()); ++v)
    if (isVertex_[v] != 0) vertices.push_back(v);
  stars.need(vertices, threads);
}

void MovedFaces::clear(std::span<const int> vertices) {
  for (const int f : faces_) isFace_[f] = 0;
  for (const int v : vertices) isVertex_[v] = 0;
}

void MovedFaces::listAmongAll(std::span<const Triangle> faces, std::span<const unsigned char> moved) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Triangle& t = faces[f];
    if (t[0] < 0 || (moved[t[0]] | moved[t[1]] | moved[t[2]]) == 0) continue;
    isFace_[f] = 1;
    faces_.push_back(static_cast<int>(f));
  }
}

void MovedFaces::listAtVertices(std::span<const unsigned char> moved, VertexStars& stars) {
  for (int v = 0; v < static_cast<int>(moved.size()); ++v) {
    if (moved[v] == 0) continue;
    stars.need(v);
    for (const Corner& c : stars.corners(v)) {
      if (isFace_[c.face] != 0) continue;
      isFace_[c.face] = 1;
      faces_.push_back(c.face);
    }
  }
}

}  // namespace handlebody
