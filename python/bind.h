#pragma once
// The parts of the module.

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "core/finding.h"
#include "core/io/decoder_settings.h"
#include "core/volume/volume.h"
#include "python/contour.h"

namespace handlebody::python {

namespace py = pybind11;

void bindVolume(py::module_& module);
void bindMesh(py::module_& module);
void bindCompare(py::module_& module);
void bindContour(py::module_& module);

using VolumePointer = std::shared_ptr<PythonVolume>;

//! A path as Python's functions take it: str, bytes or os.PathLike.
std::string pathOf(const py::object& path);
//! That of a Grid or a Volume. Throws TypeError.
Grid gridOf(const py::object& grid);
//! For readings that begin now. Precondition: the caller holds the interpreter's lock.
DecoderSettings decoderToUse();
//! Issues handlebody.HandlebodyWarning for each.
void warn(const std::vector<Finding>& findings);

}  // namespace handlebody::python
