#include "core/io/report/compared_table.h"

#include <cstdio>

#include "core/io/decimal_point.h"
#include "core/io/report/comparison_json.h"
#include "core/io/report/csv_line.h"
#include "core/units.h"

namespace handlebody {

namespace {

std::string cell(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string number(double value, const char* format = "%.4g") {
  const DecimalPoint point;
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string orNone(const Json& value, const char* format, double scale = 1) {
  return value.is_null() ? "-" : number(value.get<double>() / scale, format);
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
  std::string text = std::string(name) + ": " + (o.solid.mask ? "label map" : "mesh");
  if (!o.path.empty()) text += " " + o.path;
  if (o.label) text += ", label " + std::to_string(*o.label);
  return text + "\n";
}

std::string topologyLines(const Json& a, const Json& b) {
  std::string text;
  for (const char* name : {"components", "genus", "cavities"}) {
    const auto known = [name](const Json& object) {
      return object[name].is_null() ? "-" : std::to_string(object[name].get<int>());
    };
    text += line(name, known(a), known(b));
  }
  return text;
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
  const Json json = comparisonToJson(p), &a = json["a"], &b = json["b"];
  const auto millilitres = [](const Json& object) {
    return orNone(object["volume_mm3"], "%.6g", kMillilitre);
  };
  std::string text =
      objectLine("A", p.a) + objectLine("B", p.b) + line("", "A", "B") +
      line("volume (ml)", millilitres(a), millilitres(b)) +
      line("area (mm2)", orNone(a["area_mm2"], "%.6g"), orNone(b["area_mm2"], "%.6g")) + topologyLines(a, b) +
      line("Dice", orNone(json["dice"], "%.4f")) + line("IoU", orNone(json["iou"], "%.4f")) +
      line("volume difference, A - B (ml)", orNone(json["volume_difference_mm3"], "%.4g", kMillilitre),
           orNone(json["volume_difference_percent"], "%.2f %% of B"));
  if (p.found.distances) text += distanceLines(*p.found.distances);
  if (p.found.overlap) text += overlapText(*p.found.overlap);
  for (const Finding& warning : p.warnings) text += "warning: " + sentence(warning) + "\n";
  return text;
}

std::string comparisonCsv(const ComparedPair& p) {
  std::vector<std::string> names, values;
  const auto add = [&](const std::string& name, const Json& value) {
    names.push_back(name);
    values.push_back(cell(value));
  };
  const Json json = comparisonToJson(p), &a = json["a"], &b = json["b"], &d = json["distances"];
  const auto distance = [&d](const char* key) { return d.is_null() ? Json() : d[key]; };
  const auto mean = [&d](const char* way) { return d.is_null() ? Json() : d[way]["mean_mm"]; };
  for (const char* key : {"path", "label"}) {
    add(std::string("a_") + key, a[key]);
    add(std::string("b_") + key, b[key]);
  }
  for (const char* key : {"dice", "iou", "volume_difference_mm3", "volume_difference_percent"})
    add(key, json[key]);
  for (const char* key : {"mean_symmetric_mm", "hausdorff_95_mm", "hausdorff_mm"}) add(key, distance(key));
  add("mean_a_to_b_mm", mean("a_to_b"));
  add("mean_b_to_a_mm", mean("b_to_a"));
  for (const char* key : {"volume_mm3", "area_mm2", "components", "genus", "cavities", "closed"}) {
    add(std::string("a_") + key, a[key]);
    add(std::string("b_") + key, b[key]);
  }
  std::string warnings;
  for (const Finding& w : p.warnings) {
    if (!warnings.empty()) warnings += ' ';
    warnings += sentence(w);
  }
  add("warnings", warnings);
  return csvLine(names) + csvLine(values);
}

}  // namespace handlebody
