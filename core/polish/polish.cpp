#include "core/polish/polish.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/collision/certify.h"
#include "core/geometry/triangle_angles.h"
#include "core/indices.h"
#include "core/number_text.h"
#include "core/phase.h"
#include "core/polish/patch_search.h"
#include "core/polish/polished_surface.h"

namespace handlebody {

namespace {

//! Part of what is wanted that is aimed at, so that what was bettered is above it by more than rounding.
constexpr double kAim = 1.02;
constexpr int kMaxPasses = 6;
constexpr int kMaxChanges = 6;  // at one place in a pass
//! Operations, one after the other, that are tried as one; more for the few that are left at last.
constexpr std::size_t kDepth = 2, kLastDepth = 4;
constexpr std::size_t kBeam = 3;          // attempts that are gone on with
constexpr std::size_t kMaxWork = 800000;  // shapes of stars, some four seconds
// At one place in the first pass, so that one that cannot be bettered does not take the work of all others;
// so many times as much in each further one.
constexpr std::size_t kPlaceWork = 10000, kMorePlaceWork = 4;

//! A bad face, or the two of a bad edge.
struct BadPlace {
  double part;  // of what is wanted
  std::vector<int> vertices;
};

class Polisher {
 public:
  Polisher(const TriangleSoup& mesh, const PolishOptions& options)
      : options_(options),
        aim_{kAim * options.wanted.angle, kAim * options.wanted.dihedral},
        surface_(mesh, options.bounds),
        changedAt_(mesh.points.size(), 0) {}

  void run() {
    surface_.prepare();
    for (int pass = 1; pass <= kMaxPasses; ++pass) {
      bool any = false;
      isAnyCut_ = false;
      for (const BadPlace& place : badPlaces(nullptr))
        if (isToBeTried(place, pass)) any = better(place, pass) || any;
      if (work_ > kMaxWork || (!any && !isAnyCut_ && isLast_)) return;
      isLast_ = isLast_ || !(any || isAnyCut_);
      placeWork_ *= kMorePlaceWork;
    }
  }

  const PolishedSurface& surface() const { return surface_; }
  bool isCutShort() const { return work_ > kMaxWork; }

  //! The worst first.
  std::vector<BadPlace> badPlaces(PolishCount* count) const {
    std::vector<BadPlace> places;
    for (std::size_t f = 0; f < surface_.faces().size(); ++f) {
      const Triangle& t = surface_.faces()[f];
      if (t[0] < 0) continue;
      const double angle = leastAngle(point(t[0]), point(t[1]), point(t[2]));
      if (count) count->leastAngle = std::min(count->leastAngle, angle);
      if (angle < options_.wanted.angle && isOwn(f)) {
        places.push_back({angle / options_.wanted.angle, {t[0], t[1], t[2]}});
        if (count) ++count->faces;
      }
      addBadEdges(f, places, count);
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const BadPlace& a, const BadPlace& b) { return a.part < b.part; });
    return places;
  }

 private:
  const Vec3& point(int v) const { return surface_.points()[v]; }
  bool isOwn(std::size_t face) const { return face >= options_.isOwn.size() || options_.isOwn[face] != 0; }

  void addBadEdges(std::size_t face, std::vector<BadPlace>& places, PolishCount* count) const {
    const Triangle& t = surface_.faces()[face];
    for (std::size_t i = 0; i < 3; ++i) {
      const int p = t[i], q = t[(i + 1) % 3], c = t[(i + 2) % 3];
      if (p > q) continue;
      const int beyond = surface_.faceAt(q, p), d = surface_.apex(q, p);
      const double angle = dihedralAngle(point(p), point(q), point(c), point(d));
      if (count) count->leastDihedral = std::min(count->leastDihedral, angle);
      if (!(angle < options_.wanted.dihedral) || !(isOwn(face) || isOwn(idx(beyond)))) continue;
      places.push_back({angle / options_.wanted.dihedral, {p, q, c, d}});
      if (count) ++count->edges;
    }
  }

  //! Where nothing has changed since it was tried in vain it is not tried again.
  bool isToBeTried(const BadPlace& place, int pass) const {
    if (work_ > kMaxWork) return false;
    return pass == 1 || isLast_ || std::any_of(place.vertices.begin(), place.vertices.end(), [&](int v) {
             return changedAt_[v] >= pass - 1;
           });
  }

  //! Still as it was listed: its face, or its edge with both.
  bool isThere(const BadPlace& place) const {
    const auto& v = place.vertices;
    if (surface_.apex(v[0], v[1]) != v[2]) return false;
    if (v.size() == 3) return options_.wanted.ofFace(point(v[0]), point(v[1]), point(v[2])) < 1;
    return surface_.apex(v[1], v[0]) == v[3] &&
           options_.wanted.ofEdge(point(v[0]), point(v[1]), point(v[2]), point(v[3])) < 1;
  }

  bool better(const BadPlace& place, int pass) {
    bool any = false;
    for (int i = 0; i < kMaxChanges && isThere(place); ++i) {
      if (!change(place.vertices, pass)) break;
      any = true;
    }
    return any;
  }

  //! Operations are tried alone first, then some in a row, the best ones before the others.
  bool change(const std::vector<int>& vertices, int pass) {
    const PolishedSurface::Part part = surface_.around(vertices);
    const std::vector<Corners> first = surface_.firstNear(part.patch);
    PatchSearch search(aim_, part.patch, first, options_.bounds.distance, placeWork_);
    const Badness now = part.patch.badness(aim_);
    std::vector<int> place;  // in the patch
    for (const int v : vertices)
      place.push_back(static_cast<int>(std::find(part.patch.vertex.begin(), part.patch.vertex.end(), v) -
                                       part.patch.vertex.begin()));
    const auto take = [&](const Attempt& attempt) {
      return attempt.badness.isBetterThan(now) && surface_.accept(part, attempt.patch);
    };
    std::vector<Attempt> attempts;
    bool isDone = search.tryChanges(part.patch, place, take, attempts);
    for (std::size_t depth = 1; !isDone; ++depth) {
      PatchSearch::keepBest(attempts);
      isDone = std::any_of(attempts.begin(), attempts.end(), take);
      if (isDone || search.isSpent() || depth == (isLast_ ? kLastDepth : kDepth)) break;
      attempts = next(search, attempts, take, isDone);
    }
    work_ += search.work();
    if (isDone || search.isSpent()) noteChange(part.patch, pass);
    isAnyCut_ = isAnyCut_ || search.isSpent();
    return isDone;
  }

  void noteChange(const PolishPatch& before, int pass) {
    changedAt_.resize(surface_.points().size(), pass);
    for (const int v : before.vertex) changedAt_[v] = pass;
  }

  //! One more operation after the best of them.
  static std::vector<Attempt> next(PatchSearch& search, const std::vector<Attempt>& attempts,
                                   const PatchSearch::Take& take, bool& isDone) {
    std::vector<Attempt> all;
    for (std::size_t i = 0; !isDone && i < std::min(kBeam, attempts.size()); ++i) {
      const PolishPatch& patch = attempts[i].patch;
      if (const std::vector<int> place = search.worstPlace(patch); !place.empty())
        isDone = search.tryChanges(patch, place, take, all);
    }
    return all;
  }

  const PolishOptions& options_;
  WantedShape aim_;
  PolishedSurface surface_;
  std::vector<int> changedAt_;  // per vertex, the pass in which something around it was changed
  std::size_t work_ = 0, placeWork_ = kPlaceWork;
  bool isAnyCut_ = false;  // in this pass, the search at a place
  bool isLast_ = false;    // what is left is looked at longer
};

std::vector<int> sortedGenus(const Certificate& c) {
  std::vector<int> genus = c.genus;
  std::sort(genus.begin(), genus.end());
  return genus;
}

bool isAsGood(const Certificate& before, const Certificate& after) {
  return after.passes() && after.misplaced == before.misplaced && after.components == before.components &&
         after.cavities == before.cavities && sortedGenus(after) == sortedGenus(before);
}

std::vector<Vec3> worstOf(const std::vector<BadPlace>& places, std::span<const Vec3> points) {
  std::vector<Vec3> worst;
  for (std::size_t i = 0; i < std::min(kMaxLeft, places.size()); ++i) {
    Vec3 sum = Vec3::Zero();
    for (const int v : places[i].vertices) sum += points[v];
    worst.push_back(sum / static_cast<double>(places[i].vertices.size()));
  }
  return worst;
}

}  // namespace

PolishedMesh polished(const TriangleSoup& mesh, const PolishOptions& options) {
  const Phase phase("polishing");
  PolishedMesh out;
  out.report.limit = options.bounds.distance;
  Polisher polisher(mesh, options);
  const std::vector<BadPlace> bad = polisher.badPlaces(&out.report.before);
  out.report.after = out.report.before;
  if (bad.empty()) {
    out.mesh = mesh;
    return out;
  }
  polisher.run();
  out.report.isCutShort = polisher.isCutShort();
  TriangleSoup made = polisher.surface().compact();
  out.certificate = certify(made);
  out.report.isRefused = !isAsGood(examine(mesh), out.certificate);
  out.report.left = worstOf(bad, mesh.points);
  if (out.report.isRefused) {
    out.mesh = mesh;
    return out;
  }
  out.mesh = std::move(made);
  out.report.after = {};
  const std::vector<BadPlace> left = polisher.badPlaces(&out.report.after);
  out.report.left = worstOf(left, polisher.surface().points());
  out.report.changedFaces = polisher.surface().changedFaces();
  out.report.farthest = polisher.surface().farthest();
  return out;
}

PolishCount countBad(const TriangleSoup& mesh) {
  PolishCount count;
  Polisher(mesh, {}).badPlaces(&count);
  return count;
}

Finding polishWarning(const PolishReport& report) {
  const PolishCount& left = report.after;
  if (left.faces == 0 && left.edges == 0) return {};
  const Vec3 at = report.left.empty() ? Vec3(Vec3::Zero()) : report.left.front();
  const char* why = report.isCutShort  ? "there is too much to be done"
                    : report.isRefused ? "what it made was no valid mesh, and was not kept"
                                       : "to better them the surface would have to move farther than its "
                                         "limit, or to meet itself";
  std::string text = "polishing leaves " + counted(left.faces, "thin triangle") + " and " +
                     counted(left.edges, "sharp edge") + " (least angle of the mesh " +
                     numberText(left.leastAngle, 2) + " degrees, least dihedral angle " +
                     numberText(left.leastDihedral, 2) + "), the worst at " + numberText(at.x(), 4) + "," +
                     numberText(at.y(), 4) + "," + numberText(at.z(), 4) + ": " + why;
  return {FindingKind::polishLeaves,
          {{"thin_faces", left.faces},
           {"sharp_edges", left.edges},
           {"place", placeValue(at)},
           {"text", std::move(text)}}};
}

}  // namespace handlebody
