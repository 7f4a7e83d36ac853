#include "core/object/tube_tracking.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/cancellation.h"
#include "core/object/rays.h"
#include "core/volume/intensity_statistics.h"

namespace handlebody {

namespace {

constexpr double kNone = 1e9;       // worth of what cannot be
constexpr double kForced = 1e6;     // cost of an outline on the wrong side of a click
constexpr double kRounding = 1e-9;  // far more than sums of a few edges are rounded by
constexpr double kShift =
    0.6;  // of the radius: an outline's middle lies no further from where it was expected

class TubeTracking {
 public:
  TubeTracking(const WorkImage& work, const std::vector<CellClick>& inside,
               const std::vector<CellClick>& outside, const ObjectPolicy& policy)
      : work_(work), inside_(inside), outside_(outside), policy_(policy) {}

  std::optional<Tube> from(double radius) {
    begin(radius);
    for (int end = 0; end < 2; ++end) {
      track();
      turnRound();
    }
    for (const CellClick& c : inside_) leadTo(c.place);
    if (tube_.length() < policy_.tubeLong * 2 * tube_.usualRadius()) return {};
    for (int round = 0; round < policy_.tubeRounds; ++round) settle();
    return std::move(tube_);
  }

 private:
  std::vector<CrossSection>& sections() { return tube_.sections; }
  const CrossSection& last() const { return tube_.sections.back(); }

  //! Works on at the other end.
  void turnRound() {
    std::reverse(sections().begin(), sections().end());
    for (CrossSection& s : sections()) s = reversed(s);
  }
  //! The same plane seen from the other side: its angles run the other way round.
  static CrossSection reversed(const CrossSection& s) {
    CrossSection out = s;
    out.along = -s.along;
    out.up = -s.up;
    constexpr std::size_t n = CrossSection::kAngles, m = CrossSection::kRadii;
    for (std::size_t a = 0; a < n; ++a) {
      const std::size_t b = (n - a) % n;
      out.expected[b] = s.expected[a];
      out.last[b] = s.last[a];
      std::copy_n(s.values.begin() + static_cast<std::ptrdiff_t>(a * m), m,
                  out.values.begin() + static_cast<std::ptrdiff_t>(b * m));
      std::copy_n(s.beyond.begin() + static_cast<std::ptrdiff_t>(a * m), m,
                  out.beyond.begin() + static_cast<std::ptrdiff_t>(b * m));
    }
    return out;
  }

  //! A click as it lies in a plane.
  struct Seen {
    double ahead, aside;  // mm
    std::size_t angle;    // of the nearest ray
  };
  static Seen seen(const CrossSection& s, const Vec3& place) {
    const Vec3 to = place - s.centre;
    const double x = to.dot(s.right), y = to.dot(s.up);
    const double angle = std::atan2(y, x) / (2 * std::numbers::pi) * CrossSection::kAngles;
    const auto n = static_cast<long>(std::lround(angle)) + static_cast<long>(CrossSection::kAngles);
    return {to.dot(s.along), std::hypot(x, y), static_cast<std::size_t>(n) % CrossSection::kAngles};
  }
  bool isNear(const Seen& c, const CrossSection& s) const {
    return std::abs(c.ahead) < policy_.tubeStep * s.radius;
  }

  //! An outline on the right side of the clicks next to a plane.
  void obeyClicks(const CrossSection& s, CrossSection::Costs& costs) const {
    for (const bool isInside : {true, false})
      for (const CellClick& c : isInside ? inside_ : outside_) {
        const Seen at = seen(s, c.place);
        if (!isNear(at, s)) continue;
        for (std::size_t k = 0; k < CrossSection::kRadii; ++k)
          if ((s.radius * CrossSection::radii()[k] > at.aside) != isInside)
            costs[at.angle * CrossSection::kRadii + k] += kForced;
      }
  }

  CrossSection::Costs costsOf(const CrossSection& s, double keep) const {
    CrossSection::Costs costs = look_.costs(s, keep, policy_);
    obeyClicks(s, costs);
    return costs;
  }

  //! The outline of a plane, read anew and moved to its middle `moves` times. `isRead`: as it lies now, it
  //! has been read.
  CrossSection fitted(CrossSection s, double keep, int moves, bool resize, bool isRead = false) const {
    for (int move = 0;; ++move) {
      if (move > 0 || !isRead) s.read(work_);
      s.takeOutline(costsOf(s, keep));
      if (move == moves) break;
      const Vec3 middle = s.middle();
      if (resize) s.radius = s.meanRadius();
      s.centre = middle;
    }
    s.edge = look_.edgeOf(s);
    return s;
  }

  //! The direction in which planes before and behind look like the one at the click.
  void begin(double radius) {
    std::vector<CrossSection> first;
    for (const Vec3& d : directionsOverSphere(policy_.tubeDirections))
      if (isHalf(d)) first.push_back(CrossSection::across(inside_[0].place, d, radius, Vec3(1, 0, 0)));
    for (CrossSection& s : first) {
      s.read(work_);
      s.takeCircle();
    }
    look_ = TubeLook(first, policy_);
    double best = -kNone;
    CrossSection chosen;
    for (const CrossSection& s : first) {
      giveUpIfCancelled();
      const CrossSection middle = fitted(s, policy_.tubeStart, 2, true, true);
      const double worth = worthOf(middle, best);
      if (worth > best) best = worth, chosen = middle;
    }
    sections() = {chosen};
    learn();
    sections() = {fitted(chosen, policy_.tubeKeep, 1, true)};
  }
  //! One of each two opposite directions.
  static bool isHalf(const Vec3& d) {
    return d.z() > 1e-9 || (d.z() > -1e-9 && (d.y() > 1e-9 || (d.y() > -1e-9 && d.x() > 0)));
  }
  //! No more than `least` if it is known to be no more than that: an edge is 1 at most.
  double worthOf(const CrossSection& middle, double least) const {
    double worth = middle.edge;
    const double r = middle.meanRadius();
    int left = 4;
    for (const double side : {-2.0, -1.0, 1.0, 2.0}) {
      if (worth + left-- + kRounding <= least) return worth;
      const Vec3 centre = middle.centre + side * r * middle.along;
      const CrossSection s =
          fitted(CrossSection::across(centre, middle.along, r, middle.right), policy_.tubeStart, 1, false);
      const double shift = (s.centre - centre).norm() / r;
      worth += s.edge - std::abs(std::log(s.meanRadius() / r)) - shift / 2;
    }
    return worth;
  }

  //! What the tube so far looks like.
  void learn() { look_ = TubeLook(sections(), policy_); }

  double usualEdge() const {
    std::vector<double> edges;
    for (const CrossSection& s : tube_.sections) edges.push_back(s.edge);
    return quantile(std::move(edges), 0.5);
  }

  //! A plane that is expected to look like the last few.
  CrossSection following(const Vec3& centre, const Vec3& along) const {
    CrossSection s = CrossSection::across(centre, along, 1, last().right);
    const std::size_t n = tube_.sections.size();
    expectUsual(s, tube_.sections, n - std::min(n, policy_.tubeAround + 1), n - 1);
    const double usual = 0.5 * (s.radius + tube_.usualRadius());
    for (double& e : s.expected) e = std::clamp(e + std::log(s.radius / usual), -1.0, 0.5);
    s.radius = usual;
    return s;
  }

  //! On from the last plane until there is no tube for a while.
  void track() {
    Vec3 along = last().along, centre = last().centre;
    int missed = 0;
    while (sections().size() < policy_.tubeSections) {
      giveUpIfCancelled();
      CrossSection expected = following(centre, along);
      const Vec3 ahead = centre + policy_.tubeStep * expected.radius * along;
      expected.centre = ahead;
      if (!work_.cells().contains(ahead)) return tube_.goesOn.push_back(ahead);
      if (isEnded(expected)) return;
      const CrossSection next = fitted(expected, policy_.tubeKeep, 1, false);
      if (!continues(next, ahead)) {
        if (++missed > policy_.tubeMissed) return;
        centre = ahead;
        continue;
      }
      missed = 0;
      const Vec3& before = sections()[sections().size() - std::min<std::size_t>(sections().size(), 2)].centre;
      const Vec3 way = (next.centre - before).normalized();
      along = ((1 - policy_.tubeTurn) * along + policy_.tubeTurn * way).normalized();
      add(next.centre, along);
      centre = next.centre;
    }
  }
  void add(const Vec3& centre, const Vec3& along) {
    sections().push_back(fitted(following(centre, along), policy_.tubeKeep, 0, false));
    if (sections().size() % 4 == 0) learn();
  }

  //! Where the image shows no tube, but there is one.
  CrossSection asExpected(CrossSection s) const {
    s.read(work_);
    CrossSection::Costs costs{};
    for (std::size_t a = 0; a < CrossSection::kAngles; ++a)
      for (std::size_t k = 0; k < CrossSection::kRadii; ++k)
        costs[a * CrossSection::kRadii + k] = std::abs(std::log(CrossSection::radii()[k]) - s.expected[a]);
    obeyClicks(s, costs);
    s.takeOutline(costs);
    s.edge = look_.edgeOf(s);
    return s;
  }

  //! A click outside lies in the middle of it or of the one after it, before it has bent an outline.
  bool isEnded(const CrossSection& s) const {
    return std::any_of(outside_.begin(), outside_.end(), [&](const CellClick& c) {
      const Seen at = seen(s, c.place);
      const double step = policy_.tubeStep * s.radius;
      return at.ahead > -step && at.ahead < 2 * step && at.aside < s.radius * 2 / 3;
    });
  }
  bool continues(const CrossSection& next, const Vec3& ahead) const {
    const double r = next.radius, now = next.meanRadius(), usual = tube_.usualRadius();
    if (std::abs(std::log(now / r)) > std::log(policy_.tubeGrowth)) return false;
    if (now > 2 * usual || usual > 2 * now) return false;
    if ((next.centre - ahead).norm() > kShift * r) return false;
    if (next.edge < policy_.tubeWeak * usualEdge()) return false;
    const auto& all = tube_.sections;  // not back into itself
    return std::none_of(all.begin(), all.end() - std::min<std::ptrdiff_t>(4, std::ssize(all)),
                        [&](const CrossSection& s) { return (s.centre - next.centre).norm() < r; });
  }

  //! To a click that lies past one of the ends, and on from there.
  void leadTo(const Vec3& place) {
    const auto distance = [&](const CrossSection& s) { return (place - s.centre).norm(); };
    if (distance(sections().front()) < distance(sections().back())) turnRound();
    const Vec3 gap = place - last().centre;
    if (gap.dot(last().along) <= 0 || isWithin(place)) return;
    const double step = policy_.tubeStep * tube_.usualRadius();
    const int steps = static_cast<int>(std::ceil(gap.norm() / step));
    if (steps > static_cast<int>(policy_.tubeSections)) return;
    for (int n = steps; n > 0; --n) {
      giveUpIfCancelled();
      const Vec3 to = place - last().centre, ahead = last().centre + to / n, along = to.normalized();
      const CrossSection expected = following(ahead, along);
      const CrossSection next = fitted(expected, policy_.tubeKeep, 1, false);
      if (continues(next, ahead))
        add(next.centre, along);
      else
        sections().push_back(asExpected(expected));
    }
    learn();
    track();
  }
  //! Between two planes and next to their outlines: these give way to it.
  bool isWithin(const Vec3& place) const {
    return std::any_of(tube_.sections.begin(), tube_.sections.end(), [&](const CrossSection& s) {
      const Seen at = seen(s, place);
      return isNear(at, s) && at.aside < s.radius * CrossSection::radii().back();
    });
  }

  //! All outlines anew, each near to what is usual around it: where the wall is open, those before and behind
  //! carry it across.
  void settle() {
    learn();
    const std::vector<CrossSection> before = sections();
    std::vector<CrossSection::Costs> costs;
    for (std::size_t i = 0; i < before.size(); ++i) {
      giveUpIfCancelled();
      CrossSection& s = sections()[i];
      expectUsual(s, before, i - std::min(i, policy_.tubeAround),
                  std::min(i + policy_.tubeAround, before.size() - 1));
      s.read(work_);
      costs.push_back(costsOf(s, policy_.tubeSmooth));
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
      CrossSection::Costs sum = costs[i];
      for (const std::size_t j : {i - 1, i + 1})
        if (j < costs.size())
          for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += 0.5 * costs[j][n];
      sections()[i].takeOutline(sum);
    }
  }
  //! The median of planes.
  static void expectUsual(CrossSection& s, const std::vector<CrossSection>& tube, std::size_t first,
                          std::size_t end) {
    const auto median = [&](auto&& f) {
      std::vector<double> all;
      for (std::size_t j = first; j <= end; ++j) all.push_back(f(tube[j]));
      return quantile(std::move(all), 0.5);
    };
    s.radius = median([](const CrossSection& o) { return o.meanRadius(); });
    for (std::size_t a = 0; a < CrossSection::kAngles; ++a)
      s.expected[a] = median([&](const CrossSection& o) { return std::log(o.radiusAt(a) / s.radius); });
  }

  const WorkImage& work_;
  const std::vector<CellClick>&inside_, &outside_;
  const ObjectPolicy& policy_;
  TubeLook look_;
  Tube tube_;
};

}  // namespace

double Tube::length() const {
  double sum = 0;
  for (std::size_t i = 1; i < sections.size(); ++i)
    sum += (sections[i].centre - sections[i - 1].centre).norm();
  return sum;
}

double Tube::usualRadius() const {
  std::vector<double> all;
  for (const CrossSection& s : sections) all.push_back(s.meanRadius());
  return quantile(std::move(all), 0.5);
}

std::optional<Tube> trackTube(const WorkImage& work, const std::vector<CellClick>& inside,
                              const std::vector<CellClick>& outside, double radius,
                              const ObjectPolicy& policy) {
  return TubeTracking(work, inside, outside, policy).from(radius);
}

}  // namespace handlebody
