#include "python/mesh.h"

#include <filesystem>

#include "core/collision/certify.h"
#include "core/errors.h"
#include "core/io/formats/label_map.h"
#include "core/io/formats/volume_files.h"

namespace handlebody::python {

PythonMesh::PythonMesh(TriangleSoup mesh) : soup_(std::make_shared<const TriangleSoup>(std::move(mesh))) {}

PythonMesh::PythonMesh(CertifiedMesh mesh)
    : soup_(std::make_shared<const TriangleSoup>(std::move(mesh.mesh))),
      certificate_(std::move(mesh.certificate)) {}

const Certificate& PythonMesh::certificate() const {
  if (!certificate_) certificate_ = certify(*soup_);
  return *certificate_;
}

void PythonMesh::requireBody(const std::string& what) const {
  if (certificate().boundsBody()) return;
  throw InputError("The mesh does not bound a body, and has no inside to " + what + "; see its certificate.");
}

Volume PythonMesh::labelMap(const Grid& grid) const {
  requireBody("fill");
  return rasterize(*soup_, grid);
}

namespace {

void requireKnown(const std::string& path, const VolumeInfo* volume) {
  if (!isResultPath(path)) throw UsageError(path + ": its ending is unknown: " + resultEndings() + ".");
  if (isMeshPath(path) || volume) return;
  if (isLabelMapPath(path)) throw UsageError(path + ": a label map needs the volume whose grid it gets.");
}

CoordinateSpace spaceOf(const std::string& name) {
  if (name != "LPS" && name != "RAS") throw UsageError("space: '" + name + "' is not LPS or RAS.");
  return name == "RAS" ? CoordinateSpace::ras : CoordinateSpace::lps;
}

ObjectLabel labelOf(const SaveSettings& settings) {
  ObjectLabel label = settings.object;
  if (!settings.name.empty()) label.name = settings.name;
  if (const std::string fault = objectNameFault(label.name); !fault.empty())
    throw UsageError("name: '" + label.name + "' " + fault + ".");
  label.value = settings.label;
  if (label.value < 1 || label.value > kLargestLabel)
    throw UsageError("label: " + std::to_string(label.value) + " is not a whole number from 1 to " +
                     std::to_string(kLargestLabel) + ".");
  return label;
}

}  // namespace

void requireOther(const std::string& path, const std::string& input) {
  if (input.empty()) return;
  std::error_code failed;
  if (std::filesystem::is_directory(input, failed) && belongsToVolume(path, input))
    throw UsageError(path +
                     " would lie in the folder that was read, all of whose files belong to the volume.");
  if (std::filesystem::equivalent(path, input, failed) || belongsToVolume(path, input))
    throw UsageError(path + " belongs to what was read, and is not overwritten.");
}

std::vector<Finding> save(const TriangleSoup& mesh, const VolumeInfo* volume,
                          const std::vector<std::string>& paths, const SaveSettings& settings,
                          const std::vector<std::string>& inputs) {
  ExportContext context;
  context.space = spaceOf(settings.space);
  if (volume) {
    context.grid = volume->grid;
    context.dicom = volume->dicom;
  }
  for (const std::string& path : paths) {
    requireKnown(path, volume);
    for (const std::string& input : inputs) requireOther(path, input);
    checkResult(path, context);
  }
  if (context.space == CoordinateSpace::ras && areSpacesFixed(paths))
    throw UsageError(
        "space: RAS has no effect: .gltf (in metres, y up) and .stl.dcm (LPS) have a space of their own.");
  const ObjectLabel label = labelOf(settings);
  const TriangleSoup written = certifiedForExport(mesh).mesh;
  writeResults({{label, written}}, context, paths);
  return labelMapWarnings(written, context.grid, paths);
}

}  // namespace handlebody::python
