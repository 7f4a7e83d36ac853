#include "app/cli/compare_result.h"

#include <cstdio>
#include <numeric>

#include "app/cli/csv.h"
#include "core/io/json.h"

namespace handlebody::cli {

namespace {

constexpr double kMillilitre = 1000;  // mm³

bool hasTopology(const Solid& s) {
  return s.empty() || (s.certificate.closed && s.certificate.manifold && s.certificate.oriented);
}

//! Components and cavities are both components of the surface.
int cavitiesOf(const Solid& s) { return s.empty() ? 0 : s.certificate.cavities; }
int componentsOf(const Solid& s) { return s.certificate.components - (hasTopology(s) ? cavitiesOf(s) : 0); }
int genusOf(const Solid& s) {
  return std::accumulate(s.certificate.genus.begin(), s.certificate.genus.end(), 0);
}

Json orNull(bool known, const Json& value) { return known ? value : Json(nullptr); }

Json volumeJson(const Solid& s) { return s.isClosed() ? Json(s.volume()) : Json(nullptr); }

Json objectJson(const ComparedObject& o) {
  const Solid& s = o.solid;
  Json json = {{"path", o.path}, {"kind", s.mask ? "label map" : "mesh"}};
  json["label"] = o.label ? Json(*o.label) : Json(nullptr);
  json["volume_mm3"] = volumeJson(s);
  json["area_mm2"] = s.certificate.area;
  json["components"] = componentsOf(s);
  json["genus"] = orNull(hasTopology(s), genusOf(s));
  json["cavities"] = orNull(hasTopology(s), cavitiesOf(s));
  json["closed"] = s.isClosed();
  return json;
}

Json directedJson(const DirectedDistances& d) {
  return {{"mean_mm", d.mean},
          {"percentile_95_mm", d.percentile95},
          {"largest_mm", d.largest},
          {"samples", d.samples}};
}

Json optionalJson(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

std::optional<double> volumeDifference(const ComparedPair& p) {
  if (!p.a.solid.isClosed() || !p.b.solid.isClosed()) return std::nullopt;
  return p.a.solid.volume() - p.b.solid.volume();
}

std::optional<double> volumeDifferencePercent(const ComparedPair& p) {
  const auto difference = volumeDifference(p);
  if (!difference || !(p.b.solid.volume() > 0)) return std::nullopt;
  return 100 * *difference / p.b.solid.volume();
}

std::string cell(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string number(double value, const char* format = "%.4g") {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string orNone(const std::optional<double>& value, const char* format) {
  return value ? number(*value, format) : "-";
}

//! Three columns, the last one ragged.
std::string line(const std::string& name, const std::string& a, const std::string& b = "") {
  std::string text = name;
  text.resize(std::max<std::size_t>(34, name.size() + 1), ' ');
  text += a;
  if (b.empty()) return text + "\n";
  text.resize(std::max<std::size_t>(50, text.size() + 1), ' ');
  return text + b + "\n";
}

std::string objectLine(const char* name, const ComparedObject& o) {
  std::string text = std::string(name) + ": " + (o.solid.mask ? "label map " : "mesh ") + o.path;
  if (o.label) text += ", label " + std::to_string(*o.label);
  return text + "\n";
}

std::string topologyLines(const Solid& a, const Solid& b) {
  const auto known = [](const Solid& s, int n) { return hasTopology(s) ? std::to_string(n) : "-"; };
  return line("components", std::to_string(componentsOf(a)), std::to_string(componentsOf(b))) +
         line("genus", known(a, genusOf(a)), known(b, genusOf(b))) +
         line("cavities", known(a, cavitiesOf(a)), known(b, cavitiesOf(b)));
}

std::string overlapText(const Overlap& o) {
  const std::string spacing =
      number(o.spacing.x()) + " x " + number(o.spacing.y()) + " x " + number(o.spacing.z());
  return (o.onVoxels ? "overlap counted at the centres of voxels of " : "overlap sampled at points ") +
         spacing + (o.onVoxels ? " mm\n" : " mm apart\n");
}

std::string distanceLines(const SurfaceDistances& d) {
  return line("distances (mm)", "A to B", "B to A") + line("  mean", number(d.ofA.mean), number(d.ofB.mean)) +
         line("  95 %", number(d.ofA.percentile95), number(d.ofB.percentile95)) +
         line("  largest", number(d.ofA.largest), number(d.ofB.largest)) +
         line("mean symmetric distance (mm)", number(d.mean())) +
         line("95 % Hausdorff distance (mm)", number(d.percentile95())) +
         line("Hausdorff distance (mm)", number(d.hausdorff())) + "distances sampled at pieces of " +
         number(d.sampling) + " mm, " + std::to_string(d.ofA.samples) + " on A, " +
         std::to_string(d.ofB.samples) + " on B\n";
}

}  // namespace

std::string comparisonText(const ComparedPair& p) {
  const auto millilitres = [](const Solid& s) {
    return s.isClosed() ? number(s.volume() / kMillilitre, "%.6g") : "-";
  };
  const auto difference = volumeDifference(p);
  std::string text =
      objectLine("A", p.a) + objectLine("B", p.b) + line("", "A", "B") +
      line("volume (ml)", millilitres(p.a.solid), millilitres(p.b.solid)) +
      line("area (mm2)", number(p.a.solid.certificate.area, "%.6g"),
           number(p.b.solid.certificate.area, "%.6g")) +
      topologyLines(p.a.solid, p.b.solid) + line("Dice", orNone(p.found.dice, "%.4f")) +
      line("IoU", orNone(p.found.iou, "%.4f")) +
      line("volume difference, A - B (ml)", difference ? number(*difference / kMillilitre) : "-",
           orNone(volumeDifferencePercent(p), "%.2f %% of B"));
  if (p.found.distances) text += distanceLines(*p.found.distances);
  if (p.found.overlap) text += overlapText(*p.found.overlap);
  for (const std::string& warning : p.warnings) text += "warning: " + warning + "\n";
  return text;
}

std::string comparisonJson(const ComparedPair& p) {
  Json json = {{"version", HANDLEBODY_VERSION}, {"notice", kNotice}};
  json["a"] = objectJson(p.a);
  json["b"] = objectJson(p.b);
  json["dice"] = optionalJson(p.found.dice);
  json["iou"] = optionalJson(p.found.iou);
  json["volume_difference_mm3"] = optionalJson(volumeDifference(p));
  json["volume_difference_percent"] = optionalJson(volumeDifferencePercent(p));
  json["overlap"] = nullptr;
  if (const auto& o = p.found.overlap)
    json["overlap"] = {{"points", o->onVoxels ? "voxels" : "lattice"},
                       {"spacing_mm", vectorToJson(o->spacing)},
                       {"a_mm3", o->a},
                       {"b_mm3", o->b},
                       {"both_mm3", o->both}};
  json["distances"] = nullptr;
  if (const auto& d = p.found.distances)
    json["distances"] = {{"mean_symmetric_mm", d->mean()}, {"hausdorff_95_mm", d->percentile95()},
                         {"hausdorff_mm", d->hausdorff()}, {"smallest_mm", d->smallest()},
                         {"sampling_mm", d->sampling},     {"a_to_b", directedJson(d->ofA)},
                         {"b_to_a", directedJson(d->ofB)}};
  json["warnings"] = p.warnings;
  return jsonText(json);
}

std::string comparisonCsv(const ComparedPair& p) {
  std::vector<std::string> names, values;
  const auto add = [&](const std::string& name, const Json& value) {
    names.push_back(name);
    values.push_back(cell(value));
  };
  const Json a = objectJson(p.a), b = objectJson(p.b);
  const auto& d = p.found.distances;
  for (const char* key : {"path", "label"}) {
    add(std::string("a_") + key, a[key]);
    add(std::string("b_") + key, b[key]);
  }
  add("dice", optionalJson(p.found.dice));
  add("iou", optionalJson(p.found.iou));
  add("volume_difference_mm3", optionalJson(volumeDifference(p)));
  add("volume_difference_percent", optionalJson(volumeDifferencePercent(p)));
  add("mean_symmetric_mm", d ? Json(d->mean()) : Json());
  add("hausdorff_95_mm", d ? Json(d->percentile95()) : Json());
  add("hausdorff_mm", d ? Json(d->hausdorff()) : Json());
  add("mean_a_to_b_mm", d ? Json(d->ofA.mean) : Json());
  add("mean_b_to_a_mm", d ? Json(d->ofB.mean) : Json());
  for (const char* key : {"volume_mm3", "area_mm2", "components", "genus", "cavities", "closed"}) {
    add(std::string("a_") + key, a[key]);
    add(std::string("b_") + key, b[key]);
  }
  std::string warnings;
  for (const std::string& w : p.warnings) warnings += (warnings.empty() ? "" : " ") + w;
  add("warnings", warnings);
  return csvLine(names) + csvLine(values);
}

}  // namespace handlebody::cli
