#include "core/collision/vertex_stars.h"

#include <algorithm>
#include <cstring>

#include "core/indices.h"
#include "core/threads.h"

namespace handlebody {
namespace {

//! Brings the corners into cyclic order by looking for each successor among the rest. For few corners.
bool orderByScanning(std::span<Corner> corners) {
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    std::size_t j = i + 1;
    while (j < corners.size() && corners[j].next != corners[i].prev) ++j;
    if (j == corners.size()) return false;
    std::swap(corners[i + 1], corners[j]);
  }
  return corners.back().prev == corners.front().next;
}

//! The same in O(k log k).
bool orderBySorting(std::span<Corner> corners, std::vector<Corner>& scratch) {
  const auto byNext = [](const Corner& a, const Corner& b) { return a.next < b.next; };
  scratch.assign(corners.begin(), corners.end());
  std::sort(scratch.begin(), scratch.end(), byNext);
  for (std::size_t i = 1; i < scratch.size(); ++i) {
    if (scratch[i - 1].next == scratch[i].next) return false;
  }
  std::size_t at = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = scratch[at];
    const Corner wanted{0, corners[i].prev, 0};
    const auto found = std::lower_bound(scratch.begin(), scratch.end(), wanted, byNext);
    if (found == scratch.end() || found->next != wanted.next) {
      std::copy(scratch.begin(), scratch.end(), corners.begin());
      return false;
    }
    at = static_cast<std::size_t>(found - scratch.begin());
    if (at == 0 && i + 1 < corners.size()) {  // closed too early: more than one cycle
      std::copy(scratch.begin(), scratch.end(), corners.begin());
      return false;
    }
  }
  return at == 0;
}

//! A simple cycle meets every neighbour once; a corner that starts or ends at the vertex itself (a face with
//! a repeated index) makes none.
bool isSimple(int v, std::span<const Corner> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].next == v) return false;
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      if (corners[i].next == corners[j].next) return false;
    }
  }
  return true;
}

// Below this many a thread costs more than it saves.
constexpr std::size_t kVerticesPerThread = 1500;

bool orderCycle(int v, std::span<Corner> corners, std::vector<Corner>& scratch) {
  constexpr std::size_t kFew = 32;
  if (corners.size() < 3) return false;
  if (corners.size() <= kFew) return isSimple(v, corners) && orderByScanning(corners);
  for (const Corner& c : corners) {
    if (c.next == v || c.prev == v) return false;
  }
  return orderBySorting(corners, scratch);
}

bool same(std::span<const Triangle> a, const std::vector<Triangle>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

}  // namespace

void VertexStars::build(std::size_t pointCount, std::span<const Triangle> faces) {
  if (!mesh_ && stars_.size() == pointCount && same(faces, faces_)) return;
  mesh_ = nullptr;
  faces_.assign(faces.begin(), faces.end());
  fill(pointCount);
  for (std::size_t v = 0; v < pointCount; ++v) {
    Star& star = stars_[v];
    star.isCycle = orderCycle(static_cast<int>(v), {corners_.data() + star.first, idx(star.count)}, scratch_);
  }
}

//! Counting sort of all corners by their vertex.
void VertexStars::fill(std::size_t pointCount) {
  stars_.assign(pointCount, {0, 0, false, 0});
  for (const Triangle& t : faces_) {
    if (t[0] < 0) continue;
    for (const int v : t) ++stars_[v].count;
  }
  int sum = 0;
  for (Star& star : stars_) {
    sum += star.count;
    star.first = sum;
  }
  corners_.resize(sum);
  for (std::size_t f = faces_.size(); f-- > 0;) {  // backwards, so that corners stay in the order of faces
    const Triangle& t = faces_[f];
    if (t[0] < 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const int slot = --stars_[t[i]].first;
      corners_[slot] = {static_cast<int>(f), t[(i + 1) % 3], t[(i + 2) % 3]};
    }
  }
}

void VertexStars::readFrom(const Mesh& mesh) {
  // What was read before is kept while it takes little more room than what is valid.
  constexpr std::size_t kRoom = 3;
  const auto slots = static_cast<std::size_t>(mesh.vertexSlots());
  const bool keep = mesh_ && slots >= stars_.size() && corners_.size() <= kRoom * mesh.faces().size() * 3;
  mesh_ = &mesh;
  ++reading_;
  if (!keep) {
    corners_.clear();
    stars_.clear();
  }
  stars_.resize(slots, {0, 0, false, 0});
}

void VertexStars::check(int v) {
  if (!isStill(v)) read(v);
  stars_[v].reading = reading_;
}

//! Most are still as they were: that is looked at on threads. The others take room, one after the other.
void VertexStars::need(std::span<const int> vertices, int threads) {
  if (!mesh_) return;
  forRangesOnThreads(vertices.size(), threads, kVerticesPerThread, [&](std::size_t from, std::size_t to) {
    for (const int v : vertices.subspan(from, to - from))
      if (isStill(v)) stars_[v].reading = reading_;
  });
  for (const int v : vertices) {
    if (stars_[v].reading == reading_) continue;
    read(v);
    stars_[v].reading = reading_;
  }
}

//! True if all faces of the cycle are still there: then they are all faces of v. Without branches for each.
bool VertexStars::isStill(int v) const {
  const Star& star = stars_[v];
  if (!star.isCycle) return false;
  bool still = true;
  for (const Corner& c : corners(v)) {
    if (c.face >= mesh_->faceSlots()) return false;
    const Triangle& t = mesh_->face(c.face);
    const auto is = [&](std::size_t i, std::size_t j, std::size_t k) {
      return ((t[i] ^ v) | (t[j] ^ c.next) | (t[k] ^ c.prev)) == 0;
    };
    still &= is(0, 1, 2) | is(1, 2, 0) | is(2, 0, 1);
  }
  return still;
}

void VertexStars::read(int v) {
  Star& star = stars_[v];
  star = {static_cast<int>(corners_.size()), 0, false, 0};
  const int start = mesh_->outgoing(v);
  if (start < 0) return;
  int h = start;
  do {
    const int face = Mesh::faceOf(h);
    const Triangle& t = mesh_->face(face);
    const int i = h - 3 * face, j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
    corners_.push_back({face, t[j], t[k]});
    h = mesh_->opposite(3 * face + k);
  } while (h >= 0 && h != start);
  star.count = static_cast<int>(corners_.size()) - star.first;
  star.isCycle = h == start && star.count >= 3;
}

}  // namespace handlebody
