#pragma once
// From clicks to the object that is meant.

#include <memory>
#include <optional>
#include <vector>

#include "core/object/candidate.h"
#include "core/object/corrections.h"
#include "core/object/intensity_scale.h"

namespace handlebody {

//! A click as the search takes it.
struct ObjectClick {
  Vec3 place{0, 0, 0};             //!< mm, LPS
  std::optional<double> radius{};  //!< mm
};

enum class Contrast { any, dark, bright };  //!< of the object against what is around it

//! What is looked for.
struct ObjectQuery {
  //! The first inside one decides, the others correct. Of either side in the order given: what a click has
  //! changed stays as it is when another one of its side is added.
  std::vector<ObjectClick> inside, outside;
  int candidate = 1;  //!< 1 = the likeliest
  Contrast contrast = Contrast::any;
  int threads = 1;
  //! What the first click means, where that is known, and there are no candidates; null: it is looked for.
  std::shared_ptr<const RegionInCells> given{};
  //! What the candidate has become in the image, where that is not the region that was found: the further
  //! clicks correct this. May be null.
  std::shared_ptr<const RegionInCells> shown{};
};

//! The object around clicks, and what else they may mean.
class ObjectModel {
 public:
  //! The first is the likeliest; each with the further clicks taken in only if it was chosen.
  std::vector<ObjectCandidate> candidates;
  int chosen = 1;              //!< of them
  bool isCloseChoice = false;  //!< another one is about as likely
  IntensityScale scale;        //!< of `work`, `level` and `noise`
  std::shared_ptr<const WorkImage> work;
  Region region;             //!< what was chosen, corrected by the clicks
  bool isCutOff = false;     //!< it ends where the cells of `work` do, and the volume goes on there
  bool isCorrected = false;  //!< further clicks, or the balls around them, have changed it
  Region start;              //!< what it was before they did; empty if they did not
  //! All but the first, in the order given on each side; with the radii of balls outside.
  std::vector<ObjectClick> clicks;
  double neckRadius = 0;     //!< mm: narrower passages are cut
  bool isGiven = false;      //!< as the query said, not as the image says
  bool isStar = false;       //!< chosen by its shape, where the image alone did not say where to end
  double low = 0, high = 0;  //!< intensities: bounds of what was chosen
  double rise = 0;           //!< > 0: darker than what lies just outside
  double level = 0;          //!< at the first click
  double noise = 0;          //!< standard deviation there
};

//! Finds what clicks mean, and keeps what was found on the way: for one more click in the same volume only
//! what that click changes is looked for. What it finds does not depend on what it was asked before.
class ObjectFinder {
 public:
  explicit ObjectFinder(const ObjectPolicy& policy = {});
  ~ObjectFinder();
  //! None if the image is constant around the first click, or holds no image there; `view` may be null.
  //! Precondition: at least one click inside; all lie in the volume. Throws Cancelled (cancellation.h); it
  //! may be asked again then.
  std::optional<ObjectModel> find(const Volume& volume, const ObjectQuery& query,
                                  std::shared_ptr<const FieldOfView> view);

 private:
  class Search;
  ObjectPolicy policy_;
  std::unique_ptr<Search> search_;
};

//! The same once.
std::optional<ObjectModel> findObject(const Volume& volume, const ObjectQuery& query, const FieldOfView* view,
                                      const ObjectPolicy& policy = {});

}  // namespace handlebody
