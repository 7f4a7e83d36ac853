#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/cli/command.h"
#include "core/handles/handle_enumeration.h"
#include "core/io/report/json.h"
#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"

namespace handlebody::cli {

namespace {

struct HandlesOptions {
  std::string sizes;
  Family family = Family::balanced;
  bool json = false;
};

Family parseFamily(const std::string& text) {
  if (text == "balanced") return Family::balanced;
  if (text == "monotone") return Family::monotone;
  if (text == "all") return Family::all;
  throw OptionError("--family", "'" + text + "' is not balanced, monotone or all.");
}

int handles(const HandlesOptions& o) {
  const std::vector<int> sizes = parseIntegers("--sizes", o.sizes, 3);
  if (sizes.size() < 2)
    throw OptionError("--sizes", "'" + o.sizes + "' is not two or more loop sizes M1,M2,...");
  const HandleCount count = countHandles(sizes, o.family);
  if (o.json)
    std::fputs(jsonText({{"handles", count.handles}, {"generators", count.generators}}).c_str(), stdout);
  else
    std::printf("%llu handles, %llu generators\n", static_cast<unsigned long long>(count.handles),
                static_cast<unsigned long long>(count.generators));
  return kDone;
}

}  // namespace

void addHandles(CLI::App& app, Action& action) {
  CLI::App* command = addCommand(app, "handles", "How many handles join boundary loops of given sizes");
  auto options = std::make_shared<HandlesOptions>();
  command->add_option("--sizes", options->sizes, "Vertices of each loop")->type_name("M1,M2,...")->required();
  command
      ->add_option_function<std::string>(
          "--family", [o = options.get()](const std::string& t) { o->family = parseFamily(t); },
          "Which handles count (default balanced)")
      ->type_name("balanced|monotone|all");
  command->add_flag("--json", options->json, "As JSON");
  command->callback([&action, options] { action = [options] { return handles(*options); }; });
}

}  // namespace handlebody::cli
