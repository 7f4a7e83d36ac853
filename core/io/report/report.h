#pragma once
// The report of a run: what went in, how it was done, what came out, and every change of topology.

#include <optional>
#include <string>
#include <vector>

#include "core/evolution/correction.h"
#include "core/evolution/held_changes.h"
#include "core/evolution/leak_alarm.h"
#include "core/evolution/pinned_parts.h"
#include "core/evolution/step_report.h"
#include "core/io/report/over_time_report.h"
#include "core/io/report/session.h"
#include "core/measure/object_measures.h"
#include "core/measure/surface_gap.h"
#include "core/mesh/tunnels.h"
#include "core/mesh/validity.h"
#include "core/object/candidate.h"
#include "core/polish/polish.h"
#include "core/sensitivity/sensitivity.h"

namespace handlebody {

//! Wall-clock seconds.
struct Timings {
  double load = 0;         //!< reading and hashing the volume
  double prepare = 0;      //!< automatic parameters, smoothing, seed spheres
  double evolve = 0;       //!< all iterations
  double exported = 0;     //!< certificate and files
  double tunnels = 0;      //!< listing them, for the report
  double sensitivity = 0;  //!< the perturbed runs
  double total = 0;
};

//! What was done at a leak.
enum class LeakAnswer { goOn, stop, wall };

struct ToldLeak {
  Leak leak;
  LeakAnswer answer = LeakAnswer::goOn;
};

struct RunReport {
  Session session;                          //!< with `resolved` set
  std::vector<ObjectCandidate> candidates;  //!< of the contour as it began, as `resolved`
  bool isCloseChoice = false;               //!< the same
  VolumeInfo volume;                        //!< its grid and where that comes from, warnings
  //! About the result: hardly grown, a close choice, much of it on the volume's border.
  std::vector<Finding> warnings;
  //! Part of the surface where the image shows no edge; none if it was not compared with the image.
  std::optional<double> unsupportedSurface{};
  int iterations = 0;
  StopReason stopped = StopReason::running;
  Timings seconds;
  Certificate mesh;                          //!< of the exported mesh
  std::optional<TunnelList> tunnels{};       //!< of it, where they were looked for
  std::optional<ObjectMeasures> measures{};  //!< the same
  std::optional<PolishReport> polish{};      //!< what was bettered of it, where that was asked for
  std::optional<Sensitivity> sensitivity{};  //!< of it, where that was asked for
  std::optional<OverTimeReport> overTime{};  //!< where it was carried through other frames
  std::vector<Event> events;
  std::vector<ToldLeak> leaks{};                //!< in the order in which they came
  bool isStoppedAtLeak = false;                 //!< the mesh is that of before the last of them
  std::vector<HeldPlace> questions{};           //!< what was held and asked about, in the order of coming
  bool isStoppedToAsk = false;                  //!< the last of them was for somebody to answer
  std::vector<HeldPlace> held;                  //!< in the end
  std::vector<PinnedPart> pinned;               //!< the same
  std::vector<RecordedCorrection> corrections;  //!< what came of clicks that were changed on the way
};

//! What somebody has answered where a change was held: it may happen, it stays held, or nothing.
enum class HeldAnswer { none, allow, hold };

//! As the session tells, in its first request or a change on the way.
HeldAnswer answerTo(const HeldPlace& question, const Session& session);

//! Why a growth ended, as in the report: stopReasonName, "leak" where it stopped before one, "held" where it
//! stopped for somebody to decide, and "stop-at" where it was asked to end there.
const char* endName(const RunReport& report);

//! One for every leak.
std::vector<Finding> leakWarnings(const RunReport& report);

//! The same for every question without an answer, with the options that answer it.
std::vector<Finding> questionWarnings(const RunReport& report);

//! One for every pin whose iteration was never reached.
std::vector<Finding> pinWarnings(const RunReport& report);

//! Without what may name the patient: as the session's, and without the names of files and series that
//! warnings of the volume list.
RunReport anonymous(RunReport report);

//! The report as JSON text, without the traces of the events.
std::string reportText(const RunReport& report);

//! The events with their traces as JSON text.
std::string traceText(const RunReport& report);

//! Both for several objects of one volume, in the order in which they were grown: "objects" holds what is
//! told of one, after its name, label value, colour and term; "distances" how near they come to each other,
//! if `gaps` tells it; "seconds" those of the whole run. Precondition: there is one at least; gaps are of
//! them, by index.
std::string reportText(const std::vector<RunReport>& objects, const Timings& seconds,
                       const std::vector<PairGap>& gaps = {});
std::string traceText(const std::vector<RunReport>& objects);

}  // namespace handlebody
