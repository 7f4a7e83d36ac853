#include "core/handles/disc_triangulation.h"

#include <algorithm>
#include <cassert>

namespace handlebody {

namespace {
constexpr double kNone = CrossEdges::kNone;
}

DiscTriangulation::DiscTriangulation(const CrossEdges& edges, std::vector<int> places, std::vector<int> ends,
                                     std::span<const Triangle> taken)
    : edges_(&edges), places_(std::move(places)), ends_(std::move(ends)), n_(places_.size()) {
  chord_.assign(n_ * n_, kNone);
  const auto repeats = [&](int u, int v) {
    return std::any_of(taken.begin(), taken.end(), [&](const Triangle& t) {
      return std::count(t.begin(), t.end(), u) + std::count(t.begin(), t.end(), v) == 2;
    });
  };
  std::vector<unsigned char> isTaken(edges.vertexCount(), 0);
  for (const Triangle& t : taken)
    for (const int v : t) isTaken[v] = 1;
  int first = 0;
  for (const int end : ends_) {
    for (int i = first; i < end; ++i) {
      for (int j = i + 2; j < end; ++j) {
        const int u = places_[i];
        const int v = places_[j];
        if (isTaken[u] != 0 && isTaken[v] != 0 && repeats(u, v)) continue;
        chord_[idx(i) * n_ + idx(j)] = edges.length(u, v);
      }
      if (i + 1 < end) chord_[idx(i) * n_ + idx(i + 1)] = 0;
    }
    chord_[idx(first) * n_ + idx(end - 1)] = 0;
    first = end;
  }
  listRuns();
}

void DiscTriangulation::listRuns() {
  const auto loops = idx(edges_->loopCount());
  runs_.resize(loops * loops);
  for (std::size_t pair = 0; pair < runs_.size(); ++pair) {
    const auto isThird = [&](int place) {
      const auto loop = idx(edges_->loopOf(places_[place]));
      return loop != pair / loops && loop != pair % loops;
    };
    for (int i = 0, n = static_cast<int>(n_); i < n; ++i) {
      if (!isThird(i)) continue;
      if (i == 0 || !isThird(i - 1)) runs_[pair].push_back({i, i});
      runs_[pair].back()[1] = i + 1;
    }
  }
}

void DiscTriangulation::exclude(const Chord& chord) { chord_[idx(chord.from) * n_ + idx(chord.to)] = kNone; }

void DiscTriangulation::require(const Chord& chord) {
  for (int i = chord.from + 1; i < chord.to; ++i) {
    for (int j = 0; j < chord.from; ++j) exclude({j, i});
    for (int j = chord.to + 1; j < static_cast<int>(n_); ++j) exclude({i, j});
  }
}

double DiscTriangulation::solve() {
  below_.assign(n_ * n_, kNone);
  double total = 0;
  int first = 0;
  for (const int end : ends_) {
    for (int i = end - 2; i >= first; --i) {
      below_[idx(i) * n_ + idx(i + 1)] = below_[idx(i + 1) * n_ + idx(i)] = 0;
      for (int j = i + 2; j < end; ++j) {
        const double chord = chord_[idx(i) * n_ + idx(j)];
        if (chord == kNone) continue;
        const double length = chord + bestThrough({i, j});
        below_[idx(i) * n_ + idx(j)] = below_[idx(j) * n_ + idx(i)] = length;
      }
    }
    total += below_[idx(first) * n_ + idx(end - 1)];
    first = end;
  }
  return total;
}

//! Of all below the chord, by the face with this apex.
double DiscTriangulation::through(const Chord& base, int apex) const {
  const double length = below_[idx(base.from) * n_ + idx(apex)] + below_[idx(base.to) * n_ + idx(apex)];
  if (length == kNone || !edges_->anyFaceForbidden()) return length;
  const Triangle face{places_[base.from], places_[apex], places_[base.to]};
  return edges_->allows(face) ? length : kNone;
}

//! The places of loops that neither end of the chord is on.
const std::vector<std::array<int, 2>>& DiscTriangulation::runs(const Chord& base) const {
  const int from = edges_->loopOf(places_[base.from]), to = edges_->loopOf(places_[base.to]);
  return runs_[from * edges_->loopCount() + to];
}

//! The places where the third corner of a face on the chord can be, ascending.
template <typename F>
void DiscTriangulation::forEachApex(const Chord& base, F&& f) const {
  const int first = base.from + 1, last = base.to - 1;
  f(first);
  for (const auto& [begin, end] : runs(base))
    for (int m = std::max(begin, first + 1); m < std::min(end, last); ++m) f(m);
  if (last > first) f(last);
}

double DiscTriangulation::bestThrough(const Chord& base) const {
  double best = kNone;
  if (edges_->anyFaceForbidden()) {
    forEachApex(base, [&](int m) { best = std::min(best, through(base, m)); });
    return best;
  }
  best = std::min(through(base, base.from + 1), through(base, base.to - 1));
  for (const auto& [begin, end] : runs(base)) {
    const int first = std::max(begin, base.from + 1), past = std::min(end, base.to);
    if (first < past) best = std::min(best, bestOfRun(base, first, past));
  }
  return best;
}

//! The hot loop of the choice of a handle for three and four loops: two rows, four minima at a time.
double DiscTriangulation::bestOfRun(const Chord& base, int first, int end) const {
  const double* a = below_.data() + idx(base.from) * n_;
  const double* b = below_.data() + idx(base.to) * n_;
  std::array<double, 4> least{kNone, kNone, kNone, kNone};
  double best = kNone;
  int m = first;
  for (; m + 4 <= end; m += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const double length = a[idx(m) + lane] + b[idx(m) + lane];
      least[lane] = length < least[lane] ? length : least[lane];
    }
  }
  for (; m < end; ++m) best = std::min(best, a[m] + b[m]);
  return std::min({best, least[0], least[1], least[2], least[3]});
}

std::vector<DiscTriangulation::Option> DiscTriangulation::options(const Chord& base) const {
  std::vector<Option> out;
  forEachApex(base, [&](int m) {
    const double length = through(base, m);
    if (length < kNone) out.push_back({length, m});
  });
  std::sort(out.begin(), out.end());
  return out;
}

//! `apexOf`: of a chord, by its number in the order of the stack; below 0: none, and no derivation.
template <typename F>
DiscTriangulation::Derivation DiscTriangulation::takeApart(F&& apexOf) const {
  Derivation d;
  std::vector<Chord> open;
  for (std::size_t e = ends_.size(); e-- > 0;) open.push_back({e == 0 ? 0 : ends_[e - 1], ends_[e] - 1});
  while (!open.empty()) {
    const Chord base = open.back();
    open.pop_back();
    if (base.to - base.from < 2) continue;
    const int apex = apexOf(base, d.bases.size());
    if (apex < 0) return {};
    d.bases.push_back(base);
    d.apexes.push_back(apex);
    open.push_back({apex, base.to});
    open.push_back({base.from, apex});
  }
  return d;
}

DiscTriangulation::Derivation DiscTriangulation::derive(std::span<const int> prefix, int rank) const {
  return takeApart([&](const Chord& base, std::size_t step) {
    if (step < prefix.size()) return prefix[step];
    const std::vector<Option> all = options(base);
    const std::size_t wanted = step == prefix.size() ? idx(rank) : 0;
    return wanted < all.size() ? all[wanted].apex : -1;
  });
}

DiscTriangulation::Derivation DiscTriangulation::derivationOf(std::span<const Triangle> faces) const {
  return takeApart([&](const Chord& base, std::size_t) {
    int apex = -1;
    forEachApex(base, [&](int m) {
      Triangle face{places_[base.from], places_[m], places_[base.to]};
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      if (std::binary_search(faces.begin(), faces.end(), face)) apex = m;
    });
    return apex;
  });
}

double DiscTriangulation::lengthOf(const Derivation& d) const {
  std::vector<double> below(n_ * n_, 0);
  const auto of = [&](int from, int to) -> double& { return below[idx(from) * n_ + idx(to)]; };
  for (std::size_t step = d.bases.size(); step-- > 0;) {
    const auto [from, to] = d.bases[step];
    of(from, to) = chord_[idx(from) * n_ + idx(to)] + (of(from, d.apexes[step]) + of(d.apexes[step], to));
  }
  double total = 0;
  int first = 0;
  for (const int end : ends_) {
    total += of(first, end - 1);
    first = end;
  }
  return total;
}

double DiscTriangulation::detour(const Derivation& d, std::size_t step, int rank) const {
  const std::vector<Option> all = options(d.bases[step]);
  return idx(rank) < all.size() ? all[rank].length - all[idx(rank) - 1].length : kNone;
}

std::vector<Triangle> DiscTriangulation::faces(const Derivation& d) const {
  std::vector<Triangle> out;
  for (std::size_t s = 0; s < d.bases.size(); ++s) {
    out.push_back({places_[d.bases[s].from], places_[d.apexes[s]], places_[d.bases[s].to]});
  }
  return out;
}

bool DiscTriangulation::isSide(const Chord& c) const {
  if (c.to == c.from + 1) return true;
  const auto end = std::find(ends_.begin(), ends_.end(), c.to + 1);
  return end != ends_.end() && (end == ends_.begin() ? 0 : *(end - 1)) == c.from;
}

std::array<Chord, 2> DiscTriangulation::repeatedPair(const Derivation& d) const {
  struct Joined {
    int u, v;
    Chord chord;
  };
  std::vector<Joined> joined;
  for (const Chord& c : d.bases) {
    if (isSide(c)) continue;
    const auto [u, v] = std::minmax(places_[c.from], places_[c.to]);
    joined.push_back({u, v, c});
  }
  std::sort(joined.begin(), joined.end(), [](const Joined& a, const Joined& b) {
    return std::array{a.u, a.v, a.chord.from, a.chord.to} < std::array{b.u, b.v, b.chord.from, b.chord.to};
  });
  for (std::size_t i = 1; i < joined.size(); ++i) {
    if (joined[i - 1].u == joined[i].u && joined[i - 1].v == joined[i].v)
      return {joined[i - 1].chord, joined[i].chord};
  }
  return {};
}

}  // namespace handlebody
