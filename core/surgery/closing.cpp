#include "core/surgery/closing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core/collision/face_pair.h"
#include "core/geometry/predicates.h"
#include "core/indices.h"
#include "core/mesh/nesting.h"

namespace handlebody {

namespace {

bool stays(std::span<const Opening> openings, int f) {
  return std::none_of(openings.begin(), openings.end(), [f](const Opening& o) {
    return std::binary_search(o.faces.begin(), o.faces.end(), f);
  });
}

std::array<Vec3, 3> corners(const Mesh& mesh, const Patch& patch, const Triangle& t) {
  return {patch.position(mesh, t[0]), patch.position(mesh, t[1]), patch.position(mesh, t[2])};
}

Eigen::AlignedBox3d boxOf(const std::array<Vec3, 3>& p) {
  Eigen::AlignedBox3d box(p[0]);
  box.extend(p[1]);
  box.extend(p[2]);
  return box;
}

//! Least-area triangulations of the sub-polygons i … j, for leastAreaCap.
class PolygonTriangulation {
 public:
  PolygonTriangulation(const Mesh& mesh, const Opening& opening, const std::vector<int>& loop)
      : mesh_(mesh), opening_(opening), loop_(loop), n_(static_cast<int>(loop.size())) {
    cost_.assign(idx(n_ * n_), 0);
    apex_.assign(idx(n_ * n_), -1);
    for (int span = 2; span < n_; ++span)
      for (int i = 0; i + span < n_; ++i) solve(i, i + span);
  }
  bool exists() const { return cost_[n_ - 1] < kNone; }
  void collect(int i, int j, Patch& out) const {
    if (j - i < 2) return;
    const int m = apex_[i * n_ + j];
    out.faces.push_back({loop_[i], loop_[m], loop_[j]});
    collect(i, m, out);
    collect(m, j, out);
  }

 private:
  static constexpr double kNone = 1e300;
  // Altitude of a face as a part of its longest edge. On a polygon with three corners on a line a face
  // without area would be the cheapest of all.
  static constexpr double kThinnest = 1e-4;
  bool allowed(int i, int j) const {
    const bool side = j - i == 1 || (i == 0 && j == n_ - 1);
    return side || !staysOpenOn(mesh_, std::span(&opening_, 1), loop_[i], loop_[j]);
  }
  void solve(int i, int j) {
    double best = kNone;
    if (allowed(i, j))
      for (int m = i + 1; m < j; ++m) {
        const Vec3 &a = mesh_.position(loop_[i]), &b = mesh_.position(loop_[m]),
                   &c = mesh_.position(loop_[j]);
        const double face = (b - a).cross(c - a).norm();
        const double longest =
            std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        if (!(face > kThinnest * longest)) continue;
        const double area = cost_[i * n_ + m] + cost_[m * n_ + j] + face;
        if (area < best) {
          best = area;
          apex_[i * n_ + j] = m;
        }
      }
    cost_[i * n_ + j] = best;
  }

  const Mesh& mesh_;
  const Opening& opening_;
  const std::vector<int>& loop_;
  int n_;
  std::vector<double> cost_;
  std::vector<int> apex_;
};

//! The exact test takes one array of points: the corners of the one behind those of the other.
bool intersect(const Triangle& f, const std::array<Vec3, 3>& p, const Triangle& g,
               const std::array<Vec3, 3>& q) {
  const std::array<Vec3, 6> points{p[0], p[1], p[2], q[0], q[1], q[2]};
  Triangle other{3, 4, 5};
  for (std::size_t j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      if (g[j] == f[i]) other[j] = i;
  return facesIntersect(points, {0, 1, 2}, other);
}

}  // namespace

bool staysOpenOn(const Mesh& mesh, std::span<const Opening> openings, int u, int v) {
  const int h = mesh.findHalfedge(u, v);
  return h >= 0 && (stays(openings, Mesh::faceOf(h)) || stays(openings, Mesh::faceOf(mesh.opposite(h))));
}

void Patch::append(const Patch& other) {
  const int shift = static_cast<int>(points.size());
  points.insert(points.end(), other.points.begin(), other.points.end());
  for (Triangle t : other.faces) {
    for (int& v : t)
      if (v >= firstNew) v += shift;
    faces.push_back(t);
  }
  length += other.length;
}

Patch fanCap(const Mesh& mesh, const std::vector<int>& loop) {
  Patch patch;
  patch.firstNew = mesh.vertexSlots();
  Vec3 sum(0, 0, 0);
  for (int v : loop) sum += mesh.position(v);
  patch.points.push_back(sum / static_cast<double>(loop.size()));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    patch.faces.push_back({loop[i], loop[(i + 1) % loop.size()], patch.firstNew});
    patch.length += (mesh.position(loop[i]) - patch.points[0]).norm();
  }
  return patch;
}

std::optional<Patch> leastAreaCap(const Mesh& mesh, const Opening& opening, const std::vector<int>& loop) {
  const PolygonTriangulation triangulation(mesh, opening, loop);
  if (!triangulation.exists()) return std::nullopt;
  Patch patch;
  patch.firstNew = mesh.vertexSlots();
  triangulation.collect(0, static_cast<int>(loop.size()) - 1, patch);
  return patch;
}

double volumeGain(const Mesh& mesh, std::span<const Opening> openings, const Patch& patch) {
  const Vec3& origin = mesh.position(openings[0].lambda[0]);
  const auto cone = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    return (a - origin).dot((b - origin).cross(c - origin)) / 6;
  };
  double gain = 0;
  for (const Triangle& t : patch.faces)
    gain += cone(patch.position(mesh, t[0]), patch.position(mesh, t[1]), patch.position(mesh, t[2]));
  for (const Opening& o : openings)
    for (int f : o.faces) {
      const Triangle& t = mesh.face(f);
      gain -= cone(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
    }
  return gain;
}

double area(const Mesh& mesh, const Patch& patch) {
  double sum = 0;
  for (const Triangle& t : patch.faces) {
    const std::array<Vec3, 3> p = corners(mesh, patch, t);
    sum += (p[1] - p[0]).cross(p[2] - p[0]).norm() / 2;
  }
  return sum;
}

Replaced::Replaced(const Mesh& mesh, std::span<const Opening> openings, const Forbidden& forbidden)
    : forbidden_(forbidden) {
  if (!forbidden.places) return;
  for (const Opening& o : openings)
    for (const int f : o.faces) {
      const Triangle& t = mesh.face(f);
      faces_.push_back({mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])});
    }
}

bool Replaced::sweepsOver(const Mesh& mesh, const Patch& patch) const {
  if (faces_.empty()) return false;
  std::vector<std::array<Vec3, 3>> added;
  for (const Triangle& t : patch.faces) added.push_back(corners(mesh, patch, t));
  Eigen::AlignedBox3d box;
  for (const auto& face : faces_) box.extend(boxOf(face));
  for (const auto& face : added) box.extend(boxOf(face));
  // Old and new faces together are closed: they wind around a place between them.
  const auto isBetween = [&](const Vec3& p) {
    int winding = 0;
    for (const auto& [a, b, c] : added) winding += crossing(a, b, c, p);
    for (const auto& [a, b, c] : faces_) winding -= crossing(a, b, c, p);
    return winding != 0;
  };
  const std::vector<Vec3> places = forbidden_.places(box.min(), box.max());
  return std::any_of(places.begin(), places.end(), isBetween);
}

Surroundings::Surroundings(const Mesh& mesh, const FaceBlocks& blocks, std::span<const Opening> openings,
                           FaceMarkSpan ignored, const Forbidden& forbidden, double about)
    : mesh_(mesh), forbidden_(forbidden), replaced_(mesh, openings, forbidden) {
  for (const Opening& o : openings)
    for (const auto& loop : o.loops)
      for (int v : loop) known_.extend(mesh.position(v));
  known_ = {known_.min() - Vec3::Constant(about), known_.max() + Vec3::Constant(about)};
  blocks.forEachNear(mesh, known_, [&](int f) {
    const Triangle& t = mesh.face(f);
    const Eigen::AlignedBox3d box = boxOf({mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])});
    if (!box.intersects(known_) || (idx(f) < ignored.size() && ignored[f] != 0) || !stays(openings, f))
      return;
    faces_.push_back({box, f});
    widest_ = std::max(widest_, box.sizes().x());
  });
  std::sort(faces_.begin(), faces_.end(), [](const Staying& a, const Staying& b) {
    return a.box.min().x() != b.box.min().x() ? a.box.min().x() < b.box.min().x() : a.face < b.face;
  });
}

bool Surroundings::reach(const Patch& patch) const {
  return std::all_of(patch.faces.begin(), patch.faces.end(),
                     [&](const Triangle& t) { return known_.contains(boxOf(corners(mesh_, patch, t))); });
}

//! True if f(face) is, for any of the faces whose boxes meet the box.
template <typename F>
bool Surroundings::anyNear(const Eigen::AlignedBox3d& box, F&& f) const {
  // A little more than the widest, as the difference is rounded.
  auto near = std::lower_bound(faces_.begin(), faces_.end(), box.min().x() - 1.001 * widest_,
                               [](const Staying& s, double x) { return s.box.min().x() < x; });
  for (; near != faces_.end() && near->box.min().x() <= box.max().x(); ++near)
    if (box.intersects(near->box) && f(mesh_.face(near->face))) return true;
  return false;
}

bool Surroundings::hitsStaying(const Patch& patch, const Triangle& face) const {
  const std::array<Vec3, 3> p = corners(mesh_, patch, face);
  if (forbidden_.holds && forbidden_.holds(p[0], p[1], p[2])) return true;
  return anyNear(boxOf(p),
                 [&](const Triangle& g) { return intersect(face, p, g, corners(mesh_, patch, g)); });
}

bool Surroundings::isBlocked(int u, int v) const {
  const Vec3 &p = mesh_.position(u), &q = mesh_.position(v);
  Eigen::AlignedBox3d box(p);
  box.extend(q);
  return anyNear(box, [&](const Triangle& g) {
    const Vec3 &a = mesh_.position(g[0]), &b = mesh_.position(g[1]), &c = mesh_.position(g[2]);
    const int side = orient3d(a, b, c, p);
    if (side == 0 || orient3d(a, b, c, q) != -side) return false;
    const int turn = orient3d(p, q, a, b);
    return turn != 0 && orient3d(p, q, b, c) == turn && orient3d(p, q, c, a) == turn;
  });
}

bool Surroundings::intersectsItself(const Patch& patch) const {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Triangle& t : patch.faces) boxes.push_back(boxOf(corners(mesh_, patch, t)));
  for (std::size_t i = 0; i < patch.faces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (boxes[i].intersects(boxes[j]) && intersect(patch.faces[i], corners(mesh_, patch, patch.faces[i]),
                                                     patch.faces[j], corners(mesh_, patch, patch.faces[j])))
        return true;
  return false;
}

bool Surroundings::fits(const Patch& patch) const {
  return std::none_of(patch.faces.begin(), patch.faces.end(),
                      [&](const Triangle& f) { return hitsStaying(patch, f); }) &&
         !intersectsItself(patch);
}

bool Surroundings::hits(const Patch& patch, const Triangle& face, const Patch& other) const {
  const std::array<Vec3, 3> p = corners(mesh_, patch, face);
  const Eigen::AlignedBox3d box = boxOf(p);
  const bool hitsOther = std::any_of(other.faces.begin(), other.faces.end(), [&](const Triangle& g) {
    const std::array<Vec3, 3> q = corners(mesh_, other, g);
    return box.intersects(boxOf(q)) && intersect(face, p, g, q);
  });
  return hitsOther || hitsStaying(patch, face);
}

}  // namespace handlebody
