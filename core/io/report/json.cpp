#include "core/io/report/json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/errors.h"
#include "core/io/report/constraints_json.h"
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

// Stricter than the library, which also makes numbers of true and false.
double finiteFromJson(const Json& json) {
  if (!json.is_number()) throw UsageError(compact(json) + " is not a number.");
  return json.get<double>();
}

Vec3 vectorFromJson(const Json& json) {
  if (json.size() != 3) throw UsageError(compact(json) + " is not a point.");
  return {finiteFromJson(json.at(0)), finiteFromJson(json.at(1)), finiteFromJson(json.at(2))};
}

namespace {

double numberFromJson(const Json& json) {
  if (json == "inf") return std::numeric_limits<double>::infinity();
  if (json == "-inf") return -std::numeric_limits<double>::infinity();
  return finiteFromJson(json);
}

std::optional<double> optionalFromJson(const Json& object, const char* key) {
  if (!object.contains(key) || object.at(key).is_null()) return std::nullopt;
  return finiteFromJson(object.at(key));
}

template <typename T>
T wordFromJson(const Json& json, std::optional<T> (*fromName)(std::string_view)) {
  const auto value = fromName(json.get_ref<const std::string&>());
  if (!value) throw UsageError(compact(json) + " is not a known word.");
  return *value;
}

IntensityRange rangeFromJson(const Json& json) {
  if (json.size() != 2) throw UsageError("the range is not a pair.");
  return {numberFromJson(json.at(0)), numberFromJson(json.at(1))};
}

CoordinateSpace spaceFromJson(const Json& json) {
  if (json == "LPS") return CoordinateSpace::lps;
  if (json == "RAS") return CoordinateSpace::ras;
  throw UsageError(compact(json) + " is not a known space.");
}

}  // namespace

void readSelection(const Json& json, VolumeSelection& selection) {
  const auto given = [&](const char* key) { return json.contains(key) && !json.at(key).is_null(); };
  if (given("series")) selection.series = json.at("series").get<std::string>();
  if (given("frame")) {
    const int frame = integerFromJson(json.at("frame"));
    if (frame < 0) throw UsageError("the frame is below 0.");
    selection.frame = frame;
  }
  if (given("given_spacing")) selection.spacing = vectorFromJson(json.at("given_spacing"));
  if (given("uneven") && json.at("uneven").get<std::string>() == "refuse")
    selection.uneven = UnevenSlices::refuse;
}

int integerFromJson(const Json& json) {
  if (!json.is_number_integer() || std::abs(json.get<double>()) > std::numeric_limits<int>::max())
    throw UsageError(compact(json) + " is not a whole number in range.");
  return json.get<int>();
}

std::string jsonText(const Json& json) {
  std::string text;
  append(text, json, 0);
  return text + "\n";
}

namespace {

int candidateFromJson(const Json& json) {
  const int candidate = integerFromJson(json);
  if (candidate < 1) throw UsageError("the candidate is below 1.");
  return candidate;
}

Seed seedFromJson(const Json& json) {
  Seed seed{vectorFromJson(json.at("centre")), optionalFromJson(json, "radius")};
  if (json.contains("background")) seed.background = json.at("background").get<bool>();
  return seed;
}

std::vector<Seed> clicksFromJson(const Json& json) {
  std::vector<Seed> clicks;
  for (const Json& entry : json) clicks.push_back(seedFromJson(entry));
  return clicks;
}

//! Clicks of which at least one is inside of the object.
std::vector<Seed> seededClicksFromJson(const Json& json) {
  std::vector<Seed> clicks = clicksFromJson(json);
  if (seedsOfSide(clicks, false).empty()) throw Told<UsageError>(FindingKind::sessionWithoutSeeds);
  return clicks;
}

Parameters parametersFromJson(const Json& json) {
  Parameters p;
  p.resolution = Resolution::uniform;
  if (json.contains("object")) p.object = wordFromJson(json.at("object"), objectKindFromName);
  if (json.contains("range") && !json.at("range").is_null()) p.range = rangeFromJson(json.at("range"));
  if (json.contains("candidate")) p.candidate = candidateFromJson(json.at("candidate"));
  p.smoothing = optionalFromJson(json, "smoothing");
  p.edgeLength = optionalFromJson(json, "edge_length");
  if (json.contains("direction")) p.direction = wordFromJson(json.at("direction"), directionFromName);
  if (json.contains("balloon")) p.balloon = finiteFromJson(json.at("balloon"));
  if (json.contains("curvature")) p.curvature = finiteFromJson(json.at("curvature"));
  if (json.contains("max_iterations")) p.maxIterations = integerFromJson(json.at("max_iterations"));
  // What changes nothing needs no memory: 1, which is also written where nobody asked, leaves it to the
  // machine.
  if (json.contains("threads")) p.threads = integerFromJson(json.at("threads"));
  if (p.threads == 1) p.threads = 0;
  if (json.contains("broad_phase")) p.broadPhase = wordFromJson(json.at("broad_phase"), broadPhaseFromName);
  if (json.contains("resolution")) p.resolution = wordFromJson(json.at("resolution"), resolutionFromName);
  return p;
}

int iterationFromJson(const Json& json) {
  const int iteration = integerFromJson(json);
  if (iteration < 0) throw UsageError("an iteration is below 0.");
  return iteration;
}

std::vector<ParameterChange> changesFromJson(const Json& json) {
  if (!json.is_array()) throw UsageError("the changes on the way are not a list.");
  std::vector<ParameterChange> changes;
  for (const Json& entry : json) {
    const int iteration = iterationFromJson(entry.at("iteration"));
    if (!changes.empty() && iteration <= changes.back().iteration)
      throw UsageError("the changes on the way are not in ascending order.");
    changes.push_back({iteration, parametersFromJson(entry), {}, {}});
    if (entry.contains("seeds")) changes.back().seeds = seededClicksFromJson(entry.at("seeds"));
    if (entry.contains("constraints"))
      changes.back().constraints = constraintsFromJson(entry.at("constraints"));
  }
  return changes;
}

ObjectLabel labelFromJson(const Json& json) {
  ObjectLabel label;
  label.name = json.at("name").get<std::string>();
  if (const std::string fault = objectNameFault(label.name); !fault.empty())
    throw UsageError("the name of the object " + fault + ".");
  label.term = json.at("term").get<std::string>();
  if (!termFromName(label.term)) throw UsageError("there is no term '" + label.term + "'.");
  label.value = integerFromJson(json.at("value"));
  if (label.value < 1 || label.value > kLargestLabel)
    throw UsageError("the object's label value is not within 1 and 65535.");
  const Json& colour = json.at("colour");
  if (!colour.is_array() || colour.size() != label.colour.size())
    throw UsageError("the object's colour is not a list of three numbers.");
  for (std::size_t i = 0; i < label.colour.size(); ++i) {
    const int part = integerFromJson(colour[i]);
    if (part < 0 || part > 255) throw UsageError("the object's colour is not within 0 and 255.");
    label.colour[i] = static_cast<std::uint8_t>(part);
  }
  label.source = sourceFromJson(json);
  return label;
}

}  // namespace

void readRequest(const Json& json, Session& session) {
  session.requested = parametersFromJson(json);
  if (json.contains("space")) session.space = spaceFromJson(json.at("space"));
  if (json.contains("constraints")) session.constraints = constraintsFromJson(json.at("constraints"));
  if (json.contains("changes")) session.changes = changesFromJson(json.at("changes"));
  if (json.contains("stop_at") && !json.at("stop_at").is_null())
    session.stopAt = iterationFromJson(json.at("stop_at"));
  if (json.contains("label")) session.label = labelFromJson(json.at("label"));
  if (json.contains("polish")) session.polish = json.at("polish").get<bool>();
  session.seeds = clicksFromJson(json.at("seeds"));
}

}  // namespace handlebody
