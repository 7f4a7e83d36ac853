#include "core/io/report/over_time_report.h"

#include <iomanip>
#include <locale>
#include <sstream>

#include "core/io/report/session_files.h"
#include "core/units.h"

namespace handlebody {

namespace {

std::string inQuotes(const std::string& text) {
  std::string out = "\"";
  for (const char c : text)
    out += c == '"' ? std::string("\"\"") : std::string(1, c < ' ' && c >= 0 ? ' ' : c);
  return out + '"';
}

const char* phaseOf(const VolumeCurve& curve, std::size_t i) {
  if (curve.endDiastole == i) return "end-diastole";
  return curve.endSystole == i ? "end-systole" : "";
}

std::string faultsText(const FrameResult& r) {
  std::string text;
  for (const ToldFault& f : r.faults) text += (text.empty() ? "" : "; ") + sentence(f.finding);
  return text;
}

}  // namespace

VolumeCurve curveOf(const std::vector<FrameResult>& frames, const TimeAxis& times) {
  std::vector<VolumePoint> points;
  for (const FrameResult& r : frames) {
    VolumePoint p;
    p.frame = r.frame;
    const auto at = static_cast<std::size_t>(r.frame);
    if (at < times.milliseconds.size()) p.time = times.milliseconds[at];
    if (!r.mesh.triangles.empty()) p.volume = r.volume;
    p.isTrusted = r.isTrusted();
    points.push_back(p);
  }
  return volumeCurve(std::move(points));
}

std::vector<std::string> overTimeWarnings(const OverTimeReport& report) {
  std::vector<std::string> warnings;
  for (const FrameResult& r : report.frames) {
    const std::string behind = "frame " + std::to_string(r.frame) + ": ";
    for (const ToldFault& f : r.faults) warnings.push_back(behind + sentence(f.finding));
    if (const auto found = report.polish.find(r.frame); r.from && found != report.polish.end())
      if (const Finding left = polishWarning(found->second); left.any())
        warnings.push_back(behind + sentence(left));
  }
  for (const Drift& d : report.drifts)
    if (!d.isBack)
      warnings.push_back("frame " + std::to_string(d.at) +
                         ": the surface was lost on its way back from frame " + std::to_string(d.from) +
                         ", and its drift is not known");
  return warnings;
}

OverTimeReport anonymous(OverTimeReport report) {
  for (FrameCorrection& c : report.request.corrections)
    forEachWallMap(c.request.constraints, c.changes, [](WallMap& map) { map.path.clear(); });
  for (FrameResult& r : report.frames)
    for (ToldFault& f : r.faults)
      if (f.fault == FrameFault::unreadable) f.finding = FindingKind::frameNotRead;
  return report;
}

std::string curveCsv(const OverTimeReport& report) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(10);
  out << "frame,time_ms,volume_ml,phase,trusted,components,genus,iterations,from_frame,seconds,faults\n";
  for (std::size_t i = 0; i < report.frames.size(); ++i) {
    const FrameResult& r = report.frames[i];
    const VolumePoint& p = report.curve.points[i];
    out << r.frame << ',';
    if (p.time) out << *p.time;
    out << ',';
    if (p.volume) out << *p.volume / kMillilitre;
    out << ',' << phaseOf(report.curve, i) << ',' << (p.isTrusted ? "yes" : "no") << ',' << r.components
        << ',' << r.genus << ',' << r.iterations << ',';
    if (r.from) out << *r.from;
    out << ',' << std::setprecision(4) << r.seconds << std::setprecision(10) << ','
        << (r.faults.empty() ? "" : inQuotes(faultsText(r))) << '\n';
  }
  return out.str();
}

}  // namespace handlebody
