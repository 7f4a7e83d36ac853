#pragma once
// Parts of the surface that stay as they are: which vertices the pins hold, and where fronts that came to
// them are locked.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/evolution/constraints.h"
#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! What a pin does now.
struct PinnedPart {
  Pin pin;
  int vertices = 0;  //!< that it holds; 0: its iteration has not come yet
  int stops = 0;     //!< how often a front was stopped before them
  bool operator==(const PinnedPart&) const = default;
};

class PinnedParts {
 public:
  //! From after `iteration` on. True if something that was held is free now. Throws UsageError for a pin of
  //! an iteration that is over, unless it has been known in time.
  bool choose(const std::vector<Pin>& pins, int iteration);
  //! The pins of this iteration take hold of the vertices in their balls. Throws UsageError if there are
  //! none, and nothing has changed then.
  void take(const Mesh& mesh, int iteration);
  //! After mesh.reorder(order).
  void reorder(std::span<const int> order);

  //! True if any vertex is held.
  bool any() const { return mask_ != nullptr; }
  bool holds(int vertex) const {
    return mask_ && static_cast<std::size_t>(vertex) < mask_->size() && (*mask_)[vertex] != 0;
  }
  //! Per vertex slot, as in Forbidden; null: none.
  const std::shared_ptr<const VertexMarks>& mask() const { return mask_; }
  //! A place where an attempt has changed what is held; none if all is as it was. `before`: what
  //! the attempt started from, with the same vertex slots.
  std::optional<Vec3> broken(const Mesh& before, const Mesh& mesh) const;

  //! A front came to what is held: it is locked within that many mm, and further when it comes again.
  //! `longest`: mm, of the mesh's edges; `mesh`: as it was before the front came.
  void stop(const Mesh& mesh, const Vec3& place, double radius, double longest);
  //! True where a front was stopped.
  bool isLocked(const Vec3& p) const;
  //! What was stopped may come again.
  void forgetStops() { stops_.clear(); }
  //! No front was stopped since `before`, a copy of this. The mesh may have been put into another order.
  void takeStopsBack(const PinnedParts& before);

  //! In the order in which they were asked for.
  std::vector<PinnedPart> list() const;
  //! The first pin whose iteration has not come yet.
  std::optional<Pin> waiting() const;

 private:
  struct Part {
    Pin pin;
    std::vector<int> vertices;  // ascending
    int stops;
  };
  struct Stop {
    Vec3 centre;
    double radius;  // mm
  };
  const Part* partOf(const Pin& pin) const;
  void makeMask();

  std::vector<Pin> asked_;
  std::vector<Part> parts_;
  std::vector<Stop> stops_;
  std::shared_ptr<const VertexMarks> mask_;
};

}  // namespace handlebody
