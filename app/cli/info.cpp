#include <CLI/CLI.hpp>
#include <cstdio>
#include <limits>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/progress.h"
#include "core/io/formats/time_axis.h"
#include "core/io/formats/volume_io.h"
#include "core/io/report/json.h"
#include "core/io/report/label_file.h"
#include "core/io/report/parse.h"
#include "core/io/report/terminology_json.h"
#include "core/version.h"
#include "core/volume/intensity_statistics.h"

namespace handlebody::cli {

namespace {

struct InfoOptions {
  std::string path;
  VolumeSelection selection;
  bool json = false;
};

constexpr std::array kPercents{0.1, 1.0, 5.0, 25.0, 50.0, 75.0, 95.0, 99.0, 99.9};

// A folder with several series holds no one volume, and no frame, until one is chosen.
//! What only the voxels tell of the volume is told by its warnings, too.
std::optional<IntensityStatistics> intensities(VolumeInfo& info, const InfoOptions& o) {
  if (info.frames == 0) return std::nullopt;
  const LoadedVolume loaded = loadVolume(o.path, o.selection);
  info.warnings = loaded.info.warnings;
  return intensityStatistics(loaded.volume, kPercents);
}

std::string percentText(double percent) {
  char text[16];
  std::snprintf(text, sizeof text, "%g", percent);
  return text;
}

// Three letters: where the axes point, e.g. "LPS".
std::string orientation(const Grid& grid) {
  std::string letters;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Index largest = 0;
    grid.direction.col(axis).cwiseAbs().maxCoeff(&largest);
    letters += grid.direction(largest, axis) > 0 ? "LPS"[largest] : "RAI"[largest];
  }
  return letters;
}

Json seriesToJson(const SeriesInfo& s) {
  Json json = {{"uid", s.uid},
               {"modality", s.modality},
               {"description", s.description},
               {"files", s.files},
               {"slices", s.slices},
               {"size", s.size},
               {"frames", s.frames},
               {"spacing", vectorToJson(s.spacing)}};
  if (s.note.any()) json["note"] = sentence(s.note);
  return json;
}

//! "time_ms": null where the file does not say.
void addTimes(Json& json, const TimeAxis& times) {
  const bool known = !times.milliseconds.empty();
  json["time_ms"] = known ? Json(times.milliseconds) : Json(nullptr);
  json["frame_time_ms"] = evenStep(times) > 0 ? Json(evenStep(times)) : Json(nullptr);
  if (known) json["sources"]["time"] = times.source;
}

//! Of a segmentation.
Json labelsToJson(const FileLabels& labels) {
  Json json = Json::array();
  for (const auto& [number, label] : labels) {
    json.push_back({{"number", number}, {"name", label.name}, {"term", label.term}});
    addSource(json.back(), label.source);
  }
  return json;
}

Json toJson(const VolumeInfo& info, const FileLabels& labels, const TimeAxis& times,
            const std::optional<IntensityStatistics>& statistics) {
  Json json = {
      {"version", HANDLEBODY_VERSION}, {"notice", kNotice}, {"path", info.path}, {"format", info.format}};
  Json& series = json["series"] = Json::array();
  for (const SeriesInfo& s : info.series) series.push_back(seriesToJson(s));
  addGrid(json, info.grid);
  addSources(json, info);
  json["orientation"] = orientation(info.grid);
  json["type"] = voxelTypeName(info.type);
  json["frames"] = info.frames;
  if (info.frames > 1) addTimes(json, times);
  if (info.layers > 1) json["layers"] = info.layers;
  if (!labels.empty()) json["labels"] = labelsToJson(labels);
  json["intensities"] = nullptr;
  if (statistics) {
    Json percentiles = Json::object();
    for (std::size_t i = 0; i < kPercents.size(); ++i)
      percentiles[percentText(kPercents[i])] = statistics->percentiles[i];
    json["intensities"] = {{"min", statistics->minimum},
                           {"max", statistics->maximum},
                           {"mean", statistics->mean},
                           {"percentiles", std::move(percentiles)}};
  }
  json["warnings"] = sentences(info.warnings);
  return json;
}

void printSources(const VolumeInfo& info) {
  const GeometrySources& s = info.sources;
  std::printf("size from %s\n", s.size.c_str());
  for (std::size_t a = 0; a < 3; ++a)
    if (a == 0 || s.spacing[a] != s.spacing[a - 1])
      std::printf("spacing %c from %s%s\n", "xyz"[a], s.spacing[a].c_str(),
                  info.calibrated ? "" : " (uncalibrated)");
  std::printf("origin from %s; direction from %s\n", s.origin.c_str(), s.direction.c_str());
}

void printSeries(const SeriesInfo& s) {
  // A series without a UID is chosen by --series "".
  std::printf("series %s: %s, files %d, slices %d", s.uid.empty() ? "\"\"" : s.uid.c_str(),
              s.description.c_str(), s.files, s.slices);
  if (s.size[0] > 0)
    std::printf(", %d x %d x %d voxels of %g, %g, %g mm", s.size[0], s.size[1], s.size[2], s.spacing.x(),
                s.spacing.y(), s.spacing.z());
  std::printf(s.note.any() ? "; no volume: %s\n" : "\n", sentence(s.note).c_str());
}

void printTimes(int frames, const TimeAxis& times) {
  std::printf(", %d time points", frames);
  if (times.milliseconds.empty())
    std::printf(" (the file does not say when)");
  else if (const double step = evenStep(times); step > 0)
    std::printf(", %g ms apart (from %s)", step, times.source.c_str());
  else
    std::printf(", %g to %g ms, unevenly (from %s)", times.milliseconds.front(), times.milliseconds.back(),
                times.source.c_str());
}

void printGrid(const VolumeInfo& info, const TimeAxis& times) {
  const Grid& g = info.grid;
  std::printf("%d x %d x %d voxels, %s", g.size[0], g.size[1], g.size[2], voxelTypeName(info.type));
  if (info.frames > 1) printTimes(info.frames, times);
  std::printf("\n");
  std::printf("spacing %g, %g, %g mm; origin %g, %g, %g mm (LPS)\n", g.spacing.x(), g.spacing.y(),
              g.spacing.z(), g.origin.x(), g.origin.y(), g.origin.z());
  printSources(info);
  std::printf("axes point to %s; direction", orientation(g).c_str());
  for (int row = 0; row < 3; ++row)
    std::printf("%s %.4g %.4g %.4g", row ? " /" : "", g.direction(row, 0), g.direction(row, 1),
                g.direction(row, 2));
  std::printf("\n");
}

void printIntensities(const IntensityStatistics& statistics) {
  std::printf("intensities %g to %g, mean %g; percentiles", statistics.minimum, statistics.maximum,
              statistics.mean);
  for (std::size_t i = 0; i < kPercents.size(); ++i)
    std::printf("%s %g%%: %g", i ? "," : "", kPercents[i], statistics.percentiles[i]);
  std::printf("\n");
}

//! What is not wholly in our list is shown as it is.
std::string termText(const FileLabel& label) {
  if (!label.source.terminology) return label.term.empty() ? "" : " (" + label.term + ")";
  const CodedTerm& type = label.source.terminology->type.term;
  return " (" + type.scheme + " " + type.value + ": " + meaningOf(*label.source.terminology) + ")";
}

void printLabels(const FileLabels& labels) {
  for (const auto& [number, label] : labels)
    std::printf("label %d: %s%s\n", number, label.name.empty() ? "(no name)" : label.name.c_str(),
                termText(label).c_str());
}

void printText(const VolumeInfo& info, const FileLabels& labels, const TimeAxis& times,
               const std::optional<IntensityStatistics>& statistics) {
  std::printf("%s: %s\n", info.path.c_str(), info.format.c_str());
  for (const SeriesInfo& s : info.series) printSeries(s);
  if (statistics) {
    printGrid(info, times);
    printIntensities(*statistics);
  }
  printLabels(labels);
  for (const std::string& warning : sentences(info.warnings)) std::printf("warning: %s\n", warning.c_str());
}

int info(const InfoOptions& o) {
  const PhaseLine line(false);
  VolumeInfo found = inspectVolume(o.path, o.selection);
  const auto statistics = intensities(found, o);
  const TimeAxis times = found.frames > 1 ? readTimeAxis(o.path, o.selection) : TimeAxis{};
  const FileLabels labels = labelsSaidBy(o.path);
  if (o.json)
    std::fputs(jsonText(toJson(found, labels, times, statistics)).c_str(), stdout);
  else
    printText(found, labels, times, statistics);
  return kDone;
}

}  // namespace

void addInfo(CLI::App& app, Action& action) {
  CLI::App* command = addCommand(app, "info", "What a file or folder holds");
  auto options = std::make_shared<InfoOptions>();
  command->add_option("VOLUME", options->path, "A file, or a folder with DICOM series")->required();
  addSelection(*command, options->selection);
  command->add_flag("--json", options->json, "As JSON");
  command->callback([&action, options] { action = [options] { return info(*options); }; });
}

}  // namespace handlebody::cli
