#include "core/handles/handle_bound.h"

#include <algorithm>
#include <bit>
#include <tuple>

#include "core/cancellation.h"
#include "core/indices.h"

namespace handlebody {

namespace {

constexpr double kNone = CrossEdges::kNone;
constexpr int kPatience = 20;             // rounds without a better bound, before steps are made smaller
constexpr double kMinStepFactor = 0.002;  // of Polyak's step: below, the bound hardly rises

//! The class of a face that holds loops in this order. With four loops, the missing one names the three.
int classOfLoops(const std::array<int, 3>& l) {
  const int missing = 6 - l[0] - l[1] - l[2];  // 3 if there are three loops
  const bool even = (l[0] < l[1]) + (l[1] < l[2]) + (l[2] < l[0]) == 2;
  return 2 * missing + (even ? 0 : 1);
}

//! The sets of classes that the Type 2 faces of a handle can have, one bit per class. Each class has at most
//! one face. k = 3: both orders. k = 4: the strips between loops make the edges of a tetrahedron, whose faces
//! have the boundary of a 3-simplex as classes, or its mirror image; or one pair of loops has two strips, and
//! each of the other two loops has its two faces with the pair.
std::vector<unsigned> combinations(int loops) {
  if (loops == 2) return {0};
  const auto both = [](int missing) { return 3u << (2 * missing); };
  if (loops == 3) return {both(3)};
  std::vector<unsigned> out{0b01'10'01'10, 0b10'01'10'01};
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < a; ++b) out.push_back(both(a) | both(b));
  return out;
}

}  // namespace

HandleBound::HandleBound(const CrossEdges& edges)
    : edges_(edges),
      count_(static_cast<std::size_t>(edges.vertexCount())),
      combinations_(combinations(edges.loopCount())) {
  for (int u = 0; u < edges.vertexCount(); ++u)
    for (int v = 0; v < edges.vertexCount(); ++v) share_.push_back(edges.length(u, v) / 2);
  findLeast();
}

void HandleBound::update(std::span<const VertexPair> forbidden) {
  for (const auto& [u, v] : forbidden)
    share_[idx(u) * count_ + idx(v)] = share_[idx(v) * count_ + idx(u)] = kNone;
  findLeast();
}

double HandleBound::share(const Triangle& face) const {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const int u = face[i];
    const int v = face[(i + 1) % 3];
    if (edges_.loopOf(u) != edges_.loopOf(v)) sum += shareOf(u, v);
  }
  return sum;
}

//! -1 for Type 1.
int HandleBound::classOf(const Triangle& face) const {
  const std::array<int, 3> l{edges_.loopOf(face[0]), edges_.loopOf(face[1]), edges_.loopOf(face[2])};
  return l[0] == l[1] || l[1] == l[2] || l[2] == l[0] ? -1 : classOfLoops(l);
}

void HandleBound::findLeast() {
  least_.assign(count_, kNone);
  apex_.assign(count_, -1);
  sumOfLeast_ = 0;
  for (int v = 0; v < edges_.vertexCount(); ++v) findLeastOnLoopEdge(v);
  leastOfClass_.fill(kNone);
  const int k = edges_.loopCount();
  for (int a = 0; a < k; ++a)
    for (int b = a + 1; b < k; ++b)
      for (int c = b + 1; c < k; ++c) {
        findLeastOfClass({a, b, c});
        findLeastOfClass({a, c, b});
      }
}

void HandleBound::findLeastOnLoopEdge(int v) {
  const double* in = share_.data() + idx(edges_.next(v)) * count_;
  for (int w = 0; w < edges_.vertexCount(); ++w) {
    const double sum = in[w] + shareOf(w, v);
    if (sum >= least_[v] || !edges_.allows({v, edges_.next(v), w})) continue;
    least_[v] = sum;
    apex_[v] = w;
  }
  sumOfLeast_ += least_[v];
}

//! Faces (u, v, w) on three loops in this order; most pairs (u, v) are out of the question at once.
void HandleBound::findLeastOfClass(const std::array<int, 3>& loops) {
  const auto first = [&](std::size_t i) { return edges_.firstOf(loops[i]); };
  const auto end = [&](std::size_t i) { return edges_.firstOf(loops[i] + 1); };
  std::vector<double> from(count_, kNone);  // the least that leads from v to the third loop
  std::vector<double> back(count_, kNone);  // and from there to u
  for (int w = first(2); w < end(2); ++w) {
    for (int v = first(1); v < end(1); ++v) from[v] = std::min(from[v], shareOf(v, w));
    for (int u = first(0); u < end(0); ++u) back[u] = std::min(back[u], shareOf(w, u));
  }
  const auto id = idx(classOfLoops(loops));
  for (int u = first(0); u < end(0); ++u) {
    for (int v = first(1); v < end(1); ++v) {
      const double uv = shareOf(u, v);
      if (uv + from[v] + back[u] >= leastOfClass_[id]) continue;
      for (int w = first(2); w < end(2); ++w) {
        const double sum = uv + shareOf(v, w) + shareOf(w, u);
        if (sum >= leastOfClass_[id] || !edges_.allows({u, v, w})) continue;
        leastOfClass_[id] = sum;
        faceOfClass_[id] = {u, v, w};
      }
    }
  }
}

double HandleBound::meanExcess(int v) const {
  double sum = 0;
  int count = 0;
  for (int w = 0; w < edges_.vertexCount(); ++w) {
    const double s = shareOf(edges_.next(v), w) + shareOf(w, v);
    if (s == kNone) continue;
    sum += s;
    ++count;
  }
  return count > 0 ? sum / count - least(v) : 0;
}

//! The least that the Type 2 faces other than those used can add.
HandleBound::Combination HandleBound::leastCombination(unsigned usedClasses) const {
  Combination best{0, kNone};
  for (const unsigned classes : combinations_) {
    if ((classes & usedClasses) != usedClasses) continue;
    double sum = 0;
    for (unsigned rest = classes & ~usedClasses; rest != 0; rest &= rest - 1)
      sum += leastOfClass_[std::countr_zero(rest)];
    if (sum < best.sum) best = {classes, sum};
  }
  return best;
}

double HandleBound::with(std::span<const Triangle> faces, const Triangle& one) const {
  double sum = sumOfLeast_;
  unsigned used = 0;
  const auto add = [&](const Triangle& t) {
    sum += share(t);
    if (const int c = classOf(t); c >= 0) used |= 1u << c;
    for (std::size_t i = 0; i < 3; ++i)
      if (edges_.loopOf(t[i]) == edges_.loopOf(t[(i + 1) % 3])) sum -= least(t[i]);
  };
  for (const Triangle& t : faces) add(t);
  add(one);
  return sum + leastCombination(used).sum;
}

void HandleBound::addSlope(const Triangle& face) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int u = face[i];
    const int v = face[(i + 1) % 3];
    if (edges_.loopOf(u) == edges_.loopOf(v)) continue;
    ++slope_[idx(u) * count_ + idx(v)];
    --slope_[idx(v) * count_ + idx(u)];
    sloped_.push_back({u, v});
  }
}

//! The slope of the bound over the shares; returns the sum of its squares, each pair counted once.
int HandleBound::chooseFaces() {
  slope_.resize(count_ * count_, 0);
  for (const auto& [u, v] : sloped_) slope_[idx(u) * count_ + idx(v)] = slope_[idx(v) * count_ + idx(u)] = 0;
  sloped_.clear();
  for (int v = 0; v < edges_.vertexCount(); ++v) addSlope({v, edges_.next(v), apex_[v]});
  for (unsigned rest = leastCombination(0).classes; rest != 0; rest &= rest - 1)
    addSlope(faceOfClass_[std::countr_zero(rest)]);
  for (auto& [u, v] : sloped_) std::tie(u, v) = std::make_tuple(std::min(u, v), std::max(u, v));
  sortUnique(sloped_);
  int squares = 0;
  for (const auto& [u, v] : sloped_)
    squares += slope_[idx(u) * count_ + idx(v)] * slope_[idx(u) * count_ + idx(v)];
  return squares;
}

int HandleBound::tighten(double target, int rounds) {
  if (!(ofAll() < kNone) || !(target < kNone)) return 0;
  std::vector<double> best = share_;
  double bound = ofAll();
  double stepFactor = 1;
  int round = 0;
  for (int since = 0; round < rounds && stepFactor > kMinStepFactor; ++round) {
    giveUpIfCancelled();
    const int squares = chooseFaces();
    if (squares == 0 || ofAll() >= target) break;  // the faces fit together
    const double step = stepFactor * (target - ofAll()) / squares;
    for (const auto& [u, v] : sloped_) {
      share_[idx(u) * count_ + idx(v)] += step * slope_[idx(u) * count_ + idx(v)];
      share_[idx(v) * count_ + idx(u)] -= step * slope_[idx(u) * count_ + idx(v)];
    }
    findLeast();
    if (ofAll() > bound) {
      bound = ofAll();
      best = share_;
      since = 0;
    } else if (++since == kPatience) {
      stepFactor /= 2;
      since = 0;
    }
  }
  share_ = std::move(best);
  findLeast();
  return round;
}

}  // namespace handlebody
