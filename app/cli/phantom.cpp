#include "sample_volumes/phantom.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/outputs.h"
#include "core/errors.h"
#include "core/io/json.h"
#include "core/io/mesh_io.h"
#include "core/io/parse.h"
#include "core/io/volume_io.h"

namespace handlebody::cli {

namespace {

struct PhantomCommand {
  std::string name, volume, truth, surface;
  PhantomOptions options;
};

using Text = const std::string&;

void setSize(PhantomOptions& o, Text text) {
  const std::vector<int> size = parseIntegers("--size", text, 1);
  if (size.size() != 3) throw UsageError("--size: '" + text + "' is not three whole numbers X,Y,Z.");
  std::copy(size.begin(), size.end(), o.size.begin());
}

void setSpacing(PhantomOptions& o, Text text) {
  o.spacing = parseVector("--spacing", text);
  if (!(o.spacing.minCoeff() > 0)) throw UsageError("--spacing: '" + text + "' is not above 0.");
}

void setType(PhantomOptions& o, Text text) {
  for (VoxelType type : {VoxelType::uint8, VoxelType::int16, VoxelType::float32})
    if (text == voxelTypeName(type)) {
      o.type = type;
      return;
    }
  throw UsageError("--type: '" + text + "' is not uint8, int16 or float32.");
}

double atLeast(Text option, Text text, double lowest) {
  const double value = parseNumber(option, text);
  if (!(value >= lowest) || !std::isfinite(value))
    throw UsageError(option + ": '" + text + "' is not a finite number of at least " +
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

void checkFiles(const PhantomCommand& c) {
  std::vector<OutputFile> files{{"-o", c.volume}};
  checkVolumeExtension(files.back());
  if (!c.truth.empty()) {
    files.push_back({"--truth", c.truth});
    checkVolumeExtension(files.back());
  }
  if (!c.surface.empty()) {
    files.push_back({"--surface", c.surface});
    checkMeshExtension(files.back());
  }
  checkWritable(files, {});
}

int phantom(const PhantomCommand& c) {
  checkFiles(c);
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
  return names;
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
  command->callback([&action, options] { action = [options] { return phantom(*options); }; });
}

}  // namespace handlebody::cli
