#include "core/evolution/pinned_parts.h"

#include <algorithm>
#include <limits>
#include <string>

#include "core/indices.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

// Longest edges: what is locked beyond the vertices that met, and by how much more when they meet all the
// same.
constexpr double kBeyond = 0.5;
constexpr double kGrowth = 0.25;

bool contains(const std::vector<Pin>& list, const Pin& pin) {
  return std::find(list.begin(), list.end(), pin) != list.end();
}

std::vector<int> verticesIn(const Mesh& mesh, const Pin& pin) {
  std::vector<int> out;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && (mesh.position(v) - pin.centre).squaredNorm() <= pin.radius * pin.radius)
      out.push_back(v);
  return out;
}

}  // namespace

const PinnedParts::Part* PinnedParts::partOf(const Pin& pin) const {
  const auto at = std::find_if(parts_.begin(), parts_.end(), [&](const Part& p) { return p.pin == pin; });
  return at == parts_.end() ? nullptr : &*at;
}

bool PinnedParts::choose(const std::vector<Pin>& pins, int iteration) {
  for (const Pin& p : pins)
    if (p.iteration < iteration && !partOf(p))
      throw Told<UsageError>(Finding(FindingKind::pinTooLate, {{"pin", written(p)}, {"now", iteration}}));
  const std::size_t before = parts_.size();
  std::erase_if(parts_, [&](const Part& p) { return !contains(pins, p.pin); });
  asked_ = pins;
  const bool isFreed = parts_.size() < before;
  if (isFreed) {
    forgetStops();
    makeMask();
  }
  return isFreed;
}

void PinnedParts::take(const Mesh& mesh, int iteration) {
  std::vector<Part> taken;
  for (const Pin& p : asked_) {
    if (p.iteration != iteration || partOf(p)) continue;
    taken.push_back({p, verticesIn(mesh, p), 0});
    if (taken.back().vertices.empty())
      throw Told<UsageError>(
          Finding(FindingKind::pinHoldsNothing, {{"pin", written(p)}, {"now", iteration}}));
  }
  if (taken.empty()) return;
  for (Part& part : taken)
    if (!partOf(part.pin)) parts_.push_back(std::move(part));  // not one that is asked for twice
  makeMask();
}

void PinnedParts::makeMask() {
  mask_ = nullptr;
  if (parts_.empty()) return;
  int last = 0;
  for (const Part& p : parts_) last = std::max(last, p.vertices.back());
  VertexMarks mask(idx(last) + 1, 0);
  for (const Part& p : parts_)
    for (const int v : p.vertices) mask[v] = 1;
  mask_ = std::make_shared<const VertexMarks>(std::move(mask));
}

void PinnedParts::reorder(std::span<const int> order) {
  if (parts_.empty()) return;
  const auto slots = std::max<std::size_t>(
      mask_->size(), order.empty() ? 0 : idx(*std::max_element(order.begin(), order.end())) + 1);
  std::vector<int> now(slots, -1);
  for (std::size_t i = 0; i < order.size(); ++i) now[order[i]] = static_cast<int>(i);
  for (Part& p : parts_) {
    for (int& v : p.vertices) v = now[v];
    std::sort(p.vertices.begin(), p.vertices.end());
  }
  makeMask();
}

std::optional<Vec3> PinnedParts::broken(const Mesh& before, const Mesh& mesh) const {
  if (!any()) return std::nullopt;
  for (const Part& part : parts_)
    for (const int v : part.vertices) {
      if (!mesh.isVertex(v) || mesh.position(v) != before.position(v)) return before.position(v);
      std::optional<Vec3> place;
      before.forEachOutgoing(v, [&](int h) {
        const int w = before.target(h), apex = before.apex(h);
        if (!holds(w) || !holds(apex) || !mesh.isVertex(w)) return;
        const int same = mesh.findHalfedge(v, w);
        if (same < 0 || mesh.apex(same) != apex) place = before.position(v);
      });
      if (place) return place;
    }
  return std::nullopt;
}

void PinnedParts::stop(const Mesh& mesh, const Vec3& place, double radius, double longest) {
  Part* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (Part& part : parts_)
    for (const int v : part.vertices)
      if (const double d = (mesh.position(v) - place).squaredNorm(); d < least) {
        least = d;
        nearest = &part;
      }
  if (nearest) ++nearest->stops;
  for (Stop& s : stops_)
    if ((s.centre - place).norm() < 0.5 * std::min(s.radius, radius)) {
      s.radius = std::max(s.radius + kGrowth * longest, radius + kBeyond * longest);
      return;
    }
  stops_.push_back({place, radius + kBeyond * longest});
}

void PinnedParts::takeStopsBack(const PinnedParts& before) {
  stops_ = before.stops_;
  for (std::size_t i = 0; i < parts_.size(); ++i) parts_[i].stops = before.parts_[i].stops;
}

bool PinnedParts::isLocked(const Vec3& p) const {
  return std::any_of(stops_.begin(), stops_.end(),
                     [&](const Stop& s) { return (p - s.centre).squaredNorm() < s.radius * s.radius; });
}

std::vector<PinnedPart> PinnedParts::list() const {
  std::vector<PinnedPart> out;
  for (const Pin& p : asked_) {
    const Part* part = partOf(p);
    out.push_back({p, part ? static_cast<int>(part->vertices.size()) : 0, part ? part->stops : 0});
  }
  return out;
}

std::optional<Pin> PinnedParts::waiting() const {
  for (const Pin& p : asked_)
    if (!partOf(p)) return p;
  return std::nullopt;
}

}  // namespace handlebody
