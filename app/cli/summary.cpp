#include "app/cli/summary.h"

#include <algorithm>
#include <fstream>

#include "app/cli/csv.h"
#include "core/errors.h"
#include "core/io/report/json.h"
#include "core/units.h"

namespace handlebody::cli {

namespace {

Json readJson(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  Json json = Json::parse(file, nullptr, false);
  if (!json.is_object()) throw InputError(path + ": it cannot be read.");
  return json;
}

std::string text(const Json& number) { return number.dump(); }

template <typename List, typename Text>
std::string joined(const List& list, Text&& textOf) {
  std::string all;
  for (const auto& item : list) all += (all.empty() ? "" : ";") + textOf(item);
  return all;
}

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

//! What was wrong in a frame becomes a warning.
TimeMeasures timeMeasures(const Json& overTime, std::vector<std::string>& warnings) {
  TimeMeasures m;
  for (const Json& result : overTime.at("results")) {
    ++m.frames;
    m.failed += result.at("trusted").get<bool>() ? 0 : 1;
    for (const Json& fault : result.at("faults"))
      warnings.push_back("frame " + std::to_string(result.at("frame").get<int>()) + ": " +
                         fault.at("text").get<std::string>());
  }
  const Json& curve = overTime.at("curve");
  if (curve.is_null()) return m;
  m.endDiastole = kMillilitre * curve.at("end_diastole").at("volume_ml").get<double>();
  m.endSystole = kMillilitre * curve.at("end_systole").at("volume_ml").get<double>();
  m.strokeVolume = kMillilitre * curve.at("stroke_volume_ml").get<double>();
  m.ejectionFraction = curve.at("ejection_fraction").get<double>();
  return m;
}

//! In the order of the table's columns, with units in the names.
Json measuresToJson(const CaseMeasures& m) {
  return {{"volume_mm3", m.volume},
          {"area_mm2", m.area},
          {"largest_diameter_mm", m.largestDiameter},
          {"principal_extents_mm", m.extents},
          {"mean_intensity", m.meanIntensity ? Json(*m.meanIntensity) : Json()},
          {"components", m.components},
          {"genus", m.genus},
          {"vertices", m.vertices},
          {"faces", m.faces},
          {"iterations", m.iterations},
          {"stopped", m.stopped},
          {"unsupported_surface", orNull(m.unsupportedSurface)},
          {"seconds", m.seconds},
          {"peak_memory_mb", m.peakMegabytes},
          {"warnings", m.warnings},
          {"frames", m.overTime ? Json(m.overTime->frames) : Json()},
          {"frames_failed", m.overTime ? Json(m.overTime->failed) : Json()},
          {"end_diastole_mm3", m.overTime ? orNull(m.overTime->endDiastole) : Json()},
          {"end_systole_mm3", m.overTime ? orNull(m.overTime->endSystole) : Json()},
          {"stroke_volume_mm3", m.overTime ? orNull(m.overTime->strokeVolume) : Json()},
          {"ejection_fraction", m.overTime ? orNull(m.overTime->ejectionFraction) : Json()}};
}

std::string cellOf(const Json& value) {
  const auto plain = [](const Json& v) { return v.is_string() ? v.get<std::string>() : text(v); };
  if (value.is_null()) return "";
  return value.is_array() ? joined(value, plain) : plain(value);
}

}  // namespace

const char* statusName(CaseStatus status) {
  switch (status) {
    case CaseStatus::done:
      return "done";
    case CaseStatus::failed:
      return "failed";
    case CaseStatus::refused:
      return "refused";
    case CaseStatus::notRun:
      break;
  }
  return "not run";
}

int Summary::count(CaseStatus status) const {
  return static_cast<int>(std::count_if(rows.begin(), rows.end(),
                                        [status](const SummaryRow& row) { return row.status == status; }));
}

std::string summaryCsv(const Summary& summary) {
  std::vector<std::string> names{"case", "line", "volume", "status", "message"};
  const Json columns = measuresToJson({});
  for (const auto& column : columns.items()) names.push_back(column.key());
  names.push_back("folder");
  std::string table = csvLine(names);
  for (const SummaryRow& row : summary.rows) {
    std::vector<std::string> cells{row.name, std::to_string(row.line), row.volume, statusName(row.status),
                                   row.message};
    if (row.measures)
      for (const Json& value : measuresToJson(*row.measures)) cells.push_back(cellOf(value));
    cells.resize(names.size() - 1);
    cells.push_back(row.folder);
    table += csvLine(cells);
  }
  return table;
}

std::string summaryJson(const Summary& summary) {
  Json json = {{"version", summary.version}, {"notice", kNotice}, {"study", summary.study}};
  for (CaseStatus status : {CaseStatus::done, CaseStatus::failed, CaseStatus::refused, CaseStatus::notRun})
    json["counts"][statusName(status)] = summary.count(status);
  Json& cases = json["cases"] = Json::array();
  for (const SummaryRow& row : summary.rows) {
    Json& entry = cases.emplace_back(Json{
        {"case", row.name}, {"line", row.line}, {"volume", row.volume}, {"status", statusName(row.status)}});
    if (!row.message.empty()) entry["message"] = row.message;
    if (row.measures) entry["measures"] = measuresToJson(*row.measures);
    if (!row.folder.empty()) entry["folder"] = row.folder;
    if (!row.files.empty()) entry["files"] = row.files;
    if (!row.log.empty()) entry["log"] = row.log;
  }
  return jsonText(json);
}

CaseMeasures readMeasures(const std::string& folder) try {
  const Json report = readJson(folder + "/report.json"), record = readJson(folder + "/case.json");
  const Json& mesh = report.at("mesh");
  CaseMeasures m;
  mesh.at("volume_mm3").get_to(m.volume);
  mesh.at("area_mm2").get_to(m.area);
  const Json& shape = report.at("measures");
  shape.at("largest_diameter_mm").get_to(m.largestDiameter);
  shape.at("principal_extents_mm").get_to(m.extents);
  if (const Json& intensity = shape.at("intensity"); !intensity.is_null())
    m.meanIntensity = intensity.at("mean").get<double>();
  mesh.at("components").get_to(m.components);
  mesh.at("genus").get_to(m.genus);
  mesh.at("vertices").get_to(m.vertices);
  mesh.at("faces").get_to(m.faces);
  report.at("iterations").get_to(m.iterations);
  report.at("stopped").get_to(m.stopped);
  if (const Json& part = report.at("unsupported_surface"); !part.is_null())
    m.unsupportedSurface = part.get<double>();
  record.at("seconds").get_to(m.seconds);
  record.at("peak_memory_mb").get_to(m.peakMegabytes);
  m.warnings = report.at("input").at("warnings").get<std::vector<std::string>>();
  for (const Json& warning : report.at("warnings")) m.warnings.push_back(warning.get<std::string>());
  if (report.contains("over_time")) m.overTime = timeMeasures(report.at("over_time"), m.warnings);
  return m;
} catch (const Json::exception& error) {
  throw InputError(folder + ": its report lacks a number (" + error.what() + ").");
}

}  // namespace handlebody::cli
