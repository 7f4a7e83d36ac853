#include "core/object/tube_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/object/tube_tracking.h"
#include "core/threads.h"

namespace handlebody {

namespace {

//! A tube's cells, in a box of its own.
struct TubeRegion {
  CellBox box;                       //!< in the cells of the image
  std::vector<std::uint8_t> inside;  //!< per cell of the box
  double radius = 0, length = 0;     //!< mm
  double agreement = 0;              //!< part of the starts that end in it, more if it is long
  std::vector<Vec3> goesOn;          //!< mm: where it leaves the image
  std::size_t count = 0;             //!< of the cells inside

  bool holds(const std::array<int, 3>& cell) const { return box.holds(cell) && inside[box.at(cell)] != 0; }
};

void widenBy(CellBox& box, const CrossSection& s, const CellGrid& cells) {
  for (std::size_t a = 0; a < CrossSection::kAngles; ++a)
    box.widen(cells.nearest(s.centre + s.radiusAt(a) * s.direction(a)));
}

//! Between which distances from the middle the outlines of two planes lie, and those that go over from one to
//! the other.
std::array<double, 2> radiiOf(const CrossSection& a, const CrossSection& b) {
  constexpr double kRounding = 1e-9;  // far more than weights that sum to 1 are rounded by
  double least = a.radiusAt(0), most = least;
  for (std::size_t n = 0; n < CrossSection::kAngles; ++n)
    for (const CrossSection* s : {&a, &b}) {
      least = std::min(least, s->radiusAt(n));
      most = std::max(most, s->radiusAt(n));
    }
  return {least * (1 - kRounding), most * (1 + kRounding)};
}

//! How far the outline goes in a direction, `t` of the way from one plane to the other.
double limitAt(const CrossSection& a, const CrossSection& b, double t, double x, double y) {
  const double turn = std::atan2(y, x) / (2 * std::numbers::pi);
  const double angle = (turn < 0 ? turn + 1 : turn) * CrossSection::kAngles;
  return (1 - t) * a.radiusBetween(angle) + t * b.radiusBetween(angle);
}

//! The cells between two planes, within outlines that go over from one to the other. Few lie where it takes
//! the angle to tell.
void fillBetween(const CrossSection& a, const CrossSection& b, const WorkImage& work, TubeRegion& out) {
  const CellGrid& cells = work.cells();
  CellBox box{cells.grid.size, {-1, -1, -1}};
  widenBy(box, a, cells);
  widenBy(box, b, cells);
  const auto [least, most] = radiiOf(a, b);
  forBox(box.grown(1, cells.grid.size), [&](const std::array<int, 3>& c) {
    const Vec3 p = cells.grid.toWorld(Vec3(c[0], c[1], c[2]));
    const double before = (p - a.centre).dot(a.along), behind = (b.centre - p).dot(b.along);
    if (before < 0 || behind < 0 || before + behind <= 0) return;
    const double t = before / (before + behind);
    const Vec3 to = p - ((1 - t) * a.centre + t * b.centre);
    const double x = to.dot((1 - t) * a.right + t * b.right), y = to.dot((1 - t) * a.up + t * b.up);
    const double squared = x * x + y * y;
    if (squared > most * most) return;
    if (squared > least * least && std::hypot(x, y) > limitAt(a, b, t, x, y)) return;
    if (!work.image.padding[cells.at(c)] && out.box.holds(c)) out.inside[out.box.at(c)] = 1;
  });
}

TubeRegion regionOf(const Tube& tube, const WorkImage& work) {
  TubeRegion out;
  out.radius = tube.usualRadius();
  out.length = tube.length();
  out.goesOn = tube.goesOn;
  out.box = {work.cells().grid.size, {-1, -1, -1}};
  for (const CrossSection& s : tube.sections) widenBy(out.box, s, work.cells());
  out.box = out.box.grown(2, work.cells().grid.size);
  out.inside.assign(out.box.count(), 0);
  for (std::size_t i = 0; i + 1 < tube.sections.size(); ++i)
    fillBetween(tube.sections[i], tube.sections[i + 1], work, out);
  out.count = static_cast<std::size_t>(std::count(out.inside.begin(), out.inside.end(), std::uint8_t{1}));
  return out;
}

//! How many cells two tubes share: row by row of the box that theirs share.
std::size_t cellsOfBoth(const TubeRegion& a, const TubeRegion& b) {
  CellBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::max(a.box.low[k], b.box.low[k]);
    box.high[k] = std::min(a.box.high[k], b.box.high[k]);
    if (box.low[k] > box.high[k]) return 0;
  }
  std::size_t out = 0;
  const int row = box.size()[0];
  for (int z = box.low[2]; z <= box.high[2]; ++z)
    for (int y = box.low[1]; y <= box.high[1]; ++y) {
      const std::array<int, 3> first{box.low[0], y, z};
      const std::uint8_t *ofA = &a.inside[a.box.at(first)], *ofB = &b.inside[b.box.at(first)];
      int both = 0;
      for (int x = 0; x < row; ++x) both += ofA[x] & ofB[x];
      out += static_cast<std::size_t>(both);
    }
  return out;
}

//! Cells of two tubes that are the same, as a part of either's or of the smaller one's.
struct Shared {
  double ofAny, ofSmaller;
};
Shared sharedBy(const TubeRegion& a, const TubeRegion& b) {
  const auto both = static_cast<double>(cellsOfBoth(a, b));
  const auto first = static_cast<double>(a.count), second = static_cast<double>(b.count);
  return {both / (first + second - both), both / std::min(first, second)};
}

std::vector<TubeRegion> foundTubes(const WorkImage& work, const std::vector<CellClick>& inside,
                                   const std::vector<CellClick>& outside, const ObjectPolicy& policy,
                                   const std::vector<double>& starts, int threads) {
  std::vector<std::optional<TubeRegion>> found(starts.size());
  forEachOnThreads(starts.size(), threads, [&](std::size_t s) {
    if (const auto tube = trackTube(work, inside, outside, starts[s], policy))
      found[s] = regionOf(*tube, work);
  });
  const auto holds = [&](const TubeRegion& r, const CellClick& c) {
    return r.holds(work.cells().nearest(c.place));
  };
  std::vector<TubeRegion> out;
  for (auto& f : found)
    if (f && std::ranges::all_of(inside, [&](const CellClick& c) { return holds(*f, c); }) &&
        std::ranges::none_of(outside, [&](const CellClick& c) { return holds(*f, c); }))
      out.push_back(std::move(*f));
  return out;
}

//! Those that differ. Starts that come to an end earlier or later followed the same tube.
std::vector<TubeRegion> tubeRegions(const WorkImage& work, const std::vector<CellClick>& inside,
                                    const std::vector<CellClick>& outside, const ObjectPolicy& policy,
                                    int threads) {
  std::vector<double> starts;
  for (double r = policy.tubeSmallest * work.cells().grid.meanSpacing(); r < policy.tubeLargest;
       r *= policy.tubeNext)
    starts.push_back(r);
  std::vector<TubeRegion> found = foundTubes(work, inside, outside, policy, starts, threads), out;
  for (const TubeRegion& f : found) {
    const auto agreeing = std::ranges::count_if(found, [&](const TubeRegion& o) {
      return std::abs(std::log(f.radius / o.radius)) < policy.sameSize &&
             sharedBy(f, o).ofSmaller > policy.sameRegion;
    });
    if (std::ranges::any_of(out,
                            [&](const TubeRegion& o) { return sharedBy(f, o).ofAny > policy.sameRegion; }))
      continue;
    out.push_back(f);
    out.back().agreement = static_cast<double>(agreeing) / static_cast<double>(starts.size()) +
                           policy.tubeBonus * std::log(f.length / (2 * f.radius * policy.tubeLong));
  }
  return out;
}

CellGrid boxOfCells(const CellGrid& cells, const CellBox& box) {
  CellGrid out = cells;
  out.grid.size = box.size();
  out.grid.origin = cells.grid.toWorld(Vec3(box.low[0], box.low[1], box.low[2]));
  for (std::size_t a = 0; a < 3; ++a) {
    out.low[a] = cells.low[a] + box.low[a] * cells.factor[a];
    out.goesOn[a] = {false, false};  // the tube ends in it
  }
  return out;
}

}  // namespace

std::vector<std::unique_ptr<ClickSearch>> tubeSearches(const WorkImage& work, const ClickSearch& like,
                                                       const std::vector<CellClick>& inside,
                                                       const std::vector<CellClick>& outside,
                                                       const ObjectPolicy& policy, int threads) {
  std::vector<std::unique_ptr<ClickSearch>> out;
  if (!(like.intensities.range > 0)) return out;  // constant: nothing to find
  for (const TubeRegion& tube : tubeRegions(work, inside, outside, policy, threads)) {
    const CellGrid cells = boxOfCells(work.cells(), tube.box);
    auto s = std::make_unique<ClickSearch>();
    s->scale = like.scale;
    s->image = {cells, cutOut(work.cells(), work.image.values, tube.box),
                cutOut(work.cells(), work.image.padding, tube.box)};
    s->values = cutOut(work.cells(), work.values, tube.box);
    s->click = cells.nearest(inside[0].place);
    s->intensities = like.intensities;
    ArrivalMap map{kRungs, 0, 0, 1, tube.agreement, {}};
    for (const std::uint8_t in : tube.inside) map.level.push_back(in ? std::uint8_t{0} : kNever);
    s->stars.push_back(std::move(map));
    s->isTube = true;
    s->goesOn = tube.goesOn;
    out.push_back(std::move(s));
  }
  return out;
}

}  // namespace handlebody
