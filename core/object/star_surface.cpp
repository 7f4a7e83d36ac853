#include "core/object/star_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/cancellation.h"
#include "core/object/closure.h"
#include "core/object/intensity_shares.h"
#include "core/object/rays.h"
#include "core/threads.h"
#include "core/volume/intensity_statistics.h"

namespace handlebody {

namespace {

using Mask = std::vector<std::uint8_t>;
constexpr std::size_t kRadii = 40;  // per ray, from the innermost to the outermost
constexpr int kBins = 32;           // of the intensities
constexpr double kConverged = 0.1;  // cells: a shorter move is the last
constexpr double kForced = 1e3;     // cost: more than a surface can win
constexpr double kRounding = 1e-9;  // of a radius: far more than weights that sum to 1 are rounded by

//! A surface holds all that lies further in on its rays, and bends little between them.
std::vector<std::array<std::size_t, 2>> pairsOfSurface(const Rays& rays, std::size_t bend) {
  std::vector<std::array<std::size_t, 2>> out;
  for (std::size_t d = 0; d < rays.directions.size(); ++d)
    for (std::size_t k = 1; k < kRadii; ++k) out.push_back({d * kRadii + k, d * kRadii + k - 1});
  for (const auto& [a, b] : rays.pairs)
    for (std::size_t k = bend; k < kRadii; ++k) {
      out.push_back({a * kRadii + k, b * kRadii + k - bend});
      out.push_back({b * kRadii + k, a * kRadii + k - bend});
    }
  return out;
}

//! The image and the clicks that a surface must fit.
struct StarTask {
  const CellImage& image;
  const std::vector<float>& values;
  const std::vector<CellClick>&inside, &outside;
  const ObjectPolicy& policy;
  const Rays& rays;
};

//! One surface, from a sphere around the first click.
class StarSearch {
 public:
  explicit StarSearch(const StarTask& task)
      : task_(task),
        cell_(task.image.cells.grid.meanSpacing()),
        rays_(task.rays.directions.size()),
        closure_(rays_ * kRadii, pairsOfSurface(task.rays, task.policy.starBend)),
        intensities_(rays_ * kRadii),
        bins_(rays_ * kRadii),
        beyond_(rays_ * kRadii),
        last_(rays_) {}

  //! Cells inside, empty if the clicks do not fit.
  Mask from(double radius) {
    centre_ = task_.inside[0].place;
    std::vector<double> before(rays_, radius);
    for (int move = 0;; ++move) {
      const bool isLast = move >= task_.policy.starMoves;
      sample(radius);
      std::transform(before.begin(), before.end(), last_.begin(), [&](double r) { return stepOf(r); });
      for (int round = isLast ? 0 : task_.policy.starRounds / 2; round < task_.policy.starRounds; ++round)
        if (!improve()) break;
      if (isLast) break;
      const Vec3 from = centre_;
      before = recentre();
      if ((centre_ - from).norm() < kConverged * cell_) move = task_.policy.starMoves;
      radius = std::max(quantile(before, 0.5), 2 * cell_);
    }
    const Mask out = cellsInside();
    return fits(out) ? out : Mask{};
  }

 private:
  std::size_t stepOf(double r) const {
    const auto at = std::lower_bound(radii_.begin(), radii_.end(), r) - radii_.begin();
    return std::clamp<std::size_t>(static_cast<std::size_t>(at), 1, kRadii - 1);
  }

  //! Reads the image along the rays.
  void sample(double radius) {
    const double inner = task_.policy.starInner, outer = task_.policy.starOuter;
    double sum = 0;
    area_ = 0;
    for (std::size_t k = 0; k < kRadii; ++k) {
      radii_[k] = radius * inner * std::pow(outer / inner, static_cast<double>(k) / (kRadii - 1));
      sum += weight_[k] = std::pow(radii_[k], 3);
      area_ += radii_[k] * radii_[k] / kRadii;
    }
    for (double& w : weight_) w *= kRadii / sum;
    for (std::size_t d = 0; d < rays_; ++d)
      for (std::size_t k = 0; k < kRadii; ++k) {
        const std::size_t i = d * kRadii + k;
        beyond_[i] = !read(centre_ + radii_[k] * task_.rays.directions[d], intensities_[i]);
      }
    const double low = quantile(intensities_, 0.01), high = quantile(intensities_, 0.99);
    const double step = std::max((high - low) / kBins, 1e-12);
    for (std::size_t i = 0; i < bins_.size(); ++i)
      bins_[i] = std::clamp(static_cast<int>((intensities_[i] - low) / step), 0, kBins - 1);
  }

  //! False beyond the image.
  bool read(const Vec3& world, double& value) const {
    const CellGrid& cells = task_.image.cells;
    value = interpolated(cells.grid, task_.values, cells.grid.toIndex(world));
    return cells.contains(world) && !task_.image.padding[cells.at(cells.nearest(world))];
  }

  //! One round: what both sides look like, then the cheapest surface. False if it is the same.
  bool improve() {
    std::vector<double> in(kBins, 0), out(kBins, 0);
    double meanIn = 0, meanOut = 0, allIn = 0, allOut = 0;
    for (std::size_t d = 0; d < rays_; ++d)
      for (std::size_t k = 0; k < kRadii; ++k) {
        const std::size_t i = d * kRadii + k;
        const double w = weight_[k];
        if (k <= last_[d])
          in[bins_[i]] += w, meanIn += w * intensities_[i], allIn += w;
        else if (radii_[k] <= task_.policy.starShell * radii_[last_[d]] && !beyond_[i])
          out[bins_[i]] += w, meanOut += w * intensities_[i], allOut += w;
      }
    std::vector<double> outward = intensityShares(in), shareOut = intensityShares(out);
    for (std::size_t b = 0; b < outward.size(); ++b) outward[b] = std::log(shareOut[b] / outward[b]);
    const bool isDark = allOut > 0 && meanIn / allIn < meanOut / allOut;
    return take(costs(outward, isDark ? -1 : 1));
  }

  //! How much cheaper a surface gets that takes a place in: what its intensity speaks for, and the edge
  //! there. `outward`: log of the odds against each bin; `sign`: -1 if the object is darker than what is
  //! around it.
  std::vector<double> costs(const std::vector<double>& outward, double sign) const {
    std::vector<double> fall(rays_ * kRadii, 0), sizes;
    for (std::size_t d = 0; d < rays_; ++d)
      for (std::size_t k = 1; k + 1 < kRadii; ++k) {
        const std::size_t i = d * kRadii + k;
        fall[i] = sign * (intensities_[i - 1] - intensities_[i + 1]) / (radii_[k + 1] - radii_[k - 1]);
        sizes.push_back(std::abs(fall[i]));
      }
    const double strong = quantile(std::move(sizes), 0.9) + 1e-12;
    std::vector<double> out(rays_ * kRadii);
    for (std::size_t d = 0; d < rays_; ++d) {
      double before = 0;  // of the surface one step further in
      for (std::size_t k = 0; k < kRadii; ++k) {
        const std::size_t i = d * kRadii + k;
        const double region = beyond_[i] ? task_.policy.starBeyond : outward[bins_[i]];
        const double edge =
            -task_.policy.starEdge * std::clamp(fall[i] / strong, -1.0, 2.0) * radii_[k] * radii_[k] / area_;
        out[i] = region * weight_[k] + edge - before;
        before = edge;
      }
      out[d * kRadii] = -kForced;
    }
    for (const CellClick& c : task_.inside) force(out, c, 1);
    for (const CellClick& c : task_.outside) force(out, c, -1);
    return out;
  }

  //! The rays next to a click end on its far side (`sign` = 1) or on its near side (-1).
  void force(std::vector<double>& costs, const CellClick& click, double sign) const {
    const Vec3 to = click.place - centre_;
    const double distance = to.norm();
    if (distance < 1e-9) return;
    for (const std::size_t d : nearestRays(task_.rays, to / distance).ray)
      for (std::size_t k = 0; k < kRadii; ++k)
        if ((radii_[k] <= distance + sign * task_.policy.starMargin * cell_) == (sign > 0))
          costs[d * kRadii + k] -= sign * kForced;
  }

  //! False if the surface is the same as before.
  bool take(const std::vector<double>& costs) {
    const Mask taken = closure_.cheapest(costs);
    bool changed = false;
    for (std::size_t d = 0; d < rays_; ++d) {
      std::size_t k = 0;
      while (k + 1 < kRadii && taken[d * kRadii + k + 1]) ++k;
      changed = changed || k != last_[d];
      last_[d] = k;
    }
    return changed;
  }

  //! Moves the centre most of the way to the middle; the radii of the surface from there.
  std::vector<double> recentre() {
    const auto& all = task_.rays.directions;
    Vec3 moment(0, 0, 0);
    double volume = 0;
    for (std::size_t d = 0; d < rays_; ++d) {
      const double r = radii_[last_[d]];
      moment += all[d] * std::pow(r, 4) / 4;
      volume += std::pow(r, 3) / 3;
    }
    const Vec3 shift = task_.policy.starMove / volume * moment;
    std::vector<Vec3> directions;
    std::vector<double> distances, out;
    for (std::size_t d = 0; d < rays_; ++d) {
      const Vec3 to = radii_[last_[d]] * all[d] - shift;
      distances.push_back(std::max(to.norm(), 1e-6));
      directions.push_back(to / distances.back());
    }
    for (const Vec3& u : all) {
      const auto nearest =
          std::max_element(directions.begin(), directions.end(),
                           [&](const Vec3& a, const Vec3& b) { return a.dot(u) < b.dot(u); });
      out.push_back(distances[nearest - directions.begin()]);
    }
    centre_ += shift;
    return out;
  }

  Mask cellsInside() const {
    const CellGrid& cells = task_.image.cells;
    Mask out(cells.count(), 0);
    const auto [low, high] = std::minmax_element(last_.begin(), last_.end());
    const double least = radii_[*low], most = radii_[*high];
    std::vector<Shell> shells(Rays::kSquareCount);
    forBox(boxAround(cells, cells.nearest(centre_), most + cells.grid.spacing.maxCoeff()),
           [&](const std::array<int, 3>& c) {
             const std::size_t i = cells.at(c);
             const Vec3 to = cells.grid.toWorld(Vec3(c[0], c[1], c[2])) - centre_;
             const double distance = to.norm();
             if (distance > most || task_.image.padding[i]) return;
             out[i] = distance <= least || isWithin(to / distance, distance, shells);
           });
    return out;
  }
  //! Between which distances the surface lies in a part of the sphere.
  struct Shell {
    double low = -1, high = -1;
  };
  Shell shellOf(std::size_t square) const {
    Shell out{std::numeric_limits<double>::infinity(), 0};
    for (const std::uint16_t d : task_.rays.near(square)) {
      out.low = std::min(out.low, radii_[last_[d]] * (1 - kRounding));
      out.high = std::max(out.high, radii_[last_[d]] * (1 + kRounding));
    }
    return out;
  }
  //! Few places lie where it takes the rays beside them to tell. `shells`: those asked for already.
  bool isWithin(const Vec3& direction, double distance, std::vector<Shell>& shells) const {
    const std::size_t square = Rays::squareOf(direction);
    Shell& shell = shells[square];
    if (shell.high < 0) shell = shellOf(square);
    if (distance < shell.low || distance > shell.high) return distance < shell.low;
    return distance <= radiusTowards(direction);
  }
  double radiusTowards(const Vec3& direction) const {
    const NearestRays near = nearestRays(task_.rays, direction);
    double r = 0;
    for (std::size_t k = 0; k < 3; ++k) r += near.weight[k] * radii_[last_[near.ray[k]]];
    return r;
  }
  bool fits(const Mask& mask) const {
    const CellGrid& cells = task_.image.cells;
    const auto isIn = [&](const CellClick& c) { return mask[cells.at(cells.nearest(c.place))] != 0; };
    return std::all_of(task_.inside.begin(), task_.inside.end(), isIn) &&
           std::none_of(task_.outside.begin(), task_.outside.end(), isIn);
  }

  const StarTask& task_;
  double cell_;  // mm
  std::size_t rays_;
  Closure closure_;
  Vec3 centre_{0, 0, 0};
  std::array<double, kRadii> radii_{}, weight_{};  // mm; share of the volume, times kRadii
  double area_ = 0;                                // mean square of the radii
  std::vector<double> intensities_;                // per ray and radius
  std::vector<int> bins_;
  Mask beyond_;                    // no image there
  std::vector<std::size_t> last_;  // radius of the surface, per ray
};

double likeness(const Mask& a, const Mask& b) {
  std::size_t both = 0, any = 0;
  for (std::size_t i = 0; i < a.size(); ++i) both += a[i] && b[i], any += a[i] || b[i];
  return static_cast<double>(both) / static_cast<double>(std::max<std::size_t>(1, any));
}

//! Radii (mm) of the spheres that are started from.
std::vector<double> startsIn(const Grid& grid, const ObjectPolicy& policy) {
  double widest = 0;
  for (int a = 0; a < 3; ++a) widest = std::max(widest, grid.size[a] * grid.spacing[a]);
  const double most = std::min(policy.largestStart * widest, policy.reach / 3);
  std::vector<double> out;
  for (double r = policy.smallestStart * grid.meanSpacing(); r < most; r *= policy.nextStart)
    out.push_back(r);
  return out;
}

}  // namespace

std::vector<StarRegion> starRegions(const CellImage& image, const std::vector<float>& values,
                                    const std::vector<CellClick>& inside,
                                    const std::vector<CellClick>& outside, const ObjectPolicy& policy,
                                    int threads) {
  const std::vector<double> starts = startsIn(image.cells.grid, policy);
  const std::vector<float> smooth =
      smoothed(image.cells, values, policy.starSmoothing * image.cells.grid.meanSpacing());
  const Rays rays(policy.starRays);
  const StarTask task{image, smooth, inside, outside, policy, rays};
  std::vector<Mask> found(starts.size());
  forEachOnThreads(starts.size(), threads,
                   [&](std::size_t s) { found[s] = StarSearch(task).from(starts[s]); });
  std::vector<StarRegion> out;
  const double share = 1.0 / static_cast<double>(std::max<std::size_t>(1, starts.size()));
  for (Mask& f : found) {
    if (f.empty()) continue;
    const auto same = std::find_if(out.begin(), out.end(), [&](const StarRegion& o) {
      return likeness(o.inside, f) > policy.sameRegion;
    });
    if (same == out.end())
      out.push_back({std::move(f), share});
    else
      same->agreement += share;
  }
  return out;
}

}  // namespace handlebody
