#include "sample_volumes/phantom.h"
#include "sample_volumes/beating.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/outputs.h"
#include "core/errors.h"
#include "core/io/formats/sequence_writer.h"
#include "core/io/formats/volume_io.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/json.h"
#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"

namespace handlebody::cli {

namespace {

constexpr const char* kBeating = "beating";

struct PhantomCommand {
  std::string name, volume, truth, surface;
  PhantomOptions options;
  BeatingOptions beating;     //!< without its image
  std::string beatingOption;  //!< the first that was given of those that only it has
};

using Text = const std::string&;

void setSize(PhantomOptions& o, Text text) {
  const std::vector<int> size = parseIntegers("--size", text, 1);
  if (size.size() != 3) throw OptionError("--size", "'" + text + "' is not three whole numbers X,Y,Z.");
  std::copy(size.begin(), size.end(), o.size.begin());
}

void setSpacing(PhantomOptions& o, Text text) {
  o.spacing = parseVector("--spacing", text);
  if (!(o.spacing.minCoeff() > 0)) throw OptionError("--spacing", "'" + text + "' is not above 0.");
}

void setType(PhantomOptions& o, Text text) {
  for (VoxelType type : {VoxelType::uint8, VoxelType::int16, VoxelType::float32})
    if (text == voxelTypeName(type)) {
      o.type = type;
      return;
    }
  throw OptionError("--type", "'" + text + "' is not uint8, int16 or float32.");
}

double atLeast(Text option, Text text, double lowest) {
  const double value = parseNumber(option, text);
  if (!(value >= lowest) || !std::isfinite(value))
    throw OptionError(option, "'" + text + "' is not a finite number of at least " +
                                  std::to_string(static_cast<int>(lowest)) + ".");
  return value;
}

void addShape(CLI::App& command, PhantomOptions& o) {
  const auto add = [&command, &o](Text name, Text type, Text help, void (*set)(PhantomOptions&, Text)) {
    command
        .add_option_function<std::string>(
            name, [&o, set](Text t) { set(o, t); }, help)
        ->type_name(type);
  };
  add("--size", "X,Y,Z", "Voxels (default: the phantom's own extent)", setSize);
  add("--spacing", "X,Y,Z", "Millimetres (default 1,1,1)", setSpacing);
  add("--rotate", "RX,RY,RZ", "Rotation of the grid, degrees",
      [](PhantomOptions& p, Text t) { p.rotationDegrees = parseVector("--rotate", t); });
  add("--type", "uint8|int16|float32", "Voxel type (default uint8)", setType);
  add("--noise", "F", "Standard deviation as a fraction of the contrast",
      [](PhantomOptions& p, Text t) { p.noise = atLeast("--noise", t, 0); });
  add("--bias", "F", "Largest gain over smallest gain of a smooth field (default 1)",
      [](PhantomOptions& p, Text t) { p.bias = atLeast("--bias", t, 1); });
  add("--gap", "VOXELS", "Width of a hole in the wall",
      [](PhantomOptions& p, Text t) { p.gapVoxels = atLeast("--gap", t, 0); });
  add("--random-seed", "N", "Of the noise (default 1)", [](PhantomOptions& p, Text t) {
    p.randomSeed =
        static_cast<std::uint32_t>(parseInteger("--random-seed", t, 0, std::numeric_limits<int>::max()));
  });
}

void addBeating(CLI::App& command, PhantomCommand& c) {
  const auto add = [&command, &c](Text name, Text type, Text help, void (*set)(BeatingOptions&, Text)) {
    command
        .add_option_function<std::string>(
            name,
            [&c, name, set](Text t) {
              if (c.beatingOption.empty()) c.beatingOption = name;
              set(c.beating, t);
            },
            help)
        ->type_name(type);
  };
  add("--frames", "N", "beating: time points of one period (default 20)",
      [](BeatingOptions& o, Text t) { o.frames = parseInteger("--frames", t, 2, 10000); });
  add("--ejection", "PERCENT", "beating: ejection fraction (default 60)",
      [](BeatingOptions& o, Text t) { o.ejection = atLeast("--ejection", t, 0) / 100; });
  add("--period", "MS", "beating: period (default 1000)",
      [](BeatingOptions& o, Text t) { o.period = atLeast("--period", t, 0); });
  add("--torsion", "DEGREES", "beating: between base and apex at end systole (default 20)",
      [](BeatingOptions& o, Text t) { o.torsion = parseNumber("--torsion", t); });
  command.add_flag_callback(
      "--speckle",
      [&c] {
        if (c.beatingOption.empty()) c.beatingOption = "--speckle";
        c.beating.speckle = true;
      },
      "beating: speckle as in ultrasound instead of white noise");
}

void checkVolumeFile(const PhantomCommand& c, const OutputFile& file) {
  checkVolumeExtension(file);
  if (c.name == kBeating && !isSequencePath(file.path))
    throw UsageError(file.option + " " + file.path + ": 4D volumes are written as .nii.gz, .nii or .nrrd.");
}

void checkFiles(const PhantomCommand& c) {
  std::vector<OutputFile> files{{"-o", c.volume}};
  checkVolumeFile(c, files.back());
  if (!c.truth.empty()) {
    files.push_back({"--truth", c.truth});
    checkVolumeFile(c, files.back());
  }
  if (!c.surface.empty()) {
    files.push_back({"--surface", c.surface});
    checkMeshExtension(files.back());
  }
  checkWritable(files, {});
}

int beating(PhantomCommand c) {
  if (!c.surface.empty())
    throw OptionError("--surface",
                      "the phantom beating has a surface per frame; its truth is --truth LABEL.");
  c.beating.image = c.options;
  const BeatingPhantom made(c.beating);
  TimeAxis times;
  Json frames = Json::array();
  for (int f = 0; f < c.beating.frames; ++f) {
    times.milliseconds.push_back(made.time(f));
    frames.push_back({{"frame", f}, {"time_ms", made.time(f)}, {"volume_ml", made.volume(f) / 1000}});
  }
  {
    DeferSignals whole;
    writeSequence({made.grid(), c.options.type, c.beating.frames, times}, c.volume,
                  [&](int f) { return made.image(f); });
    if (!c.truth.empty())
      writeSequence({made.grid(), VoxelType::uint8, c.beating.frames, times}, c.truth,
                    [&](int f) { return made.truth(f); });
  }
  const Json json = {{"name", c.name},
                     {"seed", seedToJson({made.seed()})},
                     {"components", 1},
                     {"genus", Json::array({0})},
                     {"ejection_fraction", made.sampledEjection()},
                     {"frames", std::move(frames)}};
  std::fputs(jsonText(json).c_str(), stdout);
  return kDone;
}

int phantom(const PhantomCommand& c) {
  checkFiles(c);
  if (c.name == kBeating) return beating(c);
  if (!c.beatingOption.empty())
    throw UsageError(c.beatingOption + " is for the phantom beating; " + c.name + " does not move.");
  const Phantom made = makePhantom(c.name, c.options);
  {
    DeferSignals whole;
    writeVolume(made.volume, c.volume);
    if (!c.truth.empty()) writeVolume(made.truth, c.truth);
    if (!c.surface.empty()) writeMesh(phantomSurface(c.name, c.options), c.surface);
  }
  const Json json = {{"name", made.name},
                     {"seed", seedToJson({made.seed, made.seedRadius})},
                     {"components", made.genus.size()},
                     {"genus", made.genus}};
  std::fputs(jsonText(json).c_str(), stdout);
  return kDone;
}

std::string namesText() {
  std::string names;
  for (const std::string& name : phantomNames()) names += (names.empty() ? "" : " | ") + name;
  return names + " | " + kBeating;
}

}  // namespace

void addPhantom(CLI::App& app, Action& action) {
  CLI::App* command =
      addCommand(app, "phantom", "Make a volume of known shape; prints its seed and topology as JSON");
  auto options = std::make_shared<PhantomCommand>();
  command->add_option("NAME", options->name, namesText())->required();
  command->add_option("-o,--output", options->volume, "The volume: .nii .nii.gz .nrrd .mha")
      ->type_name("VOLUME")
      ->required();
  command->add_option("--truth", options->truth, "Its label map")->type_name("LABEL");
  command->add_option("--surface", options->surface, "The ideal surface")->type_name("MESH");
  addShape(*command, options->options);
  addBeating(*command, *options);
  command->callback([&action, options] { action = [options] { return phantom(*options); }; });
}

}  // namespace handlebody::cli
