#pragma once
// Ways to better a patch: edges turned, short ones collapsed, long ones split, points moved along the
// surface.

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/polish/cover.h"
#include "core/polish/patch.h"

namespace handlebody {

//! A patch that was tried.
struct Attempt {
  PolishPatch patch;
  Badness badness;
  bool isNear = false;  //!< by some points of it: it seems to stay within the distance of the first surface
};

class PatchSearch {
 public:
  //! `surface`: the one that was there at first, around the patch; no point is put farther from it than
  //! `distance`. What is given outlives it.
  PatchSearch(const WantedShape& wanted, const PolishPatch& patch, std::span<const Corners> surface,
              double distance, std::size_t mostWork);

  //! True if it was what was looked for.
  using Take = std::function<bool(const Attempt&)>;
  //! Changes by one operation at the points of `place` (those of a bad face, or of the two of a bad edge), or
  //! by none, with points near by moved as is best. Each after which nothing is bad and that seems to stay
  //! near the surface is offered at once; true, and it ends, if it was taken. Adds the others to `attempts`,
  //! whether better than the patch or not.
  bool tryChanges(const PolishPatch& patch, const std::vector<int>& place, const Take& take,
                  std::vector<Attempt>& attempts);
  //! The points of its worst face or edge within; none if nothing is bad.
  std::vector<int> worstPlace(const PolishPatch& patch) const;
  //! Shapes that were looked at, for a budget.
  std::size_t work() const { return work_; }
  //! The budget is: what is left was not tried.
  bool isSpent() const { return work_ > mostWork_; }

  static constexpr std::size_t kWidth = 12;
  //! The kWidth best ones; those that seem to stay near the surface before the others.
  static void keepBest(std::vector<Attempt>& attempts);

 private:
  struct Trial {
    PolishPatch patch;
    std::vector<int> touched;  // points whose place may be bettered
    double sum;                // of what is bad
  };
  void add(PolishPatch patch, std::vector<int> touched, std::vector<Trial>& trials);
  void addTurns(const PolishPatch& patch, int a, int b, std::vector<Trial>& trials);
  void addCollapses(const PolishPatch& patch, int a, int b, std::vector<Trial>& trials);
  void addSplits(const PolishPatch& patch, int a, int b, std::vector<Trial>& trials);
  std::vector<Trial> trialsAt(const PolishPatch& patch, const std::vector<int>& place);
  Attempt relaxed(Trial trial, double reach);
  void move(PolishPatch& patch, int v);
  std::vector<Vec3> places(const PolishPatch& patch, int v, double step) const;
  bool moveByStep(PolishPatch& patch, int v, std::span<const PolishPatch::Shape> shapes, double step,
                  Badness& now);
  bool staysNear(const PolishPatch& patch, int v, double radius) const;
  bool isNear(const PolishPatch& patch) const;
  bool isFaceNear(const Corners& face) const;
  Vec3 onSurface(const Vec3& p) const;
  double distanceFromSurface(const Vec3& p) const;

  const WantedShape& wanted_;
  std::span<const Corners> surface_;
  double distance_;
  double reach_ = 0;  // mm, how near points are kept now
  struct Ball {
    Vec3 centre;
    double radius;
  };
  std::vector<Ball> balls_;    // around each triangle of the first surface
  std::vector<Vec3> covered_;  // points of the first surface that the patch was near to
  std::size_t work_ = 0, mostWork_;
};

//! To single precision, so that what is written is what was tried.
Vec3 inSingle(const Vec3& p);

}  // namespace handlebody
