#include "core/io/report/constraints_json.h"

#include <algorithm>
#include <array>

#include "core/errors.h"
#include "core/evolution/edit_step.h"
#include "core/io/shown.h"

namespace handlebody {

namespace {

int countFromJson(const Json& json, int least) {
  const int count = integerFromJson(json);
  if (count < least) throw UsageError("a limit of the topology is below " + std::to_string(least) + ".");
  return count;
}

WallBall ballFromJson(const Json& json) {
  const WallBall wall{vectorFromJson(json.at("centre")), finiteFromJson(json.at("radius"))};
  if (!(wall.radius > 0)) throw UsageError("a wall has no radius above 0.");
  return wall;
}

WallDisc discFromJson(const Json& json) {
  const WallDisc wall{vectorFromJson(json.at("centre")), vectorFromJson(json.at("normal")),
                      finiteFromJson(json.at("radius"))};
  if (!(wall.radius > 0)) throw UsageError("a wall disc has no radius above 0.");
  if (!(wall.normal.norm() > 0)) throw UsageError("a wall disc has a normal of no length.");
  return wall;
}

Veto vetoFromJson(const Json& json) {
  const Veto veto{integerFromJson(json.at("iteration")), vectorFromJson(json.at("place"))};
  if (veto.iteration < 1) throw UsageError("a veto's iteration is below 1.");
  return veto;
}

Pin pinFromJson(const Json& json) {
  const Pin pin{vectorFromJson(json.at("centre")), finiteFromJson(json.at("radius")),
                integerFromJson(json.at("iteration"))};
  if (!(pin.radius > 0)) throw UsageError("a pin has no radius above 0.");
  if (pin.iteration < 0) throw UsageError("a pin's iteration is below 0.");
  return pin;
}

Json meshEditToJson(const MeshEdit& e) {
  Json json = {{"iteration", e.iteration}, {"kind", meshEditName(e.kind)}, {"place", vectorToJson(e.place)}};
  if (e.kind == MeshEditKind::closeTunnel) json["loop"] = tunnelCutName(e.cut);
  if (e.kind == MeshEditKind::smooth || e.kind == MeshEditKind::pull || e.radius > 0)
    json["radius"] = e.radius;
  if (e.kind == MeshEditKind::pull) json["to"] = vectorToJson(e.vector);
  if (e.kind == MeshEditKind::cut) {
    json["normal"] = vectorToJson(e.vector);
    json["keep"] = keptSideName(e.keep);
  }
  return json;
}

MeshEdit meshEditFromJson(const Json& json) {
  MeshEdit edit;
  edit.iteration = integerFromJson(json.at("iteration"));
  if (edit.iteration < 1) throw UsageError("an edit's iteration is below 1.");
  const auto name = json.at("kind").get<std::string>();
  const auto kind = meshEditKind(name);
  if (!kind) throw UsageError("'" + name + "' is no kind of edit.");
  edit.kind = *kind;
  edit.place = vectorFromJson(json.at("place"));
  if (json.contains("radius")) edit.radius = finiteFromJson(json.at("radius"));
  if (edit.kind == MeshEditKind::pull) edit.vector = vectorFromJson(json.at("to"));
  if (edit.kind == MeshEditKind::cut) {
    edit.vector = vectorFromJson(json.at("normal"));
    const auto side = json.at("keep").get<std::string>();
    if (const auto keep = keptSideOf(side); keep)
      edit.keep = *keep;
    else
      throw UsageError("'" + side + "' is no side of a cut.");
  }
  if (const std::string fault = faultOf(edit); !fault.empty()) throw UsageError("an edit " + fault + ".");
  if (!json.contains("loop")) return edit;
  const auto loop = json.at("loop").get<std::string>();
  const auto cut = tunnelCutOf(loop);
  if (!cut) throw UsageError("'" + loop + "' is no loop of a tunnel.");
  edit.cut = *cut;
  return edit;
}

Json startToJson(const StartSurface& s) {
  Json json = {{"path", nullptr}};
  if (!s.path.empty()) json["path"] = s.path;
  if (!s.sha256.empty()) json["sha256"] = s.sha256;
  if (s.label) json["label"] = *s.label;
  if (!s.among.empty()) json["among"] = s.among;
  if (s.isDone) json["done"] = true;
  if (s.shape.smoothing) json["smoothing"] = *s.shape.smoothing;
  if (s.shape.genus) json["genus"] = *s.shape.genus;
  if (s.shape.keepsLargest) json["keep_largest"] = true;
  return json;
}

int labelFromJson(const Json& json) {
  const int label = integerFromJson(json);
  if (label == 0) throw UsageError("a label of the surface to begin with is 0.");
  return label;
}

LabelShape shapeFromJson(const Json& json) {
  LabelShape shape;
  if (json.contains("smoothing")) shape.smoothing = json.at("smoothing").get<double>();
  if (shape.smoothing && !(*shape.smoothing >= 0 && std::isfinite(*shape.smoothing)))
    throw UsageError("the smoothing of the surface to begin with is no length.");
  if (json.contains("genus")) shape.genus = integerFromJson(json.at("genus"));
  if (shape.genus && *shape.genus < 0)
    throw UsageError("the genus of the surface to begin with is negative.");
  shape.keepsLargest = json.value("keep_largest", false);
  return shape;
}

StartSurface startFromJson(const Json& json) {
  StartSurface start;
  if (!json.at("path").is_null()) start.path = json.at("path").get<std::string>();
  start.sha256 = json.value("sha256", std::string());
  if (json.contains("label")) start.label = labelFromJson(json.at("label"));
  if (json.contains("among"))
    for (const Json& label : json.at("among")) start.among.push_back(labelFromJson(label));
  if (json.contains("done")) start.isDone = json.at("done").get<bool>();
  start.shape = shapeFromJson(json);
  return start;
}

}  // namespace

Json discToJson(const WallDisc& w) {
  return {{"centre", vectorToJson(w.centre)}, {"normal", vectorToJson(w.normal)}, {"radius", w.radius}};
}

Json constraintsToJson(const Constraints& c) {
  Json json = Json::object();
  for (const WallBall& w : c.walls.balls)
    json["walls"].push_back({{"centre", vectorToJson(w.centre)}, {"radius", w.radius}});
  for (const WallDisc& w : c.walls.discs) json["wall_discs"].push_back(discToJson(w));
  if (c.walls.map) {
    json["wall_map"] = {{"path", nullptr}};
    if (!c.walls.map->path.empty()) json["wall_map"]["path"] = c.walls.map->path;
    if (!c.walls.map->sha256.empty()) json["wall_map"]["sha256"] = c.walls.map->sha256;
  }
  for (const Veto& v : c.vetoes)
    json["vetoes"].push_back({{"iteration", v.iteration}, {"place", vectorToJson(v.place)}});
  if (c.topology.components) json["components"] = *c.topology.components;
  if (c.topology.genus) json["genus"] = *c.topology.genus;
  for (const Vec3& p : c.topology.allowed) json["allowed"].push_back(vectorToJson(p));
  if (c.topology.asks) json["asks"] = true;
  for (const Vec3& p : c.topology.kept) json["kept"].push_back(vectorToJson(p));
  for (const Pin& p : c.pins)
    json["pins"].push_back(
        {{"centre", vectorToJson(p.centre)}, {"radius", p.radius}, {"iteration", p.iteration}});
  for (const MeshEdit& e : c.edits) json["edits"].push_back(meshEditToJson(e));
  if (c.start) json["start"] = startToJson(*c.start);
  return json;
}

namespace {

//! A constraint that is not known, or misspelt, would be dropped, and another surface grow without a word.
void requireKnown(const Json& constraints) {
  constexpr std::array kKnown{"walls",   "wall_discs", "wall_map", "vetoes", "components", "genus",
                              "allowed", "asks",       "kept",     "pins",   "edits",      "start"};
  for (const auto& [name, value] : constraints.items())
    if (std::find(kKnown.begin(), kKnown.end(), name) == kKnown.end())
      throw UsageError("the constraints have '" + shown(name) + "', which this version does not know.");
}

}  // namespace

Constraints constraintsFromJson(const Json& json) {
  if (!json.is_object()) throw UsageError("the constraints are not an object.");
  requireKnown(json);
  Constraints c;
  if (json.contains("walls"))
    for (const Json& wall : json.at("walls")) c.walls.balls.push_back(ballFromJson(wall));
  if (json.contains("wall_discs"))
    for (const Json& wall : json.at("wall_discs")) c.walls.discs.push_back(discFromJson(wall));
  if (json.contains("wall_map")) {
    const Json& map = json.at("wall_map");
    c.walls.map = WallMap{{}, map.value("sha256", std::string()), nullptr};
    if (!map.at("path").is_null()) c.walls.map->path = map.at("path").get<std::string>();
  }
  if (json.contains("vetoes"))
    for (const Json& veto : json.at("vetoes")) c.vetoes.push_back(vetoFromJson(veto));
  if (json.contains("components")) c.topology.components = countFromJson(json.at("components"), 1);
  if (json.contains("genus")) c.topology.genus = countFromJson(json.at("genus"), 0);
  if (json.contains("allowed"))
    for (const Json& place : json.at("allowed")) c.topology.allowed.push_back(vectorFromJson(place));
  if (json.contains("asks")) c.topology.asks = json.at("asks").get<bool>();
  if (json.contains("kept"))
    for (const Json& place : json.at("kept")) c.topology.kept.push_back(vectorFromJson(place));
  if (json.contains("pins"))
    for (const Json& pin : json.at("pins")) c.pins.push_back(pinFromJson(pin));
  if (json.contains("edits"))
    for (const Json& edit : json.at("edits")) c.edits.push_back(meshEditFromJson(edit));
  if (json.contains("start")) c.start = startFromJson(json.at("start"));
  return c;
}

}  // namespace handlebody
