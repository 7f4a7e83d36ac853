// The extension handlebody._core. Names, arguments and docstrings for users stand in handlebody/__init__.pyi,
// too.

#include <exception>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/io/report/option_error.h"
#include "core/told_error.h"
#include "core/version.h"
#include "python/bind.h"
#include "python/convert.h"

namespace handlebody::python {

namespace {

// pybind11 takes a translator without state.
PyObject* inputError = nullptr;
PyObject* outputError = nullptr;
PyObject* usageError = nullptr;
PyObject* seedError = nullptr;
PyObject* warning = nullptr;

PyObject* newException(py::module_& module, const char* name, const py::object& bases, const char* doc) {
  const std::string full = std::string("handlebody.") + name;
  PyObject* type = PyErr_NewExceptionWithDoc(full.c_str(), doc, bases.ptr(), nullptr);
  if (!type) throw py::error_already_set();
  module.add_object(name, py::handle(type));
  return type;
}

//! With its options as arguments: of what carries no finding, none names any.
std::string messageOf(const std::exception& error) {
  if (const auto* option = dynamic_cast<const OptionError*>(&error)) return option->message(&asArgument);
  const Finding told = findingOf(error);
  return told.any() ? sentence(told, &asArgument) : error.what();
}

void raise(PyObject* type, const std::exception& error) { PyErr_SetString(type, messageOf(error).c_str()); }

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    raise(inputError, error);
  } catch (const OutputError& error) {
    raise(outputError, error);
  } catch (const UsageError& error) {
    raise(usageError, error);
  } catch (const SeedError& error) {
    raise(seedError, error);
  } catch (const Cancelled&) {
    PyErr_SetString(PyExc_KeyboardInterrupt, "");
  }
}

//! What set_decoder was told: an attribute of the module, which is where Python keeps such things.
constexpr const char* kDecoder = "_decoder";

py::module_ core() { return py::module_::import("handlebody._core"); }

void bindErrors(py::module_& module) {
  PyObject* base = newException(module, "Error", py::reinterpret_borrow<py::object>(PyExc_Exception),
                                "What a caller or a file can cause; the message is one sentence.");
  const auto also = [base](PyObject* builtin) {
    return py::make_tuple(py::handle(base), py::handle(builtin));
  };
  inputError = newException(module, "InputError", also(PyExc_ValueError),
                            "A file or an array cannot be read, is damaged or not supported.");
  outputError = newException(module, "OutputError", also(PyExc_OSError), "A file cannot be written.");
  usageError =
      newException(module, "UsageError", also(PyExc_ValueError), "An option has no meaning; it is named.");
  seedError = newException(module, "SeedError", also(PyExc_ValueError),
                           "A seed is outside of the volume or not in an object.");
  warning = newException(module, "HandlebodyWarning", py::reinterpret_borrow<py::object>(PyExc_UserWarning),
                         "Something about a file that was read is doubtful.");
  py::register_exception_translator(translate);
}

}  // namespace

std::string pathOf(const py::object& path) {
  const py::object bytes = py::module_::import("os").attr("fsencode")(path);
  return bytes.cast<std::string>();
}

DecoderSettings decoderToUse() { return {core().attr(kDecoder).cast<std::string>()}; }

void warn(const std::vector<Finding>& findings) {
  for (const std::string& told : sentences(findings, &asArgument))
    if (PyErr_WarnEx(warning, told.c_str(), 1) != 0) throw py::error_already_set();
}

}  // namespace handlebody::python

PYBIND11_MODULE(_core, module) {
  using namespace handlebody::python;
  module.doc() = "Handlebody: from a medical volume and a seed to a certified surface mesh.";
  module.attr("__version__") = HANDLEBODY_VERSION;
  py::options options;
  options.disable_function_signatures();
  bindErrors(module);
  module.attr(kDecoder) = py::bytes();
  bindVolume(module);
  bindMesh(module);
  bindContour(module);
  bindCompare(module);
  module.def(
      "set_decoder", [](const py::object& program) { core().attr(kDecoder) = py::bytes(pathOf(program)); },
      py::arg("program"),
      "set_decoder(program)\n\nThe path of the handlebody-cli that decodes DICOM, TIFF and VTP files in a "
      "process of "
      "its own.");
}
