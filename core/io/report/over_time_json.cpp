#include "core/io/report/over_time_json.h"

#include "core/errors.h"
#include "core/io/report/polished_export.h"
#include "core/io/report/session.h"

namespace handlebody {

namespace {

constexpr double kMillilitre = 1000;  // mm³

Json faultsToJson(const std::vector<ToldFault>& faults) {
  Json list = Json::array();
  for (const ToldFault& f : faults)
    list.push_back({{"kind", frameFaultName(f.fault)},
                    {"failed", isFailure(f.fault)},
                    {"text", sentence(f.finding)},
                    {"finding", findingToJson(f.finding)}});
  return list;
}

Json resultToJson(const FrameResult& r) {
  const bool grown = !r.mesh.triangles.empty();
  Json json = {{"frame", r.frame}, {"from_frame", r.from ? Json(*r.from) : Json(nullptr)}};
  json["volume_mm3"] = grown ? Json(r.volume) : Json(nullptr);
  json["components"] = r.components;
  json["genus"] = r.genus;
  json["iterations"] = r.iterations;
  json["stopped"] = stopReasonName(r.stopped);
  json["seconds"] = r.seconds;
  json["trusted"] = r.isTrusted();
  json["faults"] = faultsToJson(r.faults);
  return json;
}

Json curveToJson(const VolumeCurve& curve) {
  if (!curve.endDiastole) return nullptr;
  const auto phase = [&](std::size_t i) {
    const VolumePoint& p = curve.points[i];
    return Json{{"frame", p.frame},
                {"time_ms", p.time ? Json(*p.time) : Json(nullptr)},
                {"volume_ml", *p.volume / kMillilitre}};
  };
  return {{"end_diastole", phase(*curve.endDiastole)},
          {"end_systole", phase(*curve.endSystole)},
          {"stroke_volume_ml", curve.strokeVolume / kMillilitre},
          {"ejection_fraction", curve.ejectionFraction}};
}

Json driftToJson(const Drift& d) {
  Json json = {{"from_frame", d.from}, {"at_frame", d.at}, {"came_back", d.isBack}};
  if (!d.isBack) return json;
  json["dice"] = d.dice;
  json["mean_distance_mm"] = d.mean;
  json["percentile_95_mm"] = d.percentile95;
  json["volume_ratio"] = d.volumeRatio;
  return json;
}

//! As "requested" of a session, with the frame.
Json correctionToJson(const FrameCorrection& c) {
  Session session;
  session.seeds = c.request.seeds;
  session.requested = c.request.parameters;
  session.constraints = c.request.constraints;
  session.changes = c.changes;
  session.stopAt = c.stopAt;
  Json json = requestToJson(session);
  json.erase("space");
  json["frame"] = c.frame;
  return json;
}

FrameCorrection correctionFromJson(const Json& json) {
  Session session;
  readRequest(json, session);
  FrameCorrection c;
  c.frame = integerFromJson(json.at("frame"));
  c.request = {session.seeds, session.requested, session.constraints};
  c.changes = session.changes;
  c.stopAt = session.stopAt;
  if (finalRequest(c).constraints.start || c.request.constraints.start)
    throw UsageError(
        "a corrected frame begins with the surface of the frame beside it, not with that of a file.");
  return c;
}

}  // namespace

const char* driftCheckName(DriftCheck check) {
  return check == DriftCheck::none ? "none" : check == DriftCheck::back ? "back" : "wrap";
}

std::optional<DriftCheck> driftCheckFromName(std::string_view name) {
  for (const DriftCheck check : {DriftCheck::none, DriftCheck::back, DriftCheck::wrap})
    if (name == driftCheckName(check)) return check;
  return std::nullopt;
}

Json overTimeToJson(const OverTimeRequest& r) {
  Json json = Json::object();
  json["frames"] = r.frames ? Json::array({r.frames->first, r.frames->last}) : Json("all");
  json["topology"] = r.holdTopology ? "held" : "free";
  json["drift_check"] = driftCheckName(r.drift);
  if (r.frameTime) json["given_frame_time_ms"] = *r.frameTime;
  for (const FrameCorrection& c : r.corrections) json["corrections"].push_back(correctionToJson(c));
  return json;
}

OverTimeRequest overTimeFromJson(const Json& json) {
  OverTimeRequest r;
  const Json& frames = json.at("frames");
  if (frames != "all") {
    if (!frames.is_array() || frames.size() != 2) throw UsageError("the frames over time are not a pair.");
    r.frames = {integerFromJson(frames.at(0)), integerFromJson(frames.at(1))};
    if (r.frames->first < 0 || r.frames->last < r.frames->first)
      throw UsageError("the frames over time are no range.");
  }
  const auto topology = json.at("topology").get<std::string>();
  if (topology != "held" && topology != "free") throw UsageError("the topology over time is not known.");
  r.holdTopology = topology == "held";
  const auto drift = driftCheckFromName(json.at("drift_check").get<std::string>());
  if (!drift) throw UsageError("the drift check over time is not known.");
  r.drift = *drift;
  if (json.contains("given_frame_time_ms")) {
    r.frameTime = json.at("given_frame_time_ms").get<double>();
    if (!(*r.frameTime > 0)) throw UsageError("the time between frames is not above 0.");
  }
  if (json.contains("corrections"))
    for (const Json& entry : json.at("corrections")) {
      r.corrections.push_back(correctionFromJson(entry));
      const auto count = r.corrections.size();
      if (r.corrections.back().frame < 0 ||
          (count > 1 && r.corrections[count - 2].frame >= r.corrections.back().frame))
        throw UsageError("the corrected frames are not in ascending order.");
    }
  return r;
}

Json overTimeToJson(const OverTimeReport& report) {
  Json json = overTimeToJson(report.request);
  const bool known = !report.times.milliseconds.empty();
  json["time_ms"] = known ? Json(report.times.milliseconds) : Json(nullptr);
  if (known) json["time_source"] = report.times.source;
  Json& results = json["results"] = Json::array();
  for (const FrameResult& r : report.frames) {
    results.push_back(resultToJson(r));
    if (const auto found = report.polish.find(r.frame); found != report.polish.end())
      results.back()["polish"] = polishToJson(found->second);
  }
  json["curve"] = curveToJson(report.curve);
  Json& drifts = json["drift"] = Json::array();
  for (const Drift& d : report.drifts) drifts.push_back(driftToJson(d));
  return json;
}

}  // namespace handlebody
