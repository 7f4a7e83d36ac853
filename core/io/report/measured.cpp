#include "core/io/report/measured.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "core/io/decimal_point.h"
#include "core/io/report/anonymous_names.h"
#include "core/io/report/csv_line.h"
#include "core/io/report/measures_json.h"
#include "core/version.h"

namespace handlebody {

namespace {

std::string measured(double value, const char* format = "%.5g") {
  const DecimalPoint point;
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string place(const Vec3& p) { return measured(p.x()) + "," + measured(p.y()) + "," + measured(p.z()); }

std::string labelledLine(const std::string& name, const std::string& value) {
  std::string text = name;
  text.resize(std::max<std::size_t>(38, name.size() + 1), ' ');
  return text + value + "\n";
}

int genusOf(const MeasuredObject& o) {
  return std::accumulate(o.certificate.genus.begin(), o.certificate.genus.end(), 0);
}

std::string objectText(const MeasuredObject& o) {
  const ShapeMeasures& m = o.measures.shape;
  std::string text =
      o.name + "\n" + labelledLine("  volume (ml)", measured(m.volume / 1000, "%.6g")) +
      labelledLine("  area (cm2)", measured(m.area / 100, "%.6g")) +
      labelledLine("  largest diameter (mm)", measured(m.largest.distance) + " from " +
                                                  place(m.largest.from) + " to " + place(m.largest.to)) +
      labelledLine("  along its principal axes (mm)",
                   measured(m.extents[0]) + " x " + measured(m.extents[1]) + " x " + measured(m.extents[2])) +
      labelledLine("  along x, y, z (mm)",
                   measured(m.box[0]) + " x " + measured(m.box[1]) + " x " + measured(m.box[2])) +
      labelledLine("  centroid (mm LPS)", place(m.centroid)) +
      labelledLine("  components, cavities, genus",
                   std::to_string(o.certificate.components - o.certificate.cavities) + ", " +
                       std::to_string(o.certificate.cavities) + ", " + std::to_string(genusOf(o)));
  const auto& in = o.measures.intensity;
  if (in && in->voxels > 0)
    text += labelledLine("  intensity, mean and SD", measured(in->mean) + " +- " + measured(in->deviation)) +
            labelledLine("  intensity, minimum to maximum",
                         measured(in->minimum) + " to " + measured(in->maximum)) +
            labelledLine("  voxels inside", std::to_string(in->voxels));
  return text;
}

std::string gapText(const MeasuredGap& g) {
  const std::string between = "distance of " + g.from + " and " + g.to + " (mm)";
  std::string value = measured(g.gap.distance) + " from " + place(g.gap.onA) + " to " + place(g.gap.onB);
  if (g.gap.contact == BodyContact::surfaces) value = "0: the surfaces meet, near " + place(g.gap.onA);
  if (g.gap.contact == BodyContact::inside) value += "; a part of one lies in the other";
  return labelledLine(between, value);
}

std::string wallText(const MeasuredWall& w) {
  const auto directed = [](const DirectedDistances& d) {
    return "mean " + measured(d.mean) + ", least " + measured(d.smallest) + ", 95 % up to " +
           measured(d.percentile95) + ", largest " + measured(d.largest);
  };
  return labelledLine("wall thickness (mm)", "") +
         labelledLine("  from " + w.first, directed(w.wall.fromFirst)) +
         labelledLine("  from " + w.second, directed(w.wall.fromSecond));
}

//! The least and the largest section.
struct Extremes {
  const CentreLinePoint *least = nullptr, *largest = nullptr;
  double mean = 0;  // mm²
  explicit Extremes(const CentreLine& line) {
    int n = 0;
    for (const CentreLinePoint& p : line.points) {
      if (!p.area) continue;
      if (!least || *p.area < *least->area) least = &p;
      if (!largest || *p.area > *largest->area) largest = &p;
      mean += *p.area;
      ++n;
    }
    if (n > 0) mean /= n;
  }
};

std::string lineText(const MeasuredLine& m) {
  const Extremes e(m.line);
  const auto section = [](const CentreLinePoint& p) {
    return measured(*p.area) + " mm2, equivalent diameter " + measured(p.equivalentDiameter()) + " mm, at " +
           measured(p.along) + " mm, " + place(p.place);
  };
  std::string text = labelledLine("centre line (mm)", measured(m.line.length) + " in " + m.object + ", " +
                                                          std::to_string(m.line.points.size()) + " sections");
  if (e.least)
    text += labelledLine("  least section", section(*e.least)) +
            labelledLine("  largest section", section(*e.largest)) +
            labelledLine("  mean area of the sections (mm2)", measured(e.mean));
  return text;
}

//! Numbered together, as the window's list is.
std::string placedName(const Measurement& m, std::size_t index) {
  return (m.kind == MeasurementKind::ruler ? "ruler " : "angle ") + std::to_string(index + 1);
}

std::string placedText(const std::vector<Measurement>& placed) {
  std::string text;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const std::string unit = placed[i].kind == MeasurementKind::ruler ? " (mm)" : " (degrees)";
    std::string points;
    for (const Vec3& p : placed[i].points) points += (points.empty() ? " from " : " to ") + place(p);
    text += labelledLine(placedName(placed[i], i) + unit, measured(valueOf(placed[i])) + points);
  }
  return text;
}

Json directedJson(const std::string& from, const DirectedDistances& d) {
  return {{"from", from},
          {"mean_mm", d.mean},
          {"least_mm", d.smallest},
          {"percentile_95_mm", d.percentile95},
          {"largest_mm", d.largest}};
}

Json sectionJson(const CentreLinePoint& p) {
  return {{"along_mm", p.along},
          {"place", vectorToJson(p.place)},
          {"direction", vectorToJson(p.direction)},
          {"inscribed_radius_mm", p.radius},
          {"area_mm2", p.area ? Json(*p.area) : Json(nullptr)},
          {"equivalent_diameter_mm", p.area ? Json(p.equivalentDiameter()) : Json(nullptr)}};
}

Json lineJson(const MeasuredLine& m) {
  Json json = {{"object", m.object}, {"length_mm", m.line.length}};
  Json& sections = json["sections"] = Json::array();
  for (const CentreLinePoint& p : m.line.points) sections.push_back(sectionJson(p));
  return json;
}

//! Names and values of one line of a table.
struct TableRow {
  std::vector<std::string> names, values;
  void add(const std::string& name, const Json& value) {
    names.push_back(name);
    values.push_back(value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump());
  }
  void addPlace(const std::string& name, const Vec3& p, const std::string& unit = "_mm") {
    const std::array<const char*, 3> axes{"_x", "_y", "_z"};
    for (int a = 0; a < 3; ++a) add(name + axes[a] + unit, p[a]);
  }
};

TableRow rowOf(const Measured& m, const MeasuredObject& o) {
  const ShapeMeasures& s = o.measures.shape;
  const auto& in = o.measures.intensity;
  const bool has = in && in->voxels > 0;
  TableRow row;
  row.add("object", o.name);
  row.add("volume_mm3", s.volume);
  row.add("area_mm2", s.area);
  row.add("largest_diameter_mm", s.largest.distance);
  row.addPlace("largest_diameter_from", s.largest.from);
  row.addPlace("largest_diameter_to", s.largest.to);
  for (int a = 0; a < 3; ++a) row.add("principal_extent_" + std::to_string(a + 1) + "_mm", s.extents[a]);
  row.addPlace("box", s.box);
  row.addPlace("centroid", s.centroid);
  row.add("components", o.certificate.components - o.certificate.cavities);
  row.add("cavities", o.certificate.cavities);
  row.add("genus", genusOf(o));
  row.add("voxels", has ? Json(in->voxels) : Json());
  row.add("intensity_mean", has ? Json(in->mean) : Json());
  row.add("intensity_standard_deviation", has ? Json(in->deviation) : Json());
  row.add("intensity_minimum", has ? Json(in->minimum) : Json());
  row.add("intensity_maximum", has ? Json(in->maximum) : Json());
  // The nearest of the others, so that every object has the same columns.
  const MeasuredGap* nearest = nullptr;
  for (const MeasuredGap& g : m.gaps)
    if ((g.from == o.name || g.to == o.name) && (!nearest || g.gap.distance < nearest->gap.distance))
      nearest = &g;
  row.add("nearest_object", nearest ? Json(nearest->from == o.name ? nearest->to : nearest->from) : Json());
  row.add("distance_mm", nearest ? Json(nearest->gap.distance) : Json());
  return row;
}

//! False for a third object beside two whose wall it is.
bool isOfWall(const Measured& m, const MeasuredObject& o) {
  const auto isNamed = [&](const MeasuredObject& one) {
    return one.name == m.wall->first || one.name == m.wall->second;
  };
  return isNamed(o) || std::none_of(m.objects.begin(), m.objects.end(), isNamed);
}

//! The columns are there for an object that the wall is not of, too.
void addWall(TableRow& row, const MeasuredWall& wall, bool isOf) {
  const auto add = [&](const std::string& name, const Json& value) { row.add(name, isOf ? value : Json()); };
  const auto addDistances = [&](const std::string& name, const DirectedDistances& d) {
    add(name + "_mean_mm", d.mean);
    add(name + "_least_mm", d.smallest);
    add(name + "_percentile_95_mm", d.percentile95);
    add(name + "_largest_mm", d.largest);
  };
  addDistances("wall_from_first", wall.wall.fromFirst);
  addDistances("wall_from_second", wall.wall.fromSecond);
  add("wall_first", wall.first);
  add("wall_second", wall.second);
}

//! What a ruler or an angle has in a table; none: the same columns, empty.
void addPlaced(TableRow& row, const std::string& kind, const Measurement* m) {
  const bool isRuler = m && m->kind == MeasurementKind::ruler;
  row.add("kind", kind);
  row.add("length_mm", isRuler ? Json(valueOf(*m)) : Json());
  row.add("angle_degrees", m && !isRuler ? Json(valueOf(*m)) : Json());
  for (std::size_t i = 0; i < pointsOf(MeasurementKind::angle); ++i)
    for (int a = 0; a < 3; ++a)
      row.add("point_" + std::to_string(i + 1) + "_" + "xyz"[a] + "_mm",
              m && i < m->points.size() ? Json(m->points[i][a]) : Json());
}

void addPlaced(TableRow& row, const Measurement& m) {
  addPlaced(row, m.kind == MeasurementKind::ruler ? "ruler" : "angle", &m);
}

using Names = std::map<std::string, std::string>;

void rename(std::string& name, const Names& names) {
  if (const auto other = names.find(name); other != names.end()) name = other->second;
}

Finding renamed(Finding warning, const Names& names) {
  if (warning.kind == FindingKind::ofFile) return unnamed(warning.causes.at(0));
  for (auto& [key, value] : warning.values)
    if (auto* text = std::get_if<std::string>(&value); text && key == "object") rename(*text, names);
  for (Finding& cause : warning.causes) cause = renamed(std::move(cause), names);
  return warning;
}

}  // namespace

Measured anonymous(Measured m, const Names& names) {
  m.path.clear();
  m.volume.clear();
  for (MeasuredObject& object : m.objects) rename(object.name, names);
  for (MeasuredGap& gap : m.gaps)
    for (std::string* name : {&gap.from, &gap.to}) rename(*name, names);
  if (m.wall)
    for (std::string* name : {&m.wall->first, &m.wall->second}) rename(*name, names);
  if (m.line) rename(m.line->object, names);
  for (Finding& warning : m.warnings) warning = renamed(std::move(warning), names);
  return m;
}

std::string measuredText(const Measured& m) {
  std::string text;
  for (const MeasuredObject& o : m.objects) text += objectText(o);
  for (const MeasuredGap& g : m.gaps) text += gapText(g);
  if (m.wall) text += wallText(*m.wall);
  if (m.line) text += lineText(*m.line);
  text += placedText(m.placed);
  for (const Finding& warning : m.warnings) text += "warning: " + sentence(warning) + "\n";
  return text;
}

std::string measuredJson(const Measured& m) {
  Json json = {{"version", HANDLEBODY_VERSION}, {"notice", kNotice}};
  json["path"] = m.path.empty() ? Json(nullptr) : Json(m.path);
  json["volume"] = m.volume.empty() ? Json(nullptr) : Json(m.volume);
  Json& objects = json["objects"] = Json::array();
  for (const MeasuredObject& o : m.objects) {
    Json object = {{"name", o.name}};
    object["measures"] = measuresToJson(o.measures);
    object["mesh"] = certificateToJson(o.certificate);
    objects.push_back(std::move(object));
  }
  Json& gaps = json["distances"] = Json::array();
  for (const MeasuredGap& g : m.gaps) gaps.push_back(gapToJson(g.from, g.to, g.gap));
  json["wall_thickness"] = nullptr;
  if (m.wall)
    json["wall_thickness"] = {
        {"sampling_mm", m.wall->wall.sampling},
        {"surfaces", Json::array({directedJson(m.wall->first, m.wall->wall.fromFirst),
                                  directedJson(m.wall->second, m.wall->wall.fromSecond)})}};
  json["centre_line"] = m.line ? lineJson(*m.line) : Json(nullptr);
  json["measurements"] = measurementsToJson(m.placed);
  json["warnings"] = sentences(m.warnings);
  return jsonText(json);
}

namespace {

//! Behind the lines of the objects, one each for rulers and angles: a table has the same columns throughout.
void addPlacedRows(std::vector<TableRow>& rows, const std::vector<Measurement>& placed) {
  TableRow blank;
  for (const std::string& name : rows.front().names) blank.add(name, Json());
  for (TableRow& row : rows) addPlaced(row, "object", nullptr);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    TableRow& row = rows.emplace_back(blank);
    row.values.front() = placedName(placed[i], i);
    addPlaced(row, placed[i]);
  }
}

std::vector<TableRow> rowsOf(const Measured& m) {
  std::vector<TableRow> rows;
  for (const MeasuredObject& o : m.objects) {
    TableRow& row = rows.emplace_back(rowOf(m, o));
    if (m.wall) addWall(row, *m.wall, isOfWall(m, o));
    if (m.line) row.add("centre_line_mm", o.name == m.line->object ? Json(m.line->line.length) : Json());
  }
  if (!rows.empty() && !m.placed.empty()) addPlacedRows(rows, m.placed);
  return rows;
}

}  // namespace

std::string measuredCsv(const Measured& m) {
  std::string text;
  for (const TableRow& row : rowsOf(m)) {
    if (text.empty()) text = csvLine(row.names);
    text += csvLine(row.values);
  }
  return text;
}

std::string measuredColumns(const Measured& m, char separator) {
  std::string text;
  const auto add = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      text += (i > 0 ? std::string(1, separator) : "") + cells[i];
    text += '\n';
  };
  for (const TableRow& row : rowsOf(m)) {
    if (text.empty()) add(row.names);
    add(row.values);
  }
  return text;
}

std::string sectionsCsv(const CentreLine& line) {
  std::string text;
  for (const CentreLinePoint& p : line.points) {
    TableRow row;
    row.add("along_mm", p.along);
    row.addPlace("place", p.place);
    row.addPlace("direction", p.direction, "");
    row.add("inscribed_radius_mm", p.radius);
    row.add("area_mm2", p.area ? Json(*p.area) : Json());
    row.add("equivalent_diameter_mm", p.area ? Json(p.equivalentDiameter()) : Json());
    if (text.empty()) text = csvLine(row.names);
    text += csvLine(row.values);
  }
  return text;
}

std::string measurementsCsv(const std::vector<Measurement>& placed) {
  std::string text;
  for (const Measurement& m : placed) {
    TableRow row;
    addPlaced(row, m);
    if (text.empty()) text = csvLine(row.names);
    text += csvLine(row.values);
  }
  return text;
}

std::string measurementsJson(const std::vector<Measurement>& placed) {
  Json json = {{"version", HANDLEBODY_VERSION}, {"notice", kNotice}};
  json["measurements"] = measurementsToJson(placed);
  return jsonText(json);
}

std::string centreLineJson(const MeasuredLine& m) {
  return jsonText({{"version", HANDLEBODY_VERSION}, {"notice", kNotice}, {"centre_line", lineJson(m)}});
}

}  // namespace handlebody
