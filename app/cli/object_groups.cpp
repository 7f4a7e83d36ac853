#include "app/cli/object_groups.h"

#include <algorithm>

namespace handlebody::cli {

namespace {

const std::string kName = "--object-name";

//! The option of an argument, without "=value".
std::string optionOf(const std::string& argument) { return argument.substr(0, argument.find('=')); }

}  // namespace

bool nameSeveralObjects(const std::vector<std::string>& arguments) {
  const auto isHelp = [](const std::string& a) { return a == "--help" || a == "-h"; };
  const auto isName = [](const std::string& a) { return optionOf(a) == kName; };
  return std::count_if(arguments.begin(), arguments.end(), isName) > 1 &&
         std::none_of(arguments.begin(), arguments.end(), isHelp);
}

ObjectGroups groupArguments(const std::vector<std::string>& arguments,
                            const std::function<OptionKind(const std::string&)>& kindOf) {
  ObjectGroups groups;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const std::string option = optionOf(argument);
    const OptionKind kind = argument.rfind("--", 0) == 0 ? kindOf(option) : OptionKind::unknown;
    if (option == kName) groups.objects.emplace_back();
    std::vector<std::string>& group = kind == OptionKind::unknown ? groups.run
                                      : groups.objects.empty()    ? groups.common
                                                                  : groups.objects.back();
    group.push_back(argument);
    const bool hasValue = kind == OptionKind::value && option.size() == argument.size();
    // An option that follows is no value: what is missing is said by the parser.
    if (hasValue && i + 1 < arguments.size() && arguments[i + 1].rfind("--", 0) != 0)
      group.push_back(arguments[++i]);
  }
  return groups;
}

}  // namespace handlebody::cli
