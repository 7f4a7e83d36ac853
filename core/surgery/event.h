#pragma once
// A change of the mesh that somebody may question: what happened, where, and the topology before and after.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/finding.h"
#include "core/geometry/vec.h"
#include "core/mesh/topology.h"

namespace handlebody {

enum class EventKind {
  handleInserted,      //!< k fronts joined
  split,               //!< a neck was cut: two components
  enclosedPartCutOff,  //!< a part wholly inside a collision was cut off and capped
  tunnelClosed,        //!< a cut that did not separate: the genus fell by one
  componentDeleted,    //!< a component collapsed or lay wholly in a collision
  handleCut,           //!< an edit: a handle was cut through, the genus fell by one
  componentRemoved,    //!< an edit: a body went, or what lay in a cavity that was filled
  cavityFilled,        //!< an edit
  planeCut,            //!< an edit: cut flat, both sides capped
  surfaceSmoothed,     //!< an edit: smoothed in a ball
  surfacePulled,       //!< an edit: a place pulled somewhere else
  smoothed,            //!< a fold was smoothed away
  rolledBack,          //!< a part returned to its position before the step
};
//! "handle inserted", "split" … as in the report.
const char* eventKindName(EventKind kind);
//! False for repairs (a fold that was smoothed away, a part that was rolled back) and for edits that only
//! move the surface.
bool changesTopology(EventKind kind);

//! Where the handle was found that joins fronts, or the band that joins the polygons of one.
enum class HandleSource {
  none,      //!< no handle: caps, or nothing
  database,  //!< told by the handle database
  search,    //!< sizes that it does not list, or lengths that do not tell
};

//! The stages of a change of topology (the paper's Figures 1 and 7), in mm; recorded only on request.
struct EventTrace {
  std::vector<std::array<Vec3, 3>> collidingFaces;  //!< as they met, before any refinement
  std::vector<std::vector<Vec3>> lambda;            //!< the sets Λ, one list of vertex positions each
  //! The mesh near the place with new vertices on the middles of the edges around Λ; empty if no opening
  //! needed them.
  std::vector<std::array<Vec3, 3>> refinedFaces;
  std::vector<std::array<Vec3, 3>> openedFaces;  //!< M_b near the place
  std::vector<std::vector<Vec3>> boundaryLoops;  //!< the boundary polygons of M_b
  std::vector<std::array<Vec3, 3>> handleFaces;  //!< K (handle or caps)
  std::vector<std::array<Vec3, 3>> closedFaces;  //!< M_c near the place
};

//! What is told of a change that somebody asked for (mesh_edits.h).
struct EditMeasures {
  double loop = 0;                           //!< length of the loop that was cut along, mm; 0: none was
  double volumeBefore = 0, volumeAfter = 0;  //!< of the whole mesh, mm³
};

struct Event {
  EventKind kind = EventKind::smoothed;
  int iteration = 0;
  Vec3 location{0, 0, 0};      //!< mm
  int fronts = 0;              //!< k, for handles
  std::vector<int> loopSizes;  //!< vertices of each boundary polygon
  HandleSource handleFrom = HandleSource::none;
  TopologyNumbers before;
  //! What the change predicts (predicted_change.h). A step that ends with other numbers, counted on its mesh,
  //! is rolled back: in an event of a step that was kept these are the true ones.
  TopologyNumbers after;
  std::vector<Finding> reasons;        //!< why it was rolled back, or what did not fit before this
  std::optional<EventKind> held{};     //!< rolled back: the change that may not happen, as the user asked
  std::optional<EditMeasures> edit{};  //!< it is an edit, no change that the surface made by itself
  //! By the vertex slots of the mesh: the faces of the handle, or those that collided and were rolled back.
  //! Of a later step they tell where such faces have come to, as long as their vertices are there.
  std::vector<Triangle> faces{};
  EventTrace trace;  //!< empty unless traces are recorded
};
//! True if faces were taken out and made. Folds that were smoothed away by moving their vertices are no
//! surgery.
bool hasSurgery(std::span<const Event> events);

}  // namespace handlebody
