#include "core/io/report/report.h"

#include <cmath>

#include "core/io/report/anonymous_names.h"
#include "core/io/report/constraints_json.h"
#include "core/io/report/edit_json.h"
#include "core/io/report/measures_json.h"
#include "core/io/report/over_time_json.h"
#include "core/io/report/parameter_names.h"
#include "core/io/report/polished_export.h"
#include "core/io/report/sensitivity_json.h"
#include "core/io/report/terminology_json.h"

namespace handlebody {

namespace {

Json secondsToJson(const Timings& seconds) {
  return {{"load", seconds.load},       {"prepare", seconds.prepare}, {"evolve", seconds.evolve},
          {"export", seconds.exported}, {"tunnels", seconds.tunnels}, {"sensitivity", seconds.sensitivity},
          {"total", seconds.total}};
}

Json headToJson(const RunReport& report) {
  Json json = {{"version", report.session.version}, {"notice", kNotice}};
  Json input = referenceToJson(report.session.volume);
  addGrid(input, report.volume.grid);
  addSources(input, report.volume);
  input["warnings"] = sentences(report.volume.warnings);
  json["input"] = std::move(input);
  return json;
}

Json finiteOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

// Where the background was clicked stays as asked for: no surface starts there that would have to fit.
Json backgroundToJson(const std::vector<Seed>& seeds) {
  Json list = Json::array();
  for (const Seed& seed : seedsOfSide(seeds, true)) {
    Json& click = list.emplace_back(Json::object());
    click["centre"] = vectorToJson(seed.centre);
    if (seed.radius) click["radius"] = *seed.radius;
  }
  return list;
}

Json candidatesToJson(const std::vector<ObjectCandidate>& candidates, int chosen) {
  Json list = Json::array();
  for (const ObjectCandidate& candidate : candidates) {
    const int index = static_cast<int>(list.size()) + 1;
    list.push_back({{"index", index},
                    {"volume_ml", candidate.volume / 1000},
                    {"neck_radius_mm", candidate.neckRadius},
                    {"range", Json::array({finiteOrNull(candidate.low), finiteOrNull(candidate.high)})},
                    {"score", candidate.score},
                    {"chosen", index == chosen}});
  }
  return list;
}

Json correctionsToJson(const std::vector<RecordedCorrection>& corrections) {
  Json list = Json::array();
  for (const auto& [iteration, what] : corrections)
    list.push_back({{"iteration", iteration},
                    {"common", what.common},
                    {"began_anew", what.beganAnew},
                    {"gives_ground", what.givesGround},
                    {"components_deleted", what.deleted},
                    {"fronts_added", what.fronts}});
  return list;
}

//! A change of topology that the constraints hold back, where it first would have come.
Json heldToJson(const HeldPlace& held) {
  Json json = {{"kind", eventKindName(held.kind)},
               {"iteration", held.iteration},
               {"location", vectorToJson(held.place)}};
  if (held.size.tunnel > 0) json["tunnel_mm"] = held.size.tunnel;
  if (held.size.part > 0) json[held.size.isCavity ? "cavity_mm3" : "part_mm3"] = held.size.part;
  return json;
}

Json heldToJson(const std::vector<HeldPlace>& places) {
  Json list = Json::array();
  for (const HeldPlace& held : places) {
    list.push_back(heldToJson(held));
    list.back()["why"] = held.isVetoed ? "veto" : "limit";
    list.back()["times"] = held.times;
  }
  return list;
}

std::string allowOption(const HeldPlace& held) { return "--allow=" + written(held.place); }
std::string holdOption(const HeldPlace& held) { return "--hold=" + written(held.place); }

Json questionsToJson(const RunReport& report) {
  Json list = Json::array();
  for (const HeldPlace& held : report.questions) {
    const HeldAnswer answer = answerTo(held, report.session);
    list.push_back(heldToJson(held));
    list.back()["sentence"] = sentence(held);
    list.back()["options"] = {{"allow", allowOption(held)}, {"hold", holdOption(held)}};
    list.back()["answer"] = answer == HeldAnswer::allow  ? "allow"
                            : answer == HeldAnswer::hold ? "hold"
                                                         : "none";
  }
  return list;
}

Json pinnedToJson(const std::vector<PinnedPart>& parts) {
  Json list = Json::array();
  for (const PinnedPart& p : parts)
    list.push_back({{"centre", vectorToJson(p.pin.centre)},
                    {"radius", p.pin.radius},
                    {"iteration", p.pin.iteration},
                    {"vertices", p.vertices},
                    {"stops", p.stops}});
  return list;
}

Json leaksToJson(const std::vector<ToldLeak>& leaks) {
  Json list = Json::array();
  for (const auto& [leak, answer] : leaks) {
    list.push_back(leakToJson(leak));
    list.back()["answer"] = answer == LeakAnswer::wall   ? "wall"
                            : answer == LeakAnswer::stop ? "stop"
                                                         : "go-on";
  }
  return list;
}

}  // namespace

HeldAnswer answerTo(const HeldPlace& question, const Session& session) {
  const auto isIn = [&](const std::vector<Vec3>& places) {
    return std::find(places.begin(), places.end(), question.place) != places.end();
  };
  HeldAnswer answer = HeldAnswer::none;
  const auto look = [&](const Constraints& c) {
    if (isIn(c.topology.allowed))
      answer = HeldAnswer::allow;
    else if (isIn(c.topology.kept))
      answer = HeldAnswer::hold;
  };
  look(session.constraints);
  for (const ParameterChange& change : session.changes)
    if (change.constraints) look(*change.constraints);
  return answer;
}

std::vector<Finding> questionWarnings(const RunReport& report) {
  std::vector<Finding> warnings;
  for (const HeldPlace& held : report.questions)
    if (answerTo(held, report.session) == HeldAnswer::none)
      warnings.push_back({FindingKind::undecided,
                          {{"iteration", held.iteration},
                           {"spot", written(held.place)},
                           {"allow", allowOption(held)},
                           {"hold", holdOption(held)}},
                          findingOf(held)});
  return warnings;
}

const char* endName(const RunReport& report) {
  if (report.isStoppedAtLeak) return "leak";
  if (report.isStoppedToAsk) return "held";
  return report.stopped == StopReason::running ? "stop-at" : stopReasonName(report.stopped);
}

std::vector<Finding> leakWarnings(const RunReport& report) {
  std::vector<Finding> warnings;
  for (const auto& [leak, answer] : report.leaks) {
    const FindingKind kind = answer == LeakAnswer::wall   ? FindingKind::leakWalled
                             : answer == LeakAnswer::stop ? FindingKind::leakStopped
                                                          : FindingKind::leaked;
    warnings.push_back(
        {kind,
         {{"iteration", leak.iteration}, {"mesh_iteration", report.iterations}, {"disc", written(leak.disc)}},
         findingOf(leak)});
  }
  return warnings;
}

std::vector<Finding> pinWarnings(const RunReport& report) {
  std::vector<Finding> warnings;
  for (const PinnedPart& p : report.pinned)
    if (p.vertices == 0)
      warnings.push_back(
          {FindingKind::pinNotReached, {{"pin", written(p.pin)}, {"mesh_iteration", report.iterations}}});
  return warnings;
}

RunReport anonymous(RunReport report) {
  report.session = anonymous(std::move(report.session));
  if (report.overTime) report.overTime = anonymous(std::move(*report.overTime));
  for (Finding& warning : report.volume.warnings) warning = unnamed(std::move(warning));
  for (Finding& warning : report.warnings)
    if (warning.kind == FindingKind::ofFile)
      warning = {FindingKind::ofFile, {{"file", std::string("a file")}}, unnamed(warning.causes.at(0))};
  return report;
}

namespace {

//! How many handles and bands the database has told, and how many were searched.
Json handlesToJson(const std::vector<Event>& events) {
  const auto from = [&](HandleSource source) {
    return std::count_if(events.begin(), events.end(),
                         [source](const Event& e) { return e.handleFrom == source; });
  };
  return {{"from_database", from(HandleSource::database)}, {"from_search", from(HandleSource::search)}};
}

//! What is told of the object.
void addObject(Json& json, const RunReport& report) {
  const ResolvedParameters& resolved = report.session.resolved.value();
  json["parameters"] = resolvedToJson(resolved);
  json["parameters"]["broad_phase"] = broadPhaseName(resolved.broadPhase);
  json["parameters"]["resolution"] = resolutionName(resolved.resolution);
  json["parameters"]["candidate"] = resolved.candidate;
  json["requested"] = requestToJson(report.session);
  json["seeds"] = seedsToJson(seedsOfSide(resolved.seeds, false));
  if (Json background = backgroundToJson(report.session.seeds); !background.empty())
    json["background"] = std::move(background);
  json["candidates"] = candidatesToJson(report.candidates, resolved.candidate);
  json["close_choice"] = report.isCloseChoice;
  json["iterations"] = report.iterations;
  json["stopped"] = endName(report);
  json["warnings"] = sentences(report.warnings);
  json["findings"] = findingsToJson(report.warnings);
  json["unsupported_surface"] = report.unsupportedSurface ? Json(*report.unsupportedSurface) : Json();
  json["seconds"] = secondsToJson(report.seconds);
  json["mesh"] = certificateToJson(report.mesh);
  if (report.polish) json["polish"] = polishToJson(*report.polish);
  if (report.measures) json["measures"] = measuresToJson(*report.measures);
  if (report.sensitivity) json["sensitivity"] = sensitivityToJson(*report.sensitivity);
  if (report.tunnels) json["tunnels"] = tunnelsToJson(*report.tunnels);
  if (report.overTime) json["over_time"] = overTimeToJson(*report.overTime);
  if (!report.corrections.empty()) json["corrections"] = correctionsToJson(report.corrections);
  if (!report.held.empty()) json["held"] = heldToJson(report.held);
  if (!report.pinned.empty()) json["pinned"] = pinnedToJson(report.pinned);
  if (!report.questions.empty()) json["questions"] = questionsToJson(report);
  if (!report.leaks.empty()) json["leaks"] = leaksToJson(report.leaks);
  json["handles"] = handlesToJson(report.events);
  Json& events = json["events"] = Json::array();
  for (const Event& event : report.events) events.push_back(eventToJson(event));
}

void addTraces(Json& json, const RunReport& report) {
  Json& events = json["events"] = Json::array();
  for (const Event& event : report.events) {
    events.push_back(eventToJson(event));
    events.back()["trace"] = traceToJson(event.trace);
  }
}

void addMeasurements(Json& json, const RunReport& report) {
  const std::vector<Measurement>& all = report.session.measurements;
  if (!all.empty()) json["measurements"] = measurementsToJson(all);
}

//! With the names that the objects have by now: those of an anonymous report may be others.
void addDistances(Json& json, const std::vector<RunReport>& objects, const std::vector<PairGap>& gaps) {
  const auto nameOf = [&](int index) { return objects[index].session.label.name; };
  for (const PairGap& g : gaps) json["distances"].push_back(gapToJson(nameOf(g.from), nameOf(g.to), g.gap));
}

//! A place for an object, with its name.
Json& addNamed(Json& json, const ObjectLabel& label) {
  Json& object = json["objects"].emplace_back(Json::object());
  object["name"] = label.name;
  object["label_value"] = label.value;
  object["colour"] = label.colour;
  object["term"] = label.term;
  if (label.source.terminology) object["terminology"] = terminologyToJson(*label.source.terminology);
  return object;
}

}  // namespace

std::string reportText(const RunReport& report) {
  Json json = headToJson(report);
  addObject(json, report);
  addMeasurements(json, report);
  return jsonText(json);
}

std::string traceText(const RunReport& report) {
  Json json = headToJson(report);
  addTraces(json, report);
  return jsonText(json);
}

std::string reportText(const std::vector<RunReport>& objects, const Timings& seconds,
                       const std::vector<PairGap>& gaps) {
  Json json = headToJson(objects.front());
  for (const RunReport& object : objects) addObject(addNamed(json, object.session.label), object);
  addDistances(json, objects, gaps);
  json["seconds"] = secondsToJson(seconds);
  addMeasurements(json, objects.front());
  return jsonText(json);
}

std::string traceText(const std::vector<RunReport>& objects) {
  Json json = headToJson(objects.front());
  for (const RunReport& object : objects) addTraces(addNamed(json, object.session.label), object);
  return jsonText(json);
}

}  // namespace handlebody
