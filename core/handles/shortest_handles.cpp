#include "core/handles/shortest_handles.h"

#include <algorithm>
#include <cassert>
#include <deque>
#include <numeric>

#include "core/cancellation.h"
#include "core/handles/disc_triangulation.h"
#include "core/handles/handle_bound.h"
#include "core/indices.h"

namespace handlebody {

namespace {

constexpr double kNone = CrossEdges::kNone;
constexpr std::size_t kMaxLoops = 4;
constexpr int kRoundsAgain = 20;
constexpr int kRounds = 1000;                    // of the search for a good lower bound
constexpr std::size_t kRoundsWork = 30'000'000;  // that they may cost, for long loops

//! A boundary polygon of what is left of the handle; its faces hold the sides in this direction.
using Word = std::vector<int>;

//! Some faces of a handle, and what is left of it without them.
struct Partial {
  std::vector<Triangle> taken;
  std::vector<Word> loops;  // of the part that is no disc; none: there are only discs
  std::vector<Word> discs;
};

std::vector<Triangle> sortedFaces(const Partial& p) {
  std::vector<Triangle> faces = p.taken;
  std::sort(faces.begin(), faces.end());
  return faces;
}

//! The face on the side of loops.back() or of a whole loop that is to be joined next, by its third corner.
struct Branch {
  int partial = 0;  // index of what it continues
  int loop = 0;     // with the side
  int side = 0;     // its place
  int otherLoop = 0;
  int apex = 0;            // its place in otherLoop
  bool restBehind = true;  // apex on the same loop: the other loops lie between side and apex, not behind it
};

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
  std::optional<HandleCandidate> next();
  void forbid(std::span<const Triangle> faces, std::span<const VertexPair> edges);
  bool gaveUp() const { return gaveUp_; }
  std::size_t workDone() const { return workDone_; }

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
  void chooseTellingEdges();
  std::optional<Partial> anyPartial();
  void giveUp();
  void count(std::size_t steps);
  static Triangle faceOf(const Partial& p, const Branch& b);
  void push(double length, Kind kind, std::size_t index);
  double takenLength(const Partial& p) const;
  bool isUsed(const Partial& p, int u, int v) const;

  void expand(int partial);
  std::pair<int, int> sideToJoin(const Partial& p) const;
  void branchTo(Branch b, const Triangle& face);
  void branchWithin(Branch b);
  void take(const Branch& b);
  void join(Partial& p, const Branch& b) const;
  void split(Partial& p, const Branch& b) const;

  DiscTriangulation discsOf(const Partial& p) const;
  void solve(int partial);
  void openSolved(const Solved& s, double length);
  void separate(const DiscTriangulation& discs, int partial, const std::array<Chord, 2>& pair);
  std::optional<HandleCandidate> follow(const Next& n, double length);

  CrossEdges edges_;
  HandleBound bound_;
  std::vector<int> joinOrder_;      // loops, those with the most telling edge first
  std::vector<int> tellingVertex_;  // of each loop: where its edge starts
  std::vector<Entry> heap_;
  std::size_t pushed_ = 0;
  std::deque<Partial> partials_;
  std::deque<Branch> branches_;
  std::deque<Solved> solved_;
  std::deque<Next> nexts_;
  std::size_t workLeft_;
  std::size_t workDone_ = 0;
  bool gaveUp_ = false;
};

ShortestHandles::Search::Search(std::span<const std::vector<Vec3>> loops,
                                std::span<const VertexPair> forbiddenEdges, std::size_t maxWork)
    : edges_(loops, forbiddenEdges), bound_(edges_), workLeft_(maxWork) {
  assert(loops.size() >= 2 && loops.size() <= kMaxLoops);
  Partial whole;
  for (int k = 0; k < edges_.loopCount(); ++k) {
    if (edges_.firstOf(k + 1) - edges_.firstOf(k) < 3) return;
    Word& word = whole.loops.emplace_back(idx(edges_.firstOf(k + 1) - edges_.firstOf(k)));
    std::iota(word.begin(), word.end(), edges_.firstOf(k));
  }
  partials_.push_back(std::move(whole));
  start(kRounds);
}

void ShortestHandles::Search::start(int rounds) {
  if (!(bound_.ofAll() < kNone)) return;
  chooseTellingEdges();
  if (edges_.loopCount() > 2) {
    const std::optional<Partial> any = anyPartial();
    if (any) {
      const auto vertices = idx(edges_.vertexCount());
      const auto affordable = std::max<std::size_t>(kRoundsAgain, kRoundsWork / (vertices * vertices));
      workDone_ += idx(bound_.tighten(discsOf(*any).solve() + takenLength(*any),
                                      std::min(rounds, static_cast<int>(affordable)))) *
                   vertices * vertices;
    }
    chooseTellingEdges();
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
  bound_.update(edges);
  start(kRoundsAgain);
  if (gaveUp_) giveUp();
}

//! Where a wrong third corner costs most, so that few branches are followed.
void ShortestHandles::Search::chooseTellingEdges() {
  std::vector<double> excess;
  for (int v = 0; v < edges_.vertexCount(); ++v) excess.push_back(bound_.meanExcess(v));
  tellingVertex_.clear();
  for (const Word& word : partials_[0].loops)
    tellingVertex_.push_back(*std::max_element(
        word.begin(), word.end(), [&](int u, int v) { return excess[idx(u)] < excess[idx(v)]; }));
  joinOrder_.resize(tellingVertex_.size());
  std::iota(joinOrder_.begin(), joinOrder_.end(), 0);
  std::stable_sort(joinOrder_.begin(), joinOrder_.end(), [&](int a, int b) {
    return excess[idx(tellingVertex_[idx(a)])] > excess[idx(tellingVertex_[idx(b)])];
  });
}

void ShortestHandles::Search::count(std::size_t steps) {
  workLeft_ -= std::min(workLeft_, steps);
  workDone_ += steps;
  giveUpIfCancelled();
}

//! Behind the branches that look best one by one.
std::optional<Partial> ShortestHandles::Search::anyPartial() {
  Partial p = partials_[0];
  while (!p.loops.empty()) {
    const auto [loop, side] = sideToJoin(p);
    const Word& word = p.loops[idx(loop)];
    Branch best;
    double least = kNone;
    for (std::size_t l = 0; l < p.loops.size(); ++l) {
      if (static_cast<int>(l) == loop) continue;
      for (std::size_t i = 0; i < p.loops[l].size(); ++i) {
        const Triangle face{word[idx(side)], word[(idx(side) + 1) % word.size()], p.loops[l][i]};
        const double length = edges_.allows(face) ? bound_.with(p.taken, face) : kNone;
        if (length >= least) continue;
        least = length;
        best = {0, loop, side, static_cast<int>(l), static_cast<int>(i), true};
      }
    }
    if (least == kNone) return std::nullopt;
    p.taken.push_back(faceOf(p, best));
    join(p, best);
  }
  return p;
}

//! From now on only what has been found counts, and the handle that looked best at first.
void ShortestHandles::Search::giveUp() {
  gaveUp_ = true;
  std::optional<Partial> any = anyPartial();
  if (!any) return;
  const auto same = [&](const Solved& s) {
    return sortedFaces(partials_[idx(s.partial)]) == sortedFaces(*any);
  };
  if (std::any_of(solved_.begin(), solved_.end(), same)) return;
  partials_.push_back(std::move(*any));
  solve(static_cast<int>(partials_.size()) - 1);
}

Triangle ShortestHandles::Search::faceOf(const Partial& p, const Branch& b) {
  const Word& word = p.loops[idx(b.loop)];
  return {word[idx(b.side)], word[(idx(b.side) + 1) % word.size()], p.loops[idx(b.otherLoop)][idx(b.apex)]};
}

void ShortestHandles::Search::push(double length, Kind kind, std::size_t index) {
  heap_.push_back({length, pushed_++, kind, index});
  std::push_heap(heap_.begin(), heap_.end());
}

//! Of the edges between loops of the faces taken, each once.
double ShortestHandles::Search::takenLength(const Partial& p) const {
  std::vector<VertexPair> pairs;
  for (const Triangle& t : p.taken) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [u, v] = std::minmax(t[i], t[(i + 1) % 3]);
      if (edges_.loopOf(u) != edges_.loopOf(v)) pairs.push_back({u, v});
    }
  }
  sortUnique(pairs);
  double sum = 0;
  for (const auto& [u, v] : pairs) sum += edges_.length(u, v);
  return sum;
}

bool ShortestHandles::Search::isUsed(const Partial& p, int u, int v) const {
  return std::any_of(p.taken.begin(), p.taken.end(), [&](const Triangle& t) {
    return std::count(t.begin(), t.end(), u) + std::count(t.begin(), t.end(), v) == 2;
  });
}

//! The loop and the place of the side whose face is to be chosen: the telling edge of a loop that has not
//! been joined to another, or, of two joined pairs, the side of the last that comes closest to the other.
std::pair<int, int> ShortestHandles::Search::sideToJoin(const Partial& p) const {
  for (const int k : joinOrder_) {
    for (std::size_t l = 0; l < p.loops.size(); ++l) {
      const Word& word = p.loops[l];
      const int size = edges_.firstOf(k + 1) - edges_.firstOf(k);
      if (edges_.loopOf(word[0]) == k && static_cast<int>(word.size()) == size)
        return {static_cast<int>(l), tellingVertex_[idx(k)] - edges_.firstOf(k)};
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
  const Partial& p = partials_[idx(partial)];
  if (p.loops.empty()) return solve(partial);
  const auto [loop, side] = sideToJoin(p);
  const Word& word = p.loops[idx(loop)];
  const int u = word[idx(side)];
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

void ShortestHandles::Search::branchTo(Branch b, const Triangle& face) {
  if (!edges_.allows(face)) return;
  const double length = bound_.with(partials_[idx(b.partial)].taken, face);
  if (length == kNone) return;
  branches_.push_back(b);
  push(length, Kind::branch, branches_.size() - 1);
}

//! The third corner lies on the loop of the side itself. Between them are a side of the loop or a new chord;
//! the part with the other loops is bounded by a new chord.
void ShortestHandles::Search::branchWithin(Branch b) {
  const Partial& p = partials_[idx(b.partial)];
  const Word& word = p.loops[idx(b.loop)];
  const int n = static_cast<int>(word.size());
  const int u = word[idx(b.side)];
  const int v = word[idx((b.side + 1) % n)];
  const int w = word[idx(b.apex)];
  const int ahead = (b.apex - b.side - 1 + n) % n;  // sides from v to the apex
  const int behind = n - 1 - ahead;                 // and on to u
  if (b.restBehind ? behind < 2 : ahead < 2) return;
  const auto open = [&](int from, int to) { return edges_.length(from, to) < kNone && !isUsed(p, from, to); };
  if ((ahead > 1 && !open(v, w)) || (behind > 1 && !open(w, u))) return;
  branchTo(b, {u, v, w});
}

void ShortestHandles::Search::take(const Branch& b) {
  const Partial& from = partials_[idx(b.partial)];
  Partial p = from;
  p.taken.push_back(faceOf(from, b));
  if (b.loop == b.otherLoop)
    split(p, b);
  else
    join(p, b);
  partials_.push_back(std::move(p));
  expand(static_cast<int>(partials_.size()) - 1);
}

//! Two loops become one: from the end of the side round to its start, over to the apex, round the other loop
//! back to the apex.
void ShortestHandles::Search::join(Partial& p, const Branch& b) const {
  Word first = p.loops[idx(b.loop)];
  Word second = p.loops[idx(b.otherLoop)];
  std::rotate(first.begin(), first.begin() + (b.side + 1) % static_cast<int>(first.size()), first.end());
  std::rotate(second.begin(), second.begin() + b.apex, second.end());
  first.insert(first.end(), second.begin(), second.end());
  first.push_back(second[0]);
  p.loops.erase(p.loops.begin() + std::max(b.loop, b.otherLoop));
  p.loops.erase(p.loops.begin() + std::min(b.loop, b.otherLoop));
  (p.loops.empty() ? p.discs : p.loops).push_back(std::move(first));
}

//! One of the two parts of the loop is a disc (or a mere side), the other stays with the other loops.
void ShortestHandles::Search::split(Partial& p, const Branch& b) const {
  Word word = p.loops[idx(b.loop)];
  const int n = static_cast<int>(word.size());
  std::rotate(word.begin(), word.begin() + (b.side + 1) % n, word.end());  // v … w … u
  const auto apex = word.begin() + (b.apex - b.side - 1 + n) % n;
  Word ahead(word.begin(), apex + 1);
  Word behind(apex, word.end());
  Word& disc = b.restBehind ? ahead : behind;
  p.loops[idx(b.loop)] = b.restBehind ? behind : ahead;
  if (disc.size() > 2) p.discs.push_back(std::move(disc));
}

DiscTriangulation ShortestHandles::Search::discsOf(const Partial& p) const {
  std::vector<int> places;
  std::vector<int> ends;
  for (const Word& disc : p.discs) {
    places.insert(places.end(), disc.begin(), disc.end());
    ends.push_back(static_cast<int>(places.size()));
  }
  return {edges_, std::move(places), std::move(ends), p.taken};
}

void ShortestHandles::Search::solve(int partial) {
  const Partial& p = partials_[idx(partial)];
  DiscTriangulation discs = discsOf(p);
  count(discs.work());
  const double length = discs.solve() + takenLength(p);
  if (length == kNone) return;
  solved_.push_back({partial, nullptr});
  push(length, Kind::solved, solved_.size() - 1);
}

//! The shortest of all that is left is in this polygon.
void ShortestHandles::Search::openSolved(const Solved& s, double length) {
  std::shared_ptr<const DiscTriangulation> discs = s.discs;
  if (!discs) {
    auto again = std::make_shared<DiscTriangulation>(discsOf(partials_[idx(s.partial)]));
    again->solve();
    workDone_ += again->work();
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
  const double taken = takenLength(partials_[idx(partial)]);
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
  HandleCandidate handle{partials_[idx(n.partial)].taken, length};
  const std::vector<Triangle> rest = discs.faces(d);
  handle.faces.insert(handle.faces.end(), rest.begin(), rest.end());
  return handle;
}

std::optional<HandleCandidate> ShortestHandles::Search::next() {
  while (!heap_.empty()) {
    if (workLeft_ == 0 && !gaveUp_) giveUp();
    std::pop_heap(heap_.begin(), heap_.end());
    const Entry entry = heap_.back();
    heap_.pop_back();
    count(1);
    if (entry.kind == Kind::branch) {
      if (!gaveUp_) take(branches_[entry.index]);
    } else if (entry.kind == Kind::solved) {
      openSolved(solved_[entry.index], entry.length);
    } else {
      const Next n = std::move(nexts_[entry.index]);
      if (auto handle = follow(n, entry.length)) return handle;
    }
  }
  return std::nullopt;
}

ShortestHandles::ShortestHandles(std::span<const std::vector<Vec3>> loops,
                                 std::span<const VertexPair> forbiddenEdges, std::size_t maxWork)
    : search_(std::make_unique<Search>(loops, forbiddenEdges, maxWork)) {}
ShortestHandles::~ShortestHandles() = default;
ShortestHandles::ShortestHandles(ShortestHandles&&) noexcept = default;
ShortestHandles& ShortestHandles::operator=(ShortestHandles&&) noexcept = default;

std::optional<HandleCandidate> ShortestHandles::next() { return search_->next(); }
void ShortestHandles::forbid(std::span<const Triangle> faces, std::span<const VertexPair> edges) {
  search_->forbid(faces, edges);
}
std::size_t ShortestHandles::workDone() const { return search_->workDone(); }
bool ShortestHandles::gaveUp() const { return search_->gaveUp(); }

}  // namespace handlebody
