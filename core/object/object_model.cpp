#include "core/object/object_model.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

#include "core/cancellation.h"
#include "core/object/expected_overlap.h"
#include "core/object/relabel.h"
#include "core/object/tube_surface.h"
#include "core/object/work_cells.h"
#include "core/threads.h"

namespace handlebody {

namespace {

class Finder {
 public:
  Finder(const Volume& volume, const ObjectQuery& query, const FieldOfView* view, const ObjectPolicy& policy)
      : volume_(volume), query_(query), view_(view), policy_(policy), cells_(volume, view, policy) {}

  std::optional<ObjectModel> run() {
    scale_ = IntensityScale::of(makeCells(volume_, wideAround(query_.inside[0].place), view_), policy_);
    searches_ = searchesAround(query_.inside[0].place);
    const std::vector<OfferedRegion> offered = offeredFor(query_.inside[0].place);
    if (offered.empty()) return {};
    ObjectModel model;
    for (const auto& [r, expected] : offered) {
      const auto [low, high] = r.bounds();
      model.candidates.push_back({r.volume, r.map->radius, low, high, expected});
    }
    model.isCloseChoice = isClose(offered);
    model.chosen = std::clamp(query_.candidate, 1, static_cast<int>(offered.size()));
    model.scale = scale_;
    model.level = searches_[0]->intensities.level;
    model.noise = noise_ = searches_[0]->intensities.noise;
    takeClicks();
    const RankedRegion& chosen = offered[static_cast<std::size_t>(model.chosen - 1)].region;
    model.neckRadius = chosen.map->radius;
    model.isStar = chosen.isStar();
    model.low = chosen.bounds()[0];
    model.high = chosen.bounds()[1];
    model.rise = chosen.rise;
    region_ = onImage(chosen);
    reachClick(inside_[0]);
    region_ = tidied(std::move(region_));
    model.isCloseChoice = model.isCloseChoice || (offered.size() > 1 && isInThinPart(inside_[0]));
    correctAll();
    model.isCorrected = done_.size() > 1;
    stamp(work_, region_, inside_, outside_);
    model.region = std::move(region_);
    model.work = std::move(work_);
    return model;
  }

 private:
  using Searches = std::vector<std::unique_ptr<ClickSearch>>;

  //! Less sure than it should be, or another one is about as likely.
  bool isClose(const std::vector<OfferedRegion>& offered) const {
    const double first = offered[0].expected;
    return std::any_of(offered.begin() + 1, offered.end(), [&](const OfferedRegion& o) {
      return first < policy_.sure || o.expected > first - policy_.rival;
    });
  }

  CellGrid wideAround(const Vec3& click) const {
    return cellsAround(volume_.grid, click, policy_.reach, policy_.wideCells);
  }

  //! Near the click in voxels, and wide in cells that may be coarser; one if that is fine enough.
  Searches searchesAround(const Vec3& click) const {
    Searches out;
    const CellGrid wide = wideAround(click);
    if (wide.factor != std::array{1, 1, 1}) {
      const double reach = policy_.nearCells * volume_.grid.meanSpacing();
      out.push_back(search(cellsAround(volume_.grid, click, reach, policy_.wideCells), click));
    }
    out.push_back(search(wide, click));
    return out;
  }
  std::unique_ptr<ClickSearch> search(const CellGrid& cells, const Vec3& click) const {
    return std::make_unique<ClickSearch>(
        searchAround(volume_, cells, click, view_, policy_, query_.threads, scale_));
  }

  //! All regions that may be meant, star-shaped ones through these clicks among them.
  void rank(const std::vector<CellClick>& inside, const std::vector<CellClick>& outside) {
    std::erase_if(searches_, [](const auto& s) { return s->isTube; });
    for (auto& s : searches_) addStars(*s, inside, outside, policy_, query_.threads);
    auto tubes = tubeSearches(work_, *searches_[0], inside, outside, policy_, query_.threads);
    for (auto& t : tubes) searches_.insert(searches_.end() - 1, std::move(t));
    ranked_ = rankRegions(searches_, policy_);
    const double sign = query_.contrast == Contrast::dark ? 1 : -1;
    if (query_.contrast != Contrast::any)
      std::erase_if(ranked_,
                    [&](const RankedRegion& r) { return sign * r.rise <= searches_[0]->intensities.noise; });
  }

  //! What the first click may mean. If that is a tube that goes on, it is followed further.
  std::vector<OfferedRegion> offeredFor(const Vec3& click) {
    cells_.reach({click, policy_.reach});
    while (true) {
      work_ = cells_.image(scale_);
      rank({{click}}, {});
      std::vector<OfferedRegion> offered = offeredRegions(likelyRegions(ranked_, policy_), policy_);
      bool isWider = false;
      for (const OfferedRegion& o : offered)
        for (const Vec3& end : o.region.search->goesOn) isWider |= cells_.reach({end, policy_.reach / 2});
      if (!isWider) return offered;
    }
  }

  //! A click outside that lies far from all others says nothing.
  void takeClicks() {
    bool isWider = false;
    for (const ObjectClick& c : query_.inside) isWider |= cells_.reach({c.place, policy_.reach / 4});
    if (isWider) work_ = cells_.image(scale_);
    for (const ObjectClick& c : query_.inside) inside_.push_back(cellClick(c, true));
    for (const ObjectClick& c : query_.outside)
      if (work_.cells().contains(c.place)) outside_.push_back(cellClick(c, false));
  }

  //! The radius of a click inside is that of the surface's start, which may lie around the object.
  CellClick cellClick(const ObjectClick& click, bool isInside) const {
    const CellGrid& cells = work_.cells();
    const double cell = cells.grid.meanSpacing();
    return {click.place, cells.at(cells.nearest(click.place)), isInside ? cell : click.radius.value_or(cell)};
  }

  struct Pending {
    CellClick click;
    bool isInside;
  };
  bool isTrue(const Region& r, const Pending& p) const { return (r.inside[p.click.cell] != 0) == p.isInside; }

  //! The click that lies deepest on the wrong side first, as a user would give them: a shallower further
  //! click comes after the earlier ones, and most often changes nothing of what they did.
  void correctAll() {
    std::vector<Pending> left;
    for (const CellClick& c : inside_) left.push_back({c, true});
    for (const CellClick& c : outside_) left.push_back({c, false});
    done_.push_back(left.front());
    left.erase(left.begin());
    while (true) {
      double deepest = 0;
      auto next = left.end();
      for (auto p = left.begin(); p != left.end(); ++p) {
        if (isTrue(region_, *p)) continue;
        const double d = depthBehindSurface(work_, region_, p->click.cell);
        if (d > deepest) deepest = d, next = p;
      }
      if (next == left.end()) return;
      const Pending p = *next;
      left.erase(next);
      done_.push_back(p);
      correct(p, deepest);
    }
  }

  bool agrees(const RankedRegion& r) const {
    return std::all_of(done_.begin(), done_.end(),
                       [&](const Pending& p) { return r.holds(p.click.place) == p.isInside; });
  }

  //! A region in the cells of the object, with its surface on the edges next to it. That of a star-shaped one
  //! stays: it lies where edges and intensities together said.
  Region onImage(const RankedRegion& r) const {
    const Region found = regionOn(work_, r);
    if (r.isStar()) return found;
    Region moved = refined(work_, found, noise_, policy_);
    return moved.count() > 0 ? moved : found;  // one of a few cells is nothing but surface
  }

  //! The same for several. Those found by intensity are likely to be offered again for the next click.
  std::vector<std::shared_ptr<const Region>> onImageOnce(const std::vector<OfferedRegion>& offered) {
    std::vector<std::shared_ptr<const Region>> out(offered.size());
    forEachOnThreads(out.size(), query_.threads, [&](std::size_t i) {
      const RankedRegion& r = offered[i].region;
      const auto known = onImage_.find({r.map, r.rung});
      out[i] = known != onImage_.end() ? known->second : std::make_shared<const Region>(onImage(r));
    });
    for (std::size_t i = 0; i < out.size(); ++i)
      if (const RankedRegion& r = offered[i].region; !r.isStar()) onImage_[{r.map, r.rung}] = out[i];
    return out;
  }

  //! Only what hangs together with the clicks inside, without the holes that noise makes.
  Region tidied(Region region) const {
    std::vector<std::size_t> holding;
    for (const CellClick& c : inside_) holding.push_back(c.cell);
    keepParts(work_, region, holding, policy_.cavity);
    return region;
  }

  //! The click lies in a branch or at the surface of something much thicker: that branch may be meant.
  bool isInThinPart(const CellClick& click) const {
    return depthBehindSurface(work_, region_, click.cell) < policy_.thinPart * deepestInside(work_, region_);
  }

  //! The opening may have taken the place of the click itself: it hangs on by a ball.
  void reachClick(const CellClick& click) {
    if (region_.inside[click.cell] || region_.count() == 0) return;
    CellClick ball = click;
    ball.radius = depthBehindSurface(work_, region_, click.cell);
    stamp(work_, region_, {ball}, {});
  }

  //! What may have made the user click: what is tried, and what it is worth.
  class Offers {
   public:
    Offers(const Finder& finder, const Pending& pending, double depth)
        : finder_(finder), pending_(pending), depth_(depth) {}
    //! `region` is called once, on any thread.
    void add(std::function<Region()> region, double score, bool isLocal) {
      tasks_.push_back({std::move(region), score, isLocal});
    }
    //! Makes what was added.
    void weigh(int threads) {
      std::vector<std::optional<Offer>> made(tasks_.size());
      forEachOnThreads(tasks_.size(), threads, [&](std::size_t i) { made[i] = offerOf(tasks_[i]); });
      tasks_.clear();
      for (auto& o : made)
        if (o) keep(std::move(*o));
    }
    bool any() const { return !best_.empty(); }
    struct Offer {
      Region region;
      double worth;
      bool isLocal;
    };
    //! The one that is expected to share most with what is meant. Precondition: there are any.
    Offer take() {
      std::vector<double> worth;
      std::vector<std::vector<double>> overlap(best_.size(), std::vector<double>(best_.size(), 1));
      for (const Offer& o : best_) worth.push_back(o.worth);
      for (std::size_t i = 0; i < best_.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          overlap[i][j] = overlap[j][i] = overlapOf(best_[i].region, best_[j].region);
      const auto likelihood = likelihoods(worth, finder_.policy_);
      std::vector<double> expected;
      for (const auto& row : overlap)
        expected.push_back(std::inner_product(row.begin(), row.end(), likelihood.begin(), 0.0));
      return std::move(best_[static_cast<std::size_t>(std::max_element(expected.begin(), expected.end()) -
                                                      expected.begin())]);
    }

   private:
    struct Task {
      std::function<Region()> region;
      double score;
      bool isLocal;
    };
    //! None if the click is still on the wrong side.
    std::optional<Offer> offerOf(const Task& task) const {
      giveUpIfCancelled();
      Region region = finder_.tidied(task.region());
      if (!finder_.isTrue(region, pending_)) return {};
      const double worth =
          task.score + worthOfChange(finder_.work_, finder_.region_, region,
                                     {pending_.isInside, depth_, finder_.noise_}, finder_.policy_);
      return Offer{std::move(region), worth, task.isLocal};
    }
    void keep(Offer offer) {
      const auto place =
          std::find_if(best_.begin(), best_.end(), [&](const Offer& o) { return offer.worth > o.worth; });
      best_.insert(place, std::move(offer));
      if (best_.size() > finder_.policy_.weighed) best_.pop_back();
    }

    const Finder& finder_;
    const Pending& pending_;
    double depth_;
    std::vector<Task> tasks_;
    std::vector<Offer> best_;  // the best first
  };

  void correct(const Pending& p, double depth) {
    rank(done(true), done(false));  // later clicks do not change what is offered for this one
    Offers offers(*this, p, depth);
    const double local = policy_.corrected * (corrections_ + 1), made = bestScore() - local;
    if (p.isInside) offerRelabelled(offers, p, depth, made);
    offerCandidates(offers, p, depth, local);
    if (p.isInside)
      offerOwnRegions(offers, p, depth, local);
    else
      offers.add([&] { return cutAway(work_, region_, p.click, inside_, noise_, depth); }, made, true);
    offers.weigh(query_.threads);
    if (!offers.any()) {
      const auto isInside = [&](std::size_t) { return p.isInside; };
      offers.add([&] { return within(p.click, policy_.makeshiftReach * depth, isInside); }, 0, true);
      offers.weigh(1);
    }
    if (!offers.any()) return;
    Offers::Offer chosen = offers.take();
    corrections_ = chosen.isLocal ? corrections_ + 1 : 0;
    region_ = std::move(chosen.region);
  }

  //! The clicks on a side that have been taken in, and the one that is.
  std::vector<CellClick> done(bool isInside) const {
    std::vector<CellClick> out;
    for (const Pending& d : done_)
      if (d.isInside == isInside) out.push_back(d.click);
    return out;
  }

  //! 0 where nothing is of the contrast that is asked for.
  double bestScore() const {
    const auto best =
        std::max_element(ranked_.begin(), ranked_.end(),
                         [](const RankedRegion& a, const RankedRegion& b) { return a.score < b.score; });
    return best == ranked_.end() ? 0 : best->score;
  }

  //! The surface moved, near the click and further along; for a click outside the others served better.
  void offerRelabelled(Offers& offers, const Pending& p, double depth, double score) const {
    Relabelling r{p.click, depth, 0, noise_, {}, {}};
    for (const Pending& d : done_) (d.isInside ? r.inside : r.outside).push_back(d.click);
    for (const double reach : policy_.relabelReaches) {
      r.reach = reach * depth;
      offers.add([this, r] { return relabelled(work_, region_, r, policy_); }, score, true);
      score -= policy_.relabelFar;
    }
  }

  //! Other candidates that agree with all clicks so far, whole or only near this one.
  void offerCandidates(Offers& offers, const Pending& p, double depth, double local) {
    std::vector<RankedRegion> agreeing;
    std::copy_if(ranked_.begin(), ranked_.end(), std::back_inserter(agreeing),
                 [&](const RankedRegion& r) { return agrees(r) && r.holds(p.click.place) == p.isInside; });
    const std::vector<OfferedRegion> offered = offeredRegions(likelyRegions(agreeing, policy_), policy_);
    const std::vector<std::shared_ptr<const Region>> regions = onImageOnce(offered);
    for (std::size_t i = 0; i < offered.size(); ++i) {
      const RankedRegion& r = offered[i].region;
      const std::shared_ptr<const Region> whole = regions[i];
      offers.add([whole] { return *whole; }, r.score - (p.isInside ? 0 : policy_.renewed), false);
      const double reach = policy_.correctionReach * depth;
      offers.add([this, whole, reach,
                  &p] { return within(p.click, reach, [&](std::size_t c) { return whole->inside[c]; }); },
                 r.score - local - policy_.mixed, true);
    }
  }

  //! What a search from the click finds: other intensities belong to the object, too.
  void offerOwnRegions(Offers& offers, const Pending& p, double depth, double local) const {
    const Searches own = searchesAround(p.click.place);
    std::vector<RankedRegion> ranked = rankRegions(own, policy_);
    std::erase_if(ranked, [&](const RankedRegion& r) {
      return std::any_of(done_.begin(), done_.end(),
                         [&](const Pending& o) { return !o.isInside && r.holds(o.click.place); });
    });
    for (const RankedRegion& r : distinctRegions(ranked, policy_.tried, policy_)) {
      const double reach = policy_.correctionReach * depth;
      offers.add(
          [this, whole = regionOn(work_, r), reach, &p] {
            return within(p.click, reach,
                          [&](std::size_t c) { return region_.inside[c] || whole.inside[c]; });
          },
          r.score - local, true);
    }
  }

  //! The region with f(cell) instead within `reach` (mm) of a click.
  template <typename F>
  Region within(const CellClick& click, double reach, F&& f) const {
    Region out = region_;
    forCellsWithin(work_.cells(), click.place, reach + work_.cells().grid.meanSpacing(),
                   [&](std::size_t i) { out.inside[i] = f(i); });
    return out;
  }

  const Volume& volume_;
  const ObjectQuery& query_;
  const FieldOfView* view_;
  const ObjectPolicy& policy_;
  IntensityScale scale_;
  Searches searches_;
  std::vector<RankedRegion> ranked_;
  WorkCells cells_;
  WorkImage work_;
  Region region_;
  double noise_ = 0;
  std::vector<Pending> done_;  // clicks that have been taken in
  int corrections_ = 0;        // near clicks, in a row
  std::map<std::pair<const ArrivalMap*, int>, std::shared_ptr<const Region>> onImage_;  // map and rung
  std::vector<CellClick> inside_, outside_;
};

}  // namespace

std::optional<ObjectModel> findObject(const Volume& volume, const ObjectQuery& query, const FieldOfView* view,
                                      const ObjectPolicy& policy) {
  return Finder(volume, query, view, policy).run();
}

}  // namespace handlebody
