#include "core/mesh/loop_search.h"

#include <algorithm>
#include <queue>

#include "core/cancellation.h"
#include "core/indices.h"

namespace handlebody {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

//! Rows of bits that are independent modulo 2.
class Independent {
 public:
  explicit Independent(int rank) : rows_(idx(rank)) {}
  //! Adds the row if it is no sum of those that are there.
  bool add(std::span<const std::int64_t> coordinates) {
    std::vector<unsigned char> row;
    for (const std::int64_t x : coordinates) row.push_back(static_cast<unsigned char>(x & 1));
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i] == 0) continue;
      if (rows_[i].empty()) {
        rows_[i] = std::move(row);
        return true;
      }
      for (std::size_t j = i; j < row.size(); ++j) row[j] ^= rows_[i][j];
    }
    return false;
  }

 private:
  std::vector<std::vector<unsigned char>> rows_;  // by their first bit
};

}  // namespace

LoopSearch::LoopSearch(const Mesh& mesh, const LoopClasses& classes) : mesh_(mesh), classes_(classes) {
  const std::size_t n = idx(mesh.vertexSlots());
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    firstArc_.push_back(arcs_.size());
    mesh.forEachOutgoing(v, [&](int h) {
      arcs_.push_back({h, mesh.target(h), (mesh.position(mesh.target(h)) - mesh.position(v)).norm()});
    });
  }
  firstArc_.push_back(arcs_.size());
  distance_.assign(n, kFar);
  parent_.assign(n, -1);
  key_.assign(n, {});
}

void LoopSearch::spread(int base, double radius) {
  giveUpIfCancelled();
  for (const int v : reached_) distance_[v] = kFar;
  reached_.clear();
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance_[base] = 0;
  parent_[base] = -1;
  key_[base] = {};
  reached_.push_back(base);
  queue.emplace(0, base);
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance_[v]) continue;
    for (std::size_t a = firstArc_[v]; a < firstArc_[idx(v) + 1]; ++a) {
      const Arc& arc = arcs_[a];
      const double there = d + arc.length;
      double& known = distance_[arc.target];
      if (there >= known || there > radius) continue;
      if (known == kFar) reached_.push_back(arc.target);
      known = there;
      parent_[arc.target] = arc.halfedge;
      key_[arc.target] = key_[v];
      key_[arc.target] += classes_.key(arc.halfedge);
      queue.emplace(there, arc.target);
    }
  }
}

void LoopSearch::searchFrom(int base, double radius) {
  spread(base, radius);
  collect(radius);
}

void LoopSearch::collect(double radius) {
  struct Closing {
    double length;
    int halfedge;
  };
  std::map<Key, Closing> best[3];
  for (const int v : reached_)
    for (std::size_t a = firstArc_[v]; a < firstArc_[idx(v) + 1]; ++a) {
      const Arc& arc = arcs_[a];
      const double length = distance_[v] + arc.length + distance_[arc.target];
      if (length > 2 * radius || parent_[arc.target] == arc.halfedge) continue;
      ClassKey key = key_[v];
      key += classes_.key(arc.halfedge);
      key -= key_[arc.target];
      if (key.outer == 0 && key.inner == 0) continue;  // bounds on the surface
      const auto kind = key.outer == 0   ? LoopKind::handle
                        : key.inner == 0 ? LoopKind::tunnel
                                         : LoopKind::neither;
      if (kind == LoopKind::neither && !keepsOthers_) continue;
      const std::uint64_t number = key.outer + key.inner;
      if (number > 0 - number) continue;  // the same loop the other way comes, too
      auto& closing = best[static_cast<int>(kind)]
                          .try_emplace(Key{key.outer, key.inner}, Closing{kFar, -1})
                          .first->second;
      if (length < closing.length) closing = {length, arc.halfedge};
    }
  for (int kind = 0; kind < 3; ++kind)
    for (const auto& [key, closing] : best[kind]) {
      Found& found = found_[kind][key];
      if (closing.length >= found.length) continue;
      std::vector<int> vertices = path(mesh_.origin(closing.halfedge), mesh_.target(closing.halfedge));
      const double length = lengthOf(vertices);
      if (length < found.length) found = {length, std::move(vertices)};
    }
}

double LoopSearch::lengthOf(const std::vector<int>& loop) const {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (mesh_.position(loop[(i + 1) % loop.size()]) - mesh_.position(loop[i])).norm();
  return length;
}

EdgeLoop LoopSearch::loopThrough(int base, const ClassKey& key, double radius) {
  spread(base, radius);
  double shortest = 2 * radius;
  const Arc* closing = nullptr;
  for (const int v : reached_)
    for (std::size_t a = firstArc_[v]; a < firstArc_[idx(v) + 1]; ++a) {
      const Arc& arc = arcs_[a];
      const double length = distance_[v] + arc.length + distance_[arc.target];
      if (!(length < shortest)) continue;
      ClassKey sum = key_[v];
      sum += classes_.key(arc.halfedge);
      sum -= key_[arc.target];
      if (!(sum == key)) continue;
      shortest = length;
      closing = &arc;
    }
  EdgeLoop out;
  out.key = key;
  if (closing == nullptr) return out;
  out.vertices = path(mesh_.origin(closing->halfedge), closing->target);
  out.length = lengthOf(out.vertices);
  return out;
}

//! From the place where the paths to u and w part, to u, to w and back: what both share is left out.
std::vector<int> LoopSearch::path(int u, int w) const {
  const auto toBase = [&](int v) {
    std::vector<int> out{v};
    while (parent_[v] >= 0) out.push_back(v = mesh_.origin(parent_[v]));
    return out;
  };
  std::vector<int> there = toBase(u), back = toBase(w);
  while (there.size() > 1 && back.size() > 1 && there[there.size() - 2] == back[back.size() - 2]) {
    there.pop_back();
    back.pop_back();
  }
  std::reverse(there.begin(), there.end());
  there.insert(there.end(), back.begin(), back.end() - 1);
  return there;
}

EdgeLoop LoopSearch::described(const Found& found, LoopKind kind) const {
  EdgeLoop out{found.vertices, found.length, kind, {}, {}};
  out.coordinates.assign(classes_.rank(), 0);
  for (std::size_t i = 0; i < out.vertices.size(); ++i) {
    const int h = mesh_.findHalfedge(out.vertices[i], out.vertices[(i + 1) % out.vertices.size()]);
    classes_.addTo(out.coordinates, h);
    out.key += classes_.key(h);
  }
  return out;
}

std::vector<const LoopSearch::Found*> LoopSearch::byLength(LoopKind kind) const {
  std::vector<const Found*> order;
  for (const auto& [key, found] : found_[static_cast<int>(kind)]) order.push_back(&found);
  std::stable_sort(order.begin(), order.end(),
                   [](const Found* a, const Found* b) { return a->length < b->length; });
  return order;
}

std::vector<EdgeLoop> LoopSearch::basis(LoopKind kind) const {
  Independent chosen(classes_.rank());
  std::vector<EdgeLoop> out;
  for (const Found* found : byLength(kind)) {
    if (2 * static_cast<int>(out.size()) == classes_.rank()) break;
    EdgeLoop loop = described(*found, kind);
    if (classes_.isOfKind(loop.coordinates, kind) && chosen.add(loop.coordinates))
      out.push_back(std::move(loop));
  }
  return out;
}

std::vector<EdgeLoop> LoopSearch::others(const std::vector<EdgeLoop>& given) const {
  Independent chosen(classes_.rank());
  int count = 0;
  for (const EdgeLoop& loop : given) count += chosen.add(loop.coordinates);
  std::vector<EdgeLoop> out;
  for (const Found* found : byLength(LoopKind::neither)) {
    if (count == classes_.rank()) break;
    EdgeLoop loop = described(*found, LoopKind::neither);
    if (!chosen.add(loop.coordinates)) continue;
    out.push_back(std::move(loop));
    ++count;
  }
  return out;
}

}  // namespace handlebody
