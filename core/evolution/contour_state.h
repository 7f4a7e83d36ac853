#pragma once
// What a contour is between two steps, and what a step is made of. For the sources of ActiveContour alone:
// active_contour.cpp (steps), contour_request.cpp (what is asked for), contour_pins.cpp, contour_edits.cpp.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "core/collision/self_intersection.h"
#include "core/evolution/active_contour.h"
#include "core/evolution/clicked_object.h"
#include "core/evolution/collapsed_components.h"
#include "core/evolution/edit_step.h"
#include "core/evolution/leak_alarm.h"
#include "core/evolution/motion.h"
#include "core/evolution/object_image.h"
#include "core/evolution/quiet_vertices.h"
#include "core/evolution/resting_places.h"
#include "core/evolution/scratch.h"
#include "core/evolution/stillness.h"
#include "core/evolution/transaction.h"
#include "core/evolution/wall_guard.h"
#include "core/mesh/remesh.h"
#include "core/mesh/topology.h"
#include "core/surgery/topology_adaptation.h"

namespace handlebody {

// Of surgery in one step (units of WorkBudget).
inline constexpr std::size_t kStepWork = 120'000'000;
inline constexpr int kFitsIntoCache = 3000;  // vertices: any order of them will do

//! What the clicks mean; where there are none inside, what a start encloses.
ClickedObject objectOf(const Volume& volume, std::vector<Seed> seeds, const Parameters& parameters,
                       const std::optional<StartSurface>& start, ObjectMemory* memory);

struct ActiveContour::State {
  Mesh mesh;
  Scratch<Transaction> transaction;
  std::vector<unsigned char> quiet;  // iterations per vertex without motion, up to kQuietToSleep
  Volume volume;
  std::vector<Seed> seeds;  // as asked for
  Parameters requested;
  Constraints constraints;
  WallGuard walls;
  ClickedObject object;
  ResolvedParameters parameters;
  MotionSettings motion;
  RemeshLimits limits;
  Scratch<CollisionDetector> detector;
  RestingPlaces resting;
  HeldChanges held;  // what the constraints forbid
  PinnedParts pins;
  EditSchedule edits;
  CollapsedComponents collapsed;
  Stillness stillness;
  LeakAlarm alarm;
  std::optional<Correction> correction;
  double automaticEdge = 0;  // mm; what the edge length is if none is asked for
  TopologyNumbers topology;
  StopReason stop = StopReason::running;
  int iteration = 0;
  int orderedVertices = kFitsIntoCache;  // vertices when they were last put into order
  bool traces = false;
  WorkBudget work{kStepWork};

  //! True if parts of the surface may give ground: where that was asked for, or after other clicks.
  bool mayShrink() const { return !motion.outwardOnly || (correction && correction->givesGround); }
  bool sleeps(int v) const { return quiet[static_cast<std::size_t>(v)] >= kQuietToSleep; }

  void chooseEdge();
  void resolve(const Parameters& p);
  void start(const Parameters& p, const Constraints& c);
  //! `withStart`: with the surface that was given, if one was; else with spheres at the seeds.
  void begin(bool withStart);
  void beginWithStart();
  //! The object is a surface that was given, and nothing grows.
  bool isDone() const { return constraints.start && constraints.start->isDone; }
  std::vector<Seed> seedsInside() const;
  void startFrom(const Mesh& surface, bool holdTopology);
  void change(const Request& to, const State* prepared);
  void chooseWalls();
  void chooseForbidden();
  void splitLongEdges();
  void chooseSizes(const std::vector<Seed>& inside, bool anew);
  //! Of edges, in parts of the target.
  double sizeAt(const Vec3& p) const { return motion.sizes ? motion.sizes->at(p) : 1; }
  double longestAt(const Vec3& p) const { return sizeAt(p) * limits.longest; }
  void forgetRest();
  void correct();
  void beginAnew();
  void resolveSeeds(const std::vector<Seed>& inside);
  void keepOrder();
  Attempt attempt();
  std::vector<int> verticesToMove() const;
  void stopBeforeFlat(Attempt& a) const;
  void lookAtPins(Attempt& a) const;
  void takePins();
  void adapt(Attempt& a);
  void deleteCollapsed(Attempt& a);
  void accept(Attempt& a, StepReport& report);
  std::vector<HeldChange> judge(const Attempt& a, StepReport& report);
  void restRepeated(StepReport& report);
  Event rolledBack(const Vec3& place, Finding reason) const;
  void watch(const Attempt& kept, StepReport& report);
  void decideStop(const StepReport& report);
  StopReason restReason() const;
  bool leadsToEdit() const;
  Attempt editAttempt(const MeshEdit& edit);
  StepReport editStep(const MeshEdit& edit);
  void letSleep(const Attempt& edited);
  StepReport step();
  StepReport stepOrNothing();
};

}  // namespace handlebody
