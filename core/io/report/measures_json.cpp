#include "core/io/report/measures_json.h"

#include "core/io/report/json_field.h"

namespace handlebody {

namespace {

Json intensityToJson(const std::optional<IntensityInside>& in) {
  if (!in || in->voxels == 0) return nullptr;
  return {{"voxels", in->voxels},
          {"mean", in->mean},
          {"standard_deviation", in->deviation},
          {"minimum", in->minimum},
          {"maximum", in->maximum}};
}

const char* contactName(BodyContact contact) {
  if (contact == BodyContact::surfaces) return "meet";
  return contact == BodyContact::inside ? "inside" : "apart";
}

Json spreadToJson(const Spread& s) {
  return {{"least", s.least}, {"percent_5", s.percent5}, {"median", s.median}, {"largest", s.largest}};
}

}  // namespace

Json measuresToJson(const ObjectMeasures& measures) {
  const ShapeMeasures& m = measures.shape;
  Json json = {{"volume_mm3", m.volume}, {"area_mm2", m.area}};
  json["centroid"] = vectorToJson(m.centroid);
  json["largest_diameter_mm"] = m.largest.distance;
  json["largest_diameter_ends"] = Json::array({vectorToJson(m.largest.from), vectorToJson(m.largest.to)});
  json["principal_extents_mm"] = vectorToJson(m.extents);
  Json& axes = json["principal_axes"] = Json::array();
  for (int a = 0; a < 3; ++a) axes.push_back(vectorToJson(m.axes.col(a)));
  json["box_mm"] = vectorToJson(m.box);
  json["intensity"] = intensityToJson(measures.intensity);
  return json;
}

Json gapToJson(const std::string& from, const std::string& to, const SurfaceGap& gap) {
  return {{"from", from},
          {"to", to},
          {"distance_mm", gap.distance},
          {"contact", contactName(gap.contact)},
          {"places", Json::array({vectorToJson(gap.onA), vectorToJson(gap.onB)})}};
}

Json qualityToJson(const MeshQuality& q) {
  return {{"angles_degrees", spreadToJson(q.angles)},
          {"radius_ratio", spreadToJson(q.radiusRatio)},
          {"edges_mm", spreadToJson(q.edges)},
          {"dihedral_angles_degrees", spreadToJson(q.dihedral)},
          {"faces_without_area", q.flat}};
}

Json measurementsToJson(const std::vector<Measurement>& measurements) {
  Json list = Json::array();
  for (const Measurement& m : measurements) {
    const bool isRuler = m.kind == MeasurementKind::ruler;
    Json& json = list.emplace_back(Json::object());
    json["kind"] = isRuler ? "ruler" : "angle";
    Json& points = json["points"] = Json::array();
    for (const Vec3& p : m.points) points.push_back(vectorToJson(p));
    json[isRuler ? "length_mm" : "angle_degrees"] = valueOf(m);
  }
  return list;
}

namespace {

std::optional<MeasurementKind> measurementKindOf(std::string_view name) {
  if (name == "ruler") return MeasurementKind::ruler;
  if (name == "angle") return MeasurementKind::angle;
  return std::nullopt;
}

}  // namespace

std::vector<Measurement> measurementsFromJson(const JsonField& json) {
  std::vector<Measurement> list;
  for (const JsonField& one : json.list()) {
    Measurement& m = list.emplace_back();
    m.kind = one.at("kind").word(measurementKindOf);
    for (const JsonField& p : one.at("points").list(pointsOf(m.kind))) m.points.push_back(p.point());
  }
  return list;
}

}  // namespace handlebody
