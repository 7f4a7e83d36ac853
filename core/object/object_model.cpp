#include "core/object/object_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <utility>

#include "core/object/displacement.h"
#include "core/object/expected_overlap.h"
#include "core/object/offers.h"
#include "core/object/relabel.h"
#include "core/object/tube_surface.h"
#include "core/object/work_cells.h"
#include "core/threads.h"

namespace handlebody {

namespace {

//! A click that is taken in, or will be.
struct Pending {
  CellClick click;
  bool isInside;
};
bool isSame(const Pending& a, const Pending& b) {
  return a.isInside == b.isInside && a.click.place == b.click.place && a.click.radius == b.click.radius;
}
bool isTrue(const Region& r, const Pending& p) { return (r.inside[p.click.cell] != 0) == p.isInside; }

bool isSame(const Volume& a, const Volume& b) {
  return a.voxels == b.voxels && a.type == b.type && a.grid.size == b.grid.size &&
         a.grid.spacing == b.grid.spacing && a.grid.origin == b.grid.origin &&
         a.grid.direction == b.grid.direction;
}
bool isSame(const CellGrid& a, const CellGrid& b) {
  return a.low == b.low && a.factor == b.factor && a.grid.size == b.grid.size;
}

//! What some clicks have made of the first region.
struct Corrected {
  Region region;
  std::vector<Pending> done;  // clicks that have been taken in
  int inARow = 0;             // corrections near clicks, after the last of the whole
};

}  // namespace

//! All that was found around a first click.
class ObjectFinder::Search {
 public:
  Search(const Volume& volume, const ObjectQuery& query, std::shared_ptr<const FieldOfView> view,
         const ObjectPolicy& policy)
      : volume_(volume),
        view_(std::move(view)),
        policy_(policy),
        first_(query.inside[0].place),
        contrast_(query.contrast),
        threads_(query.threads),
        cells_(volume_, view_.get(), policy_) {
    scale_ = IntensityScale::of(makeCells(volume_, wideAround(first_), view_.get()), policy_);
    searches_ = searchesAround(first_);
    offered_ = offeredFor(first_);
    keepFirst();
  }
  bool isFor(const Volume& volume, const ObjectQuery& query, bool hasView) const {
    return isSame(volume, volume_) && query.inside[0].place == first_ && query.contrast == contrast_ &&
           hasView == (view_ != nullptr);
  }

  std::optional<ObjectModel> answer(const ObjectQuery& query) {
    if (offered_.empty()) return {};
    threads_ = query.threads;
    chooseCells(query);
    const int candidate = std::clamp(query.candidate, 1, static_cast<int>(offered_.size()));
    if (!start_ || candidate != candidate_) startWith(candidate);
    Corrected corrected = *start_;
    const std::vector<Pending> clicks = clicksOf(query);
    correctAll(corrected, clicks);
    return modelOf(std::move(corrected), clicks);
  }

 private:
  using Searches = std::vector<std::unique_ptr<ClickSearch>>;

  const RankedRegion& chosen() const { return offered_[candidate_ - 1].region; }

  ObjectModel modelOf(Corrected corrected, const std::vector<Pending>& clicks) const {
    ObjectModel model;
    for (const auto& [r, expected] : offered_) {
      const auto [low, high] = r.bounds();
      model.candidates.push_back({r.volume, r.map->radius, low, high, expected});
    }
    model.isCloseChoice = isClose() || (offered_.size() > 1 && isInThinPart_);
    model.chosen = candidate_;
    model.scale = scale_;
    model.level = searches_[0]->intensities.level;
    model.noise = noise();
    model.neckRadius = chosen().map->radius;
    model.isStar = chosen().isStar();
    model.low = chosen().bounds()[0];
    model.high = chosen().bounds()[1];
    model.rise = chosen().rise;
    model.isCorrected = corrected.done.size() > 1;
    stamp(*work_, corrected.region, clicksOf(clicks, true), clicksOf(clicks, false));
    model.region = std::move(corrected.region);
    model.work = work_;
    return model;
  }
  double noise() const { return searches_[0]->intensities.noise; }

  //! Less sure than it should be, or another one is about as likely.
  bool isClose() const {
    const double first = offered_[0].expected;
    return std::any_of(offered_.begin() + 1, offered_.end(), [&](const OfferedRegion& o) {
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
        searchAround(volume_, cells, click, view_.get(), policy_, threads_, scale_));
  }

  //! All regions that may be meant, star-shaped ones through these clicks among them.
  std::vector<RankedRegion> rank(const std::vector<CellClick>& inside,
                                 const std::vector<CellClick>& outside) {
    std::erase_if(searches_, [](const auto& s) { return s->isTube; });
    for (auto& s : searches_) addStars(*s, inside, outside, policy_, threads_);
    auto tubes = tubeSearches(*work_, *searches_[0], inside, outside, policy_, threads_);
    for (auto& t : tubes) searches_.insert(searches_.end() - 1, std::move(t));
    std::vector<RankedRegion> ranked = rankRegions(searches_, policy_, threads_);
    const double sign = contrast_ == Contrast::dark ? 1 : -1;
    if (contrast_ != Contrast::any)
      std::erase_if(ranked, [&](const RankedRegion& r) { return sign * r.rise <= noise(); });
    return ranked;
  }

  //! What the first click may mean. If that is a tube that goes on, it is followed further.
  std::vector<OfferedRegion> offeredFor(const Vec3& click) {
    cells_.reach({click, policy_.reach});
    while (true) {
      work_ = std::make_shared<const WorkImage>(cells_.image(scale_));
      std::vector<RankedRegion> ranked = rank({{click}}, {});
      std::vector<OfferedRegion> offered = offeredRegions(likelyRegions(ranked, policy_), policy_);
      bool isWider = false;
      for (const OfferedRegion& o : offered)
        for (const Vec3& end : o.region.search->goesOn) isWider |= cells_.reach({end, policy_.reach / 2});
      if (!isWider) return offered;
    }
  }

  //! What is offered rests on the first click's stars and tubes; those of further clicks come and go.
  void keepFirst() {
    for (auto& s : searches_) firstStars_.push_back(std::move(s->stars));
    const auto tubes =
        std::stable_partition(searches_.begin(), searches_.end(), [](const auto& s) { return !s->isTube; });
    std::move(tubes, searches_.end(), std::back_inserter(firstTubes_));
    searches_.erase(tubes, searches_.end());
  }

  //! Of the object: those of the first click, and what further clicks inside reach.
  void chooseCells(const ObjectQuery& query) {
    WorkCells cells = cells_;
    for (const ObjectClick& c : query.inside) cells.reach({c.place, policy_.reach / 4});
    if (isSame(cells.cells(), work_->cells())) return;
    start_.reset();
    onImage_.clear();
    work_ = std::make_shared<const WorkImage>(cells.image(scale_));
  }

  //! In the order in which those of either side were given. One outside that lies far from all others says
  //! nothing.
  std::vector<Pending> clicksOf(const ObjectQuery& query) const {
    std::vector<Pending> out;
    for (const ObjectClick& c : query.inside) out.push_back({cellClick(c, true), true});
    for (const ObjectClick& c : query.outside)
      if (work_->cells().contains(c.place)) out.push_back({cellClick(c, false), false});
    return out;
  }
  static std::vector<CellClick> clicksOf(const std::vector<Pending>& clicks, bool isInside) {
    std::vector<CellClick> out;
    for (const Pending& p : clicks)
      if (p.isInside == isInside) out.push_back(p.click);
    return out;
  }

  //! The radius of a click inside is that of the surface's start, which may lie around the object.
  CellClick cellClick(const ObjectClick& click, bool isInside) const {
    const CellGrid& cells = work_->cells();
    const double cell = cells.grid.meanSpacing();
    return {click.place, cells.at(cells.nearest(click.place)), isInside ? cell : click.radius.value_or(cell)};
  }

  void startWith(int candidate) {
    start_.reset();  // so that nothing of another candidate is left if this gives up
    steps_.clear();
    candidate_ = candidate;
    const Pending first{cellClick({first_, {}}, true), true};
    Corrected start{onImage(chosen()), {first}, 0};
    reachClick(start.region, first.click);
    start.region = tidied(std::move(start.region), start.done);
    isInThinPart_ = isInThinPart(start.region, first.click);
    start_ = std::move(start);
  }

  //! The order of the clicks of either side is known, but not how the sides took turns: of the first of each
  //! on the wrong side the one that lies deeper is next. It stays the first when others are added.
  const Pending* nextOf(const Corrected& c, const std::vector<Pending>& clicks, double& deepest) const {
    const Pending* next = nullptr;
    deepest = 0;
    for (const bool isInside : {true, false}) {
      const auto isLeft = [&](const Pending& p) {
        return p.isInside == isInside && !isTrue(c.region, p) &&
               std::none_of(c.done.begin(), c.done.end(), [&](const Pending& d) { return isSame(d, p); });
      };
      const auto p = std::find_if(clicks.begin(), clicks.end(), isLeft);
      if (p == clicks.end()) continue;
      const double depth = depthBehindSurface(*work_, c.region, p->click.cell);
      if (depth > deepest) deepest = depth, next = &*p;
    }
    return next;
  }

  void correctAll(Corrected& c, const std::vector<Pending>& clicks) {
    double depth = 0;
    for (std::size_t step = 0; const Pending* next = nextOf(c, clicks, depth); ++step) {
      if (step == steps_.size() || !isSame(steps_[step].done.back(), *next)) {
        steps_.resize(std::min(step, steps_.size()));
        c.done.push_back(*next);
        correct(c, depth);
        steps_.push_back(c);
      }
      c = steps_[step];
    }
  }

  //! A region in the cells of the object, with its surface on the edges next to it. That of a star-shaped one
  //! stays: it lies where edges and intensities together said.
  Region onImage(const RankedRegion& r) const {
    Region found = regionOn(*work_, r);
    if (r.isStar()) return found;
    Region moved = refined(*work_, found, noise(), policy_);
    return moved.count() > 0 ? moved : found;  // one of a few cells is nothing but surface
  }

  //! The same for several. Those found by intensity are likely to be offered again for the next click.
  std::vector<std::shared_ptr<const Region>> onImageOnce(const std::vector<OfferedRegion>& offered) {
    std::vector<std::shared_ptr<const Region>> out(offered.size());
    forEachOnThreads(out.size(), threads_, [&](std::size_t i) {
      const RankedRegion& r = offered[i].region;
      const auto known = onImage_.find({r.map, r.rung});
      out[i] = known != onImage_.end() ? known->second : std::make_shared<const Region>(onImage(r));
    });
    for (std::size_t i = 0; i < out.size(); ++i)
      if (const RankedRegion& r = offered[i].region; !r.isStar()) onImage_[{r.map, r.rung}] = out[i];
    return out;
  }

  //! Only what hangs together with the clicks inside so far, without the holes that noise makes.
  Region tidied(Region region, const std::vector<Pending>& done) const {
    std::vector<std::size_t> holding;
    for (const Pending& p : done)
      if (p.isInside) holding.push_back(p.click.cell);
    keepParts(*work_, region, holding, policy_.cavity);
    return region;
  }

  //! The click lies in a branch or at the surface of something much thicker: that branch may be meant.
  bool isInThinPart(const Region& region, const CellClick& click) const {
    return depthBehindSurface(*work_, region, click.cell) < policy_.thinPart * deepestInside(*work_, region);
  }

  //! The opening may have taken the place of the click itself: it hangs on by a ball.
  void reachClick(Region& region, const CellClick& click) const {
    if (region.inside[click.cell] || region.count() == 0) return;
    CellClick ball = click;
    ball.radius = depthBehindSurface(*work_, region, click.cell);
    stamp(*work_, region, {ball}, {});
  }

  //! What a click asks for that is offered to.
  struct Asked {
    const Corrected& from;
    const Pending& click;
    double depth;    // mm
    double radius;   // mm: the region's deepest place
    double cells;    // of the region
    double local;    // cost of a change near it
    double renewed;  // and of another candidate as a whole
  };

  //! Takes in the click done last.
  void correct(Corrected& c, double depth) {
    const Pending click = c.done.back();
    const double radius = deepestInside(*work_, c.region);
    if (depth < policy_.shallow * radius && moveSurface(c, c.region, click, depth, radius)) {
      ++c.inARow;
      return;
    }
    const std::vector<CellClick> inside = clicksOf(c.done, true), outside = clicksOf(c.done, false);
    const std::vector<RankedRegion> ranked = rank(inside, outside);  // as if later clicks were not there
    const Asked asked = askedBy(c, click, depth, radius);
    Offers offers(*work_, c.region, {click.isInside, depth, noise()}, policy_,
                  [&](Region r) { return fitted(std::move(r), asked); });
    const double made = bestScore(ranked) - asked.local;
    if (click.isInside) offerRelabelled(offers, asked, made);
    offerCandidates(offers, asked, ranked);
    if (click.isInside)
      offerOwnRegions(offers, asked);
    else
      offers.add([&] { return cutAway(*work_, c.region, click.click, inside, noise(), depth); }, made, true);
    offers.weigh(threads_);
    Offer best = offers.any() ? offers.take() : makeshift(asked);
    c.inARow = best.isLocal ? c.inARow + 1 : 0;
    const Region before = std::exchange(c.region, std::move(best.region));
    if (depth < policy_.otherPart * radius) moveSurface(c, before, click, depth, radius);
  }

  //! One outside in the middle of a region that is thick enough for that to be told says that most of it is
  //! wrong: another one is meant, and cuts are not. `radius`: the deepest place of the region, mm.
  Asked askedBy(const Corrected& c, const Pending& click, double depth, double radius) const {
    const double cost = policy_.corrected * (click.isInside ? 1 : c.inARow + 1);
    const auto cells = static_cast<double>(c.region.count());
    if (click.isInside) return {c, click, depth, radius, cells, cost, 0};
    const bool isCore =
        depth > policy_.core * radius && depth > policy_.coreCells * work_->cells().grid.meanSpacing();
    return isCore ? Asked{c, click, depth, radius, cells, cost + policy_.coreCut, 0}
                  : Asked{c, click, depth, radius, cells, cost, policy_.renewed};
  }

  //! A ball around the click, where nothing else serves; nothing changes if it is none that hangs together
  //! with the rest.
  Offer makeshift(const Asked& asked) const {
    Region ball = tidied(within(asked, policy_.makeshiftReach * asked.depth,
                                [&](std::size_t) { return asked.click.isInside; }),
                         asked.from.done);
    return {isTrue(ball, asked.click) ? std::move(ball) : asked.from.region, 0, true};
  }

  //! What can be offered; none if the click is still on the wrong side, or by far too much is added.
  std::optional<Region> fitted(Region region, const Asked& asked) const {
    region = tidied(std::move(region), asked.from.done);
    if (!isTrue(region, asked.click) || addsTooMuch(region, asked)) return {};
    return region;
  }

  //! Of a region that the user has corrected before, a click inside says that a part is missing: what adds
  //! much more than that is another object, and has been wrong nearly always.
  bool addsTooMuch(const Region& region, const Asked& asked) const {
    const std::size_t corrections = asked.from.done.size() - 1;  // this one among them
    if (!asked.click.isInside || corrections < 2) return false;
    const double added = static_cast<double>(region.count()) - asked.cells;
    if (asked.depth < policy_.otherPart * asked.radius) return added > policy_.growth * asked.cells;
    const double ball =
        4.0 / 3 * std::numbers::pi * std::pow(asked.depth, 3) / work_->cells().grid.spacing.prod();
    return added > std::max(policy_.growthApart * asked.cells, ball);
  }

  //! What is wrong is mostly a shell as wide as the object: the surface that the region had before moves
  //! around the click. False, and nothing changes, if the click is still on the wrong side then.
  bool moveSurface(Corrected& c, const Region& before, const Pending& click, double depth,
                   double radius) const {
    Region moved =
        displaced(*work_, before, c.region,
                  {click.click, click.isInside, policy_.displaced * depth, policy_.displacedWidth * radius,
                   clicksOf(c.done, !click.isInside), policy_.displacedEdge * noise()});
    moved = tidied(std::move(moved), c.done);
    if (!isTrue(moved, click)) return false;
    c.region = std::move(moved);
    return true;
  }

  //! 0 where nothing is of the contrast that is asked for.
  static double bestScore(const std::vector<RankedRegion>& ranked) {
    const auto best =
        std::max_element(ranked.begin(), ranked.end(),
                         [](const RankedRegion& a, const RankedRegion& b) { return a.score < b.score; });
    return best == ranked.end() ? 0 : best->score;
  }

  //! The surface moved, near the click and further along; for a click outside the others served better.
  void offerRelabelled(Offers& offers, const Asked& asked, double score) const {
    Relabelling r{asked.click.click,
                  asked.depth,
                  0,
                  noise(),
                  clicksOf(asked.from.done, true),
                  clicksOf(asked.from.done, false)};
    for (const double reach : policy_.relabelReaches) {
      r.reach = reach * asked.depth;
      offers.add([this, &asked, r] { return relabelled(*work_, asked.from.region, r, policy_); }, score,
                 true);
      score -= policy_.relabelFar;
    }
  }

  //! Other candidates that agree with all clicks so far, whole or only near this one.
  void offerCandidates(Offers& offers, const Asked& asked, const std::vector<RankedRegion>& ranked) {
    const std::vector<Pending>& done = asked.from.done;
    std::vector<RankedRegion> agreeing;
    std::copy_if(ranked.begin(), ranked.end(), std::back_inserter(agreeing), [&](const RankedRegion& r) {
      return std::all_of(done.begin(), done.end(),
                         [&](const Pending& p) { return r.holds(p.click.place) == p.isInside; });
    });
    const std::vector<OfferedRegion> offered = offeredRegions(likelyRegions(agreeing, policy_), policy_);
    const std::vector<std::shared_ptr<const Region>> regions = onImageOnce(offered);
    for (std::size_t i = 0; i < offered.size(); ++i) {
      const double score = offered[i].region.score;
      const std::shared_ptr<const Region>& whole = regions[i];
      offers.add([whole] { return *whole; }, score - asked.renewed, false);
      offers.add(
          [this, whole, &asked] {
            return within(asked, policy_.correctionReach * asked.depth,
                          [&](std::size_t cell) { return whole->inside[cell]; });
          },
          score - asked.local - policy_.mixed, true);
    }
  }

  //! What a search from the click finds: other intensities belong to the object, too.
  void offerOwnRegions(Offers& offers, const Asked& asked) const {
    const Searches own = searchesAround(asked.click.click.place);
    std::vector<RankedRegion> ranked = rankRegions(own, policy_, threads_);
    std::erase_if(ranked, [&](const RankedRegion& r) {
      return std::any_of(asked.from.done.begin(), asked.from.done.end(),
                         [&](const Pending& o) { return !o.isInside && r.holds(o.click.place); });
    });
    for (const RankedRegion& r : distinctRegions(ranked, policy_.tried, policy_))
      offers.add(
          [this, whole = regionOn(*work_, r), &asked] {
            return within(asked, policy_.correctionReach * asked.depth, [&](std::size_t cell) {
              return asked.from.region.inside[cell] || whole.inside[cell];
            });
          },
          r.score - asked.local, true);
  }

  //! The region with f(cell) instead within `reach` (mm) of a click.
  template <typename F>
  Region within(const Asked& asked, double reach, F&& f) const {
    Region out = asked.from.region;
    forCellsWithin(work_->cells(), asked.click.click.place, reach + work_->cells().grid.meanSpacing(),
                   [&](std::size_t i) { out.inside[i] = f(i); });
    return out;
  }

  Volume volume_;
  std::shared_ptr<const FieldOfView> view_;
  const ObjectPolicy& policy_;
  Vec3 first_;  // mm: the first click
  Contrast contrast_;
  int threads_;
  IntensityScale scale_;
  WorkCells cells_;  // for the first click alone
  Searches searches_, firstTubes_;
  std::vector<std::vector<ArrivalMap>> firstStars_;
  std::vector<OfferedRegion> offered_;
  std::shared_ptr<const WorkImage> work_;
  // Of the candidate, in the cells of the object:
  int candidate_ = 0;
  bool isInThinPart_ = false;
  std::optional<Corrected> start_;
  std::vector<Corrected> steps_;                                                        // a click each
  std::map<std::pair<const ArrivalMap*, int>, std::shared_ptr<const Region>> onImage_;  // map and rung
};

ObjectFinder::ObjectFinder(const ObjectPolicy& policy) : policy_(policy) {}
ObjectFinder::~ObjectFinder() = default;

std::optional<ObjectModel> ObjectFinder::find(const Volume& volume, const ObjectQuery& query,
                                              std::shared_ptr<const FieldOfView> view) {
  if (!search_ || !search_->isFor(volume, query, view != nullptr)) {
    search_.reset();
    search_ = std::make_unique<Search>(volume, query, std::move(view), policy_);
  }
  return search_->answer(query);
}

std::optional<ObjectModel> findObject(const Volume& volume, const ObjectQuery& query, const FieldOfView* view,
                                      const ObjectPolicy& policy) {
  const std::shared_ptr<const FieldOfView> unowned(std::shared_ptr<const void>(), view);
  return ObjectFinder(policy).find(volume, query, unowned);
}

}  // namespace handlebody
