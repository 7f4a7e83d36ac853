#include "core/io/report/constraints_json.h"

#include "core/evolution/edit_step.h"
#include "core/io/report/json_field.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

using K = FindingKind;

WallBall ballFromJson(const JsonField& json) {
  return {json.at("centre").point(), json.at("radius").numberAbove(0)};
}

WallDisc discFromJson(const JsonField& json) {
  return {json.at("centre").point(), json.at("normal").direction(), json.at("radius").numberAbove(0)};
}

Veto vetoFromJson(const JsonField& json) {
  return {json.at("iteration").wholeAtLeast(1), json.at("place").point()};
}

Pin pinFromJson(const JsonField& json) {
  return {json.at("centre").point(), json.at("radius").numberAbove(0), json.at("iteration").wholeAtLeast(0)};
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

MeshEdit meshEditFromJson(const JsonField& json) {
  MeshEdit edit;
  edit.iteration = json.at("iteration").wholeAtLeast(1);
  edit.kind = json.at("kind").word(meshEditKind);
  edit.place = json.at("place").point();
  if (json.has("radius")) edit.radius = json.at("radius").number();
  if (edit.kind == MeshEditKind::pull) edit.vector = json.at("to").point();
  if (edit.kind == MeshEditKind::cut) {
    edit.vector = json.at("normal").direction();
    edit.keep = json.at("keep").word(keptSideOf);
  }
  if (const Finding fault = faultOf(edit); fault.any()) throw Told<UsageError>(fault);
  if (json.has("loop")) edit.cut = json.at("loop").word(tunnelCutOf);
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

int labelNumberFromJson(const JsonField& json) {
  const int label = json.whole();
  if (label == 0) json.refuse(K::fieldNoLabel);
  return label;
}

LabelShape shapeFromJson(const JsonField& json) {
  LabelShape shape;
  if (json.has("smoothing")) shape.smoothing = json.at("smoothing").numberAtLeast(0);
  if (json.has("genus")) shape.genus = json.at("genus").wholeAtLeast(0);
  if (json.has("keep_largest")) shape.keepsLargest = json.at("keep_largest").flag();
  return shape;
}

//! Empty for null: of an anonymous session.
std::string pathFromJson(const JsonField& json) { return json.isNull() ? std::string() : json.text(); }

StartSurface startFromJson(const JsonField& json) {
  StartSurface start;
  start.path = pathFromJson(json.at("path"));
  if (json.has("sha256")) start.sha256 = json.at("sha256").text();
  if (json.has("label")) start.label = labelNumberFromJson(json.at("label"));
  if (json.has("among"))
    for (const JsonField& label : json.at("among").list()) start.among.push_back(labelNumberFromJson(label));
  if (json.has("done")) start.isDone = json.at("done").flag();
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

WallMap wallMapFromJson(const JsonField& json) {
  WallMap map{pathFromJson(json.at("path")), {}, nullptr};
  if (json.has("sha256")) map.sha256 = json.at("sha256").text();
  return map;
}

//! f(entry) of the list of that name, where it is there.
template <typename F>
void forEachEntry(const JsonField& json, const char* key, F&& f) {
  if (!json.has(key)) return;
  for (const JsonField& entry : json.at(key).list()) f(entry);
}

}  // namespace

Constraints constraintsFromJson(const JsonField& json) {
  // One that is not known, or misspelt, would be dropped, and another surface grow without a word.
  json.requireKeys({"walls", "wall_discs", "wall_map", "vetoes", "components", "genus", "allowed", "asks",
                    "kept", "pins", "edits", "start"});
  Constraints c;
  using J = const JsonField&;
  forEachEntry(json, "walls", [&](J wall) { c.walls.balls.push_back(ballFromJson(wall)); });
  forEachEntry(json, "wall_discs", [&](J wall) { c.walls.discs.push_back(discFromJson(wall)); });
  if (json.has("wall_map")) c.walls.map = wallMapFromJson(json.at("wall_map"));
  forEachEntry(json, "vetoes", [&](J veto) { c.vetoes.push_back(vetoFromJson(veto)); });
  if (json.has("components")) c.topology.components = json.at("components").wholeAtLeast(1);
  if (json.has("genus")) c.topology.genus = json.at("genus").wholeAtLeast(0);
  forEachEntry(json, "allowed", [&](J place) { c.topology.allowed.push_back(place.point()); });
  if (json.has("asks")) c.topology.asks = json.at("asks").flag();
  forEachEntry(json, "kept", [&](J place) { c.topology.kept.push_back(place.point()); });
  forEachEntry(json, "pins", [&](J pin) { c.pins.push_back(pinFromJson(pin)); });
  forEachEntry(json, "edits", [&](J edit) { c.edits.push_back(meshEditFromJson(edit)); });
  if (json.has("start")) c.start = startFromJson(json.at("start"));
  return c;
}

}  // namespace handlebody
