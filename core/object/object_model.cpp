#include "core/object/object_model.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "core/object/click_correction.h"
#include "core/object/relabel.h"
#include "core/object/tube_surface.h"
#include "core/object/work_cells.h"
#include "core/threads.h"

namespace handlebody {

namespace {

bool isSame(const GivenClick& a, const GivenClick& b) {
  return a.isInside == b.isInside && a.click.place == b.click.place && a.click.radius == b.click.radius;
}

bool isSame(const Volume& a, const Volume& b) {
  return a.voxels == b.voxels && a.type == b.type && a.grid.size == b.grid.size &&
         a.grid.spacing == b.grid.spacing && a.grid.origin == b.grid.origin &&
         a.grid.direction == b.grid.direction;
}
bool isSame(const CellGrid& a, const CellGrid& b) {
  return a.low == b.low && a.factor == b.factor && a.grid.size == b.grid.size;
}

bool isSame(const RegionInCells* a, const RegionInCells* b) {
  if (!a || !b) return a == b;
  return isSame(a->cells, b->cells) && a->region.inside == b->region.inside;
}

}  // namespace

//! All that was found around a first click.
class ObjectFinder::Search : private RegionSource {
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
    if (!start_ || candidate != candidate_ || !isSame(query.shown.get(), shown_.get()))
      startWith(candidate, query.shown);
    Corrected corrected = *start_;
    const std::vector<GivenClick> clicks = givenIn(query);
    correctAll(corrected, clicks);
    return modelOf(std::move(corrected), clicks);
  }

 private:
  const RankedRegion& chosen() const { return offered_[candidate_ - 1].region; }

  ObjectModel modelOf(Corrected corrected, const std::vector<GivenClick>& clicks) const {
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
    for (auto c = clicks.begin() + 1; c != clicks.end(); ++c) model.clicks.push_back(c->click.place);
    stamp(*work_, corrected.region, clicksOf(clicks, true), clicksOf(clicks, false));
    model.region = std::move(corrected.region);
    model.isCutOff = isCutOff(work_->cells(), model.region);
    if (model.isCorrected) model.start = start_->region;
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

  ClickSearches searchesAround(const Vec3& click) const override {
    return searchesIn(wideAround(click), click);
  }
  //! Near the click in voxels, and wide in cells that may be coarser; one if that is fine enough.
  ClickSearches searchesIn(const CellGrid& wide, const Vec3& click) const {
    ClickSearches out;
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

  std::vector<RankedRegion> rank(const std::vector<CellClick>& inside,
                                 const std::vector<CellClick>& outside) override {
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

  //! What the first click may mean. If that is a tube that goes on, it is followed further, and if the
  //! likeliest is cut off where the search ends, it is looked for in a wider one.
  std::vector<OfferedRegion> offeredFor(const Vec3& click) {
    cells_.reach({click, policy_.reach});
    while (true) {
      work_ = std::make_shared<const WorkImage>(cells_.image(scale_));
      std::vector<RankedRegion> ranked = rank({{click}}, {});
      std::vector<OfferedRegion> offered = offeredRegions(likelyRegions(ranked, policy_), policy_);
      bool isWider = false;
      for (const OfferedRegion& o : offered)
        for (const Vec3& end : o.region.search->goesOn) isWider |= cells_.reach({end, policy_.reach / 2});
      if (!offered.empty()) isWider |= searchWider(click, offered[0].region);
      if (!isWider) return offered;
    }
  }
  //! True if the search ends too early for the region, and has been done anew in a wider box.
  bool searchWider(const Vec3& click, const RankedRegion& region) {
    const std::vector<Vec3> sides = cutSides(region);
    if (sides.empty()) return false;
    for (const Vec3& side : sides) cells_.reach({side, policy_.reach / 2});
    const CellGrid wide = cells_.cells(policy_.wideCells);
    if (isSame(wide, searches_.back()->image.cells)) return false;
    searches_ = searchesIn(wide, click);
    return true;
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
  std::vector<GivenClick> givenIn(const ObjectQuery& query) const {
    std::vector<GivenClick> out;
    for (const ObjectClick& c : query.inside) out.push_back({cellClick(c, true), true});
    for (const ObjectClick& c : query.outside)
      if (work_->cells().contains(c.place)) out.push_back({cellClick(c, false), false});
    return out;
  }

  //! The radius of a click inside is that of the surface's start, which may lie around the object.
  CellClick cellClick(const ObjectClick& click, bool isInside) const {
    const CellGrid& cells = work_->cells();
    const double cell = cells.grid.meanSpacing();
    return {click.place, cells.at(cells.nearest(click.place)), isInside ? cell : click.radius.value_or(cell)};
  }

  void startWith(int candidate, const std::shared_ptr<const RegionInCells>& shown) {
    start_.reset();  // so that nothing of another candidate is left if this gives up
    steps_.clear();
    candidate_ = candidate;
    shown_ = shown;
    const GivenClick first{cellClick({first_, {}}, true), true};
    Corrected start{shown ? regionOn(*work_, *shown) : onImage(chosen()), {first}};
    start.isBoundary = shown != nullptr;
    reachClick(start.region, first.click);
    start.region = tidied(*work_, std::move(start.region), start.done, policy_);
    isInThinPart_ = isInThinPart(start.region, first.click);
    start_ = std::move(start);
  }

  //! The order of the clicks of either side is known, but not how the sides took turns: of the first of each
  //! on the wrong side the one that lies deeper is next. It stays the first when others are added.
  const GivenClick* nextOf(const Corrected& c, const std::vector<GivenClick>& clicks, double& deepest) const {
    const GivenClick* next = nullptr;
    deepest = 0;
    for (const bool isInside : {true, false}) {
      const auto isLeft = [&](const GivenClick& p) {
        return p.isInside == isInside && !isTrue(c.region, p) &&
               std::none_of(c.done.begin(), c.done.end(), [&](const GivenClick& d) { return isSame(d, p); });
      };
      const auto p = std::find_if(clicks.begin(), clicks.end(), isLeft);
      if (p == clicks.end()) continue;
      const double depth = depthBehindSurface(*work_, c.region, p->click.cell);
      if (depth > deepest) deepest = depth, next = &*p;
    }
    return next;
  }

  void correctAll(Corrected& c, const std::vector<GivenClick>& clicks) {
    double depth = 0;
    for (std::size_t step = 0; const GivenClick* next = nextOf(c, clicks, depth); ++step) {
      if (step == steps_.size() || !isSame(steps_[step].done.back(), *next)) {
        steps_.resize(std::min(step, steps_.size()));
        c.done.push_back(*next);
        correct({*this, *work_, noise(), policy_, threads_}, c, depth);
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
  std::vector<std::shared_ptr<const Region>> onImage(const std::vector<OfferedRegion>& offered) override {
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

  Volume volume_;
  std::shared_ptr<const FieldOfView> view_;
  const ObjectPolicy& policy_;
  Vec3 first_;  // mm: the first click
  Contrast contrast_;
  int threads_;
  IntensityScale scale_;
  WorkCells cells_;  // for the first click alone
  ClickSearches searches_, firstTubes_;
  std::vector<std::vector<ArrivalMap>> firstStars_;
  std::vector<OfferedRegion> offered_;
  std::shared_ptr<const WorkImage> work_;
  // Of the candidate, in the cells of the object:
  int candidate_ = 0;
  std::shared_ptr<const RegionInCells> shown_;
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
