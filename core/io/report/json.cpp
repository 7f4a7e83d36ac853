#include "core/io/report/json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/io/meshes/object_name.h"
#include "core/io/report/constraints_json.h"
#include "core/io/report/json_field.h"
#include "core/io/report/parameter_names.h"
#include "core/io/report/terminology_json.h"
#include "core/told_error.h"

namespace handlebody {

Json numberToJson(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

Json vectorToJson(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json rangeToJson(const IntensityRange& range) {
  return Json::array({numberToJson(range.low), numberToJson(range.high)});
}

namespace {

Json optionalToJson(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json topologyToJson(const TopologyNumbers& numbers) {
  return {{"components", numbers.components}, {"genus", numbers.genus}, {"euler", numbers.euler}};
}

Json polygonToJson(const std::vector<Vec3>& polygon) {
  Json list = Json::array();
  for (const Vec3& p : polygon) list.push_back(vectorToJson(p));
  return list;
}

Json polygonsToJson(const std::vector<std::vector<Vec3>>& polygons) {
  Json list = Json::array();
  for (const auto& polygon : polygons) list.push_back(polygonToJson(polygon));
  return list;
}

Json trianglesToJson(const std::vector<std::array<Vec3, 3>>& triangles) {
  Json list = Json::array();
  for (const auto& [a, b, c] : triangles)
    list.push_back(Json::array({vectorToJson(a), vectorToJson(b), vectorToJson(c)}));
  return list;
}

}  // namespace

Json seedToJson(const Seed& seed) {
  Json json = {{"centre", vectorToJson(seed.centre)}, {"radius", optionalToJson(seed.radius)}};
  if (seed.background) json["background"] = true;
  return json;
}

Json seedsToJson(const std::vector<Seed>& seeds) {
  Json list = Json::array();
  for (const Seed& seed : seeds) list.push_back(seedToJson(seed));
  return list;
}

void addGrid(Json& object, const Grid& grid) {
  object["size"] = grid.size;
  object["spacing"] = vectorToJson(grid.spacing);
  object["origin"] = vectorToJson(grid.origin);
  Json rows = Json::array();
  for (int r = 0; r < 3; ++r) rows.push_back(vectorToJson(grid.direction.row(r).transpose()));
  object["direction"] = std::move(rows);
}

Json certificateToJson(const Certificate& certificate) {
  return {{"vertices", certificate.vertices},
          {"faces", certificate.faces},
          {"components", certificate.components},
          {"genus", certificate.genus},
          {"euler", certificate.euler},
          {"volume_mm3", certificate.volume},
          {"area_mm2", certificate.area},
          {"closed", certificate.closed},
          {"manifold", certificate.manifold},
          {"oriented", certificate.oriented},
          {"self_intersections", certificate.selfIntersections},
          {"cavities", certificate.cavities},
          {"misplaced_components", certificate.misplaced}};
}

Json referenceToJson(const VolumeReference& volume) {
  Json json = {{"path", volume.path.empty() ? Json(nullptr) : Json(volume.path)}, {"sha256", volume.sha256}};
  if (volume.selection.series) json["series"] = *volume.selection.series;
  if (volume.path.empty() && !volume.voxels.empty()) json["voxels_sha256"] = volume.voxels;
  if (volume.selection.frame) json["frame"] = *volume.selection.frame;
  if (volume.selection.spacing) json["given_spacing"] = vectorToJson(*volume.selection.spacing);
  if (volume.selection.uneven == UnevenSlices::refuse) json["uneven"] = "refuse";
  return json;
}

void addSources(Json& object, const VolumeInfo& info) {
  const GeometrySources& s = info.sources;
  object["calibrated"] = info.calibrated;
  object["sources"] = {
      {"size", s.size}, {"spacing", s.spacing}, {"origin", s.origin}, {"direction", s.direction}};
}

namespace {

// Sessions without these are those of earlier versions, to the letter.
template <typename AnyParameters>
void addRare(Json& json, const AnyParameters& p) {
  if (p.candidate != 1) json["candidate"] = p.candidate;
  if (p.broadPhase != BroadPhase::sorted) json["broad_phase"] = broadPhaseName(p.broadPhase);
  if (p.resolution != Resolution::uniform) json["resolution"] = resolutionName(p.resolution);
}

Json requestedToJson(const Parameters& parameters) {
  Json json = {{"object", objectKindName(parameters.object)},
               {"range", parameters.range ? rangeToJson(*parameters.range) : Json(nullptr)},
               {"smoothing", optionalToJson(parameters.smoothing)},
               {"edge_length", optionalToJson(parameters.edgeLength)},
               {"direction", directionName(parameters.direction)},
               {"balloon", parameters.balloon},
               {"curvature", parameters.curvature},
               {"max_iterations", parameters.maxIterations},
               {"threads", std::max(1, parameters.threads)}};  // as earlier versions, where nobody asked
  addRare(json, parameters);
  return json;
}

Json changesToJson(const std::vector<ParameterChange>& changes) {
  Json list = Json::array();
  for (const ParameterChange& change : changes) {
    Json entry = {{"iteration", change.iteration}};
    entry.update(requestedToJson(change.parameters));
    if (change.seeds) entry["seeds"] = seedsToJson(*change.seeds);
    if (change.constraints) entry["constraints"] = constraintsToJson(*change.constraints);
    list.push_back(std::move(entry));
  }
  return list;
}

Json labelToJson(const ObjectLabel& label) {
  Json json = {{"name", label.name}, {"colour", label.colour}, {"value", label.value}, {"term", label.term}};
  addSource(json, label.source);
  return json;
}

}  // namespace

Json requestToJson(const Session& session) {
  Json json = requestedToJson(session.requested);
  json["seeds"] = seedsToJson(session.seeds);
  json["space"] = session.space == CoordinateSpace::ras ? "RAS" : "LPS";
  if (!session.constraints.empty()) json["constraints"] = constraintsToJson(session.constraints);
  if (!session.changes.empty()) json["changes"] = changesToJson(session.changes);
  if (session.stopAt) json["stop_at"] = *session.stopAt;
  if (!(session.label == ObjectLabel{})) json["label"] = labelToJson(session.label);
  if (session.polish) json["polish"] = true;
  return json;
}

Json resolvedToJson(const ResolvedParameters& parameters) {
  Json json = {{"object", objectKindName(parameters.object)},
               {"range", rangeToJson(parameters.range)},
               {"smoothing", parameters.smoothing},
               {"edge_length", parameters.edgeLength},
               {"direction", directionName(parameters.direction)},
               {"balloon", parameters.balloon},
               {"curvature", parameters.curvature},
               {"max_iterations", parameters.maxIterations},
               {"threads", parameters.threads}};
  addRare(json, parameters);
  return json;
}

Json findingToJson(const Finding& finding) {
  Json json = {{"kind", findingName(finding.kind)}};
  for (const auto& [name, value] : finding.values) {
    Json& entry = json[std::string(name)];
    if (const auto* x = std::get_if<double>(&value))
      entry = std::isfinite(*x) ? Json(*x) : Json(nullptr);
    else if (const auto* place = std::get_if<std::array<double, 3>>(&value))
      entry = Json(*place);
    else
      entry = std::get<std::string>(value);
  }
  if (finding.causes.size() == 1) json["cause"] = findingToJson(finding.causes.front());
  if (finding.causes.size() > 1) json["causes"] = findingsToJson(finding.causes);
  json["sentence"] = sentence(finding);
  return json;
}

Json findingsToJson(const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& f : findings) list.push_back(findingToJson(f));
  return list;
}

Json eventToJson(const Event& event) {
  Json json = {{"kind", eventKindName(event.kind)},
               {"iteration", event.iteration},
               {"location", vectorToJson(event.location)},
               {"fronts", event.fronts},
               {"loop_sizes", event.loopSizes},
               {"before", topologyToJson(event.before)},
               {"after", topologyToJson(event.after)},
               {"reason", sentence(event.reasons)}};
  if (!event.reasons.empty()) json["reasons"] = findingsToJson(event.reasons);
  if (event.edit) {
    json["edit"] = {{"volume_before_ml", event.edit->volumeBefore / 1000},
                    {"volume_after_ml", event.edit->volumeAfter / 1000}};
    if (event.edit->loop > 0) json["edit"]["loop_mm"] = event.edit->loop;
  }
  if (event.held) json["held"] = eventKindName(*event.held);
  if (event.handleFrom != HandleSource::none)
    json["handle_from"] = event.handleFrom == HandleSource::database ? "database" : "search";
  return json;
}

Json leakToJson(const Leak& leak) {
  const Passage& p = leak.passage;
  return {{"iteration", leak.iteration},
          {"location", vectorToJson(leak.place)},
          {"width_mm", p.isSeen ? Json(2 * p.radius) : Json(nullptr)},
          {"width_before_mm", 2 * p.before},
          {"width_behind_mm", 2 * p.behind},
          {"disc", discToJson(leak.disc)},
          {"option", "--wall-disc " + written(leak.disc)}};
}

Json traceToJson(const EventTrace& trace) {
  return {{"colliding_faces", trianglesToJson(trace.collidingFaces)},
          {"lambda", polygonsToJson(trace.lambda)},
          {"refined_faces", trianglesToJson(trace.refinedFaces)},
          {"opened_faces", trianglesToJson(trace.openedFaces)},
          {"boundary_loops", polygonsToJson(trace.boundaryLoops)},
          {"handle_faces", trianglesToJson(trace.handleFaces)},
          {"closed_faces", trianglesToJson(trace.closedFaces)}};
}

namespace {

std::string compact(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

bool isFlat(const Json& json) {
  return json.empty() || !json.is_structured() ||
         (json.is_array() &&
          std::none_of(json.begin(), json.end(), [](const Json& e) { return e.is_structured(); }));
}

// The library's own indentation would put every coordinate on a line of its own.
void append(std::string& text, const Json& json, std::size_t indent) {
  if (isFlat(json)) {
    text += compact(json);
    return;
  }
  const std::string inner(indent + 2, ' ');
  text += json.is_array() ? "[" : "{";
  const char* separator = "\n";
  for (auto it = json.begin(); it != json.end(); ++it) {
    text += separator + inner;
    if (json.is_object()) text += compact(Json(it.key())) + ": ";
    append(text, it.value(), indent + 2);
    separator = ",\n";
  }
  text += "\n" + std::string(indent, ' ') + (json.is_array() ? "]" : "}");
}

}  // namespace

std::string jsonText(const Json& json) {
  std::string text;
  append(text, json, 0);
  return text + "\n";
}

namespace {

double endFromJson(const JsonField& json) {
  if (json.json() == "inf") return std::numeric_limits<double>::infinity();
  if (json.json() == "-inf") return -std::numeric_limits<double>::infinity();
  return json.number();
}

std::optional<double> optionalFromJson(const JsonField& object, const char* key) {
  const auto given = object.given(key);
  return given ? std::optional(given->number()) : std::nullopt;
}

IntensityRange rangeFromJson(const JsonField& json) {
  const std::vector<JsonField> ends = json.list(2);
  return {endFromJson(ends[0]), endFromJson(ends[1])};
}

std::optional<CoordinateSpace> spaceFromName(std::string_view name) {
  if (name == "LPS") return CoordinateSpace::lps;
  if (name == "RAS") return CoordinateSpace::ras;
  return std::nullopt;
}

}  // namespace

void readSelection(const JsonField& json, VolumeSelection& selection) {
  if (const auto series = json.given("series")) selection.series = series->text();
  if (const auto frame = json.given("frame")) selection.frame = frame->wholeAtLeast(0);
  if (const auto spacing = json.given("given_spacing")) selection.spacing = spacing->point();
  if (const auto uneven = json.given("uneven"); uneven && uneven->text() == "refuse")
    selection.uneven = UnevenSlices::refuse;
}

namespace {

using K = FindingKind;

Seed seedFromJson(const JsonField& json) {
  Seed seed{json.at("centre").point(), optionalFromJson(json, "radius")};
  if (json.has("background")) seed.background = json.at("background").flag();
  return seed;
}

std::vector<Seed> clicksFromJson(const JsonField& json) {
  std::vector<Seed> clicks;
  for (const JsonField& entry : json.list()) clicks.push_back(seedFromJson(entry));
  return clicks;
}

//! Clicks of which at least one is inside of the object.
std::vector<Seed> seededClicksFromJson(const JsonField& json) {
  std::vector<Seed> clicks = clicksFromJson(json);
  if (seedsOfSide(clicks, false).empty()) throw Told<UsageError>(K::sessionWithoutSeeds);
  return clicks;
}

//! A misspelt one would be left out without a word. `more`: what stands beside the parameters.
void requireParameters(const JsonField& json, std::initializer_list<const char*> more) {
  std::vector<std::string> known{"object",      "range",      "candidate", "smoothing",      "edge_length",
                                 "direction",   "balloon",    "curvature", "max_iterations", "threads",
                                 "broad_phase", "resolution", "seeds",     "constraints"};
  known.insert(known.end(), more.begin(), more.end());
  json.requireKeys(known);
}

Parameters parametersFromJson(const JsonField& json) {
  Parameters p;
  p.resolution = Resolution::uniform;
  if (json.has("object")) p.object = json.at("object").word(objectKindFromName);
  if (const auto range = json.given("range")) p.range = rangeFromJson(*range);
  if (json.has("candidate")) p.candidate = json.at("candidate").wholeAtLeast(1);
  p.smoothing = optionalFromJson(json, "smoothing");
  p.edgeLength = optionalFromJson(json, "edge_length");
  if (json.has("direction")) p.direction = json.at("direction").word(directionFromName);
  if (json.has("balloon")) p.balloon = json.at("balloon").number();
  if (json.has("curvature")) p.curvature = json.at("curvature").number();
  if (json.has("max_iterations")) p.maxIterations = json.at("max_iterations").whole();
  // What changes nothing needs no memory: 1, which is also written where nobody asked, leaves it to the
  // machine.
  if (json.has("threads")) p.threads = json.at("threads").whole();
  if (p.threads == 1) p.threads = 0;
  if (json.has("broad_phase")) p.broadPhase = json.at("broad_phase").word(broadPhaseFromName);
  if (json.has("resolution")) p.resolution = json.at("resolution").word(resolutionFromName);
  return p;
}

std::vector<ParameterChange> changesFromJson(const JsonField& json) {
  std::vector<ParameterChange> changes;
  for (const JsonField& entry : json.list()) {
    requireParameters(entry, {"iteration"});
    const JsonField field = entry.at("iteration");
    const int iteration = field.wholeAtLeast(0);
    if (!changes.empty() && iteration <= changes.back().iteration) field.refuse(K::fieldNotAscending);
    changes.push_back({iteration, parametersFromJson(entry), {}, {}});
    if (entry.has("seeds")) changes.back().seeds = seededClicksFromJson(entry.at("seeds"));
    if (entry.has("constraints")) changes.back().constraints = constraintsFromJson(entry.at("constraints"));
  }
  return changes;
}

std::string nameFromJson(const JsonField& json) {
  std::string name = json.text();
  if (nameFaultOf(name) != NameFault::none)
    json.refuse(K::fieldNoName, {{"most", kLongestName}, {"separators", std::string(kNameSeparators)}});
  return name;
}

ObjectLabel labelFromJson(const JsonField& json) {
  ObjectLabel label;
  label.name = nameFromJson(json.at("name"));
  const JsonField term = json.at("term");
  label.term = term.text();
  if (!termFromName(label.term)) term.refuseWord();
  label.value = json.at("value").wholeWithin(1, kLargestLabel);
  const std::vector<JsonField> colour = json.at("colour").list(label.colour.size());
  for (std::size_t i = 0; i < label.colour.size(); ++i)
    label.colour[i] = static_cast<std::uint8_t>(colour[i].wholeWithin(0, 255));
  label.source = sourceFromJson(json);
  return label;
}

}  // namespace

void readRequest(const JsonField& json, Session& session) {
  requireParameters(json, {"space", "changes", "stop_at", "label", "polish", "frame", "moved_object"});
  session.requested = parametersFromJson(json);
  if (json.has("space")) session.space = json.at("space").word(spaceFromName);
  if (json.has("constraints")) session.constraints = constraintsFromJson(json.at("constraints"));
  if (json.has("changes")) session.changes = changesFromJson(json.at("changes"));
  if (const auto last = json.given("stop_at")) session.stopAt = last->wholeAtLeast(0);
  if (json.has("label")) session.label = labelFromJson(json.at("label"));
  if (json.has("polish")) session.polish = json.at("polish").flag();
  session.seeds = clicksFromJson(json.at("seeds"));
}

}  // namespace handlebody
