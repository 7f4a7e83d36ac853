#include "core/handles/two_front_handle.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>

namespace handlebody {
namespace {

// The handle is a strip of triangles. Its cross edges, in order around the tube, form a closed path on the
// torus of all pairs (i, j): a face on an edge of the first loop goes from (i, j) to (i + 1, j), one on an
// edge of the second from (i, j) to (i, j - 1). The second loop runs backwards because a face that holds the
// cross edge as b_j -> a_i on its way in must leave it as a_i -> b_j to the next. Unrolled with y = start -
// j, the path runs from (0, 0) to (p, q) in steps to the right and up. The first step is to the right, which
// makes `start` the apex of the edge (0, 1), hence unique to the handle.
//
// A pair occurs twice exactly when all q steps up are made in one run: then one vertex meets the whole other
// loop and closes on itself. The phases below are an automaton that accepts paths with two runs or more.
enum Phase : std::uint8_t { kNoRun, kInFirstRun, kAfterFirstRun, kSeveralRuns };
constexpr std::size_t kPhases = 4;

constexpr Phase afterRight(Phase phase) { return phase == kInFirstRun ? kAfterFirstRun : phase; }
constexpr Phase afterUp(Phase phase) {
  if (phase == kNoRun) return kInFirstRun;
  return phase == kAfterFirstRun ? kSeveralRuns : phase;
}

struct Arrival {
  double cost = std::numeric_limits<double>::infinity();
  Phase previous = kNoRun;
  bool up = false;
};

class StripSearch {
 public:
  StripSearch(std::span<const Vec3> first, std::span<const Vec3> second, std::span<const LoopPair> forbidden);
  //! The shortest strip whose face on the edge (0, 1) has the apex `start`; no faces if there is none.
  HandleCandidate best(int start);

 private:
  Arrival& at(int x, int y, Phase phase) {
    return table_[(static_cast<std::size_t>(x) * static_cast<std::size_t>(q_ + 1) +
                   static_cast<std::size_t>(y)) *
                      kPhases +
                  phase];
  }
  int second(int start, int y) const { return (start - y + q_) % q_; }
  double length(int i, int j) const {
    return lengths_[static_cast<std::size_t>(i) * static_cast<std::size_t>(q_) + static_cast<std::size_t>(j)];
  }
  void relax(int x, int y, Phase phase, bool up, int start);
  void fill(int start);
  std::vector<Triangle> trace(int start);

  int p_;
  int q_;
  std::vector<double> lengths_;  // of the cross edges, infinite if forbidden
  std::vector<Arrival> table_;
};

StripSearch::StripSearch(std::span<const Vec3> first, std::span<const Vec3> second,
                         std::span<const LoopPair> forbidden)
    : p_(static_cast<int>(first.size())), q_(static_cast<int>(second.size())) {
  lengths_.reserve(first.size() * second.size());
  for (const Vec3& a : first) {
    for (const Vec3& b : second) lengths_.push_back((a - b).norm());
  }
  for (const LoopPair& pair : forbidden) {
    assert(pair[0] >= 0 && pair[0] < p_ && pair[1] >= 0 && pair[1] < q_);
    lengths_[static_cast<std::size_t>(pair[0]) * second.size() + static_cast<std::size_t>(pair[1])] =
        std::numeric_limits<double>::infinity();
  }
  table_.resize((first.size() + 1) * (second.size() + 1) * kPhases);
}

void StripSearch::relax(int x, int y, Phase phase, bool up, int start) {
  const double before = at(x, y, phase).cost;
  const int nextX = up ? x : x + 1;
  const int nextY = up ? y + 1 : y;
  const double cost = before + length(nextX % p_, second(start, nextY));
  Arrival& next = at(nextX, nextY, up ? afterUp(phase) : afterRight(phase));
  if (cost < next.cost) next = {cost, phase, up};
}

void StripSearch::fill(int start) {
  std::fill(table_.begin(), table_.end(), Arrival{});
  at(0, 0, kNoRun).cost = 0;
  for (int x = 0; x <= p_; ++x) {
    for (int y = 0; y <= q_; ++y) {
      for (const Phase phase : {kNoRun, kInFirstRun, kAfterFirstRun, kSeveralRuns}) {
        if (x < p_) relax(x, y, phase, false, start);
        if (x > 0 && y < q_) relax(x, y, phase, true, start);
      }
    }
  }
}

std::vector<Triangle> StripSearch::trace(int start) {
  std::vector<Triangle> faces;
  faces.reserve(static_cast<std::size_t>(p_ + q_));
  int x = p_;
  int y = q_;
  Phase phase = kSeveralRuns;
  while (x > 0 || y > 0) {
    const Arrival arrival = at(x, y, phase);
    const int j = second(start, y);
    if (arrival.up) {
      faces.push_back({p_ + j, p_ + (j + 1) % q_, x % p_});
      --y;
    } else {
      --x;
      faces.push_back({x, (x + 1) % p_, p_ + j});
    }
    phase = arrival.previous;
  }
  std::reverse(faces.begin(), faces.end());
  return faces;
}

HandleCandidate StripSearch::best(int start) {
  fill(start);
  const double cost = at(p_, q_, kSeveralRuns).cost;
  if (cost == std::numeric_limits<double>::infinity()) return {};
  return {trace(start), cost};
}

}  // namespace

std::vector<HandleCandidate> bestTwoFrontHandles(std::span<const Vec3> first, std::span<const Vec3> second,
                                                 int limit, std::span<const LoopPair> forbidden) {
  std::vector<HandleCandidate> found;
  if (first.size() < 3 || second.size() < 3 || limit <= 0) return found;
  StripSearch search(first, second, forbidden);
  for (int start = 0; start < static_cast<int>(second.size()); ++start) {
    HandleCandidate candidate = search.best(start);
    if (!candidate.faces.empty()) found.push_back(std::move(candidate));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const HandleCandidate& a, const HandleCandidate& b) { return a.length < b.length; });
  if (found.size() > static_cast<std::size_t>(limit)) found.resize(static_cast<std::size_t>(limit));
  return found;
}

}  // namespace handlebody
