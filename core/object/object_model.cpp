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
  return a.isInside == b.isInside && a.click.place == b.click.place && a.asked == b.asked;
}

bool isSame(const Volume& a, const Volume& b) {
  return a.voxels == b.voxels && a.type == b.type && a.grid.size == b.grid.size &&
         a.grid.spacing == b.grid.spacing && a.grid.origin == b.grid.origin &&
         a.grid.direction == b.grid.direction;
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
        given_(query.given),
        first_(query.inside[0].place),
        contrast_(query.contrast),
        threads_(query.threads),
        cells_(volume_, view_.get(), policy_) {
    scale_ = IntensityScale::of(makeCells(volume_, wideAround(first_), view_.get()), policy_);
    searches_ = searchesAround(first_);
    if (given_)
      reachGiven();
    else
      offered_ = offeredFor(first_);
    firstWork_ = work_;
    keepFirst();
  }
  bool isFor(const Volume& volume, const ObjectQuery& query, bool hasView) const {
    return isSame(volume, volume_) && query.inside[0].place == first_ && query.contrast == contrast_ &&
           hasView == (view_ != nullptr) && isSame(query.given.get(), given_.get());
  }

  std::optional<ObjectModel> answer(const ObjectQuery& query) {
    if (offered_.empty() && !given_) return {};
    threads_ = query.threads;
    const int candidate = given_ ? 1 : std::clamp(query.candidate, 1, static_cast<int>(offered_.size()));
    if (!start_ || candidate != candidate_ || !isSame(query.shown.get(), shown_.get()))
      startWith(candidate, query.shown);
    State now = *start_;
    correctAll(now, query);
    const std::vector<GivenClick> clicks = givenIn(*now.work, query);
    return modelOf(std::move(now), clicks);
  }

 private:
  //! What some clicks have made of the object, and the cells in which it is kept since.
  struct State {
    Corrected corrected;
    std::shared_ptr<const WorkImage> work;
    WorkCells cells;
  };

  //! Null where the object is given.
  const RankedRegion* chosen() const { return given_ ? nullptr : &offered_[candidate_ - 1].region; }

  ObjectModel modelOf(State last, const std::vector<GivenClick>& clicks) const {
    Corrected& corrected = last.corrected;
    ObjectModel model;
    for (const auto& [r, expected] : offered_) {
      const auto [low, high] = r.bounds();
      model.candidates.push_back({r.volume, r.map->radius, low, high, expected});
    }
    model.isCloseChoice = !given_ && (isClose() || (offered_.size() > 1 && isInThinPart_));
    model.chosen = candidate_;
    model.scale = scale_;
    model.level = searches_[0]->intensities.level;
    model.noise = noise();
    if (const RankedRegion* r = chosen()) {
      model.neckRadius = r->map->radius;
      model.isStar = r->isStar();
      model.low = r->bounds()[0];
      model.high = r->bounds()[1];
      model.rise = r->rise;
    }
    model.isGiven = given_ != nullptr;
    for (auto c = clicks.begin() + 1; c != clicks.end(); ++c)
      model.clicks.push_back({c->click.place, c->asked});
    const bool isTaken = stampAll(*last.work, corrected.region, clicks);
    model.isCorrected = isTaken || corrected.done.size() > 1;
    model.region = std::move(corrected.region);
    model.isCutOff = isCutOff(last.work->cells(), model.region);
    if (model.isCorrected) model.start = regionIn(*last.work, *start_);
    model.work = last.work;
    return model;
  }
  //! True if a ball outside takes something of the region: its centre need not lie there.
  static bool stampAll(const WorkImage& work, Region& region, const std::vector<GivenClick>& clicks) {
    std::vector<GivenClick> points = clicks;
    std::erase_if(points, [](const GivenClick& c) { return c.asked.has_value(); });
    const auto stamped = [&](const std::vector<GivenClick>& balls) {
      Region out = region;
      stamp(work, out, clicksOf(balls, true), clicksOf(balls, false));
      return out;
    };
    Region all = stamped(clicks);
    const bool isTaken = points.size() < clicks.size() && all.inside != stamped(points).inside;
    region = std::move(all);
    return isTaken;
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
  //! The cells reach all of what is given, with some room around it.
  void reachGiven() {
    const CellGrid& cells = given_->cells;
    const auto& n = cells.grid.size;
    for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(n[0] - 1, n[1] - 1, n[2] - 1)})
      cells_.reach({withinVolume(cells.grid.toWorld(corner)), policy_.reach / 4});
    cells_.reach({first_, policy_.reach / 4});
    work_ = std::make_shared<const WorkImage>(cells_.image(scale_));
  }
  //! The last of coarse cells may stand out of the volume, their middles, too.
  Vec3 withinVolume(const Vec3& world) const {
    const auto& n = volume_.grid.size;
    const Vec3 last(n[0] - 1, n[1] - 1, n[2] - 1);
    return volume_.grid.toWorld(volume_.grid.toIndex(world).cwiseMax(Vec3::Zero()).cwiseMin(last));
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

  //! In the order in which those of either side were given. One outside that lies far from all others says
  //! nothing.
  static std::vector<GivenClick> givenIn(const WorkImage& work, const ObjectQuery& query) {
    std::vector<GivenClick> out;
    for (const ObjectClick& c : query.inside) out.push_back(given(work, c, true));
    for (const ObjectClick& c : query.outside)
      if (work.cells().contains(c.place)) out.push_back(given(work, c, false));
    return out;
  }

  //! The radius of a click inside is that of the surface's start, which may lie around the object.
  static GivenClick given(const WorkImage& work, const ObjectClick& click, bool isInside) {
    const CellGrid& cells = work.cells();
    const std::optional<double> asked = isInside ? std::nullopt : click.radius;
    const std::size_t cell = cells.at(cells.nearest(click.place));
    return {{click.place, cell, asked.value_or(cells.grid.meanSpacing())}, isInside, asked};
  }

  void startWith(int candidate, const std::shared_ptr<const RegionInCells>& shown) {
    start_.reset();  // so that nothing of another candidate is left if this gives up
    steps_.clear();
    candidate_ = candidate;
    shown_ = shown;
    use(firstWork_);
    const GivenClick first = given(*work_, {first_, {}}, true);
    Corrected start{firstRegion(), {first}};
    start.isBoundary = shown != nullptr;
    reachClick(start.region, first.click);
    if (given_) start.parts = deepestOfParts(*work_, start.region);
    start.region = tidied(*work_, std::move(start.region), start.done, policy_, start.parts);
    isInThinPart_ = isInThinPart(start.region, first.click);
    start_ = State{std::move(start), work_, cells_};
  }

  Region firstRegion() const {
    if (shown_) return regionOn(*work_, *shown_);
    return given_ ? regionOn(*work_, *given_) : onImage(*chosen());
  }

  //! What regions are looked for in from now on.
  void use(const std::shared_ptr<const WorkImage>& work) {
    if (work == work_) return;
    work_ = work;
    onImage_.clear();
  }

  static Region regionIn(const WorkImage& work, const State& s) {
    const Region& region = s.corrected.region;
    return s.work.get() == &work ? region : regionOn(work, {s.work->cells(), region});
  }

  //! The cells reach a click inside, with some room around it.
  bool reaches(const State& s, const GivenClick& click) const {
    WorkCells cells = s.cells;
    return !cells.reach({click.click.place, policy_.reach / 4});
  }
  //! The same object in cells that reach the click.
  State widened(const State& s, const GivenClick& click) const {
    State out = s;
    out.cells.reach({click.click.place, policy_.reach / 4});
    out.work = std::make_shared<const WorkImage>(out.cells.image(scale_));
    const CellGrid &from = s.work->cells(), &to = out.work->cells();
    out.corrected.region = regionIn(*out.work, s);
    out.corrected.largest *= from.grid.voxelVolume() / to.grid.voxelVolume();
    for (GivenClick& c : out.corrected.done) c = given(*out.work, {c.click.place, c.asked}, c.isInside);
    return out;
  }

  //! The order of the clicks of either side is known, but not how the sides took turns: of the first of each
  //! on the wrong side the one that lies deeper is next; one that the cells do not reach comes last. It stays
  //! the first when others are added.
  std::optional<GivenClick> nextOf(const State& s, const ObjectQuery& query) const {
    const Corrected& c = s.corrected;
    const std::vector<GivenClick> clicks = givenIn(*s.work, query);
    std::optional<GivenClick> next;
    double deepest = -1;
    for (const bool isInside : {true, false}) {
      const auto isLeft = [&](const GivenClick& p) {
        return p.isInside == isInside && !(isTrue(c.region, p) && s.work->cells().contains(p.click.place)) &&
               std::none_of(c.done.begin(), c.done.end(), [&](const GivenClick& d) { return isSame(d, p); });
      };
      const auto p = std::find_if(clicks.begin(), clicks.end(), isLeft);
      if (p == clicks.end()) continue;
      const double depth =
          isInside && !reaches(s, *p) ? 0 : depthBehindSurface(*s.work, c.region, p->click.cell);
      if (depth > deepest) deepest = depth, next = *p;
    }
    return next;
  }

  void correctAll(State& now, const ObjectQuery& query) {
    std::size_t step = 0;
    for (auto next = nextOf(now, query); next; next = nextOf(now, query), ++step) {
      if (step == steps_.size() || !isSame(steps_[step].corrected.done.back(), *next)) {
        steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(step), steps_.end());
        steps_.push_back(correctedBy(now, *next));
      }
      now = steps_[step];
    }
  }
  State correctedBy(const State& now, GivenClick next) {
    State out = now;
    if (next.isInside && !reaches(now, next)) {
      out = widened(now, next);
      next = given(*out.work, {next.click.place, {}}, true);
    }
    use(out.work);
    out.corrected.done.push_back(next);
    const double depth = depthBehindSurface(*work_, out.corrected.region, next.click.cell);
    correct({*this, *work_, noise(), policy_, threads_}, out.corrected, depth);
    return out;
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
  std::shared_ptr<const RegionInCells> given_;  // may be null
  Vec3 first_;                                  // mm: the first click
  Contrast contrast_;
  int threads_;
  IntensityScale scale_;
  WorkCells cells_;  // for the first click alone
  ClickSearches searches_, firstTubes_;
  std::vector<std::vector<ArrivalMap>> firstStars_;
  std::vector<OfferedRegion> offered_;
  std::shared_ptr<const WorkImage> firstWork_, work_;  // of the first click; in which is looked for regions
  // Of the candidate:
  int candidate_ = 0;
  std::shared_ptr<const RegionInCells> shown_;
  bool isInThinPart_ = false;
  std::optional<State> start_;
  std::vector<State> steps_;                                                            // a click each
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
