#pragma once
// Between the engine's types and Python's.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <string_view>

#include "core/io/report/json.h"
#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace handlebody::python {

namespace py = pybind11;

//! dict, list, str, int, float, bool, None; the keys in their order.
py::object toPython(const Json& json);
//! The same of JSON text.
py::object toPython(const std::string& jsonText);

//! An option of the engine as Python has it: "edge-length" is "edge_length" (OptionSpelling).
std::string asArgument(std::string_view option);

//! (n, 3) float64 and (m, 3) int32, without a copy: what they show is kept alive by them, and cannot be
//! written.
py::array verticesView(const std::shared_ptr<const TriangleSoup>& mesh);
py::array facesView(const std::shared_ptr<const TriangleSoup>& mesh);
//! (nz, ny, nx) of the volume's type, the same.
py::array voxelsView(const Volume& volume);
//! The same of a volume that nobody else has: it can be written.
py::array ownVoxels(const Volume& volume);

//! Rows of three numbers and of three indices that exist. Throws UsageError.
TriangleSoup soupFrom(const py::object& vertices, const py::object& faces);

//! Three finite numbers. Throws UsageError that names `what`.
Vec3 vectorFrom(const py::object& value, const std::string& what);

}  // namespace handlebody::python
