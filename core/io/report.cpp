#include "core/io/report.h"

#include "core/io/json.h"

namespace handlebody {

namespace {

Json secondsToJson(const Timings& seconds) {
  return {{"load", seconds.load},
          {"prepare", seconds.prepare},
          {"evolve", seconds.evolve},
          {"export", seconds.exported},
          {"total", seconds.total}};
}

Json headToJson(const RunReport& report) {
  Json json = {{"version", report.session.version}, {"notice", kNotice}};
  Json input = referenceToJson(report.session.volume);
  addGrid(input, report.volume.grid);
  addSources(input, report.volume);
  input["warnings"] = report.volume.warnings;
  json["input"] = std::move(input);
  return json;
}

}  // namespace

const char* endName(StopReason stopped) {
  return stopped == StopReason::running ? "stop-at" : stopReasonName(stopped);
}

std::string reportText(const RunReport& report) {
  const ResolvedParameters& resolved = report.session.resolved.value();
  Json json = headToJson(report);
  json["parameters"] = resolvedToJson(resolved);
  json["requested"] = requestToJson(report.session);
  json["seeds"] = seedsToJson(resolved.seeds);
  json["iterations"] = report.iterations;
  json["stopped"] = endName(report.stopped);
  json["warnings"] = report.doubts;
  json["seconds"] = secondsToJson(report.seconds);
  json["mesh"] = certificateToJson(report.mesh);
  Json& events = json["events"] = Json::array();
  for (const Event& event : report.events) events.push_back(eventToJson(event));
  return jsonText(json);
}

std::string traceText(const RunReport& report) {
  Json json = headToJson(report);
  Json& events = json["events"] = Json::array();
  for (const Event& event : report.events) {
    events.push_back(eventToJson(event));
    events.back()["trace"] = traceToJson(event.trace);
  }
  return jsonText(json);
}

}  // namespace handlebody
