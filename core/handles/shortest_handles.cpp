#include "core/handles/shortest_handles.h"

#include <algorithm>
#include <cassert>
#include <deque>
#include <numeric>
#include <utility>

#include "core/cancellation.h"
#include "core/handles/disc_triangulation.h"
#include "core/handles/handle_bound.h"
#include "core/handles/listed_handles.h"
#include "core/handles/partial_handle.h"
#include "core/indices.h"

namespace handlebody {

namespace {

constexpr double kNone = CrossEdges::kNone;
constexpr std::size_t kMaxLoops = 4;
constexpr int kRoundsAgain = 20;
constexpr int kRounds = 1000;                    // of the search for a good lower bound
constexpr std::size_t kRoundsWork = 30'000'000;  // that they may cost, for long loops

std::vector<Triangle> sortedFaces(const PartialHandle& p) {
  std::vector<Triangle> faces = p.taken;
  std::sort(faces.begin(), faces.end());
  return faces;
}

HandleCandidate candidate(const PartialHandle& p, const std::vector<Triangle>& rest, double length) {
  HandleCandidate handle{p.taken, length};
  handle.faces.insert(handle.faces.end(), rest.begin(), rest.end());
  return handle;
}

bool has(const Handle& handle, Triangle face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return std::binary_search(handle.begin(), handle.end(), face);
}

//! One polygon that is left, with the triangulation that comes next in it.
struct Next {
  std::shared_ptr<const DiscTriangulation> discs;
  int partial = 0;
  std::vector<int> prefix;
  int rank = 0;
};

}  // namespace

class ShortestHandles::Search {
 public:
  Search(std::span<const std::vector<Vec3>> loops, std::span<const VertexPair> forbiddenEdges,
         std::size_t maxWork);
  std::optional<HandleCandidate> nextListed();
  std::optional<HandleCandidate> next();
  void forbid(std::span<const Triangle> faces, std::span<const VertexPair> edges);
  bool gaveUp() const { return gaveUp_; }
  std::size_t workDone() const { return work_.done; }

 private:
  enum class Kind { branch, solved, next };
  struct Entry {
    double length;  // exact, or a lower bound for a branch
    std::size_t order;
    Kind kind;
    std::size_t index;
    bool operator<(const Entry& o) const {  // for a heap with the least on top
      return length != o.length ? length > o.length : order > o.order;
    }
  };
  //! A polygon whose shortest triangulation is known.
  struct Solved {
    int partial;
    std::shared_ptr<const DiscTriangulation> discs;  // none: not kept, solved again when it is wanted
  };

  void start(int rounds);
  void chooseBranchingEdges();
  std::optional<PartialHandle> anyPartial();
  void giveUp();
  void count(std::size_t steps);
  void push(double length, Kind kind, std::size_t index);
  bool isUsed(const PartialHandle& p, int u, int v) const;

  void expand(int partial);
  std::pair<int, int> sideToJoin(const PartialHandle& p) const;
  void branchTo(HandleBranch b, const Triangle& face);
  void branchWithin(HandleBranch b);
  void takeBranch(const HandleBranch& b);

  DiscTriangulation discsOf(const PartialHandle& p) const;
  void solve(int partial);
  void openSolved(const Solved& s, double length);
  void separate(const DiscTriangulation& discs, int partial, const std::array<Chord, 2>& pair);
  std::optional<HandleCandidate> follow(const Next& n, double length);
  std::optional<HandleCandidate> searchOn();

  CrossEdges edges_;
  HandleBound bound_;
  std::vector<int> joinOrder_;        // loops, those with the best branching edge first
  std::vector<int> branchingVertex_;  // of each loop: where its edge starts
  std::vector<Entry> heap_;
  std::size_t pushed_ = 0;
  std::deque<PartialHandle> partials_;
  std::deque<HandleBranch> branches_;
  std::deque<Solved> solved_;
  std::deque<Next> nexts_;
  struct Work {
    std::size_t left;
    std::size_t done;
  };
  Work work_;
  bool gaveUp_ = false;
  bool isFresh_ = false;  // nothing has been taken from the heap
  // As it was before a handle came from the list, which the search has yet to find: else none.
  std::optional<Work> beforeListed_;
};

ShortestHandles::Search::Search(std::span<const std::vector<Vec3>> loops,
                                std::span<const VertexPair> forbiddenEdges, std::size_t maxWork)
    : edges_(loops, forbiddenEdges), bound_(edges_), work_{maxWork, 0} {
  assert(loops.size() >= 2 && loops.size() <= kMaxLoops);
  PartialHandle whole;
  for (int k = 0; k < edges_.loopCount(); ++k) {
    if (edges_.firstOf(k + 1) - edges_.firstOf(k) < 3) return;
    Word& word = whole.loops.emplace_back(idx(edges_.firstOf(k + 1) - edges_.firstOf(k)));
    std::iota(word.begin(), word.end(), edges_.firstOf(k));
  }
  partials_.push_back(std::move(whole));
  start(kRounds);
}

void ShortestHandles::Search::start(int rounds) {
  isFresh_ = true;
  if (!(bound_.ofAll() < kNone)) return;
  chooseBranchingEdges();
  if (edges_.loopCount() > 2) {
    const std::optional<PartialHandle> any = anyPartial();
    if (any) {
      const auto vertices = idx(edges_.vertexCount());
      const auto affordable = std::max<std::size_t>(kRoundsAgain, kRoundsWork / (vertices * vertices));
      work_.done += idx(bound_.tighten(discsOf(*any).solve() + edges_.lengthOf(any->taken),
                                       std::min(rounds, static_cast<int>(affordable)))) *
                    vertices * vertices;
    }
    chooseBranchingEdges();
  }
  expand(0);
}

//! The shares found so far stay good ones; all else is done anew.
void ShortestHandles::Search::forbid(std::span<const Triangle> faces, std::span<const VertexPair> edges) {
  edges_.forbid(faces);
  edges_.forbid(edges);
  if (partials_.empty()) return;
  partials_.resize(1);
  heap_.clear();
  branches_.clear();
  solved_.clear();
  nexts_.clear();
  beforeListed_.reset();
  bound_.update(edges);
  start(kRoundsAgain);
  if (gaveUp_) giveUp();
}

//! Where a wrong third corner costs most, so that few branches are followed.
void ShortestHandles::Search::chooseBranchingEdges() {
  std::vector<double> excess;
  for (int v = 0; v < edges_.vertexCount(); ++v) excess.push_back(bound_.meanExcess(v));
  branchingVertex_.clear();
  for (const Word& word : partials_[0].loops)
    branchingVertex_.push_back(
        *std::max_element(word.begin(), word.end(), [&](int u, int v) { return excess[u] < excess[v]; }));
  joinOrder_.resize(branchingVertex_.size());
  std::iota(joinOrder_.begin(), joinOrder_.end(), 0);
  std::stable_sort(joinOrder_.begin(), joinOrder_.end(),
                   [&](int a, int b) { return excess[branchingVertex_[a]] > excess[branchingVertex_[b]]; });
}

void ShortestHandles::Search::count(std::size_t steps) {
  work_.left -= std::min(work_.left, steps);
  work_.done += steps;
  giveUpIfCancelled();
}

//! Behind the branches that look best one by one.
std::optional<PartialHandle> ShortestHandles::Search::anyPartial() {
  PartialHandle p = partials_[0];
  while (!p.loops.empty()) {
    const auto [loop, side] = sideToJoin(p);
    const Word& word = p.loops[loop];
    HandleBranch best;
    double least = kNone;
    for (std::size_t l = 0; l < p.loops.size(); ++l) {
      if (static_cast<int>(l) == loop) continue;
      for (std::size_t i = 0; i < p.loops[l].size(); ++i) {
        const Triangle face{word[side], word[(idx(side) + 1) % word.size()], p.loops[l][i]};
        const double length = edges_.allows(face) ? bound_.with(p.taken, face) : kNone;
        if (length >= least) continue;
        least = length;
        best = {0, loop, side, static_cast<int>(l), static_cast<int>(i), true};
      }
    }
    if (least == kNone) return std::nullopt;
    take(p, best);
  }
  return p;
}

//! From now on only what has been found counts, and the handle that looked best at first.
void ShortestHandles::Search::giveUp() {
  gaveUp_ = true;
  std::optional<PartialHandle> any = anyPartial();
  if (!any) return;
  const auto same = [&](const Solved& s) { return sortedFaces(partials_[s.partial]) == sortedFaces(*any); };
  if (std::any_of(solved_.begin(), solved_.end(), same)) return;
  partials_.push_back(std::move(*any));
  solve(static_cast<int>(partials_.size()) - 1);
}

void ShortestHandles::Search::push(double length, Kind kind, std::size_t index) {
  heap_.push_back({length, pushed_++, kind, index});
  std::push_heap(heap_.begin(), heap_.end());
}

bool ShortestHandles::Search::isUsed(const PartialHandle& p, int u, int v) const {
  return std::any_of(p.taken.begin(), p.taken.end(), [&](const Triangle& t) {
    return std::count(t.begin(), t.end(), u) + std::count(t.begin(), t.end(), v) == 2;
  });
}

//! The loop and the place of the side whose face is to be chosen: the branching edge of a loop that has not
//! been joined to another, or, of two joined pairs, the side of the last that comes closest to the other.
std::pair<int, int> ShortestHandles::Search::sideToJoin(const PartialHandle& p) const {
  for (const int k : joinOrder_) {
    for (std::size_t l = 0; l < p.loops.size(); ++l) {
      const Word& word = p.loops[l];
      const int size = edges_.firstOf(k + 1) - edges_.firstOf(k);
      if (edges_.loopOf(word[0]) == k && static_cast<int>(word.size()) == size)
        return {static_cast<int>(l), branchingVertex_[k] - edges_.firstOf(k)};
    }
  }
  assert(p.loops.size() == 2);
  const Word& word = p.loops[1];
  int best = 0;
  double least = kNone;
  for (std::size_t i = 0; i < word.size(); ++i) {
    for (const int w : p.loops[0]) {
      const double sum = edges_.length(word[i], w) + edges_.length(word[(i + 1) % word.size()], w);
      if (sum >= least) continue;
      least = sum;
      best = static_cast<int>(i);
    }
  }
  return {1, best};
}

void ShortestHandles::Search::expand(int partial) {
  const PartialHandle& p = partials_[partial];
  if (p.loops.empty()) return solve(partial);
  const auto [loop, side] = sideToJoin(p);
  const Word& word = p.loops[loop];
  const int u = word[side];
  const int v = word[(idx(side) + 1) % word.size()];
  for (std::size_t l = 0; l < p.loops.size(); ++l) {
    if (static_cast<int>(l) == loop) continue;
    for (std::size_t i = 0; i < p.loops[l].size(); ++i)
      branchTo({partial, loop, side, static_cast<int>(l), static_cast<int>(i), true}, {u, v, p.loops[l][i]});
  }
  for (std::size_t i = 2; i < word.size(); ++i) {
    const int apex = static_cast<int>((idx(side) + i) % word.size());
    branchWithin({partial, loop, side, loop, apex, true});
    branchWithin({partial, loop, side, loop, apex, false});
  }
}

void ShortestHandles::Search::branchTo(HandleBranch b, const Triangle& face) {
  if (!edges_.allows(face)) return;
  const double length = bound_.with(partials_[b.partial].taken, face);
  if (length == kNone) return;
  branches_.push_back(b);
  push(length, Kind::branch, branches_.size() - 1);
}

//! The third corner lies on the loop of the side itself. Between them are a side of the loop or a new chord;
//! the part with the other loops is bounded by a new chord.
void ShortestHandles::Search::branchWithin(HandleBranch b) {
  const PartialHandle& p = partials_[b.partial];
  const Word& word = p.loops[b.loop];
  const int n = static_cast<int>(word.size());
  const int u = word[b.side];
  const int v = word[(b.side + 1) % n];
  const int w = word[b.apex];
  const int toApex = (b.apex - b.side - 1 + n) % n;  // sides from v to the apex
  const int fromApex = n - 1 - toApex;               // and on to u
  if (b.restAfterApex ? fromApex < 2 : toApex < 2) return;
  const auto open = [&](int from, int to) { return edges_.length(from, to) < kNone && !isUsed(p, from, to); };
  if ((toApex > 1 && !open(v, w)) || (fromApex > 1 && !open(w, u))) return;
  branchTo(b, {u, v, w});
}

void ShortestHandles::Search::takeBranch(const HandleBranch& b) {
  PartialHandle p = partials_[b.partial];
  take(p, b);
  partials_.push_back(std::move(p));
  expand(static_cast<int>(partials_.size()) - 1);
}

DiscTriangulation ShortestHandles::Search::discsOf(const PartialHandle& p) const {
  std::vector<int> places;
  std::vector<int> ends;
  for (const Word& disc : p.discs) {
    places.insert(places.end(), disc.begin(), disc.end());
    ends.push_back(static_cast<int>(places.size()));
  }
  return {edges_, std::move(places), std::move(ends), p.taken};
}

void ShortestHandles::Search::solve(int partial) {
  const PartialHandle& p = partials_[partial];
  DiscTriangulation discs = discsOf(p);
  count(discs.work());
  const double length = discs.solve() + edges_.lengthOf(p.taken);
  if (length == kNone) return;
  solved_.push_back({partial, nullptr});
  push(length, Kind::solved, solved_.size() - 1);
}

//! The shortest of all that is left is in this polygon.
void ShortestHandles::Search::openSolved(const Solved& s, double length) {
  std::shared_ptr<const DiscTriangulation> discs = s.discs;
  if (!discs) {
    auto again = std::make_shared<DiscTriangulation>(discsOf(partials_[s.partial]));
    again->solve();
    work_.done += again->work();
    discs = std::move(again);
  }
  const auto pair = discs->repeatedPair(discs->derive({}, 0));
  if (pair[0].to != 0) return separate(*discs, s.partial, pair);
  nexts_.push_back({std::move(discs), s.partial, {}, 0});
  push(length, Kind::next, nexts_.size() - 1);
}

//! All triangulations without the first chord, and all with the first and without the second.
void ShortestHandles::Search::separate(const DiscTriangulation& discs, int partial,
                                       const std::array<Chord, 2>& pair) {
  auto without = std::make_shared<DiscTriangulation>(discs);
  auto with = std::make_shared<DiscTriangulation>(discs);
  without->exclude(pair[0]);
  with->require(pair[0]);
  with->exclude(pair[1]);
  const double taken = edges_.lengthOf(partials_[partial].taken);
  for (auto& part : {without, with}) {
    count(part->work());
    const double length = part->solve() + taken;
    if (length == kNone) continue;
    solved_.push_back({partial, part});
    push(length, Kind::solved, solved_.size() - 1);
  }
}

//! The handle that `n` stands for, none if it is no simplicial complex; and what comes after it in its
//! polygon.
std::optional<HandleCandidate> ShortestHandles::Search::follow(const Next& n, double length) {
  const DiscTriangulation& discs = *n.discs;
  const auto d = discs.derive(n.prefix, n.rank);
  for (std::size_t step = n.prefix.size(); step < d.bases.size(); ++step) {
    const int rank = step == n.prefix.size() ? n.rank + 1 : 1;
    const double detour = discs.detour(d, step, rank);
    if (detour == kNone) continue;
    const auto end = d.apexes.begin() + static_cast<std::ptrdiff_t>(step);
    nexts_.push_back({n.discs, n.partial, std::vector<int>(d.apexes.begin(), end), rank});
    push(length + detour, Kind::next, nexts_.size() - 1);
  }
  if (discs.repeatedPair(d)[0].to != 0) return std::nullopt;
  return candidate(partials_[n.partial], discs.faces(d), length);
}

std::optional<HandleCandidate> ShortestHandles::Search::searchOn() {
  isFresh_ = false;
  while (!heap_.empty()) {
    if (work_.left == 0 && !gaveUp_) giveUp();
    std::pop_heap(heap_.begin(), heap_.end());
    const Entry entry = heap_.back();
    heap_.pop_back();
    count(1);
    if (entry.kind == Kind::branch) {
      if (!gaveUp_) takeBranch(branches_[entry.index]);
    } else if (entry.kind == Kind::solved) {
      openSolved(solved_[entry.index], entry.length);
    } else {
      const Next n = std::move(nexts_[entry.index]);
      if (auto handle = follow(n, entry.length)) return handle;
    }
  }
  return std::nullopt;
}

//! The faces in the order in which the search gives them, and with its work, as if it had been done: neither
//! the numbers of faces in a mesh nor what a step may still take depends on who found the handle.
std::optional<HandleCandidate> ShortestHandles::Search::nextListed() {
  if (!isFresh_ || gaveUp_) return std::nullopt;
  const std::optional<Handle> listed = shortestListed(edges_);
  if (!listed) return std::nullopt;
  const auto own = std::find_if(heap_.begin(), heap_.end(), [&](const Entry& e) {
    return has(*listed, faceOf(partials_[0], branches_[e.index]));
  });
  assert(own != heap_.end());
  PartialHandle p = partials_[0];
  take(p, branches_[own->index]);
  const DiscTriangulation discs = discsOf(p);
  const auto d = discs.derivationOf(*listed);
  HandleCandidate handle = candidate(p, discs.faces(d), discs.lengthOf(d) + edges_.lengthOf(p.taken));
  // It would solve all branches that can be as short, and open this one.
  const auto solved = static_cast<std::size_t>(std::count_if(
      heap_.begin(), heap_.end(), [&](const Entry& e) { return e.length <= handle.length || !(e < *own); }));
  const std::size_t steps = solved * (1 + discs.work()) + 2;
  if (work_.left <= steps) return std::nullopt;
  isFresh_ = false;
  beforeListed_ = work_;
  count(steps);
  work_.done += discs.work();
  return handle;
}

std::optional<HandleCandidate> ShortestHandles::Search::next() {
  if (beforeListed_) {
    work_ = *std::exchange(beforeListed_, std::nullopt);
    searchOn();
  }
  return searchOn();
}

ShortestHandles::ShortestHandles(std::span<const std::vector<Vec3>> loops,
                                 std::span<const VertexPair> forbiddenEdges, std::size_t maxWork)
    : search_(std::make_unique<Search>(loops, forbiddenEdges, maxWork)) {}
ShortestHandles::~ShortestHandles() = default;
ShortestHandles::ShortestHandles(ShortestHandles&&) noexcept = default;
ShortestHandles& ShortestHandles::operator=(ShortestHandles&&) noexcept = default;

std::optional<HandleCandidate> ShortestHandles::nextListed() { return search_->nextListed(); }
std::optional<HandleCandidate> ShortestHandles::next() { return search_->next(); }
void ShortestHandles::forbid(std::span<const Triangle> faces, std::span<const VertexPair> edges) {
  search_->forbid(faces, edges);
}
std::size_t ShortestHandles::workDone() const { return search_->workDone(); }
bool ShortestHandles::gaveUp() const { return search_->gaveUp(); }

}  // namespace handlebody
