#include "python/options.h"

#include <algorithm>

#include "core/errors.h"
#include "core/io/report/growth_options.h"
#include "core/io/report/option_effects.h"
#include "python/bind.h"

namespace handlebody::python {

namespace py = pybind11;

namespace {

bool isText(py::handle value) { return py::isinstance<py::str>(value); }

//! Numbers of NumPy are numbers, too; True and False are none.
bool isNumber(py::handle value) {
  if (PyBool_Check(value.ptr()) || isText(value) || py::isinstance<py::sequence>(value)) return false;
  return PyIndex_Check(value.ptr()) || PyFloat_Check(value.ptr()) ||
         (py::hasattr(value, "__float__") && !py::hasattr(value, "__len__"));
}

bool isSequence(py::handle value) {
  return !isText(value) && !PyBytes_Check(value.ptr()) && !PyDict_Check(value.ptr()) &&
         py::hasattr(value, "__len__") && py::hasattr(value, "__getitem__");
}

[[noreturn]] void refuse(const std::string& key, py::handle value) {
  throw py::type_error(key + ": " + py::repr(value).cast<std::string>() +
                       " is not a number, a text or a sequence of numbers.");
}

//! The shortest text that reads back to the same number.
std::string textOfNumber(py::handle value) {
  if (PyIndex_Check(value.ptr())) return py::str(py::module_::import("operator").attr("index")(value));
  return py::repr(py::float_(py::reinterpret_borrow<py::object>(value)));
}

std::string textOf(const std::string& key, py::handle value) {
  if (isText(value)) return value.cast<std::string>();
  if (isNumber(value)) return textOfNumber(value);
  if (!isSequence(value)) refuse(key, value);
  std::string text;
  for (const py::handle number : value) {
    if (!isNumber(number)) refuse(key, value);
    text += (text.empty() ? "" : ",") + textOfNumber(number);
  }
  return text;
}

//! One text for each time that the option is given.
std::vector<std::string> textsOf(const std::string& key, py::handle value, bool isRepeated) {
  if (!isRepeated || !isSequence(value)) return {textOf(key, value)};
  std::vector<std::string> texts;
  if (py::len(value) > 0 && isNumber(value[py::int_(0)])) return {textOf(key, value)};
  for (const py::handle one : value) texts.push_back(textOf(key, one));
  return texts;
}

bool isClick(const std::string& key) {
  return key == "seed" || key == "seed_ijk" || key == "background" || key == "background_ijk";
}

void readOption(const std::string& key, py::handle value, Asked& asked) {
  std::string name = "--" + key;
  std::replace(name.begin(), name.end(), '_', '-');
  if (isClick(key)) {
    for (std::string& text : textsOf(key, value, true)) asked.clicks.push_back({name, std::move(text)});
    return;
  }
  const GrowthOption* option = findGrowthOption(name);
  if (!option || key.find('-') != std::string::npos)
    throw py::type_error("there is no option '" + key +
                         "'; those of `handlebody-cli segment` are meant, "
                         "with underscores, as edge_length.");
  asked.given.push_back(name);
  if (option->type.ends_with("LABELMAP"))
    return option->set(asked.parameters, asked.constraints,
                       pathOf(py::reinterpret_borrow<py::object>(value)));
  for (const std::string& text : textsOf(key, value, option->isRepeated))
    option->set(asked.parameters, asked.constraints, text);
}

}  // namespace

void readOptions(const py::kwargs& options, Asked& asked) {
  for (const auto& [key, value] : options)
    if (!value.is_none()) readOption(key.cast<std::string>(), value, asked);
  const auto& start = asked.constraints.start;
  if (start && start->path.empty() && !start->mesh)
    throw UsageError(
        "start_label says which voxels of a label map are meant, start_smooth, start_keep_largest and "
        "start_genus how they become a surface: give that map with start or given.");
  std::vector<std::string> names = asked.given;
  if (asked.parameters.range) names.emplace_back("--range");  // also one of before a change
  requireEffect(names, asked.constraints);
}

std::vector<std::string> optionNames() {
  std::vector<std::string> names{"seed", "seed_ijk", "background", "background_ijk"};
  for (const auto* options : {&parameterOptions(), &constraintOptions()})
    for (const GrowthOption& option : *options) {
      names.push_back(option.name.substr(2));
      std::replace(names.back().begin(), names.back().end(), '-', '_');
    }
  return names;
}

}  // namespace handlebody::python
