// Mesh, read_mesh.

#include <pybind11/stl.h>

#include "core/io/meshes/mesh_io.h"
#include "core/io/report/measures_json.h"
#include "python/bind.h"
#include "python/convert.h"
#include "python/work.h"

namespace handlebody::python {

namespace {

using MeshPointer = std::shared_ptr<PythonMesh>;

//! The certificate is worked out once, and by one thread at a time.
std::mutex& certificateMutex() {
  static std::mutex mutex;
  return mutex;
}

py::object certificateOf(const PythonMesh& mesh) {
  withoutLock([&] {
    const std::lock_guard lock(certificateMutex());
    mesh.certificate();
  });
  return toPython(certificateToJson(mesh.certificate()));
}

py::array labelMapOf(const PythonMesh& mesh, const py::object& on) {
  const Grid grid = gridOf(on);
  Volume labels;
  withoutLock([&] {
    const std::lock_guard lock(certificateMutex());
    labels = mesh.labelMap(grid);
  });
  return ownVoxels(labels);
}

py::object measureMesh(const PythonMesh& mesh, const VolumePointer& volume) {
  ObjectMeasures measures;
  withoutLock([&] {
    const std::lock_guard lock(certificateMutex());
    mesh.requireBody("measure");
    measures = objectMeasures(*mesh.soup(), volume ? &volume->loaded.volume : nullptr);
  });
  return toPython(measuresToJson(measures));
}

void saveMesh(const PythonMesh& mesh, const py::object& to, const VolumePointer& volume,
              const std::string& space, const std::string& name, int label) {
  const std::string path = pathOf(to);
  std::vector<Finding> warnings;
  withoutLock([&] {
    const std::lock_guard lock(filesMutex());
    std::vector<std::string> inputs;
    if (volume) inputs.push_back(volume->loaded.info.path);
    warnings =
        save(*mesh.soup(), volume ? &volume->loaded.info : nullptr, {path}, {space, name, label, {}}, inputs);
  });
  warn(warnings);
}

MeshPointer readMeshOf(const py::object& from) {
  const std::string path = pathOf(from);
  const DecoderSettings decoder = decoderToUse();
  MeshPointer mesh;
  withoutLock([&] {
    const std::lock_guard lock(filesMutex());
    mesh = std::make_shared<PythonMesh>(readMesh(path, decoder));
  });
  return mesh;
}

std::string nameOf(const PythonMesh& mesh) {
  return "<handlebody.Mesh " + std::to_string(mesh.soup()->points.size()) + " vertices, " +
         std::to_string(mesh.soup()->triangles.size()) + " faces>";
}

}  // namespace

Grid gridOf(const py::object& grid) {
  if (py::isinstance<PythonVolume>(grid)) return grid.cast<VolumePointer>()->loaded.volume.grid;
  if (!py::isinstance<Grid>(grid)) throw py::type_error("grid: a Grid or a Volume is wanted.");
  return grid.cast<Grid>();
}

void bindMesh(py::module_& module) {
  py::class_<PythonMesh, MeshPointer> mesh(module, "Mesh",
                                           "Mesh(vertices, faces)\n\nTriangles in mm LPS, counter-clockwise "
                                           "seen from outside. A mesh never changes. "
                                           "Of any kind; what needs an inside refuses a mesh that has none.");
  mesh.def(py::init([](const py::object& vertices, const py::object& faces) {
             return std::make_shared<PythonMesh>(soupFrom(vertices, faces));
           }),
           py::arg("vertices"), py::arg("faces"));
  mesh.def_property_readonly(
      "vertices", [](const PythonMesh& m) { return verticesView(m.soup()); },
      "(n, 3) float64, mm LPS: a view without a copy that cannot be written and stays valid.");
  mesh.def_property_readonly(
      "faces", [](const PythonMesh& m) { return facesView(m.soup()); },
      "(m, 3) int32, indices into vertices: a view like vertices.");
  mesh.def("certificate", &certificateOf,
           "certificate()\n\n'mesh' of a report: closed, manifold, oriented, self_intersections, genus, "
           "components, "
           "volume_mm3 and so on.");
  mesh.def(
      "measure", &measureMesh, py::arg("volume") = py::none(),
      "measure(volume=None)\n\n'measures' of a report: volume, area, diameters, extents, and of a volume the "
      "intensities inside. Raises InputError for a mesh that does not bound a body.");
  mesh.def("label_map", &labelMapOf, py::arg("grid"),
           "label_map(grid)\n\nuint8 array z, y, x on a Grid or the grid of a Volume: 1 where the voxel's "
           "centre lies "
           "inside. Raises InputError for a mesh that does not bound a body.");
  mesh.def(
      "save", &saveMesh, py::arg("path"), py::kw_only(), py::arg("volume") = py::none(),
      py::arg("space") = "LPS", py::arg("name") = "", py::arg("label") = 1,
      "save(path, *, volume=None, space='LPS', name='', label=1)\n\nWrites by extension as the command line "
      "does: rounded to single precision, certified, whole or not at all. Label maps and DICOM files need "
      "the "
      "volume. Raises UsageError, OutputError; RuntimeError for a mesh that fails its certificate.");
  mesh.def("__repr__", &nameOf);
  module.def("read_mesh", &readMeshOf, py::arg("path"),
             "read_mesh(path)\n\nReads .stl, .vtp, .ply, .obj, .3mf or .stl.dcm. Raises InputError.");
}

}  // namespace handlebody::python
