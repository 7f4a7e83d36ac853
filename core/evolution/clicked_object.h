#pragma once
// What the clicks mean (core/object), as the contour sees it.

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/evolution/constraints.h"
#include "core/evolution/first_object.h"

namespace handlebody {

//! The phase (phase.h) of the search.
inline constexpr const char* kFindingPhase = "finding what the clicks mean";

//! What the clicks may mean, whichever of it grows.
struct ObjectChoices {
  std::vector<ObjectCandidate> candidates;  //!< the likeliest first
  bool isCloseChoice = false;
};

//! The same, looked for when it is first asked for: where a boundary is meant, it takes most of the time of a
//! preparation, and the object does not depend on it. Any number of threads may ask.
class AskedChoices {
 public:
  explicit AskedChoices(ObjectChoices known) : found_(std::move(known)) {}
  explicit AskedChoices(std::function<ObjectChoices()> find) : find_(std::move(find)) {}
  //! Throws Cancelled (cancellation.h); it may be asked again then.
  const ObjectChoices& get() const;
  bool areKnown() const;

 private:
  mutable std::mutex guard_;
  mutable std::function<ObjectChoices()> find_;
  mutable std::optional<ObjectChoices> found_;
};

//! The image term of an object and what is told of it.
struct ClickedObject {
  std::shared_ptr<const ObjectImage> image;
  ObjectKind kind = ObjectKind::dark;
  IntensityRange range{};
  double smoothing = 0;   //!< mm
  double neckRadius = 0;  //!< mm: passages narrower than this are cut; 0 = none
  bool isCutOff = false;  //!< it ends where the search around the clicks did, and the volume goes on there
  std::shared_ptr<const AskedChoices> choices;
  int candidate = 1;
};

//! What earlier clicks found, so that one more takes no longer than itself (ObjectFinder). Any number of
//! threads may use it; one that would have to wait for another searches anew.
class ObjectMemory {
 public:
  //! As ObjectFinder::find.
  std::optional<ObjectModel> find(const Volume& volume, const ObjectQuery& query,
                                  std::shared_ptr<const FieldOfView> view);
  //! What one click alone means: what is `given`, if that is not null.
  std::shared_ptr<const FirstObject> first(const Volume& volume, const Seed& seed,
                                           const Parameters& parameters,
                                           const std::shared_ptr<const FieldOfView>& view,
                                           const std::shared_ptr<const RegionInCells>& given);

 private:
  struct KnownFirst {
    std::shared_ptr<const void> voxels;  // of the volume
    Seed seed;
    Parameters parameters;
    std::shared_ptr<const RegionInCells> given;
    std::shared_ptr<const FirstObject> object;
  };
  std::mutex guard_;
  ObjectFinder finder_;
  std::optional<KnownFirst> first_;
};

//! From clicks to the object: the strongest boundary around the seeds (object_range.h) where one has a radius
//! or the kind of object is given and the image shows it all around (boundary_evidence.h); else what the
//! first click means (first_object.h), corrected by the others. With a surface to begin with (`start`, may be
//! null) the first click is its deepest place, and means what it encloses (start_object.h); but where no
//! other is given and there is a clear boundary around it, of which the surface is no part (outlinesPart), it
//! means that. Throws as chooseObject; SeedError also if there is nothing but one intensity, or no image, at
//! the first click, and for clicks that contradict each other. `memory` may be null; the object does not
//! depend on it.
ClickedObject findClickedObject(const Volume& volume, const std::vector<Seed>& clicks,
                                const Parameters& parameters, ObjectMemory* memory = nullptr,
                                const StartSurface* start = nullptr);

}  // namespace handlebody
