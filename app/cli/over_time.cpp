#include "app/cli/over_time.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "app/cli/command.h"
#include "app/cli/frame_files.h"
#include "app/picture/picture.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/report/option_error.h"
#include "core/io/report/over_time_report.h"
#include "core/io/report/parse.h"
#include "core/io/report/polished_export.h"
#include "core/io/report/polished_frames.h"
#include "core/io/report/result.h"
#include "core/io/report/single_precision.h"
#include "core/mesh/validity.h"
#include "core/sequence/cycle_check.h"

namespace handlebody::cli {

namespace {

using Text = const std::string&;

OverTimeRequest::Range parseRange(Text text) {
  const auto dash = text.find('-');
  if (dash == std::string::npos || dash == 0)
    throw OptionError("--frames", "'" + text + "' is neither 'all' nor a range A-B.");
  const int most = std::numeric_limits<int>::max();
  const int first = parseInteger("--frames", text.substr(0, dash), 0, most);
  return {first, parseInteger("--frames", text.substr(dash + 1), first, most)};
}

template <typename Set>
void addOther(CLI::App& command, OverTimeOptions& o, Text name, Text type, Text help, Set set) {
  command
      .add_option_function<std::string>(
          name,
          [&o, name, set](Text text) {
            if (o.firstOther.empty()) o.firstOther = name;
            set(o.others, text);
          },
          help)
      ->type_name(type);
}

void setTopology(OverTimeRequest& r, Text text) {
  if (text != "held" && text != "free")
    throw OptionError("--topology", "'" + text + "' is not held or free.");
  r.holdTopology = text == "held";
}

void setDrift(OverTimeRequest& r, Text text) {
  if (text == "none")
    r.drift = DriftCheck::none;
  else if (text == "back")
    r.drift = DriftCheck::back;
  else if (text == "wrap")
    r.drift = DriftCheck::wrap;
  else
    throw OptionError("--drift-check", "'" + text + "' is not back, wrap or none.");
}

void setFrameTime(OverTimeRequest& r, Text text) {
  r.frameTime = parseNumber("--frame-time", text);
  if (!(*r.frameTime > 0) || !std::isfinite(*r.frameTime))
    throw OptionError("--frame-time", "'" + text + "' is not a finite number above 0.");
}

}  // namespace

void addCurve(CLI::App& command, OverTimeOptions& options) {
  command
      .add_option(
          "--curve", options.curves,
          "Over time: volume of each frame as a table (.csv) or a plot (.svg); may be given several times")
      ->type_name("F")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

void addOverTime(CLI::App& command, OverTimeOptions& options) {
  const auto setFrames = [&options](Text text) {
    options.request.emplace();
    if (text != "all") options.request->frames = parseRange(text);
  };
  command
      .add_option_function<std::string>("--frames", setFrames,
                                        "Of a 4D volume: grow in --frame (default: the first of these) and "
                                        "carry the surface through all of "
                                        "them; meshes are numbered, a label map (.nii.gz .nii .nrrd) is 4D")
      ->type_name("all|A-B");
  addOther(command, options, "--topology", "held|free",
           "With --frames: the topology of the first surface is held in all (default), or free", setTopology);
  addOther(
      command, options, "--drift-check", "back|wrap|none",
      "With --frames: carry the surface back from the ends to --frame and tell how far it is off (default), "
      "or, in a cycle, from the last frame to the first (wrap)",
      setDrift);
  addOther(command, options, "--frame-time", "MS",
           "With --frames: time between frames, for a file that does not say it", setFrameTime);
  addCurve(command, options);
}

std::optional<OverTimeRequest> requestOf(const OverTimeOptions& o) {
  if (!o.request) {
    if (!o.firstOther.empty()) throw UsageError(o.firstOther + " needs --frames.");
    if (!o.curves.empty()) throw UsageError("--curve needs --frames.");
    return std::nullopt;
  }
  OverTimeRequest request = o.others;
  request.frames = o.request->frames;
  return request;
}

void chooseFrame(Session& session) {
  const auto& range = session.overTime->frames;
  std::optional<int>& frame = session.volume.selection.frame;
  if (!frame) frame = range ? range->first : 0;
  if (range && (*frame < range->first || *frame > range->last))
    throw UsageError("--frame " + std::to_string(*frame) + " is not one of --frames " +
                     std::to_string(range->first) + "-" + std::to_string(range->last) + ".");
}

void checkOverTime(const Session& session, const RunOutputs& outputs, const OverTimeOptions& options,
                   const std::vector<std::string>& inputs) {
  const VolumeInfo info = inspectVolume(session.volume.path, session.volume.selection);
  const OverTimeRequest::Range range =
      session.overTime->frames.value_or(OverTimeRequest::Range{0, info.frames - 1});
  if (info.frames < 2)
    throw UsageError(session.volume.path + ": --frames is for a 4D volume; this has one time point.");
  if (range.last >= info.frames)
    throw UsageError(session.volume.path + ": there is no frame " + std::to_string(range.last) +
                     "; it has the frames 0 to " + std::to_string(info.frames - 1) + ".");
  checkFrameFiles(outputs, options.curves, range, inputs);
}

namespace {

//! What the session asks for in the end.
Request finalRequest(const Session& session) {
  Request request{session.seeds, session.requested, session.constraints};
  for (const ParameterChange& change : session.changes) request = changed(request, change);
  return request;
}

TimeAxis timesOf(const Session& session, int frames) {
  if (session.overTime->frameTime)
    return evenTimes(frames, *session.overTime->frameTime, "given by the user");
  return readTimeAxis(session.volume.path, session.volume.selection);
}

Volume loadFrame(const VolumeReference& reference, int frame) {
  VolumeSelection selection = reference.selection;
  selection.frame = frame;
  return readVolume(reference.path, selection);
}

//! As it is carried: before any polish, so that neither growth nor what is told of it depends on that.
FrameResult grownFrame(const GrownObject& grown) {
  FrameResult result;
  result.frame = *grown.report.session.volume.selection.frame;
  result.mesh = grown.unpolished.mesh;
  result.volume = grown.unpolished.certificate.volume;
  result.components = grown.unpolished.certificate.components;
  for (const int g : grown.unpolished.certificate.genus) result.genus += g;
  result.iterations = grown.report.iterations;
  result.stopped = grown.report.stopped;
  result.seconds = grown.report.seconds.load + grown.report.seconds.prepare + grown.report.seconds.evolve;
  for (const ToldLeak& leak : grown.report.leaks)  // before the first of them it may have been stopped
    if (leak.answer != LeakAnswer::wall && leak.leak.iteration <= result.iterations)
      result.faults.push_back(leakFault(leak.leak));
  for (ToldFault& f : faultsAtEnd(result.stopped, grown.report.held)) result.faults.push_back(std::move(f));
  return result;
}

//! The frames of a run, and what comes of them.
class OverTimeRun {
 public:
  OverTimeRun(const GrownObject& grown, OverTimeReport& report, bool quiet)
      : session_(grown.report.session),
        report_(report),
        start_(grownFrame(grown)),
        edgeLength_(session_.resolved->edgeLength),
        carrier_({finalRequest(session_), edgeLength_, session_.resolved->smoothing,
                  session_.overTime->holdTopology, start_.frame, session_.overTime->corrections},
                 {[this](int frame) { return loadFrame(session_.volume, frame); },
                  [](const TriangleSoup& mesh) { return certifiedForExport(mesh).mesh; }}),
        quiet_(quiet) {}

  void carry() {
    const auto [first, last] = *report_.request.frames;
    std::vector<FrameResult> before = carryThrough(carrier_, start_, first, told());
    std::reverse(before.begin(), before.end());
    report_.frames = std::move(before);
    report_.frames.push_back(start_);
    for (FrameResult& r : carryThrough(carrier_, start_, last, told()))
      report_.frames.push_back(std::move(r));
    report_.curve = curveOf(report_.frames, report_.times);
    report_.drifts = checkCycle(carrier_, report_.frames, start_, report_.request.drift, edgeLength_);
  }

  //! The meshes as they are written. That of the frame that was grown is polished already.
  void polish(const GrownObject& grown) {
    if (!grown.report.polish) return;
    for (FrameResult& r : report_.frames)
      if (r.frame == start_.frame) r.mesh = grown.mesh;
    report_.polish[start_.frame] = *grown.report.polish;
    polishFrames(report_);
  }

 private:
  std::function<void(const FrameResult&)> told() const {
    return [this](const FrameResult& r) {
      if (quiet_) return;
      std::fprintf(stderr, "frame %d: %.4g ml, %d iterations from frame %d (%.2f s)%s\n", r.frame,
                   r.volume / 1000, r.iterations, *r.from, r.seconds, r.isTrusted() ? "" : ", failed");
    };
  }

  const Session& session_;
  OverTimeReport& report_;
  FrameResult start_;
  double edgeLength_;
  FrameCarrier carrier_;
  bool quiet_;
};

void printOverTime(const OverTimeReport& report) {
  const VolumeCurve& c = report.curve;
  if (c.endDiastole) {
    const VolumePoint &d = c.points[*c.endDiastole], &s = c.points[*c.endSystole];
    std::printf(
        "over %zu frames: end-diastole %.4g ml (frame %d), end-systole %.4g ml (frame %d), stroke volume "
        "%.4g ml, ejection fraction %.1f %%\n",
        c.points.size(), *d.volume / 1000, d.frame, *s.volume / 1000, s.frame, c.strokeVolume / 1000,
        100 * c.ejectionFraction);
  }
  if (const std::string text = polishText(together(report.polish)); !text.empty())
    std::printf("over %zu frames, %s\n", report.polish.size(), text.c_str());
  for (const Drift& d : report.drifts)
    if (d.isBack)
      std::printf(
          "from frame %d back at frame %d: Dice %.4f, %.3g mm (95 %% of it less than %.3g), volume %+.2f "
          "%%\n",
          d.from, d.at, d.dice, d.mean, d.percentile95, 100 * (d.volumeRatio - 1));
}

//! Carried through the frames, and polished where that is wanted; its warnings are said on standard error.
OverTimeReport carried(GrownObject& grown, OverTimeReport over, const RunOutputs& outputs) {
  Stopwatch watch;
  OverTimeRun through(grown, over, outputs.quiet);
  through.carry();
  grown.report.seconds.evolve += watch.lap();
  through.polish(grown);
  for (const std::string& warning : overTimeWarnings(over))
    std::fprintf(stderr, "handlebody-cli: warning: %s\n", warning.c_str());
  warnOfLabelMap(over, grown.report.volume.grid, outputs);
  grown.report.seconds.exported += watch.lap();
  return over;
}

int codeOf(const RunReport& report) {
  const auto& frames = report.overTime->frames;
  const bool all =
      std::all_of(frames.begin(), frames.end(), [](const FrameResult& r) { return r.isTrusted(); });
  return all ? exitCodeOf({report}) : kIncomplete;
}

}  // namespace

int runOverTime(LoadedSession loaded, const RunOutputs& outputs, const OverTimeOptions& options) {
  std::optional<Volume> shown;
  if (!outputs.picture.empty()) shown = loaded.volume;
  Session& session = loaded.session;
  session.label = chosenLabel(outputs.object, session.label);
  const int frames = loaded.info.frames;
  if (!session.overTime->frames) session.overTime->frames = OverTimeRequest::Range{0, frames - 1};
  OverTimeReport over{*session.overTime, timesOf(session, frames)};
  GrownObject grown = grow(std::move(loaded), outputs);
  grown.report.overTime = carried(grown, std::move(over), outputs);
  Stopwatch watch;
  {
    DeferSignals whole;
    const auto results = [&] {
      writeFrameFiles(grown.report, outputs, options.curves);
      if (shown) writePicture(*shown, grown.mesh, outputs.picture);
      writeSpread(grown.mesh, grown.report, outputs);
    };
    writeAll(results, [&] {
      Timings& s = grown.report.seconds;
      s.exported += watch.lap();
      s.total = s.load + s.prepare + s.evolve + s.exported + s.tunnels + s.sensitivity;
      writeSideFiles(grown.report, outputs);
    });
  }
  if (!outputs.quiet) {
    printSummary(grown.report);
    printOverTime(*grown.report.overTime);
  }
  return codeOf(grown.report);
}

}  // namespace handlebody::cli
