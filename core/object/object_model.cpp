#include "core/object/object_model.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
static double env(const char* n, double d) { const char* e = std::getenv(n); return e ? atof(e) : d; }

namespace handlebody {

namespace {

// What a click costs that a candidate does not agree with, in scores: it takes a correction; and the log of how
// much deeper than the clicks say the likeliest candidate is changed.
static const double kCorrected = env("KC", 0.2), kTooDeep = env("KD", 0.3), kLocal = env("KL", 0.6), kOwn = env("KO", 0.3), kBall = env("KB", 3);
constexpr std::size_t kTried = 8;    // candidates
constexpr std::size_t kCavity = 14;  // cells: a ball of one and a half cells' radius is noise

class Finder {
 public:
  Finder(const Volume& volume, const ObjectQuery& query, const FieldOfView* view, const ObjectPolicy& policy)
      : volume_(volume), query_(query), view_(view), policy_(policy) {}

  std::optional<ObjectModel> run() {
    searches_ = searchesAround(query_.inside[0].place);
    ranked_ = rankRegions(searches_, policy_);
    std::vector<RankedRegion> distinct = distinctRegions(ranked_, policy_.offered, policy_);
    if (distinct.empty()) return {};
    ObjectModel model;
    for (const RankedRegion& r : distinct) {
      const auto [low, high] = r.bounds();
      model.candidates.push_back({r.volume, r.map->radius, low, high, r.score});
    }
    model.isCloseChoice = distinct.size() > 1 && distinct[0].score - distinct[1].score < policy_.close;
    model.chosen = std::clamp(query_.candidate, 1, static_cast<int>(distinct.size()));
    model.level = searches_[0]->intensities.level;
    model.noise = noise_ = searches_[0]->intensities.noise;
    work_ = makeWork();
    for (const ObjectClick& c : query_.inside) inside_.push_back(cellClick(c));
    for (const ObjectClick& c : query_.outside) outside_.push_back(cellClick(c));
    region_ = tidied(regionOn(work_, distinct[static_cast<std::size_t>(model.chosen - 1)]));
    if (query_.candidate == 1 && inside_.size() + outside_.size() > 1) choose();
    for (const CellClick& c : inside_) take(c, true);
    for (const CellClick& c : outside_) take(c, false);
    model.region = std::move(region_);
    model.work = std::move(work_);
    return model;
  }

 private:
  using Searches = std::vector<std::unique_ptr<ClickSearch>>;

  //! Near the click in voxels, and wide in cells that may be coarser; one if that is fine enough.
  Searches searchesAround(const Vec3& click) const {
    Searches out;
    const CellGrid wide = cellsAround(volume_.grid, click, policy_.reach, policy_.wideCells);
    if (wide.factor != std::array{1, 1, 1}) {
      const double reach = policy_.nearCells * volume_.grid.meanSpacing();
      out.push_back(search(cellsAround(volume_.grid, click, reach, policy_.wideCells), click));
    }
    out.push_back(search(wide, click));
    return out;
  }
  std::unique_ptr<ClickSearch> search(const CellGrid& cells, const Vec3& click) const {
    return std::make_unique<ClickSearch>(searchAround(volume_, cells, click, view_, policy_, query_.threads));
  }

  WorkImage makeWork() const {
    const CellGrid cells = cellsAround(volume_.grid, query_.inside[0].place, policy_.reach, policy_.workCells);
    WorkImage work{makeCells(volume_, cells, view_), {}};
    work.values = smoothed(cells, work.image.values, policy_.smoothing * cells.grid.meanSpacing());
    return work;
  }

  CellClick cellClick(const ObjectClick& click) const {
    const CellGrid& cells = work_.cells();
    return {click.place, cells.at(cells.nearest(click.place)),
            click.radius.value_or(cells.grid.meanSpacing())};
  }

  //! Makes a click true that is not.
  void take(const CellClick& click, bool isInside) {
    if ((region_.inside[click.cell] != 0) == isInside) return;
    const double depth = depthBehindSurface(work_, region_, click.cell);
    region_ = tidied(corrected(click, isInside, depth));
  }

  //! Only what hangs together with the clicks inside, without the holes that noise makes.
  Region tidied(Region region) const {
    std::vector<std::size_t> holding;
    for (const CellClick& c : inside_) holding.push_back(c.cell);
    keepParts(work_, region, holding, kCavity);
    return region;
  }

  std::size_t contradictions(const RankedRegion& r) const {
    const auto missed = std::count_if(inside_.begin(), inside_.end(), [&](const CellClick& c) { return !r.holds(c.place); });
    const auto taken = std::count_if(outside_.begin(), outside_.end(), [&](const CellClick& c) { return r.holds(c.place); });
    return static_cast<std::size_t>(missed + taken);
  }

  //! Another candidate for all the clicks, if it agrees with more of them, is about as likely as the likeliest,
  //! and differs from that no deeper than the clicks say.
  void choose() {
    double depth = 0;
    const auto look = [&](const CellClick& c, bool isInside) {
      if ((region_.inside[c.cell] != 0) != isInside)
        depth = std::max(depth, depthBehindSurface(work_, region_, c.cell));
    };
    for (const CellClick& c : inside_) look(c, true);
    for (const CellClick& c : outside_) look(c, false);
    if (depth == 0) return;
    std::vector<RankedRegion> worth = ranked_;
    for (RankedRegion& r : worth) r.score -= kCorrected * static_cast<double>(contradictions(r));
    double bestWorth = -1e9;
    Region best;
    for (const RankedRegion& r : distinctRegions(worth, kTried, policy_)) {
      if (r.score <= bestWorth) break;
      Region other = tidied(regionOn(work_, r));
      const double here = r.score - tooDeep(other, depth);
      if (here <= bestWorth) continue;
      bestWorth = here;
      best = std::move(other);
    }
    region_ = std::move(best);
  }

  double tooDeep(const Region& other, double depth) const {
    const double cell = work_.cells().grid.meanSpacing();
    const double change = std::max(0.5 * cell, depthOfChange(work_, region_, other));
    return kTooDeep * std::max(0.0, std::log(change / (1.5 * depth + 0.5 * cell)));
  }

  Region corrected(const CellClick& click, bool isInside, double depth) const {
    const RankedRegion* other = nullptr;
    for (const RankedRegion& r : ranked_)
      if (contradictions(r) == 0 && (!other || r.score > other->score)) other = &r;
    const double worth = other ? other->score : -1e9;
    const double top = ranked_[0].score;
    if (!isInside) {
      if (worth > top - kLocal) return mixed(*other, click, depth);
      return cutAway(work_, region_, click, inside_, noise_, depth);
    }
    const Searches own = searchesAround(click.place);
    const std::vector<RankedRegion> ranked = rankRegions(own, policy_);
    double ownBest = -1e9;
    for (const auto& r : ranked) if (std::none_of(outside_.begin(), outside_.end(), [&](const CellClick& o) { return r.holds(o.place); })) ownBest = std::max(ownBest, r.score);
    if (worth > top - kLocal && worth > ownBest - kOwn) return mixed(*other, click, depth);
    return addNear(work_, region_, click, ranked, outside_, depth);
  }
  Region mixed(const RankedRegion& r, const CellClick& click, double depth) const {
    Region out = region_;
    const Region o = regionOn(work_, r);
    const CellGrid& cells = work_.cells();
    const double reach = kBall * depth + cells.grid.meanSpacing();
    std::size_t i = 0;
    for (int z = 0; z < cells.grid.size[2]; ++z)
      for (int y = 0; y < cells.grid.size[1]; ++y)
        for (int x = 0; x < cells.grid.size[0]; ++x, ++i)
          if ((cells.grid.toWorld(Vec3(x, y, z)) - click.place).norm() <= reach) out.inside[i] = o.inside[i];
    return out;
  }

  const Volume& volume_;
  const ObjectQuery& query_;
  const FieldOfView* view_;
  const ObjectPolicy& policy_;
  Searches searches_;
  std::vector<RankedRegion> ranked_;
  WorkImage work_;
  Region region_;
  double noise_ = 0;
  std::vector<CellClick> inside_, outside_;
};

}  // namespace

std::optional<ObjectModel> findObject(const Volume& volume, const ObjectQuery& query, const FieldOfView* view,
                                      const ObjectPolicy& policy) {
  return Finder(volume, query, view, policy).run();
}

}  // namespace handlebody
