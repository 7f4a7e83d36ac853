#include "core/handles/handle_enumeration.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <string>

#include "core/errors.h"
#include "core/handles/handle_sizes.h"
#include "core/indices.h"

namespace handlebody {
namespace {

// Ends searches that find little but try much; about ten seconds.
constexpr std::uint64_t kMaxTrials = 400'000'000;

constexpr int kMaxListedVertices = 200;

//! An entry of a stack that branches: taking a branch back is to remember its last entry.
struct NeededEdge {
  int from;
  int to;
  int below;  // index of the entry below, -1 at the bottom
};

// The search keeps the directed edges of the faces chosen so far. A directed edge is needed if it is a
// boundary edge of a cap, or the reverse of an edge between two caps that is in use. It takes one needed
// edge and tries every third vertex, so each handle is met exactly once.
//
// When nothing is needed and all boundary edges are used, the faces with the caps form a closed surface,
// connected across its edges, with V = m + k vertices and, if there are 2k - 4 faces of Type 2, with
// F = 2V - 4 faces, so Euler number V - F/2 = 2. Pulling pinched vertices apart only adds vertices, and a
// connected closed surface has at most 2: it is a sphere, and there are no pinched vertices.
class HandleSearch {
 public:
  HandleSearch(std::span<const int> sizes, Family family, const std::function<void(const Handle&)>& visit);
  void forbid(int u, int v) { used(u, v) = used(v, u) = 1; }
  void run() { tryBoundary(0); }

 private:
  bool isBoundaryEdge(int u, int v) const { return next_[u] == v; }
  char& used(int u, int v) { return used_[idx(u) * next_.size() + idx(v)]; }
  void search();
  void complete();
  void tryFace(int u, int v, int w);
  void tryBoundary(int v);
  bool mayUse(int u, int v);
  bool allowed(const Triangle& face, int apex) const;
  void mark(const Triangle& face, int apex, int sign);
  int apexOf(const Triangle& face) const;

  Family family_;
  int mostTypeTwo_;
  std::vector<int> cap_;         // of each vertex
  std::vector<int> next_;        // along the boundary of its cap
  std::vector<int> previous_;    // likewise
  std::vector<char> surjected_;  // vertices that Example 8 wants to be an apex
  std::vector<char> used_;
  std::vector<int> apexCount_;
  std::vector<int> typeTwoCount_;
  int typeTwo_ = 0;
  std::uint64_t trials_ = 0;
  std::vector<NeededEdge> needed_;  // what is used by now is skipped
  int lastNeeded_ = -1;
  Handle faces_;
  const std::function<void(const Handle&)>& visit_;
};

HandleSearch::HandleSearch(std::span<const int> sizes, Family family,
                           const std::function<void(const Handle&)>& visit)
    : family_(family), mostTypeTwo_(2 * static_cast<int>(sizes.size()) - 4), visit_(visit) {
  const int smallest = *std::min_element(sizes.begin(), sizes.end());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const int first = static_cast<int>(cap_.size());
    for (int v = 0; v < sizes[i]; ++v) {
      cap_.push_back(static_cast<int>(i));
      next_.push_back(first + (v + 1) % sizes[i]);
      previous_.push_back(first + (v + sizes[i] - 1) % sizes[i]);
      surjected_.push_back(family == Family::monotone && sizes[i] == smallest ? 1 : 0);
    }
  }
  used_.resize(cap_.size() * cap_.size(), 0);
  apexCount_.resize(cap_.size(), 0);
  typeTwoCount_.resize(cap_.size(), 0);
}

//! The vertex of a Type 1 face opposite its boundary edge, -1 for Type 2.
int HandleSearch::apexOf(const Triangle& face) const {
  for (std::size_t k = 0; k < 3; ++k) {
    if (isBoundaryEdge(face[k], face[(k + 1) % 3])) return face[(k + 2) % 3];
  }
  return -1;
}

bool HandleSearch::mayUse(int u, int v) {
  return used(u, v) == 0 && (cap_[u] != cap_[v] || isBoundaryEdge(u, v));
}

bool HandleSearch::allowed(const Triangle& face, int apex) const {
  if (apex < 0 && typeTwo_ == mostTypeTwo_) return false;
  if (family_ != Family::balanced) return true;
  if (apex >= 0) return apexCount_[apex] == 0;
  return std::all_of(face.begin(), face.end(), [&](int v) { return typeTwoCount_[v] == 0; });
}

void HandleSearch::mark(const Triangle& face, int apex, int sign) {
  for (std::size_t k = 0; k < 3; ++k) used(face[k], face[(k + 1) % 3]) = sign > 0 ? 1 : 0;
  if (apex >= 0) {
    apexCount_[apex] += sign;
    return;
  }
  typeTwo_ += sign;
  for (const int v : face) typeTwoCount_[v] += sign;
}

void HandleSearch::tryFace(int u, int v, int w) {
  if (++trials_ > kMaxTrials) {
    throw UsageError("The handles for caps of these sizes are too many to search for; use smaller caps.");
  }
  if (!mayUse(u, v) || !mayUse(v, w) || !mayUse(w, u)) return;
  const Triangle face = {u, v, w};
  const int apex = apexOf(face);
  if (!allowed(face, apex)) return;
  mark(face, apex, 1);
  faces_.push_back(face);
  const int lastBefore = lastNeeded_;
  const std::size_t sizeBefore = needed_.size();
  for (std::size_t k = 0; k < 3; ++k) {
    const int from = face[(k + 1) % 3];
    const int to = face[k];
    if (cap_[from] == cap_[to]) continue;
    needed_.push_back({from, to, lastNeeded_});
    lastNeeded_ = static_cast<int>(needed_.size()) - 1;
  }
  search();
  needed_.resize(sizeBefore);
  lastNeeded_ = lastBefore;
  faces_.pop_back();
  mark(face, apex, -1);
}

//! A face on the boundary edge that leaves v.
void HandleSearch::tryBoundary(int v) {
  for (int w = 0; w < static_cast<int>(cap_.size()); ++w) {
    if (cap_[w] != cap_[v]) tryFace(v, next_[v], w);
  }
}

void HandleSearch::search() {
  while (lastNeeded_ >= 0) {
    const NeededEdge& edge = needed_[lastNeeded_];
    if (used(edge.from, edge.to) == 0) break;
    lastNeeded_ = edge.below;
  }
  if (lastNeeded_ < 0) return complete();
  const int u = needed_[lastNeeded_].from;
  const int v = needed_[lastNeeded_].to;
  tryFace(u, v, previous_[u]);
  tryFace(u, v, next_[v]);
  if (typeTwo_ == mostTypeTwo_) return;
  for (int w = 0; w < static_cast<int>(cap_.size()); ++w) {
    if (cap_[w] != cap_[u] && cap_[w] != cap_[v]) tryFace(u, v, w);
  }
}

//! Nothing is needed between the caps: keeps the faces if they are a handle.
void HandleSearch::complete() {
  if (faces_.size() != cap_.size() + static_cast<std::size_t>(mostTypeTwo_)) return;
  for (std::size_t v = 0; v < cap_.size(); ++v) {
    if (surjected_[v] != 0 && apexCount_[v] == 0) return;
  }
  visit_(faces_);
}

}  // namespace

void forEachHandle(std::span<const int> sizes, Family family, const std::function<void(const Handle&)>& visit,
                   std::span<const std::array<int, 2>> forbidden) {
  checkSizes(sizes, family);
  if (std::accumulate(sizes.begin(), sizes.end(), 0.0) > kMaxListedVertices) {
    throw UsageError("Handles are listed for caps of at most " + std::to_string(kMaxListedVertices) +
                     " vertices together; use smaller caps.");
  }
  HandleSearch search(sizes, family, visit);
  for (const auto& [u, v] : forbidden) search.forbid(u, v);
  search.run();
}

std::vector<Handle> enumerateHandles(std::span<const int> sizes, Family family) {
  std::vector<Handle> found;
  forEachHandle(sizes, family, [&](const Handle& handle) {
    if (found.size() == kMaxListedHandles) {
      throw UsageError("There are more than " + std::to_string(kMaxListedHandles) +
                       " handles for caps of these sizes, too many to list; use smaller caps.");
    }
    found.push_back(normalised(handle));
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace handlebody
