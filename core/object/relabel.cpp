#include "core/object/relabel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/cancellation.h"
#include "core/indices.h"
#include "core/object/distance.h"
#include "core/volume/intensity_statistics.h"
#include "core/volume/voxel_walk.h"

namespace handlebody {

namespace {

using Cell = std::array<int, 3>;
constexpr int kBins = 48;           // of the intensities, at either scale
constexpr double kWideScale = 1.5;  // cells: Gaussian of the second scale
constexpr double kEmpty = 1e-4;     // share of a bin in which nothing is
constexpr float kMinPull = 1e-3f;   // across the strongest edge
constexpr int kSweeps = 60;         // of successive over-relaxation at most; a zone is some ten cells thick
constexpr std::size_t kConverged = 20'000;  // one open cell of so many still changes its side
constexpr float kOverRelaxation = 1.6f;

std::size_t bin(int i, int j) { return idx(i) * idx(kBins) + idx(j); }

//! How common pairs of intensities are: at the cell, and around it.
class Density {
 public:
  void add(int i, int j) { h_[bin(i, j)] += 1; }
  //! `part` of what is left is the other's.
  void mix(const Density& other, double part) {
    const double a = total(), b = other.total();
    if (b <= 0) return;
    for (std::size_t i = 0; i < h_.size(); ++i)
      h_[i] = (1 - part) * h_[i] / std::max(a, 1e-9) + part * other.h_[i] / b;
  }
  //! Gaussian, standard deviation in bins; sums to 1 then.
  void smooth(double sigma) {
    const int reach = static_cast<int>(std::ceil(3 * sigma));
    for (const bool along : {false, true}) {
      std::vector<double> out(h_.size(), 0);
      for (int i = 0; i < kBins; ++i)
        for (int j = 0; j < kBins; ++j)
          for (int k = -reach; k <= reach; ++k) {
            const int a = std::clamp(along ? i : i + k, 0, kBins - 1),
                      b = std::clamp(along ? j + k : j, 0, kBins - 1);
            out[bin(i, j)] += std::exp(-0.5 * k * k / (sigma * sigma)) * h_[bin(a, b)];
          }
      h_.swap(out);
    }
    const double all = std::max(total(), 1e-9);
    for (double& x : h_) x /= all;
  }
  double at(int i, int j) const { return h_[bin(i, j)]; }

 private:
  double total() const {
    double sum = 0;
    for (const double x : h_) sum += x;
    return sum;
  }
  std::vector<double> h_ = std::vector<double>(idx(kBins) * idx(kBins), 0);
};

enum class Kind : std::uint8_t { outside, inside, open };

//! Which cells are open, and what they go by.
struct Walk {
  double outer = 0, inner = 0;              //!< mm: outside and inside so near to the surface
  double prior = 0;                         //!< pull of the cell's intensities against that of a neighbour
  double noise = 0;                         //!< standard deviation, intensities
  double shape = 0;                         //!< per mm: log of the odds that a place within the surface has
  const Relabelling* correction = nullptr;  //!< none: all around, by the image alone
};

class RandomWalk {
 public:
  RandomWalk(const WorkImage& work, const Region& region, const Walk& walk, const ObjectPolicy& policy)
      : cells_(work.cells()),
        walk_(walk),
        click_(walk.correction),
        policy_(policy),
        cell_(cells_.grid.meanSpacing()),
        box_(boxFor(region)),
        size_(box_.size()),
        inside_(cutOut(cells_, region.inside, box_)),
        padding_(cutOut(cells_, work.image.padding, box_)) {
    values_.reserve(inside_.size());
    forBox(box_, [&](const Cell& c) { values_.push_back(work.values[cells_.at(c)]); });
  }

  Region run(Region region) {
    measure();
    setKinds();
    setPrior();
    walk();
    std::size_t l = 0;
    forBox(box_, [&](const Cell& c) {
      if (isReached(l)) region.inside[cells_.at(c)] = kind_[l] == Kind::inside;
      ++l;
    });
    return region;
  }

 private:
  //! The region and what may join it, and as much again to tell it from.
  CellBox boxFor(const Region& region) const {
    CellBox box = boxOf(cells_, region);
    if (click_) box.widen(cells_.cellOf(click_->click.cell));
    for (std::size_t a = 0; a < 3; ++a) {
      const double h = cells_.grid.spacing[static_cast<Eigen::Index>(a)];
      const int more = static_cast<int>(std::ceil(background() / h));
      box.low[a] = std::max(0, box.low[a] - more);
      box.high[a] = std::min(cells_.grid.size[a] - 1, box.high[a] + more);
    }
    if (!click_) return box;
    const CellBox near = boxAround(cells_, cells_.cellOf(click_->click.cell), click_->reach + 3 * cell_);
    for (std::size_t a = 0; a < 3; ++a) {
      box.low[a] = std::max(box.low[a], near.low[a]);
      box.high[a] = std::min(box.high[a], near.high[a]);
    }
    return box;
  }
  //! mm from the surface up to where the intensities outside are read.
  double background() const { return 2 * walk_.outer + 2 * cell_; }
  bool isReached(std::size_t i) const { return !click_ || fromClick_[i] <= click_->reach; }
  void measure() {
    std::vector<std::uint8_t> outside(inside_.size());
    std::transform(inside_.begin(), inside_.end(), outside.begin(), [](std::uint8_t in) { return !in; });
    out_ = distanceTo(size_, cells_.grid.spacing, inside_, background());
    in_ = distanceTo(size_, cells_.grid.spacing, outside, std::max(walk_.inner, cell_));
    if (!click_) return;
    const Cell click = cells_.cellOf(click_->click.cell);
    forBox(box_, [&](const Cell& c) {
      const Vec3 from(c[0] - click[0], c[1] - click[1], c[2] - click[2]);
      fromClick_.push_back(static_cast<float>(from.cwiseProduct(cells_.grid.spacing).norm()));
    });
  }

  void setKinds() {
    kind_.resize(inside_.size());
    for (std::size_t i = 0; i < kind_.size(); ++i) {
      kind_[i] = inside_[i] ? Kind::inside : Kind::outside;
      if (!isReached(i) || padding_[i]) continue;
      // Just inside of the surface cells are open, too: the surface may have been ragged.
      if (inside_[i] ? in_[i] <= walk_.inner : out_[i] <= walk_.outer) kind_[i] = Kind::open;
    }
    if (!click_) return;
    setBall(click_->click, policy_.relabelBall * click_->depth,
            click_->isInside ? Kind::inside : Kind::outside);
    for (const CellClick& c : click_->outside) setBall(c, std::max(c.radius, 1.01 * cell_), Kind::outside);
    for (const CellClick& c : click_->inside) setBall(c, std::max(c.radius, 1.01 * cell_), Kind::inside);
  }
  void setBall(const CellClick& click, double radius, Kind kind) {
    const Cell at = cells_.nearest(click.place);
    forBox(boxAround(cells_, at, radius), [&](const Cell& c) {
      if (!box_.holds(c)) return;
      const Vec3 from(c[0] - at[0], c[1] - at[1], c[2] - at[2]);
      if (from.cwiseProduct(cells_.grid.spacing).norm() <= radius) kind_[box_.at(c)] = kind;
    });
  }

  //! mm from a cell's middle to the surface: negative outside.
  double within(std::size_t i) const {
    return inside_[i] ? static_cast<double>(in_[i]) - 0.5 * cell_
                      : 0.5 * cell_ - static_cast<double>(out_[i]);
  }

  //! What each cell's intensities and place say by themselves.
  void setPrior() {
    CellGrid part = cells_;
    part.grid.size = size_;
    const std::vector<float> wide = smoothed(part, values_, kWideScale * cell_);
    const double low = quantile(values_, 0.01),
                 step = std::max((quantile(values_, 0.99) - low) / (kBins - 1), 1e-12);
    const auto binOf = [&](float v) { return std::clamp(static_cast<int>((v - low) / step), 0, kBins - 1); };
    const auto add = [&](Density& to, std::size_t i) { to.add(binOf(values_[i]), binOf(wide[i])); };
    Density in, near, out;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (inside_[i] && in_[i] > 0.5 * cell_) add(in, i);
      if (click_ && fromClick_[i] <= policy_.relabelBall * click_->depth + 0.5 * cell_) add(near, i);
      if (!inside_[i] && out_[i] > walk_.outer && out_[i] <= background()) add(out, i);
    }
    (click_ && !click_->isInside ? out : in).mix(near, policy_.relabelClick);
    const double sigma = std::max(1.0, 0.7 * walk_.noise / step);  // the search's Gaussian leaves so much
    in.smooth(sigma);
    out.smooth(sigma);
    std::vector<double> ofPair(idx(kBins) * idx(kBins));
    for (int a = 0; a < kBins; ++a)
      for (int b = 0; b < kBins; ++b) {
        const double odds = std::log((in.at(a, b) + kEmpty) / (out.at(a, b) + kEmpty));
        const double sure = policy_.relabelSure;
        ofPair[bin(a, b)] = std::clamp(odds, -sure, sure);
      }
    prior_.resize(values_.size());
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (kind_[i] == Kind::open) {
        const double odds = ofPair[bin(binOf(values_[i]), binOf(wide[i]))] + walk_.shape * within(i);
        prior_[i] = static_cast<float>(1 / (1 + std::exp(-odds)));
      }
  }

  float pull(std::size_t i, std::size_t j, std::size_t axis) const {
    const double jump = (values_[i] - values_[j]) / (policy_.relabelEdge * walk_.noise);
    const double h = cell_ / cells_.grid.spacing[static_cast<Eigen::Index>(axis)];
    return static_cast<float>(h * h) * (static_cast<float>(1 / (1 + jump * jump)) + kMinPull);
  }

  //! An open cell: its neighbours below and above along each axis, by their numbers in the order of the
  //! sweeps, and how strongly they pull.
  struct Open {
    std::array<std::uint32_t, 6> at;
    std::array<float, 6> pulls;
    float prior, all;
  };
  static constexpr std::uint32_t kOut = 0, kIn = 1, kFirstOpen = 2;

  //! The numbers of the open cells, and in their order the cells. A sweep takes each cell after its
  //! neighbours below and before those above. That is so row by row, where each cell waits for the one before
  //! it, and as well from one diagonal plane (x + y + z) to the next, where the cells of a plane do not
  //! touch.
  std::vector<std::uint32_t> inPlanes(std::vector<std::uint32_t>& number) const {
    std::vector<std::uint32_t> from(idx(size_[0] + size_[1] + size_[2]), 0), order;
    const auto forOpen = [&](auto&& f) {
      std::size_t i = 0;
      for (int z = 0; z < size_[2]; ++z)
        for (int y = 0; y < size_[1]; ++y)
          for (int x = 0; x < size_[0]; ++x, ++i)
            if (kind_[i] == Kind::open) f(i, idx(x + y + z));
    };
    forOpen([&](std::size_t, std::size_t plane) { ++from[plane + 1]; });
    std::partial_sum(from.begin(), from.end(), from.begin());
    order.resize(from.back());
    forOpen([&](std::size_t i, std::size_t plane) {
      order[from[plane]] = static_cast<std::uint32_t>(i);
      number[i] = kFirstOpen + from[plane]++;
    });
    return order;
  }

  //! Open cells become inside or outside.
  void walk() {
    std::vector<std::uint32_t> number(kind_.size());
    for (std::size_t i = 0; i < kind_.size(); ++i) number[i] = kind_[i] == Kind::inside ? kIn : kOut;
    const std::vector<std::uint32_t> order = inPlanes(number);
    const auto weight = static_cast<float>(walk_.prior);
    std::vector<Open> open;
    open.reserve(order.size());
    std::vector<float> u{0.f, 1.f};  // chance to be inside
    u.reserve(kFirstOpen + order.size());
    for (const std::uint32_t i : order) {
      Open o{{}, {}, weight * prior_[i], weight};
      forFaceNeighbours(size_, i, [&](std::size_t j, std::size_t a) {
        const std::size_t side = 2 * a + (j > i ? 1 : 0);
        o.at[side] = number[j];
        const bool isKnown = j < i && number[j] >= kFirstOpen;  // its neighbours' pull is the same back
        o.all += o.pulls[side] = isKnown ? open[number[j] - kFirstOpen].pulls[side + 1] : pull(i, j, a);
      });
      open.push_back(o);
      u.push_back(prior_[i]);
    }
    relax(open, u);
    for (std::size_t k = 0; k < order.size(); ++k)
      kind_[order[k]] = u[kFirstOpen + k] > 0.5f ? Kind::inside : Kind::outside;
  }
  //! Where there is no neighbour nothing pulls, and what it would pull to is 0.
  static void relax(const std::vector<Open>& open, std::vector<float>& u) {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      giveUpIfCancelled();
      std::size_t flips = 0;
      float* own = u.data() + kFirstOpen;
      for (const Open& o : open) {
        float sum = o.prior;
        for (std::size_t side = 0; side < 6; ++side) sum += o.pulls[side] * u[o.at[side]];
        const float before = *own, after = before + kOverRelaxation * (sum / o.all - before);
        *own++ = after;
        flips += (before > 0.5f) != (after > 0.5f);
      }
      if (flips * kConverged <= open.size()) return;
    }
  }

  const CellGrid& cells_;
  const Walk& walk_;
  const Relabelling* click_;
  const ObjectPolicy& policy_;
  double cell_;  // mm
  CellBox box_;
  std::array<int, 3> size_;
  std::vector<std::uint8_t> inside_, padding_;
  std::vector<float> values_, out_, in_, fromClick_;  // distances in mm
  std::vector<Kind> kind_;
  std::vector<float> prior_;  // of the open cells: the chance to be inside by their own intensities
};

}  // namespace

Region relabelled(const WorkImage& work, const Region& region, const Relabelling& r,
                  const ObjectPolicy& policy) {
  const double cell = work.cells().grid.meanSpacing();
  const Walk walk{policy.relabelZone * r.depth + cell, cell, policy.relabelPrior, r.noise, 0, &r};
  return RandomWalk(work, region, walk, policy).run(region);
}

Region settled(const WorkImage& work, const Region& region, const Relabelling& r,
               const ObjectPolicy& policy) {
  const double zone = policy.settled * r.depth + work.cells().grid.meanSpacing();
  const Walk walk{zone, zone, policy.relabelPrior, r.noise, policy.settledShape / r.depth, &r};
  return RandomWalk(work, region, walk, policy).run(region);
}

Region refined(const WorkImage& work, const Region& region, double noise, const ObjectPolicy& policy) {
  if (region.count() == 0) return region;
  const double cell = work.cells().grid.meanSpacing();
  const Walk walk{
      policy.refineOuter * cell, policy.refineInner * cell, policy.relabelPrior, noise, 0, nullptr};
  return RandomWalk(work, region, walk, policy).run(region);
}

}  // namespace handlebody
