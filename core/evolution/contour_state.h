#pragma once
// What a contour is between two steps. For the sources of ActiveContour alone: active_contour.cpp (steps),
// contour_request.cpp (what is asked for) and keyframe.cpp (what is kept).

#include <optional>
#include <vector>

#include "core/evolution/active_contour.h"
#include "core/evolution/active_vertices.h"
#include "core/evolution/clicked_object.h"
#include "core/evolution/edit_step.h"
#include "core/evolution/leak_alarm.h"
#include "core/evolution/motion.h"
#include "core/evolution/restraints.h"
#include "core/evolution/step_transaction.h"
#include "core/evolution/stop_decision.h"
#include "core/evolution/wall_guard.h"
#include "core/mesh/remesh.h"
#include "core/mesh/topology.h"

namespace handlebody {

inline constexpr int kFitsIntoCache = 3000;  // vertices: any order of them will do

//! What the clicks mean; where there are none inside, what a start encloses.
ClickedObject objectOf(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& parameters,
                       const std::optional<StartSurface>& start, ObjectMemory* memory);

//! What putting the vertices into order changes, as it was before.
struct BeforeOrder {
  Mesh mesh;
  ActiveVertices active;
  PinnedParts pins;
  int orderedVertices;
};

//! What a contour is between two steps. Each part says what it owns; only here is it known how they are
//! joined.
struct ActiveContour::State {
  // What is asked for.
  Volume volume;
  Request asked;
  EditSchedule edits;  // of those that are asked for

  // What is chosen for that: how the surface moves, and where it may not.
  ClickedObject object;
  double automaticEdge = 0;  // mm; what the edge length is if none is asked for
  ResolvedParameters parameters;
  MotionSettings motion;
  RemeshLimits limits;
  WallGuard walls;

  // The surface, and what is known of it.
  Mesh mesh;
  TopologyNumbers topology;  // of the mesh
  int iteration = 0;
  int orderedVertices = kFitsIntoCache;  // vertices when they were last put into order
  std::optional<BeforeOrder> unordered;  // in a step that has put them into order
  ActiveVertices active;
  Restraints locked;
  StepTransaction transaction;
  StopDecision stop;
  LeakAlarm alarm;
  std::optional<Correction> correction;
  bool traces = false;

  //! True if parts of the surface may give ground: where that was asked for, or after other clicks.
  bool mayShrink() const { return !motion.outwardOnly || (correction && correction->givesGround); }
  //! The object is a surface that was given, and nothing grows.
  bool isDone() const { return asked.constraints.start && asked.constraints.start->isDone; }
  std::vector<Seed> seedsInside() const;
  StepScene scene();
  StopFacts facts() const;

  // contour_request.cpp: what is asked for, at first and on the way
  void start(Request request);
  void startFrom(const Mesh& surface, bool holdTopology);
  void change(const Request& to, const State* prepared);
  void chooseEdge();
  void resolve();
  void chooseWalls();
  void chooseForbidden();
  std::shared_ptr<const SizeField> sizesFor(const std::vector<Seed>& inside) const;
  void chooseSizes(const std::vector<Seed>& inside, bool anew);
  void splitLongEdges();
  //! `withStart`: with the surface that was given, if one was; else with spheres at the seeds.
  void begin(bool withStart);
  void beginWithStart();
  void beginAnew();
  void resolveSeeds(const std::vector<Seed>& inside);
  void forgetLocks();
  void correct();

  // active_contour.cpp: steps
  StepReport stepOrNothing();
  StepReport step();
  StepReport editStep(const MeshEdit& edit);
  StepReport waitingStep();
  void keepOrder();
  void takeOrderBack();
  void accept(const Attempt& a, StepReport& report);
  void watch(const Attempt& kept, StepReport& report);
  void finish(StepReport& report);
  void releaseWalls();
  void takePins();
};

}  // namespace handlebody
