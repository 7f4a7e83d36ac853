#include "core/object/click_correction.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "core/object/displacement.h"
#include "core/object/offers.h"
#include "core/object/relabel.h"
#include "core/volume/voxel_walk.h"

namespace handlebody {

std::vector<CellClick> clicksOf(const std::vector<GivenClick>& clicks, bool isInside) {
  std::vector<CellClick> out;
  for (const GivenClick& c : clicks)
    if (c.isInside == isInside) out.push_back(c.click);
  return out;
}

Region tidied(const WorkImage& work, Region region, const std::vector<GivenClick>& done,
              const ObjectPolicy& policy, const std::vector<Vec3>& parts) {
  std::vector<std::size_t> holding;
  for (const CellClick& c : clicksOf(done, true)) holding.push_back(c.cell);
  const CellGrid& cells = work.cells();
  for (const Vec3& place : parts) holding.push_back(cells.at(cells.nearest(place)));
  keepParts(work, region, holding, policy.cavity);
  return region;
}

namespace {

//! Cells of the largest piece of a region that a part of it lacks, without what is new in the region.
double largestLost(const WorkImage& work, const Region& before, const Region& region, const Region& part) {
  std::vector<std::uint8_t> lost(region.inside.size());
  for (std::size_t i = 0; i < lost.size(); ++i)
    lost[i] = before.inside[i] != 0 && region.inside[i] != 0 && part.inside[i] == 0;
  std::size_t largest = 0;
  for (std::size_t start = 0; start < lost.size(); ++start) {
    if (lost[start] == 0) continue;
    lost[start] = 0;
    std::vector<std::size_t> piece{start};
    for (std::size_t k = 0; k < piece.size(); ++k)
      forFaceNeighbours(work.cells().grid.size, piece[k], [&](std::size_t w, std::size_t) {
        if (lost[w] == 0) return;
        lost[w] = 0;
        piece.push_back(w);
      });
    largest = std::max(largest, piece.size());
  }
  return static_cast<double>(largest);
}

//! In cells.
double ballOf(double radius, const WorkImage& work) {
  return 4.0 / 3 * std::numbers::pi * std::pow(radius, 3) / work.cells().grid.spacing.prod();
}

//! 0 where nothing is of the contrast that is asked for.
double bestScore(const std::vector<RankedRegion>& ranked) {
  const auto best =
      std::max_element(ranked.begin(), ranked.end(),
                       [](const RankedRegion& a, const RankedRegion& b) { return a.score < b.score; });
  return best == ranked.end() ? 0 : best->score;
}

class Correction {
 public:
  Correction(const CorrectionScene& scene, Corrected& corrected, double depth)
      : source_(scene.source),
        work_(scene.work),
        noise_(scene.noise),
        policy_(scene.policy),
        threads_(scene.threads),
        corrected_(corrected),
        click_(corrected.done.back()),
        depth_(depth),
        radius_(deepestInside(work_, corrected.region)) {}

  void run() {
    if (depth_ <= policy_.shallow * kRounding * radius_ && moveSurface(corrected_.region)) {
      settle();
      ++corrected_.inARow;
      return;
    }
    Offer best = bestOffer();
    corrected_.inARow = best.isLocal ? corrected_.inARow + 1 : 0;
    corrected_.isBoundary &= best.isLocal;
    const Region before = std::exchange(corrected_.region, std::move(best.region));
    if (depth_ < policy_.otherPart * radius_ && moveSurface(before) && best.isLocal) settle();
  }

 private:
  static constexpr double kEverywhere = 1e5;     // mm
  static constexpr double kRounding = 1 + 1e-6;  // of distances in few cells, which are often equal

  const Region& from() const { return corrected_.region; }

  //! What is wrong is mostly a shell as wide as the object: the surface that the region had before moves
  //! around the click. False, and nothing changes, if the click is still on the wrong side then.
  bool moveSurface(const Region& before) {
    Region moved = displaced(work_, before, corrected_.region,
                             {click_.click, click_.isInside, policy_.displaced * depth_,
                              policy_.displacedWidth * radius_, clicksOf(corrected_.done, !click_.isInside),
                              policy_.displacedEdge * noise_, policy_.slices, policy_.fewSlices});
    moved = tidy(std::move(moved));
    if (!isTrue(moved, click_)) return false;
    corrected_.region = std::move(moved);
    return true;
  }
  //! On edges again, everywhere: what a click tells of intensities holds elsewhere, too. A boundary between
  //! two intensities lies better than cells can tell, and stays as it is far from the click; so does all
  //! where something thin would come apart, which is not what the click has said.
  void settle() {
    Relabelling r = relabelling();
    r.isInside = click_.isInside;
    r.depth = std::min(depth_, deepestInside(work_, from()));
    if (r.depth <= 0) return;  // nothing is left
    r.reach = kEverywhere;
    if (!corrected_.isBoundary && settleWithoutCut(r)) return;
    r.reach = policy_.settledNear * policy_.displacedWidth * radius_;
    settleWithoutCut(r);
  }
  //! False, and nothing changes, if it would cut off a piece of more than a ball as deep as the click.
  bool settleWithoutCut(const Relabelling& r) {
    const Region moved = settled(work_, from(), r, policy_);
    Region out = tidy(moved);
    if (largestLost(work_, from(), moved, out) >= ballOf(r.depth, work_)) return false;
    if (isTrue(out, click_)) corrected_.region = std::move(out);
    return true;
  }

  Offer bestOffer() {
    setCosts();
    corrected_.largest = std::max(corrected_.largest, static_cast<double>(from().count()));
    const std::vector<CellClick> inside = clicksOf(corrected_.done, true);
    const std::vector<RankedRegion> ranked = source_.rank(inside, clicksOf(corrected_.done, false));
    Offers offers(work_, from(), {click_.isInside, depth_, noise_}, policy_,
                  [this](Region r) { return fitted(std::move(r)); });
    const double made = bestScore(ranked) - local_;
    if (click_.isInside) offerRelabelled(offers, made);
    offerCandidates(offers, ranked);
    if (click_.isInside)
      offerOwnRegions(offers);
    else
      offers.add([&] { return cutAway(work_, from(), click_.click, inside, noise_, depth_); }, made, true);
    offers.weigh(threads_);
    return offers.any() ? offers.take() : makeshift();
  }

  //! One outside in the middle of a region that is thick enough for that to be told says that most of it is
  //! wrong: another one is meant, and cuts are not.
  void setCosts() {
    local_ = policy_.corrected * (click_.isInside ? 1 : corrected_.inARow + 1);
    if (click_.isInside) return;
    const bool isCore =
        depth_ > policy_.core * radius_ && depth_ > policy_.coreCells * work_.cells().grid.meanSpacing();
    if (isCore)
      local_ += policy_.coreCut;
    else
      renewed_ = policy_.renewed;
  }

  Region tidy(Region region) const {
    return tidied(work_, std::move(region), corrected_.done, policy_, corrected_.parts);
  }

  //! What can be offered; none if the click is still on the wrong side, or by far too much is added.
  std::optional<Region> fitted(Region region) const {
    region = tidy(std::move(region));
    if (!isTrue(region, click_) || addsTooMuch(region) || leavesTooLittle(region)) return {};
    return region;
  }

  //! By a click before this one.
  bool isCorrected() const { return corrected_.done.size() > 2; }

  //! Of a region that the user has corrected before, a click inside says that a part is missing: what adds
  //! much more than that is another object, and has been wrong nearly always. What an earlier click has taken
  //! away may come back.
  bool addsTooMuch(const Region& region) const {
    if (!click_.isInside || !isCorrected()) return false;
    const double added = static_cast<double>(region.count()) - corrected_.largest;
    if (depth_ < policy_.otherPart * radius_) return added > policy_.growth * corrected_.largest;
    return added > std::max(policy_.growthApart * corrected_.largest, ballOf(depth_, work_));
  }

  //! One outside, of a region that the user has corrected before, does not say that next to nothing is right.
  bool leavesTooLittle(const Region& region) const {
    return !click_.isInside && isCorrected() &&
           static_cast<double>(region.count()) < policy_.left * static_cast<double>(from().count());
  }

  //! A ball around the click, where nothing else serves; nothing changes if it is none that hangs together
  //! with the rest.
  Offer makeshift() const {
    const auto isInside = [this](std::size_t) { return click_.isInside; };
    Region ball = tidy(within(policy_.makeshiftReach * depth_, isInside));
    if (!isTrue(ball, click_)) return {from(), 0, true};
    return {std::move(ball), 0, true};
  }

  Relabelling relabelling() const {
    return {
        click_.click, depth_, 0, noise_, clicksOf(corrected_.done, true), clicksOf(corrected_.done, false)};
  }

  //! The surface moved near the click; for a click outside the others served better.
  void offerRelabelled(Offers& offers, double score) const {
    Relabelling r = relabelling();
    r.reach = policy_.correctionReach * depth_;
    offers.add([this, r] { return relabelled(work_, from(), r, policy_); }, score, true);
  }

  //! Other candidates that agree with all clicks so far, whole or only near this one.
  void offerCandidates(Offers& offers, const std::vector<RankedRegion>& ranked) const {
    const std::vector<GivenClick>& done = corrected_.done;
    std::vector<RankedRegion> agreeing;
    std::copy_if(ranked.begin(), ranked.end(), std::back_inserter(agreeing), [&](const RankedRegion& r) {
      return std::all_of(done.begin(), done.end(),
                         [&](const GivenClick& c) { return r.holds(c.click.place) == c.isInside; });
    });
    const std::vector<OfferedRegion> offered = offeredRegions(likelyRegions(agreeing, policy_), policy_);
    const std::vector<std::shared_ptr<const Region>> regions = source_.onImage(offered);
    for (std::size_t i = 0; i < offered.size(); ++i) {
      const double score = offered[i].region.score;
      const std::shared_ptr<const Region>& whole = regions[i];
      offers.add([whole] { return *whole; }, score - renewed_, false);
      offers.add(
          [this, whole] {
            return within(policy_.correctionReach * depth_,
                          [&](std::size_t cell) { return whole->inside[cell]; });
          },
          score - local_ - policy_.mixed, true);
    }
  }

  //! What a search from the click finds: other intensities belong to the object, too.
  void offerOwnRegions(Offers& offers) const {
    const ClickSearches own = source_.searchesAround(click_.click.place);
    std::vector<RankedRegion> ranked = rankRegions(own, policy_, threads_);
    std::erase_if(ranked, [&](const RankedRegion& r) {
      return std::any_of(corrected_.done.begin(), corrected_.done.end(),
                         [&](const GivenClick& c) { return !c.isInside && r.holds(c.click.place); });
    });
    for (const RankedRegion& r : distinctRegions(ranked, policy_.tried, policy_))
      offers.add(
          [this, whole = regionOn(work_, r)] {
            return within(policy_.correctionReach * depth_,
                          [&](std::size_t cell) { return from().inside[cell] || whole.inside[cell]; });
          },
          r.score - local_, true);
  }

  //! The region with f(cell) instead within `reach` (mm) of the click.
  template <typename F>
  Region within(double reach, F&& f) const {
    Region out = from();
    forCellsWithin(work_.cells(), click_.click.place, reach + work_.cells().grid.meanSpacing(),
                   [&](std::size_t i) { out.inside[i] = f(i); });
    return out;
  }

  RegionSource& source_;
  const WorkImage& work_;
  double noise_;
  const ObjectPolicy& policy_;
  int threads_;
  Corrected& corrected_;
  GivenClick click_;
  double depth_, radius_;  // mm: of the click behind the surface, and of the region's deepest place
  double local_ = 0;       // cost of a change near the click,
  double renewed_ = 0;     // and of another candidate as a whole
};

}  // namespace

void correct(const CorrectionScene& scene, Corrected& corrected, double depth) {
  Correction(scene, corrected, depth).run();
}

}  // namespace handlebody
