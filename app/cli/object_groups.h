#pragma once
// Command lines of several objects: --object-name begins a group, and what follows is that object's.

#include <functional>
#include <string>
#include <vector>

namespace handlebody::cli {

//! An option of an object: whether there is one of that name (with its dashes), and whether it has a value.
enum class OptionKind { unknown, flag, value };

//! The arguments of a command line, sorted by whom they concern.
struct ObjectGroups {
  std::vector<std::string> run;                   //!< the volume, files and what else is the whole run's
  std::vector<std::string> common;                //!< options of objects before the first name
  std::vector<std::vector<std::string>> objects;  //!< each begins with its --object-name
};

//! True if the arguments of `segment` name two objects or more (and do not ask for help).
bool nameSeveralObjects(const std::vector<std::string>& arguments);

//! `kindOf` tells the options of objects; whatever is none belongs to the run, wherever it stands.
ObjectGroups groupArguments(const std::vector<std::string>& arguments,
                            const std::function<OptionKind(const std::string&)>& kindOf);

}  // namespace handlebody::cli
