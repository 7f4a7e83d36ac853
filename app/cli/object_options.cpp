#include "app/cli/object_options.h"

#include <CLI/CLI.hpp>

#include "core/io/report/label_file.h"
#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"

namespace handlebody::cli {

namespace {

using Text = const std::string&;

void setName(ObjectOptions& o, Text text) {
  if (const std::string fault = objectNameFault(text); !fault.empty())
    throw OptionError("--object-name", "'" + text + "' " + fault + ".");
  o.name = text;
}

void setColour(ObjectOptions& o, Text text) {
  const std::vector<int> parts = parseIntegers("--color", text, 0);
  Colour colour{};
  if (parts.size() != colour.size()) throw OptionError("--color", "'" + text + "' is not R,G,B.");
  for (std::size_t i = 0; i < colour.size(); ++i) {
    if (parts[i] > 255) throw OptionError("--color", "'" + text + "' is not within 0 and 255.");
    colour[i] = static_cast<std::uint8_t>(parts[i]);
  }
  o.colour = colour;
}

std::string termNames() {
  std::string names;
  for (const Term& term : terms()) names += (names.empty() ? "" : ", ") + term.name;
  return names;
}

void setTerm(ObjectOptions& o, Text text) {
  if (!termFromName(text)) throw OptionError("--term", "'" + text + "' is none of " + termNames() + ".");
  o.term = text;
}

}  // namespace

void addObjectOptions(CLI::App& command, ObjectOptions& options) {
  const auto add = [&](Text name, Text type, Text help, void (*set)(ObjectOptions&, Text)) {
    command
        .add_option_function<std::string>(
            name, [&options, set](Text t) { set(options, t); }, help)
        ->type_name(type);
  };
  add("--object-name", "NAME",
      "What the object is called in files that hold names (default Object); given again in `segment` it "
      "begins another object, whose options follow",
      setName);
  add("--term", "TERM", "What it is, as a code of SNOMED CT (default tissue): " + termNames(), setTerm);
  add("--color", "R,G,B", "Its colour, 0 to 255 each (default: the term's)", setColour);
  add("--label-value", "N", "The value of its voxels in a label map (default 1)",
      [](ObjectOptions& o, Text t) { o.value = parseInteger("--label-value", t, 1, kLargestLabel); });
}

ObjectLabel chosenLabel(const ObjectOptions& options, const ObjectLabel& before) {
  ObjectLabel label = before;
  if (options.term) {
    const Term& term = *termFromName(*options.term);
    if (label.name == ObjectLabel{}.name) label.name = term.type.meaning;
    label.term = term.name;
    label.source.terminology.reset();
    label.colour = term.colour;
  }
  if (options.name) label.name = *options.name;
  if (options.colour) label.colour = *options.colour;
  if (options.value) label.value = *options.value;
  return label;
}

}  // namespace handlebody::cli
