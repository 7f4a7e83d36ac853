#include "core/surgery/closing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core/collision/face_pair.h"
#include "core/mesh/nesting.h"

namespace handlebody {

namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

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
  bool exists() const { return cost_[idx(n_ - 1)] < kNone; }
  void collect(int i, int j, Patch& out) const {
    if (j - i < 2) return;
    const int m = apex_[idx(i * n_ + j)];
    out.faces.push_back({loop_[idx(i)], loop_[idx(m)], loop_[idx(j)]});
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
    return side || !staysOpenOn(mesh_, std::span(&opening_, 1), loop_[idx(i)], loop_[idx(j)]);
  }
  void solve(int i, int j) {
    double best = kNone;
    if (allowed(i, j))
      for (int m = i + 1; m < j; ++m) {
        const Vec3 &a = mesh_.position(loop_[idx(i)]), &b = mesh_.position(loop_[idx(m)]),
                   &c = mesh_.position(loop_[idx(j)]);
        const double face = (b - a).cross(c - a).norm();
        const double longest =
            std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        if (!(face > kThinnest * longest)) continue;
        const double area = cost_[idx(i * n_ + m)] + cost_[idx(m * n_ + j)] + face;
        if (area < best) {
          best = area;
          apex_[idx(i * n_ + j)] = m;
        }
      }
    cost_[idx(i * n_ + j)] = best;
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
      if (g[j] == f[idx(i)]) other[j] = i;
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
  const Vec3 origin = mesh.position(openings[0].lambda[0]);
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

Surroundings::Surroundings(const Mesh& mesh, std::span<const Opening> openings,
                           std::span<const unsigned char> ignored, const Forbidden& forbidden)
    : mesh_(mesh), forbidden_(forbidden), replaced_(mesh, openings, forbidden) {
  Eigen::AlignedBox3d box;
  for (const Opening& o : openings)
    for (const auto& loop : o.loops)
      for (int v : loop) box.extend(mesh.position(v));
  const Vec3 low = box.min(), high = box.max();
  for (int f = 0; f < mesh.faceSlots(); ++f) {
    const Triangle& t = mesh.face(f);
    if (t[0] < 0) continue;
    const Vec3 &a = mesh.position(t[0]), &b = mesh.position(t[1]), &c = mesh.position(t[2]);
    // Axis by axis, so that most faces cost three comparisons.
    bool apart = false;
    for (int axis = 0; axis < 3 && !apart; ++axis)
      apart = (a[axis] < low[axis] && b[axis] < low[axis] && c[axis] < low[axis]) ||
              (a[axis] > high[axis] && b[axis] > high[axis] && c[axis] > high[axis]);
    if (apart || (idx(f) < ignored.size() && ignored[idx(f)]) || !stays(openings, f)) continue;
    faces_.push_back(f);
  }
}

bool Surroundings::hitsStaying(const Patch& patch, const Triangle& face) const {
  const std::array<Vec3, 3> p = corners(mesh_, patch, face);
  if (forbidden_.holds && forbidden_.holds(p[0], p[1], p[2])) return true;
  const Eigen::AlignedBox3d box = boxOf(p);
  return std::any_of(faces_.begin(), faces_.end(), [&](int g) {
    const std::array<Vec3, 3> q = corners(mesh_, patch, mesh_.face(g));
    return box.intersects(boxOf(q)) && intersect(face, p, mesh_.face(g), q);
  });
}

bool Surroundings::intersectsItself(const Patch& patch) const {
  for (std::size_t i = 0; i < patch.faces.size(); ++i) {
    const std::array<Vec3, 3> p = corners(mesh_, patch, patch.faces[i]);
    const Eigen::AlignedBox3d box = boxOf(p);
    for (std::size_t j = 0; j < i; ++j) {
      const std::array<Vec3, 3> q = corners(mesh_, patch, patch.faces[j]);
      if (box.intersects(boxOf(q)) && intersect(patch.faces[i], p, patch.faces[j], q)) return true;
    }
  }
  return false;
}

bool Surroundings::fits(const Patch& patch) const {
  return std::none_of(patch.faces.begin(), patch.faces.end(),
                      [&](const Triangle& f) { return hitsStaying(patch, f); }) &&
         !intersectsItself(patch);
}

std::vector<std::size_t> Surroundings::hits(const Patch& patch, const Patch& other) const {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < patch.faces.size(); ++i) {
    const std::array<Vec3, 3> p = corners(mesh_, patch, patch.faces[i]);
    const bool hitsOther = std::any_of(other.faces.begin(), other.faces.end(), [&](const Triangle& g) {
      return intersect(patch.faces[i], p, g, corners(mesh_, other, g));
    });
    if (hitsOther || hitsStaying(patch, patch.faces[i])) out.push_back(i);
  }
  return out;
}

}  // namespace handlebody
