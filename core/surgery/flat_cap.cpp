#include "core/surgery/flat_cap.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/geometry/predicates.h"

namespace handlebody {

namespace {

int axisOf(const Vec3& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return axis;
}

class Region {
 public:
  Region(const std::vector<Vec3>& points, const Vec3& normal)
      : points_(points), axis_(axisOf(normal)), sign_(normal[axis_] > 0 ? 1 : -1) {}

  std::optional<std::vector<Triangle>> triangulate(const std::vector<std::vector<int>>& polygons) {
    outline_ = polygons.front();
    std::vector<std::vector<int>> holes(polygons.begin() + 1, polygons.end());
    const int across = (axis_ + 1) % 3;
    const auto highest = [&](const std::vector<int>& loop) {
      return *std::max_element(loop.begin(), loop.end(),
                               [&](int a, int b) { return at(a)[across] < at(b)[across]; });
    };
    std::sort(holes.begin(), holes.end(),
              [&](const auto& a, const auto& b) { return at(highest(a))[across] > at(highest(b))[across]; });
    for (std::size_t i = 0; i < holes.size(); ++i)
      if (!bridge(holes, i, highest(holes[i]))) return std::nullopt;
    return clip();
  }

 private:
  const Vec3& at(int v) const { return points_[v]; }
  int turn(int a, int b, int c) const { return sign_ * orient2d(at(a), at(b), at(c), axis_); }

  //! True if the segments ab and cd have a point in common, but for a common end.
  bool cross(int a, int b, int c, int d) const {
    const bool shared = a == c || a == d || b == c || b == d;
    const int abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
    if (shared) {
      // On one line and to the same side.
      if (abc != 0 || abd != 0) return false;
      const int common = a == c || a == d ? a : b, other = common == a ? b : a, far = common == c ? d : c;
      return far == other || (at(other) - at(common)).dot(at(far) - at(common)) > 0;
    }
    if (abc == 0 && abd == 0) {
      const Vec3 along = at(b) - at(a);
      const double end = along.squaredNorm(), s = along.dot(at(c) - at(a)), t = along.dot(at(d) - at(a));
      return std::max(s, t) >= 0 && std::min(s, t) <= end;
    }
    return abc * abd <= 0 && cda * cdb <= 0;
  }
  bool isFree(int a, int b, const std::vector<int>& loop) const {
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (cross(a, b, loop[i], loop[(i + 1) % loop.size()])) return false;
    return true;
  }

  //! Joins the hole to the outline from its highest vertex.
  bool bridge(const std::vector<std::vector<int>>& holes, std::size_t hole, int from) {
    std::vector<std::pair<double, std::size_t>> ends;
    for (std::size_t i = 0; i < outline_.size(); ++i)
      ends.emplace_back((at(outline_[i]) - at(from)).squaredNorm(), i);
    std::sort(ends.begin(), ends.end());
    for (const auto& [length, i] : ends) {
      const int to = outline_[i];
      bool free = opensInto(i, from) && isFree(from, to, outline_);
      for (std::size_t k = hole; k < holes.size() && free; ++k) free = isFree(from, to, holes[k]);
      if (!free) continue;
      std::vector<int> loop = holes[hole];
      std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), from), loop.end());
      loop.push_back(from);
      loop.push_back(to);
      outline_.insert(outline_.begin() + static_cast<std::ptrdiff_t>(i) + 1, loop.begin(), loop.end());
      return true;
    }
    return false;
  }
  //! True if p lies in the angle of the outline at its place i, on the side of the region.
  bool opensInto(std::size_t i, int p) const {
    const std::size_t n = outline_.size();
    const int before = outline_[(i + n - 1) % n], here = outline_[i], after = outline_[(i + 1) % n];
    const bool left = turn(before, here, p) > 0, right = turn(here, after, p) > 0;
    return turn(before, here, after) > 0 ? left && right : left || right;
  }

  bool isEar(std::size_t i) const {
    const std::size_t n = outline_.size();
    const int a = outline_[(i + n - 1) % n], b = outline_[i], c = outline_[(i + 1) % n];
    if (a == b || b == c || a == c || turn(a, b, c) <= 0) return false;
    return std::none_of(outline_.begin(), outline_.end(), [&](int p) {
      return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    });
  }
  //! The sine of the smallest angle of the triangle at place i, or so.
  double shape(std::size_t i) const {
    const std::size_t n = outline_.size();
    const Vec3 &a = at(outline_[(i + n - 1) % n]), &b = at(outline_[i]), &c = at(outline_[(i + 1) % n]);
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return (b - a).cross(c - a).norm() / longest;
  }

  std::optional<std::vector<Triangle>> clip() {
    std::vector<Triangle> out;
    std::vector<double> quality;  // of the ear at each place; below 0: it is none
    for (std::size_t i = 0; i < outline_.size(); ++i) quality.push_back(isEar(i) ? shape(i) : -1);
    while (outline_.size() > 2) {
      const auto best = std::max_element(quality.begin(), quality.end());
      if (*best < 0) return std::nullopt;
      const auto i = static_cast<std::size_t>(best - quality.begin());
      const std::size_t n = outline_.size();
      out.push_back({outline_[(i + n - 1) % n], outline_[i], outline_[(i + 1) % n]});
      outline_.erase(outline_.begin() + static_cast<std::ptrdiff_t>(i));
      quality.erase(quality.begin() + static_cast<std::ptrdiff_t>(i));
      if (n == 3) break;
      for (const std::size_t beside : {(i + n - 2) % (n - 1), i % (n - 1)})
        quality[beside] = isEar(beside) ? shape(beside) : -1;
    }
    return out;
  }

  const std::vector<Vec3>& points_;
  int axis_, sign_;
  std::vector<int> outline_;
};

//! Turns edges within a triangulation until it is Delaunay's: the last ears are what the others have left.
class Flipping {
 public:
  Flipping(const std::vector<Vec3>& points, const Vec3& normal, std::vector<Triangle>& faces)
      : points_(points), axis_(axisOf(normal)), sign_(normal[axis_] > 0 ? 1 : -1), faces_(faces) {
    for (std::size_t f = 0; f < faces.size(); ++f) enter(f);
  }
  void run() {
    for (int round = 0; round < kRounds; ++round) {
      bool any = false;
      for (std::size_t f = 0; f < faces_.size(); ++f)
        for (std::size_t i = 0; i < 3; ++i) any = flip(f, i) || any;
      if (!any) return;
    }
  }

 private:
  static constexpr int kRounds = 50;
  static constexpr double kMargin = 1e-9;  // so that no edge is turned to and fro

  void enter(std::size_t f) {
    const Triangle& t = faces_[f];
    for (std::size_t i = 0; i < 3; ++i) faceAt_[{t[i], t[(i + 1) % 3]}] = f;
  }
  const Vec3& at(int v) const { return points_[v]; }
  int turn(int a, int b, int c) const { return sign_ * orient2d(at(a), at(b), at(c), axis_); }

  bool flip(std::size_t f, std::size_t i) {
    const int a = faces_[f][i], b = faces_[f][(i + 1) % 3], c = faces_[f][(i + 2) % 3];
    const auto across = faceAt_.find({b, a});
    if (across == faceAt_.end()) return false;
    const std::size_t g = across->second;
    const int d = *std::find_if(faces_[g].begin(), faces_[g].end(), [&](int v) { return v != a && v != b; });
    if (turn(c, a, d) <= 0 || turn(d, b, c) <= 0 || !isObtuse(a, b, c, d)) return false;
    faceAt_.erase({a, b});
    faceAt_.erase({b, a});
    faces_[f] = {c, a, d};
    faces_[g] = {d, b, c};
    enter(f);
    enter(g);
    return true;
  }
  //! True if the angles at c and d add up to more than a straight one.
  bool isObtuse(int a, int b, int c, int d) const {
    const Vec3 ca = at(a) - at(c), cb = at(b) - at(c), da = at(a) - at(d), db = at(b) - at(d);
    const double sine = ca.cross(cb).norm() * da.dot(db) + ca.dot(cb) * da.cross(db).norm();
    return sine < -kMargin * ca.norm() * cb.norm() * da.norm() * db.norm();
  }

  const std::vector<Vec3>& points_;
  int axis_, sign_;
  std::vector<Triangle>& faces_;
  std::map<std::pair<int, int>, std::size_t> faceAt_;  // by directed edge
};

}  // namespace

std::optional<std::vector<Triangle>> flatCap(const std::vector<Vec3>& points, const Vec3& normal,
                                             const std::vector<std::vector<int>>& polygons) {
  auto faces = Region(points, normal).triangulate(polygons);
  if (faces) Flipping(points, normal, *faces).run();
  return faces;
}

int windingAround(const std::vector<Vec3>& points, const Vec3& normal, const std::vector<int>& polygon,
                  const Vec3& p) {
  const int axis = axisOf(normal), sign = normal[axis] > 0 ? 1 : -1, up = (axis + 2) % 3;
  int winding = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = points[polygon[i]], &b = points[polygon[(i + 1) % polygon.size()]];
    // In the order of the axes after `axis`, orient2d > 0 is counter-clockwise.
    const bool isBelow = a[up] <= p[up], willBeBelow = b[up] <= p[up];
    if (isBelow == willBeBelow) continue;
    const int side = orient2d(a, b, p, axis);
    if (isBelow && side > 0) ++winding;
    if (!isBelow && side < 0) --winding;
  }
  return sign * winding;
}

}  // namespace handlebody
