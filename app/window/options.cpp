#include "app/window/options.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "core/io/formats/volume_files.h"
#include "core/io/lowered.h"
#include "core/io/report/session.h"
#include "core/version.h"

namespace handlebody::app {

namespace {

constexpr int kUsage = 2;

// "WxH"; CLI11 checks it before it is read.
std::string faultOfSize(const std::string& text) {
  const QStringList parts = QString::fromStdString(text).split(QLatin1Char('x'));
  const bool good = parts.size() == 2 && parts[0].toInt() >= 640 && parts[1].toInt() >= 480 &&
                    parts[0].toInt() <= 8192 && parts[1].toInt() <= 8192;
  return good ? std::string() : "'" + text + "' is not a size from 640x480 to 8192x8192";
}

std::string faultOfPicture(const std::string& path) {
  if (path.starts_with("--")) return "'" + path + "' is no path but an option";
  return lowered(path).ends_with(".png") ? std::string() : "'" + path + "' does not end in .png";
}

//! What is read where that file is opened. One that cannot be read is told of when it is.
std::vector<std::string> inputsIn(const std::string& file) {
  std::vector<std::string> inputs{file};
  if (!lowered(file).ends_with(".json")) return inputs;
  try {
    InputPaths asItSays;
    asItSays.mayBeUnnamed = true;
    for (const Session& session : readSessions(file, asItSays))
      for (std::string& path : inputsOf(session)) inputs.push_back(std::move(path));
  } catch (const InputError&) {
  }
  return inputs;
}

//! Why the picture may not be written there; empty: it may.
std::string faultOfOutput(const std::string& picture, const std::string& file) {
  if (picture.empty() || file.empty()) return {};
  for (const std::string& input : inputsIn(file))
    if (!input.empty() && belongsToVolume(picture, input))
      return "--screenshot " + picture + " cannot be written: it is the input, or a part of it";
  return {};
}

QSize sizeFrom(const std::string& text) {
  const QStringList parts = QString::fromStdString(text).split(QLatin1Char('x'));
  return {parts[0].toInt(), parts[1].toInt()};
}

struct Texts {
  std::string file, session, screenshot, view = "window", stage, step, appearance, language, size;
};

void addOptions(CLI::App& app, Texts& texts, Options& options) {
  auto* file =
      app.add_option("FILE", texts.file, "A volume, a folder with a DICOM series, a session or a report");
  app.add_option("--session", texts.session, "The same as FILE, for a session")
      ->type_name("FILE")
      ->excludes(file);
  auto* screenshot = app.add_option("--screenshot", texts.screenshot, "Write a picture and end")
                         ->type_name("OUT.png")
                         ->check(faultOfPicture);
  app.add_option("--view", texts.view, "What the picture shows (default window)")
      ->check(CLI::IsMember({"window", "all", "axial", "coronal", "sagittal", "3d"}))
      ->needs(screenshot);
  app.add_option("--iteration", options.iteration, "Grow the surface so far first")
      ->type_name("N")
      ->check(CLI::Range(0, 1'000'000))
      ->needs(screenshot);
  app.add_option("--stage", texts.stage, "Show this stage of the event at that iteration")
      ->check(CLI::IsMember({"collide", "refine", "open", "handle", "close"}))
      ->needs("--iteration");
  app.add_option("--size", texts.size, "Of the window in logical pixels")
      ->type_name("WxH")
      ->check(faultOfSize)
      ->needs(screenshot);
  app.add_option("--step", texts.step, "The step that the picture shows, or a panel")
      ->needs(screenshot)
      ->check(CLI::IsMember(
          {"open", "seed", "tune", "grow", "correct", "export", "measure", "sensitivity", "time"}));
  app.add_option("--appearance", texts.appearance, "Colours of the window")
      ->check(CLI::IsMember({"system", "light", "dark"}));
  app.add_option("--language", texts.language, "Language of the window (default: as set there)")
      ->check(CLI::IsMember({"system", "en", "de", "fr", "es", "zh_CN"}));
}

}  // namespace

std::optional<int> readOptions(int argc, char** argv, Options& options) {
  CLI::App app("Shows a medical volume and grows a certified surface in it.", "handlebody");
  app.footer(
      "For research use only; not a medical device. handlebody-cli does the same work without a window.");
  app.set_version_flag("--version", std::string("handlebody ") + HANDLEBODY_VERSION);
  Texts texts;
  addOptions(app, texts, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "handlebody: " << error.what() << ".\n";
    return kUsage;
  }
  const std::string& file = texts.file.empty() ? texts.session : texts.file;
  if (const std::string fault = faultOfOutput(texts.screenshot, file); !fault.empty()) {
    std::cerr << "handlebody: " << fault << ".\n";
    return kUsage;
  }
  options.file = QString::fromStdString(file);
  options.screenshot = QString::fromStdString(texts.screenshot);
  options.view = QString::fromStdString(texts.view);
  options.stage = QString::fromStdString(texts.stage);
  options.step = QString::fromStdString(texts.step);
  options.appearance = QString::fromStdString(texts.appearance);
  options.language = QString::fromStdString(texts.language);
  if (!texts.size.empty()) options.size = sizeFrom(texts.size);
  return std::nullopt;
}

}  // namespace handlebody::app
