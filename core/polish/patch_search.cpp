#include "core/polish/patch_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "core/cancellation.h"
#include "core/geometry/closest_points.h"
#include "core/geometry/triangle_distance.h"

namespace handlebody {

namespace {

constexpr std::size_t kMaxTrials = 40;
constexpr int kSweeps = 2;
constexpr int kDirections = 8;
constexpr int kMaxSteps = 24;
constexpr double kFirstStep = 0.3, kLastStep = 0.015;  // of the mean edge at a point
constexpr double kOffSurface = 0.5;                    // of the distance allowed: a step along the normal
//! Of the distance allowed: where points may go. First as far as seems safe; less where that was too far.
constexpr std::array<double, 2> kReaches{0.85, 0.5};

struct Star {
  Vec3 normal = Vec3::Zero();
  double edge = 0;  // mean
};

Star starOf(const PolishPatch& patch, int v) {
  Star star;
  int n = 0;
  for (const Triangle& t : patch.faces)
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] != v) continue;
      const Vec3& p = patch.points[v];
      const Vec3 u = patch.points[t[(i + 1) % 3]] - p, w = patch.points[t[(i + 2) % 3]] - p;
      star.normal += u.cross(w);
      star.edge += u.norm();
      ++n;
    }
  if (n > 0) star.edge /= n;
  star.normal.stableNormalize();
  return star;
}

//! At right angles to a unit vector.
Vec3 across(const Vec3& n) {
  int least = 0;
  for (int a = 1; a < 3; ++a)
    if (std::abs(n[a]) < std::abs(n[least])) least = a;
  return n.cross(Vec3::Unit(least)).stableNormalized();
}

}  // namespace

//! By way of a volatile: GCC 12 takes a vectorised conversion to float and back for nothing at all.
Vec3 inSingle(const Vec3& p) {
  Vec3 out;
  for (int a = 0; a < 3; ++a) {
    const volatile float single = static_cast<float>(p[a]);
    out[a] = static_cast<double>(single);
  }
  return out;
}

namespace {

std::array<Vec3, 4> samplesOf(const Corners& c) {
  return {(c[0] + c[1]) / 2, (c[1] + c[2]) / 2, (c[2] + c[0]) / 2, (c[0] + c[1] + c[2]) / 3};
}

Corners cornersOf(const PolishPatch& patch, const Triangle& t) {
  return {patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]};
}

bool isOutside(const Vec3& p, const Corners& c, double distance) {
  for (int a = 0; a < 3; ++a)
    if (std::min({c[0][a], c[1][a], c[2][a]}) - distance > p[a] ||
        std::max({c[0][a], c[1][a], c[2][a]}) + distance < p[a])
      return true;
  return false;
}

bool isNearFaces(const Vec3& p, const PolishPatch& patch, double distance) {
  return std::any_of(patch.faces.begin(), patch.faces.end(), [&](const Triangle& t) {
    const Corners c = cornersOf(patch, t);
    return !isOutside(p, c, distance) && squaredDistance(p, c[0], c[1], c[2]) <= distance * distance;
  });
}

}  // namespace

PatchSearch::PatchSearch(const WantedShape& wanted, const PolishPatch& patch,
                         std::span<const Corners> surface, double distance, std::size_t mostWork)
    : wanted_(wanted), surface_(surface), distance_(distance), mostWork_(mostWork) {
  for (const Corners& c : surface) {
    const auto samples = samplesOf(c);
    covered_.insert(covered_.end(), c.begin(), c.end());
    covered_.insert(covered_.end(), samples.begin(), samples.end());
    const Vec3& centre = samples.back();
    balls_.push_back(
        {centre, std::max({(c[0] - centre).norm(), (c[1] - centre).norm(), (c[2] - centre).norm()})});
  }
  const auto tuple = [](const Vec3& p) { return std::tuple(p.x(), p.y(), p.z()); };
  std::sort(covered_.begin(), covered_.end(),
            [&](const Vec3& a, const Vec3& b) { return tuple(a) < tuple(b); });
  covered_.erase(std::unique(covered_.begin(), covered_.end()), covered_.end());
  std::erase_if(covered_, [&](const Vec3& p) { return !isNearFaces(p, patch, distance); });
}

bool PatchSearch::isFaceNear(const Corners& face) const {
  const auto samples = samplesOf(face);
  return std::all_of(samples.begin(), samples.end(),
                     [&](const Vec3& p) { return distanceFromSurface(p) <= reach_; });
}

//! What lies at v and at most so far from it.
bool PatchSearch::staysNear(const PolishPatch& patch, int v, double radius) const {
  for (const Triangle& t : patch.faces)
    if ((t[0] == v || t[1] == v || t[2] == v) && !isFaceNear(cornersOf(patch, t))) return false;
  return std::all_of(covered_.begin(), covered_.end(), [&](const Vec3& p) {
    return (p - patch.points[v]).norm() > radius || isNearFaces(p, patch, reach_);
  });
}

bool PatchSearch::isNear(const PolishPatch& patch) const {
  return std::all_of(patch.faces.begin(), patch.faces.end(),
                     [&](const Triangle& t) { return isFaceNear(cornersOf(patch, t)); }) &&
         std::all_of(covered_.begin(), covered_.end(),
                     [&](const Vec3& p) { return isNearFaces(p, patch, reach_); });
}

void PatchSearch::keepBest(std::vector<Attempt>& attempts) {
  std::stable_sort(attempts.begin(), attempts.end(), [](const Attempt& x, const Attempt& y) {
    return x.isNear != y.isNear ? x.isNear : x.badness.sum < y.badness.sum;
  });
  if (attempts.size() > kWidth) attempts.erase(attempts.begin() + kWidth, attempts.end());
}

Vec3 PatchSearch::onSurface(const Vec3& p) const {
  // No farther than the nearest centre, by more than rounding: most triangles need no look.
  double atMost = std::numeric_limits<double>::infinity();
  for (const Ball& ball : balls_) atMost = std::min(atMost, (ball.centre - p).squaredNorm());
  atMost = (1 + 1e-9) * std::sqrt(atMost);
  double least = std::numeric_limits<double>::infinity();
  Vec3 nearest = p;
  for (std::size_t i = 0; i < surface_.size(); ++i) {
    const double reach = std::min(least, atMost) + balls_[i].radius;
    if ((balls_[i].centre - p).squaredNorm() > reach * reach) continue;
    const Vec3 q = closestPoint(p, surface_[i]);
    if (const double d = (q - p).norm(); d < least) {
      least = d;
      nearest = q;
    }
  }
  return nearest;
}

double PatchSearch::distanceFromSurface(const Vec3& p) const { return (onSurface(p) - p).norm(); }

void PatchSearch::add(PolishPatch patch, std::vector<int> touched, std::vector<Trial>& trials) {
  work_ += patch.faces.size();
  const double sum = patch.badness(wanted_).sum;
  trials.push_back({std::move(patch), std::move(touched), sum});
}

void PatchSearch::addTurns(const PolishPatch& patch, int a, int b, std::vector<Trial>& trials) {
  if (a > b) return;
  PolishPatch turned = patch;
  const int c = patch.apex(a, b), d = patch.apex(b, a);
  if (turned.flip(a, b)) add(std::move(turned), {a, b, c, d}, trials);
}

void PatchSearch::addCollapses(const PolishPatch& patch, int a, int b, std::vector<Trial>& trials) {
  std::vector<int> touched = patch.neighbours(a);
  PolishPatch at = patch;
  if (!at.collapse(a, b, patch.points[b])) return;
  add(std::move(at), touched, trials);
  PolishPatch between = patch;
  const Vec3 middle = inSingle(onSurface((patch.points[a] + patch.points[b]) / 2));
  if (a < b && between.collapse(a, b, middle)) add(std::move(between), touched, trials);
}

void PatchSearch::addSplits(const PolishPatch& patch, int a, int b, std::vector<Trial>& trials) {
  if (a > b) return;
  PolishPatch divided = patch;
  const int c = patch.apex(a, b), d = patch.apex(b, a);
  const Vec3 middle = inSingle(onSurface((patch.points[a] + patch.points[b]) / 2));
  const int m = divided.split(a, b, middle);
  if (m >= 0) add(std::move(divided), {m, a, b, c, d}, trials);
}

//! The likeliest first, but for the patch as it is before all others.
std::vector<PatchSearch::Trial> PatchSearch::trialsAt(const PolishPatch& patch,
                                                      const std::vector<int>& place) {
  std::vector<Trial> trials;
  add(patch, place, trials);
  for (const int a : place)
    for (const int b : patch.neighbours(a)) {
      const bool isWithin = std::find(place.begin(), place.end(), b) != place.end();
      addTurns(patch, isWithin ? std::min(a, b) : a, isWithin ? std::max(a, b) : b, trials);
      addCollapses(patch, a, b, trials);
      if (!isWithin) addCollapses(patch, b, a, trials);
      if (isWithin) addSplits(patch, a, b, trials);
    }
  std::stable_sort(trials.begin() + 1, trials.end(),
                   [](const Trial& x, const Trial& y) { return x.sum < y.sum; });
  if (trials.size() > kMaxTrials) trials.erase(trials.begin() + kMaxTrials, trials.end());
  return trials;
}

bool PatchSearch::tryChanges(const PolishPatch& patch, const std::vector<int>& place, const Take& take,
                             std::vector<Attempt>& attempts) {
  const std::vector<Trial> trials = trialsAt(patch, place);
  for (const double reach : kReaches)
    for (const Trial& trial : trials) {
      giveUpIfCancelled();
      if (isSpent()) return false;
      Attempt attempt = relaxed(trial, reach);
      if (attempt.isNear && attempt.badness.sum == 0 && take(attempt)) return true;
      attempts.push_back(std::move(attempt));
    }
  return false;
}

Attempt PatchSearch::relaxed(Trial trial, double reach) {
  reach_ = reach * distance_;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (const int v : trial.touched)
      if (trial.patch.isFree[v] && trial.patch.isUsed(v)) move(trial.patch, v);
  const Badness badness = trial.patch.badness(wanted_);
  const bool isGood = isNear(trial.patch);
  return {std::move(trial.patch), badness, isGood};
}

void PatchSearch::move(PolishPatch& patch, int v) {
  const std::vector<PolishPatch::Shape> shapes = patch.shapesAt(v);
  Badness now = patch.badnessOf(shapes, wanted_);
  double step = kFirstStep;
  for (int i = 0; i < kMaxSteps && now.sum > 0 && step > kLastStep; ++i)
    if (!moveByStep(patch, v, shapes, step, now)) step /= 2;
}

//! Where a point may go with a step: along the surface in all directions and along its edges (which may lie
//! on a ridge), and off it.
std::vector<Vec3> PatchSearch::places(const PolishPatch& patch, int v, double step) const {
  const Star star = starOf(patch, v);
  const Vec3 from = patch.points[v], u = across(star.normal), w = star.normal.cross(u);
  std::vector<Vec3> all;
  for (int i = 0; i < kDirections; ++i) {
    const double turn = 2 * std::numbers::pi * i / kDirections;
    all.push_back(onSurface(from + step * star.edge * (std::cos(turn) * u + std::sin(turn) * w)));
  }
  for (const int n : patch.neighbours(v)) all.push_back(onSurface(from + step * (patch.points[n] - from)));
  const double off = std::min(step * star.edge, kOffSurface * reach_);
  for (const double way : {off, -off})
    if (const Vec3 to = from + way * star.normal; distanceFromSurface(to) <= reach_) all.push_back(to);
  for (Vec3& p : all) p = inSingle(p);
  return all;
}

//! To the best of some places at that distance, if it is better than where it is.
bool PatchSearch::moveByStep(PolishPatch& patch, int v, std::span<const PolishPatch::Shape> shapes,
                             double step, Badness& now) {
  const Vec3 from = patch.points[v];
  double radius = 0;
  for (const int n : patch.neighbours(v)) radius = std::max(radius, (patch.points[n] - from).norm());
  const bool wasNear = staysNear(patch, v, 1.5 * radius);
  Vec3 best = from;
  Badness least = now;
  for (const Vec3& to : places(patch, v, step)) {
    patch.points[v] = to;
    const Badness there = patch.badnessOf(shapes, wanted_);
    ++work_;
    if (!there.isBetterThan(least) || (wasNear && !staysNear(patch, v, 1.5 * radius))) continue;
    least = there;
    best = to;
  }
  patch.points[v] = best;
  now = least;
  return best != from;
}

std::vector<int> PatchSearch::worstPlace(const PolishPatch& patch) const {
  std::vector<int> place;
  double worst = 1;
  const auto p = [&](int v) -> const Vec3& { return patch.points[v]; };
  for (const Triangle& t : patch.faces) {
    if (const double part = wanted_.ofFace(p(t[0]), p(t[1]), p(t[2])); part < worst) {
      worst = part;
      place.assign(t.begin(), t.end());
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3], d = patch.apex(b, a);
      if (d < 0 || a > b) continue;
      if (const double part = wanted_.ofEdge(p(a), p(b), p(c), p(d)); part < worst) {
        worst = part;
        place = {a, b, c, d};
      }
    }
  }
  return place;
}

}  // namespace handlebody
