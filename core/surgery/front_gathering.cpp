#include "core/surgery/front_gathering.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>

#include "core/indices.h"
#include "core/mesh/union_find.h"

namespace handlebody {

namespace {

//! Edges on the way from a set to others, found by spreading from all sets at once.
class Reach {
 public:
  Reach(const Mesh& mesh, std::span<const std::vector<int>* const> sets, int reach) : mesh_(mesh) {
    std::vector<int> front;
    for (std::size_t s = 0; s < sets.size(); ++s)
      for (const int v : *sets[s]) {
        nearest_[v] = {static_cast<int>(s), -1, 0};
        front.push_back(v);
      }
    // Two sets that are n edges apart meet after n / 2 steps, rounded down, on an edge or at a vertex.
    for (int step = 0; step < reach / 2; ++step) front = spread(front, step + 1);
    for (const auto& [v, place] : nearest_) mesh_.forEachNeighbour(v, [&](int w) { meet(v, w, reach); });
  }

  struct Bridge {
    int from, to;              // sets, from < to
    int length;                // edges
    std::vector<int> between;  // vertices on the way
  };
  //! Between sets at most `reach` apart: a shortest one for each two, in the order of the sets.
  std::vector<Bridge> bridges() const {
    std::vector<Bridge> out;
    for (const auto& [sets, edge] : meeting_) {
      Bridge b{sets.first, sets.second, edge.length, {}};
      for (int v : {edge.u, edge.v})
        for (; nearest_.at(v).from >= 0; v = nearest_.at(v).from) b.between.push_back(v);
      out.push_back(std::move(b));
    }
    return out;
  }

 private:
  struct Reached {
    int set;
    int from;  // the vertex it was reached from, -1 in the set
    int distance;
  };
  struct Meeting {
    int length, u, v;
  };
  std::vector<int> spread(const std::vector<int>& front, int distance) {
    std::vector<int> next;
    for (const int v : front) {
      const int set = nearest_.at(v).set;
      mesh_.forEachNeighbour(v, [&](int w) {
        if (nearest_.try_emplace(w, Reached{set, v, distance}).second) next.push_back(w);
      });
    }
    return next;
  }
  void meet(int u, int v, int reach) {
    const auto other = nearest_.find(v);
    if (other == nearest_.end()) return;
    const Reached &a = nearest_.at(u), &b = other->second;
    const int length = a.distance + b.distance + 1;
    if (a.set >= b.set || length > reach) return;
    const auto [it, fresh] = meeting_.try_emplace({a.set, b.set}, Meeting{length, u, v});
    if (!fresh && length < it->second.length) it->second = {length, u, v};
  }

  const Mesh& mesh_;
  std::map<int, Reached> nearest_;
  std::map<std::pair<int, int>, Meeting> meeting_;
};

//! The sets of all groups that may be gathered, which of them are one front, and which groups meet there.
class Gatherer {
 public:
  Gatherer(const Mesh& mesh, const std::vector<CollisionGroup>& groups, int reach)
      : groups_(groups), fronts_(countSets(groups)), places_(groups.size()) {
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (groups[g].lambda.size() < 2) continue;  // a fold
      for (const auto& lambda : groups[g].lambda) {
        sets_.push_back(&lambda);
        groupOf_.push_back(static_cast<int>(g));
      }
    }
    for (Reach::Bridge& b : Reach(mesh, sets_, reach).bridges()) {
      if (fronts_.find(b.from) == fronts_.find(b.to)) continue;
      fronts_.join(b.from, b.to);
      places_.join(groupOf_[b.from], groupOf_[b.to]);
      bridges_.push_back(std::move(b));
    }
  }

  //! What the group belongs to, if it is the first of several and they are to be gathered.
  std::optional<Gathering> gather(int group) {
    if (places_.find(group) != group) return std::nullopt;
    Gathering out;
    for (std::size_t g = 0; g < groups_.size(); ++g)
      if (places_.find(static_cast<int>(g)) == group) out.parts.push_back(groups_[g]);
    std::map<int, std::vector<int>> fronts;  // by the representative of their sets
    for (std::size_t s = 0; s < sets_.size(); ++s)
      if (places_.find(groupOf_[s]) == group) append(fronts[fronts_.find(static_cast<int>(s))], *sets_[s]);
    const bool several = out.parts.size() > 1 && fronts.size() > 2;
    if (!several || !everyGroupHasTwoFronts(group)) return std::nullopt;
    for (const Reach::Bridge& b : bridges_)
      if (places_.find(groupOf_[b.from]) == group) append(fronts[fronts_.find(b.from)], b.between);
    for (auto& [set, lambda] : fronts) out.whole.lambda.push_back(std::move(lambda));
    for (const CollisionGroup& part : out.parts)
      out.whole.pairs.insert(out.whole.pairs.end(), part.pairs.begin(), part.pairs.end());
    std::sort(out.whole.pairs.begin(), out.whole.pairs.end());
    return out;
  }
  //! With a group before it.
  bool isGathered(int group) {
    const int first = places_.find(group);
    return first != group && gather(first).has_value();
  }

 private:
  static std::size_t countSets(const std::vector<CollisionGroup>& groups) {
    std::size_t n = 0;
    for (const CollisionGroup& g : groups) n += g.lambda.size();
    return n;
  }
  static void append(std::vector<int>& lambda, const std::vector<int>& more) {
    lambda.insert(lambda.end(), more.begin(), more.end());
    sortUnique(lambda);
  }
  //! No group has come to collide with itself.
  bool everyGroupHasTwoFronts(int place) {
    std::map<int, std::map<int, int>> fronts;
    for (std::size_t s = 0; s < sets_.size(); ++s)
      if (places_.find(groupOf_[s]) == place) ++fronts[groupOf_[s]][fronts_.find(static_cast<int>(s))];
    return std::all_of(fronts.begin(), fronts.end(), [](const auto& g) { return g.second.size() > 1; });
  }

  const std::vector<CollisionGroup>& groups_;
  std::vector<const std::vector<int>*> sets_;
  std::vector<int> groupOf_;
  UnionFind fronts_;  // over sets
  UnionFind places_;  // over groups
  std::vector<Reach::Bridge> bridges_;
};

}  // namespace

std::vector<Gathering> gatherFronts(const Mesh& mesh, const std::vector<CollisionGroup>& groups, int reach) {
  Gatherer gatherer(mesh, groups, reach);
  std::vector<Gathering> out;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (gatherer.isGathered(static_cast<int>(g))) continue;
    if (auto several = gatherer.gather(static_cast<int>(g)))
      out.push_back(std::move(*several));
    else
      out.push_back({groups[g], {}});
  }
  return out;
}

}  // namespace handlebody
