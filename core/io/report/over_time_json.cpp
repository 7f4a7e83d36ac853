#include "core/io/report/over_time_json.h"

#include "core/io/report/json_field.h"
#include "core/io/report/polished_export.h"
#include "core/io/report/session.h"
#include "core/told_error.h"
#include "core/units.h"

namespace handlebody {

namespace {

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
  if (c.isOfMoved) json["moved_object"] = true;
  return json;
}

FrameCorrection correctionFromJson(const JsonField& json) {
  Session session;
  readRequest(json, session);
  FrameCorrection c;
  c.frame = json.at("frame").wholeAtLeast(0);
  c.request = {session.seeds, session.requested, session.constraints};
  c.changes = session.changes;
  c.stopAt = session.stopAt;
  c.isOfMoved = json.has("moved_object") && json.at("moved_object").flag();
  if (finalRequest(c).constraints.start || c.request.constraints.start)
    throw Told<UsageError>(FindingKind::correctedFrameWithStart);
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

namespace {

OverTimeRequest::Range framesFromJson(const JsonField& json) {
  const std::vector<JsonField> ends = json.list(2);
  const OverTimeRequest::Range range{ends[0].wholeAtLeast(0), ends[1].whole()};
  if (range.last < range.first) json.refuse(FindingKind::fieldNoRange);
  return range;
}

std::vector<FrameCorrection> correctionsFromJson(const JsonField& json) {
  std::vector<FrameCorrection> corrections;
  for (const JsonField& entry : json.list()) {
    FrameCorrection next = correctionFromJson(entry);
    if (!corrections.empty() && next.frame <= corrections.back().frame)
      entry.at("frame").refuse(FindingKind::fieldNotAscending);
    corrections.push_back(std::move(next));
  }
  return corrections;
}

//! Whether it is held.
std::optional<bool> topologyFromName(std::string_view name) {
  if (name == "held") return true;
  if (name == "free") return false;
  return std::nullopt;
}

}  // namespace

OverTimeRequest overTimeFromJson(const JsonField& json) {
  OverTimeRequest r;
  if (const JsonField frames = json.at("frames"); frames.json() != "all") r.frames = framesFromJson(frames);
  r.holdTopology = json.at("topology").word(topologyFromName);
  r.drift = json.at("drift_check").word(driftCheckFromName);
  if (json.has("given_frame_time_ms")) r.frameTime = json.at("given_frame_time_ms").numberAbove(0);
  if (json.has("corrections")) r.corrections = correctionsFromJson(json.at("corrections"));
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
