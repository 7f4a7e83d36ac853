#pragma once
// Ways to better a patch: edges turned, short ones collapsed, long ones split, points moved along the surface.

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/polish/cover.h"
#include "core/polish/patch.h"

namespace handlebody {

//! A patch that was tried.
struct Attempt {
  Patch patch;
  Badness badness;
};

class PatchSearch {
 public:
  //! `surface`: the one that was there at first, around the patch; no point is put farther from it than
  //! `distance`. Both outlive it.
  PatchSearch(const WantedShape& wanted, std::span<const Corners> surface, double distance)
      : wanted_(wanted), surface_(surface), distance_(distance) {}

  //! Changes by one operation at the points of `place` (those of a bad face, or of the two of a bad edge), or
  //! by none, with points near by moved as is best: the kWidth best ones, whether better than the patch or
  //! not.
  std::vector<Attempt> changes(const Patch& patch, const std::vector<int>& place);
  //! The points of its worst face or edge within; none if nothing is bad.
  std::vector<int> worstPlace(const Patch& patch) const;
  //! Shapes that were looked at, for a budget.
  std::size_t work() const { return work_; }

  static constexpr std::size_t kWidth = 8;

 private:
  struct Trial {
    Patch patch;
    std::vector<int> touched;  // points whose place may be bettered
    double sum;                // of what is bad
  };
  void add(Patch patch, std::vector<int> touched, std::vector<Trial>& trials);
  void addTurns(const Patch& patch, int a, int b, std::vector<Trial>& trials);
  void addCollapses(const Patch& patch, int a, int b, std::vector<Trial>& trials);
  void addSplits(const Patch& patch, int a, int b, std::vector<Trial>& trials);
  void relax(Trial& trial);
  void move(Patch& patch, int v);
  std::vector<Vec3> places(const Patch& patch, int v, double step) const;
  bool moveByStep(Patch& patch, int v, double step, Badness& now);
  Vec3 onSurface(const Vec3& p) const;
  double distanceFromSurface(const Vec3& p) const;

  const WantedShape& wanted_;
  std::span<const Corners> surface_;
  double distance_;
  std::size_t work_ = 0;
};

//! To single precision, so that what is written is what was tried.
Vec3 inSingle(const Vec3& p);

}  // namespace handlebody
