#pragma once
// The active contour: seeds grow into the object; each step is a transaction that leaves a certified mesh.

#include <memory>
#include <string>
#include <vector>

#include "core/evolution/correction.h"
#include "core/evolution/held_changes.h"
#include "core/evolution/image_warnings.h"
#include "core/evolution/parameters.h"
#include "core/evolution/pinned_parts.h"
#include "core/evolution/step_report.h"
#include "core/mesh/mesh.h"
#include "core/object/candidate.h"
#include "core/volume/volume.h"

namespace handlebody {

class AskedChoices;  // clicked_object.h
class ObjectMemory;

//! Grows a closed surface from seeds in a volume. The same volume, seeds, parameters and version give the
//! same mesh, bit for bit, with any number of threads.
class ActiveContour {
 public:
  //! Resolves the automatic parameters from the image around the seeds and makes the seed spheres, or takes
  //! the surface of Constraints::start in their place; without a seed the image around a place within it.
  //! `memory`: of earlier contours in the volume, which makes this one quicker and changes nothing else.
  //! Throws SeedError (seed outside the volume or not in an object), UsageError (a parameter without meaning,
  //! a range without voxels, a wall outside of the volume, a start in a wall or that meets an object of them,
  //! a pin of iteration 0 without a vertex), Cancelled (cancellation.h).
  ActiveContour(Volume volume, std::vector<Seed> seeds, Parameters parameters,
                const Constraints& constraints = {}, ObjectMemory* memory = nullptr);
  ~ActiveContour();
  ActiveContour(ActiveContour&&) noexcept;
  ActiveContour& operator=(ActiveContour&&) noexcept;
  //! A copy goes on exactly as the original would, bit for bit. The image is shared: what a copy costs is the
  //! mesh.
  ActiveContour(const ActiveContour&);
  ActiveContour& operator=(const ActiveContour&);

  //! One iteration, all or nothing: the mesh it leaves is closed, manifold, oriented and free of
  //! self-intersections. Throws UsageError if a veto of that iteration finds no change of topology, or a pin
  //! no vertex; no further step may be taken then. An edit of that iteration (mesh_edit.h) is made in place
  //! of motion; if it finds nothing, would change what is pinned, or what it would leave is not certain to be
  //! valid, UsageError, and the contour is as it was before the step. Throws Cancelled (cancellation.h)
  //! within some 20 ms after the stop token is set; the contour is as it was before the step.
  StepReport step();

  //! Goes on with other clicks and parameters from here. What is automatic is chosen as for a new contour;
  //! the mesh and the seeds' radii stay. With other parameters alone everything that has converged or is
  //! locked becomes active, unless only the iterations or threads have changed. With other clicks the
  //! automatic edge length stays too, and what has converged where the new image has the boundary stays so;
  //! elsewhere the surface grows, or gives ground, and its components are corrected (correction.h). If it has
  //! next to nothing in common with the new object it begins anew, at the same iteration: correction() tells.
  //! Throws as the constructor, and nothing has changed then. Walls may not be put where the surface is,
  //! unless it may move in both directions and crosses them (UsageError otherwise); objects never. What is
  //! pinned neither moves nor goes; a surface that would have to begin anew may not be pinned (UsageError). A
  //! pin of this iteration holds from here on.
  void change(const Request& request);
  //! The same with what `prepared` was made from, whose image is taken over where it would be chosen again.
  //! Precondition: it was made for the same volume.
  void change(const ActiveContour& prepared);
  //! The clicks and the constraints stay.
  void changeParameters(const Parameters& parameters) {
    change({requestedSeeds(), parameters, constraints()});
  }
  //! What came of the last change of the clicks; none if they have not been changed.
  const std::optional<Correction>& correction() const;
  //! A new contour at iteration 0 for the same volume and seeds. Quick if both choose the same image. Throws
  //! as the constructor.
  ActiveContour restarted(const Parameters& parameters, const Constraints& constraints) const;

  //! Puts `mesh` in the place of the spheres at the seeds: the surface of another time point, say. With
  //! `holdTopology` no step changes its topology; places that would are held (held()). Preconditions: no step
  //! was made yet and nothing is pinned; the mesh is closed, oriented, without intersections, and its edges
  //! are those of this edge length. Throws UsageError if it lies in a wall.
  void startFrom(const Mesh& mesh, bool holdTopology);

  //! StopReason::running while step() would go on.
  StopReason stopReason() const;
  int iteration() const;
  const Mesh& mesh() const;
  const Grid& grid() const;
  const ResolvedParameters& parameters() const;
  //! The object that the surface is driven into, as it sees it; the walls are outside of it.
  std::shared_ptr<const ObjectImage> image() const;
  //! As asked for: with what was left to the image still open.
  const Parameters& requested() const;
  const std::vector<Seed>& requestedSeeds() const;
  const Constraints& constraints() const;
  //! The first veto whose iteration has not come yet.
  std::optional<Veto> waitingVeto() const;
  //! The first edit that has not been made. While there is one, a contour at rest goes on for it; one at the
  //! limit of its iterations does only if the next step is that edit.
  std::optional<MeshEdit> waitingEdit() const;
  //! What the constraints hold back now.
  std::vector<HeldPlace> held() const;
  //! What the pins hold now.
  std::vector<PinnedPart> pinned() const;
  //! The first pin whose iteration has not come yet.
  std::optional<Pin> waitingPin() const;
  //! What it goes on with.
  Request request() const { return {requestedSeeds(), requested(), constraints()}; }
  //! The objects that the clicks may mean, the likeliest first; at most five. `parameters().candidate` is the
  //! one that grows. Empty with a given range. Where a seed with a radius or the kind of object says what is
  //! meant, they are looked for when they are first asked for: that takes longer than everything before.
  const std::vector<ObjectCandidate>& candidates() const;
  //! True if the first candidate is hardly likelier than another one.
  bool isCloseChoice() const;
  //! What both tell, to be asked for on another thread while this one goes on.
  std::shared_ptr<const AskedChoices> choices() const;
  //! True if the vertex has not moved for some iterations and is not asked to any more. Precondition:
  //! mesh().isVertex(vertex).
  bool isConverged(int vertex) const;
  //! True if a pin holds the vertex. Precondition: the same.
  bool isPinned(int vertex) const;
  //! Bytes of a copy that are its own: not the image.
  std::size_t memory() const;
  //! Where the image shows an edge at the surface as it is now, and where none. Of no face where the surface
  //! is not the image's (StartSurface::isDone).
  SurfaceSupport support() const;
  //! What in the image speaks against the surface as it is now (image_warnings.h), and once it has ended the
  //! clicks that it does not heed. `support`: of the surface as it is now.
  std::vector<Finding> warnings(const SurfaceSupport& support) const;
  //! Traces of events are recorded from the next step on. Off by default.
  void recordTraces(bool on);

 private:
  friend class Keyframe;  // keeps the mesh in another form
  struct State;
  explicit ActiveContour(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace handlebody
