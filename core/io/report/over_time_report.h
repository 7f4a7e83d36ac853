#pragma once
// What is told of a surface over time: in the report, as a table and as a plot.

#include <map>
#include <string>
#include <vector>

#include "core/io/formats/time_axis.h"
#include "core/io/report/over_time_request.h"
#include "core/polish/polish.h"
#include "core/sequence/drift.h"
#include "core/sequence/over_time.h"
#include "core/sequence/volume_curve.h"

namespace handlebody {

struct OverTimeReport {
  OverTimeRequest request{};          //!< with its range
  TimeAxis times{};                   //!< of all time points of the volume
  std::vector<FrameResult> frames{};  //!< of the range, in its order
  VolumeCurve curve{};                //!< of them
  std::vector<Drift> drifts{};
  std::map<int, PolishReport> polish{};  //!< of the meshes by frame; empty: they are as they were carried
};

//! The volumes of these frames, each with its time where that is known.
VolumeCurve curveOf(const std::vector<FrameResult>& frames, const TimeAxis& times);

//! Sentences without a full stop, "frame 3: …": every fault, what polishing left (but in the frame that was
//! grown, whose own report tells it), a surface that was lost on its way back.
std::vector<std::string> overTimeWarnings(const OverTimeReport& report);

//! Without what may name the patient: paths, of walls in corrected frames and in what is told of frames.
OverTimeReport anonymous(OverTimeReport report);

//! The curve as CSV (RFC 4180, lines end in LF): frame, time_ms, volume_ml, phase (end-diastole,
//! end-systole), trusted, components, genus, iterations, from_frame, seconds, faults. Fields that are not
//! known are empty.
std::string curveCsv(const OverTimeReport& report);
//! The same as a plot: the volume (ml) over time (ms; over frames where no time is known).
std::string curveSvg(const OverTimeReport& report);

}  // namespace handlebody
