#include "core/mesh/loop_search.h"

#include <algorithm>
#include <atomic>

#include "core/indices.h"
#include "core/threads.h"

namespace handlebody {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

// At most so many at once: what they find may be much, and little of it is kept.
constexpr std::size_t kBasesPerTree = 8;

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

LoopSearch::LoopSearch(const Mesh& mesh, const LoopClasses& classes)
    : classes_(classes), graph_(mesh, classes) {
  trees_.emplace_back(graph_);
}

void LoopSearch::searchFrom(const LoopBase& base) {
  keep(candidates(trees_.front(), base));
  double& radius = searched_.try_emplace(base.vertex, base.radius).first->second;
  radius = std::max(radius, base.radius);
}

void LoopSearch::searchFrom(std::span<const LoopBase> bases, int threads) {
  const std::vector<LoopBase> left = notSearched(bases);
  const std::size_t trees = idx(std::max(1, threads)), atOnce = kBasesPerTree * trees;
  while (trees_.size() < std::min(trees, left.size())) trees_.emplace_back(graph_);
  for (std::size_t first = 0; first < left.size(); first += atOnce)
    searchAtOnce(std::span(left).subspan(first, std::min(atOnce, left.size() - first)), threads);
}

//! What is kept is kept in the order of the bases.
void LoopSearch::searchAtOnce(std::span<const LoopBase> bases, int threads) {
  std::vector<std::vector<Candidate>> found(bases.size());
  std::atomic<std::size_t> next{0};
  forEachOnThreads(std::min(trees_.size(), bases.size()), threads, [&](std::size_t t) {
    for (std::size_t i = next++; i < bases.size(); i = next++) found[i] = candidates(trees_[t], bases[i]);
  });
  for (std::vector<Candidate>& some : found) keep(std::move(some));
}

//! Those that may have something new, each once.
std::vector<LoopBase> LoopSearch::notSearched(std::span<const LoopBase> bases) {
  std::vector<LoopBase> out;
  for (const LoopBase& base : bases) {
    const auto [known, isNew] = searched_.try_emplace(base.vertex, base.radius);
    if (!isNew && base.radius <= known->second) continue;
    known->second = base.radius;
    out.push_back(base);
  }
  return out;
}

//! What may be shorter than what has been kept.
std::vector<LoopSearch::Candidate> LoopSearch::candidates(LoopTree& tree, const LoopBase& base) const {
  tree.spread(base.vertex, base.radius);
  struct Closing {
    double length;
    const LoopGraph::Arc* arc;
  };
  std::map<Key, Closing> best[3];
  tree.forEachLoop(2 * base.radius, [&](double length, const LoopGraph::Arc& arc, const ClassKey& key) {
    if (key.outer == 0 && key.inner == 0) return;  // bounds on the surface
    const auto kind = key.outer == 0   ? LoopKind::handle
                      : key.inner == 0 ? LoopKind::tunnel
                                       : LoopKind::neither;
    if (kind == LoopKind::neither && !keepsOthers_) return;
    const std::uint64_t number = key.outer + key.inner;
    if (number > 0 - number) return;  // the same loop the other way comes, too
    auto& closing = best[static_cast<int>(kind)]
                        .try_emplace(Key{key.outer, key.inner}, Closing{kFar, nullptr})
                        .first->second;
    if (length < closing.length) closing = {length, &arc};
  });
  std::vector<Candidate> out;
  for (int kind = 0; kind < 3; ++kind)
    for (const auto& [key, closing] : best[kind]) {
      const auto known = found_[kind].find(key);
      if (known != found_[kind].end() && closing.length >= known->second.length) continue;
      std::vector<int> loop = tree.loopOf(*closing.arc);
      const double length = graph_.lengthOf(loop);
      out.push_back({static_cast<LoopKind>(kind), key, closing.length, {length, std::move(loop)}});
    }
  return out;
}

void LoopSearch::keep(std::vector<Candidate> candidates) {
  for (Candidate& c : candidates) {
    Found& found = found_[static_cast<int>(c.kind)][c.key];
    if (c.withPaths < found.length && c.loop.length < found.length) found = std::move(c.loop);
  }
}

EdgeLoop LoopSearch::loopThrough(const LoopBase& base, const ClassKey& key) {
  LoopTree& tree = trees_.front();
  tree.spread(base.vertex, base.radius);
  double shortest = 2 * base.radius;
  const LoopGraph::Arc* closing = nullptr;
  tree.forEachLoop(shortest, [&](double length, const LoopGraph::Arc& arc, const ClassKey& sum) {
    if (!(length < shortest) || !(sum == key)) return;
    shortest = length;
    closing = &arc;
  });
  EdgeLoop out;
  out.key = key;
  if (closing == nullptr) return out;
  out.vertices = tree.loopOf(*closing);
  out.length = graph_.lengthOf(out.vertices);
  return out;
}

EdgeLoop LoopSearch::described(const Found& found, LoopKind kind) const {
  EdgeLoop out{found.vertices, found.length, kind, {}, {}};
  out.coordinates.assign(classes_.rank(), 0);
  for (std::size_t i = 0; i < out.vertices.size(); ++i) {
    const int h = graph_.mesh().findHalfedge(out.vertices[i], out.vertices[(i + 1) % out.vertices.size()]);
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
