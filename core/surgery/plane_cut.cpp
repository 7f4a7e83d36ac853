#include "core/surgery/plane_cut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "core/indices.h"
#include "core/mesh/containment.h"
#include "core/mesh/remesh.h"
#include "core/surgery/flat_cap.h"

namespace handlebody {

namespace {

constexpr double kGapOfFree = 0.4;  // half of the gap, as a part of the way to the next vertex
constexpr int kMerges = 4;          // rounds
constexpr double kSliver = 0.25;    // edges: vertices so near to a rim are merged into it
constexpr double kLongest = 1.4, kShortest = 0.55;  // edges, in a cap

//! A ring of faces that the plane crosses, by the half-edges that lead across it from below to above, in the
//! order in which they follow each other round it.
using Ring = std::vector<int>;

//! Points on either side of the gap.
struct Rims {
  std::vector<int> low, high;
  std::vector<int> all() const {
    std::vector<int> both = low;
    both.insert(both.end(), high.begin(), high.end());
    return both;
  }
};

class Cut {
 public:
  Cut(const Mesh& mesh, const PlaneCut& cut) : mesh_(mesh), cut_(cut), normal_(cut.normal.normalized()) {}
  TouchedMesh run();

 private:
  double height(int v) const { return (mesh_.position(v) - cut_.point).dot(normal_) - offset_; }
  bool leadsUp(int h) const { return height(mesh_.origin(h)) < 0 && height(mesh_.target(h)) >= 0; }
  void placePlane();
  void findRings();
  Vec3 crossing(int h, double above) const;
  std::vector<std::vector<std::size_t>> regions() const;
  bool isNear(const std::vector<std::size_t>& region) const;
  bool divide(const std::vector<std::vector<std::size_t>>& chosen);
  bool cap(const std::vector<std::size_t>& region, const std::vector<int>& first, const Vec3& outward);
  void splitFace(int face, std::map<int, int>& low, std::map<int, int>& high);
  void mergeRims(Mesh& mesh, Rims& rims) const;
  static bool staysFlat(const Mesh& mesh, int v, int other, const Vec3& p);
  Mesh evened(const Mesh& raw, Rims& rims) const;
  FindingKind dropOtherSide(Mesh& mesh, const Rims& rims) const;

  const Mesh& mesh_;
  const PlaneCut& cut_;
  Vec3 normal_;
  double offset_ = 0, half_ = 0, edge_ = 0;  // mm: of the plane, of the gap, mean crossed edge
  std::vector<Ring> rings_;
  std::vector<Vec3> section_;               // where the rings' half-edges cross the plane
  std::vector<std::vector<int>> outlines_;  // per ring, of `section_`
  TriangleSoup soup_;
  Rims rims_;
  std::vector<Triangle> caps_;
  int predicted_ = 0;  // Euler number
};

//! Where the widest part of the range without a vertex is.
void Cut::placePlane() {
  double sum = 0, n = 0;
  for (int h = 0; h < 3 * mesh_.faceSlots(); ++h)
    if (mesh_.isFace(Mesh::faceOf(h)) && leadsUp(h)) {
      sum += (mesh_.position(mesh_.target(h)) - mesh_.position(mesh_.origin(h))).norm();
      n += 1;
    }
  edge_ = n > 0 ? sum / n : 0;
  const double range = kWidestShift * edge_;
  std::vector<double> heights{-range, range};
  for (int v = 0; v < mesh_.vertexSlots(); ++v)
    if (mesh_.isVertex(v) && std::abs(height(v)) < range) heights.push_back(height(v));
  std::sort(heights.begin(), heights.end());
  double widest = -1, middle = 0;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i)
    if (heights[i + 1] - heights[i] > widest) {
      widest = heights[i + 1] - heights[i];
      middle = (heights[i + 1] + heights[i]) / 2;
    }
  offset_ += middle;
  half_ = std::min(kGapOfFree * widest / 2, kWidestGap / 2 * edge_);
}

void Cut::findRings() {
  std::vector<unsigned char> isSeen(3 * idx(mesh_.faceSlots()), 0);
  for (int h = 0; h < 3 * mesh_.faceSlots(); ++h) {
    if (!mesh_.isFace(Mesh::faceOf(h)) || isSeen[h] != 0 || !leadsUp(h)) continue;
    Ring ring;
    // Through the face on the left of a half-edge that leads up to the one that leads down, and over it.
    for (int at = h; isSeen[at] == 0;) {
      isSeen[at] = 1;
      ring.push_back(at);
      const int down = height(mesh_.apex(at)) < 0 ? Mesh::next(at) : Mesh::prev(at);
      at = mesh_.opposite(down);
    }
    rings_.push_back(std::move(ring));
  }
  for (const Ring& ring : rings_) {
    std::vector<int> outline;
    for (const int h : ring) {
      outline.push_back(static_cast<int>(section_.size()));
      section_.push_back(crossing(h, 0));
    }
    outlines_.push_back(std::move(outline));
  }
}

Vec3 Cut::crossing(int h, double above) const {
  const int u = mesh_.origin(h), w = mesh_.target(h);
  const double t = (above - height(u)) / (height(w) - height(u));
  return mesh_.position(u) + t * (mesh_.position(w) - mesh_.position(u));
}

//! The rings that bound one part of the section each, its outer boundary first.
std::vector<std::vector<std::size_t>> Cut::regions() const {
  const std::size_t n = rings_.size();
  std::vector<std::vector<std::size_t>> within(n);  // the rings around each
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (i != j && windingAround(section_, normal_, outlines_[j], section_[outlines_[i][0]]) != 0)
        within[i].push_back(j);
  std::vector<std::vector<std::size_t>> out;
  std::vector<std::size_t> regionOf(n, n);
  for (std::size_t i = 0; i < n; ++i)
    if (within[i].size() % 2 == 0) {
      regionOf[i] = out.size();
      out.push_back({i});
    }
  for (std::size_t i = 0; i < n; ++i) {
    if (within[i].size() % 2 == 0) continue;
    for (const std::size_t j : within[i])
      if (within[j].size() + 1 == within[i].size()) out[regionOf[j]].push_back(i);
  }
  return out;
}

bool Cut::isNear(const std::vector<std::size_t>& region) const {
  if (!cut_.radius) return true;
  bool isIn = false;
  for (const std::size_t ring : region) {
    for (const int p : outlines_[ring])
      if ((section_[p] - cut_.point).norm() <= *cut_.radius) return true;
    if (windingAround(section_, normal_, outlines_[ring], cut_.point) != 0) isIn = !isIn;
  }
  return isIn;
}

//! Parts of a face that a ring crosses, on either side of the gap.
void Cut::splitFace(int face, std::map<int, int>& low, std::map<int, int>& high) {
  for (int h = 3 * face; h < 3 * face + 3; ++h) {
    // The corner that is alone on its side is the origin of h.
    const int a = mesh_.origin(h), b = mesh_.target(h), c = mesh_.apex(h);
    const bool isUp = height(a) >= 0;
    if ((height(b) >= 0) == isUp || (height(c) >= 0) == isUp) continue;
    const auto key = [&](int side) { return leadsUp(side) ? side : mesh_.opposite(side); };
    const int ab = key(h), ca = key(Mesh::prev(h));
    std::map<int, int>&own = isUp ? high : low, &other = isUp ? low : high;
    soup_.triangles.push_back({a, own.at(ab), own.at(ca)});
    const int p = other.at(ab), q = other.at(ca);
    // The shorter diagonal of p, b, c, q.
    const auto length = [&](int i, int j) { return (soup_.points[i] - soup_.points[j]).norm(); };
    if (length(p, c) < length(b, q)) {
      soup_.triangles.push_back({p, b, c});
      soup_.triangles.push_back({p, c, q});
    } else {
      soup_.triangles.push_back({p, b, q});
      soup_.triangles.push_back({b, c, q});
    }
    return;
  }
}

//! The caps of one region on one side. `first`: per ring the soup's point on its first half-edge.
bool Cut::cap(const std::vector<std::size_t>& region, const std::vector<int>& first, const Vec3& outward) {
  std::vector<std::vector<int>> polygons;
  for (const std::size_t ring : region) {
    std::vector<int> polygon(rings_[ring].size());
    std::iota(polygon.begin(), polygon.end(), first[ring]);
    // Left of what leads up lies the way round the body that is clockwise seen from above.
    if (outward.dot(normal_) > 0) std::reverse(polygon.begin(), polygon.end());
    polygons.push_back(std::move(polygon));
  }
  const auto faces = flatCap(soup_.points, outward, polygons);
  if (!faces) return false;
  caps_.insert(caps_.end(), faces->begin(), faces->end());
  predicted_ += 2 - static_cast<int>(region.size());
  return true;
}

//! The soup without the rings of the chosen regions, with their caps.
bool Cut::divide(const std::vector<std::vector<std::size_t>>& chosen) {
  soup_.points.assign(mesh_.positions().begin(), mesh_.positions().end());
  std::map<int, int> low, high;  // per half-edge that leads up
  std::vector<int> firstLow(rings_.size()), firstHigh(rings_.size());
  FaceMarks isCrossed(idx(mesh_.faceSlots()), 0);
  for (const auto& region : chosen)
    for (const std::size_t ring : region) {
      const auto add = [&](double above, std::map<int, int>& points, std::vector<int>& rim) {
        const int first = static_cast<int>(soup_.points.size());
        for (const int h : rings_[ring]) {
          points[h] = static_cast<int>(soup_.points.size());
          rim.push_back(points[h]);
          soup_.points.push_back(crossing(h, above));
        }
        return first;
      };
      firstLow[ring] = add(-half_, low, rims_.low);
      firstHigh[ring] = add(half_, high, rims_.high);
      for (const int h : rings_[ring]) isCrossed[Mesh::faceOf(h)] = 1;
    }
  for (int f = 0; f < mesh_.faceSlots(); ++f) {
    if (!mesh_.isFace(f)) continue;
    if (isCrossed[f] == 0)
      soup_.triangles.push_back(mesh_.face(f));
    else
      splitFace(f, low, high);
  }
  predicted_ = topologyNumbers(mesh_).euler;  // the rings have Euler number 0
  return std::all_of(chosen.begin(), chosen.end(), [&](const auto& region) {
    return cap(region, firstLow, normal_) && cap(region, firstHigh, -normal_);
  });
}

//! Merges what is close to each other on a rim, within the plane, where the surface is nearly flat beside it.
void Cut::mergeRims(Mesh& mesh, Rims& rims) const {
  VertexMarks isRim(idx(mesh.vertexSlots()), 0);
  for (const int v : rims.all()) isRim[v] = 1;
  const auto isOnRim = [&](int h) {
    const auto isCap = [&](int side) { return isRim[mesh.apex(side)] != 0; };
    return isRim[mesh.target(h)] != 0 && isCap(h) != isCap(mesh.opposite(h));
  };
  for (int round = 0; round < kMerges; ++round)
    for (const int v : rims.all()) {
      if (!mesh.isVertex(v)) continue;
      int shortest = -1;
      double least = kShortest * edge_;
      mesh.forEachOutgoing(v, [&](int h) {
        const double length = (mesh.position(mesh.target(h)) - mesh.position(v)).norm();
        if (length >= least || !isOnRim(h)) return;
        least = length;
        shortest = h;
      });
      if (shortest < 0 || !mesh.canCollapse(shortest)) continue;
      const int w = mesh.target(shortest);
      const Vec3 middle = (mesh.position(v) + mesh.position(w)) / 2;
      if (staysFlat(mesh, v, w, middle) && staysFlat(mesh, w, v, middle)) mesh.collapseEdge(shortest, middle);
    }
  for (std::vector<int>* rim : {&rims.low, &rims.high})
    std::erase_if(*rim, [&](int v) { return !mesh.isVertex(v); });
}

//! True if the faces around v that do not hold `other` keep their normals, about, when v goes to p.
bool Cut::staysFlat(const Mesh& mesh, int v, int other, const Vec3& p) {
  bool ok = true;
  mesh.forEachOutgoing(v, [&](int h) {
    const int b = mesh.target(h), c = mesh.apex(h);
    if (!ok || b == other || c == other) return;
    const Vec3 across = mesh.position(c) - mesh.position(b);
    const Vec3 was = across.cross(mesh.position(v) - mesh.position(b)).normalized();
    ok = was.dot(across.cross(p - mesh.position(b)).normalized()) > kFlatEnough;
  });
  return ok;
}

//! With small faces at the rims merged, and caps of edges as even as those around.
Mesh Cut::evened(const Mesh& raw, Rims& rims) const {
  Mesh mesh = raw;
  mergeRims(mesh, rims);
  VertexStates active(idx(mesh.vertexSlots()), kAtRest);
  VertexMarks isRim(idx(mesh.vertexSlots()), 0);
  for (const int v : rims.all()) isRim[v] = 1;
  std::vector<std::pair<double, std::pair<int, int>>> chords;
  const auto isCap = [&](int side) { return isRim[mesh.apex(side)] != 0; };
  for (const int v : rims.all())
    mesh.forEachOutgoing(v, [&](int h) {
      const int w = mesh.target(h);
      const double length = (mesh.position(w) - mesh.position(v)).norm();
      if (isRim[w] == 0 && length < kSliver * edge_) active[w] = kActive;
      if (isRim[w] != 0 && v < w && length > kLongest * edge_ && isCap(h) && isCap(mesh.opposite(h)))
        chords.push_back({-length, {v, w}});
    });
  std::sort(chords.begin(), chords.end());
  for (const auto& [length, ends] : chords) {
    const int h = mesh.findHalfedge(ends.first, ends.second);
    const int m = mesh.splitEdge(h, (mesh.position(ends.first) + mesh.position(ends.second)) / 2);
    active.resize(mesh.vertexSlots(), kAtRest);
    active[m] = kActive;
  }
  regulate(mesh, {kLongest * edge_, kShortest * edge_, {}}, active);
  return mesh;
}

//! What lies on the other side goes. The reason if it cannot.
FindingKind Cut::dropOtherSide(Mesh& mesh, const Rims& rims) const {
  if (cut_.keep == KeptSide::both) return FindingKind::none;
  const Components parts = findComponents(mesh);
  ComponentMarks isLow(idx(parts.count()), 0), isHigh(idx(parts.count()), 0);
  for (const int v : rims.low) isLow[parts.ofVertex[v]] = 1;
  for (const int v : rims.high) isHigh[parts.ofVertex[v]] = 1;
  std::vector<int> anyVertex(parts.count(), -1);
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) anyVertex[parts.ofVertex[v]] = v;
  const std::vector<int> around = surroundingComponents(mesh, parts);
  ComponentMarks goes(idx(parts.count()), 0);
  for (int c = 0; c < parts.count(); ++c) {
    if (isLow[c] != 0 && isHigh[c] != 0) return FindingKind::cutPartsNothing;
    const bool isCut = isLow[c] != 0 || isHigh[c] != 0;
    const double side = (mesh.position(anyVertex[c]) - cut_.point).dot(normal_) - offset_;
    const bool isUp = isCut ? isHigh[c] != 0 : side >= 0;
    goes[c] = isUp != (cut_.keep == KeptSide::positive) && (isCut || !cut_.radius);
  }
  for (int c = 0; c < parts.count(); ++c)
    for (int o = around[c]; o >= 0; o = around[o])
      if (goes[o] != 0) goes[c] = 1;
  for (int c = 0; c < parts.count(); ++c)
    if (goes[c] != 0) deleteComponent(mesh, anyVertex[c]);
  return FindingKind::none;
}

TouchedMesh Cut::run() {
  placePlane();
  findRings();
  std::vector<std::vector<std::size_t>> chosen = regions();
  std::erase_if(chosen, [this](const auto& region) { return !isNear(region); });
  if (chosen.empty())
    return refused(mesh_, cut_.radius ? FindingKind::planeMissesNear : FindingKind::planeMisses);
  if (!divide(chosen)) return refused(mesh_, FindingKind::noFlatCap);
  soup_.triangles.insert(soup_.triangles.end(), caps_.begin(), caps_.end());
  Mesh raw(soup_);
  for (int v = 0; v < mesh_.vertexSlots(); ++v)
    if (!mesh_.isVertex(v)) raw.removeVertex(v);
  if (!certifiedEdit(mesh_, raw).isDone() || topologyNumbers(raw).euler != predicted_)
    return refused(mesh_, FindingKind::noFlatCap);
  for (const bool isEven : {true, false}) {
    Rims rims = rims_;
    Mesh done = isEven ? evened(raw, rims) : raw;
    if (topologyNumbers(done).euler != predicted_) continue;
    if (const FindingKind why = dropOtherSide(done, rims); why != FindingKind::none)
      return refused(mesh_, why);
    TouchedMesh out = certifiedEdit(mesh_, std::move(done));
    if (out.isDone() || !isEven) return out;
  }
  return refused(mesh_, FindingKind::noFlatCap);
}

}  // namespace

TouchedMesh cutByPlane(const Mesh& mesh, const PlaneCut& cut) { return Cut(mesh, cut).run(); }

}  // namespace handlebody
