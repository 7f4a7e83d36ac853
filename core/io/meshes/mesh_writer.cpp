#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include "core/io/atomic_file.h"
#include "core/io/lowered.h"
#include "core/io/meshes/mesh_files.h"
#include "core/phase.h"
#include "core/told_error.h"

namespace handlebody {
namespace {

std::string endingOf(const std::string& path) {
  const auto dot = path.rfind('.');
  return dot == std::string::npos ? "" : lowered(path.substr(dot));
}

vtkNew<vtkPolyData> toVtk(const MeshFile& file) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(file.mesh.points.size()));
  for (std::size_t i = 0; i < file.mesh.points.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), file.mesh.points[i].data());
  vtkNew<vtkCellArray> polygons;
  polygons->AllocateExact(static_cast<vtkIdType>(file.mesh.triangles.size()),
                          static_cast<vtkIdType>(3 * file.mesh.triangles.size()));
  for (const Triangle& t : file.mesh.triangles) polygons->InsertNextCell({t[0], t[1], t[2]});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

//! f(part, face), face by face.
template <typename F>
void forEachFace(const MeshFile& file, F&& f) {
  vtkIdType face = 0;
  for (const MeshPart& part : file.parts)
    for (std::size_t i = 0; i < part.triangles; ++i) f(part, face++);
}

//! Labels per face; which label has which name is in the field data.
void addLabels(const MeshFile& file, vtkPolyData* data) {
  if (file.parts.empty()) return;
  vtkNew<vtkIntArray> perFace, labels;
  vtkNew<vtkStringArray> names;
  perFace->SetName("Label");
  perFace->SetNumberOfValues(data->GetNumberOfCells());
  forEachFace(file, [&](const MeshPart& part, vtkIdType face) { perFace->SetValue(face, part.label); });
  labels->SetName("LabelValues");
  names->SetName("LabelNames");
  for (const MeshPart& part : file.parts) {
    labels->InsertNextValue(part.label);
    names->InsertNextValue(part.name);
  }
  data->GetCellData()->SetScalars(perFace);
  data->GetFieldData()->AddArray(labels);
  data->GetFieldData()->AddArray(names);
}

void addColours(const MeshFile& file, vtkPolyData* data, vtkPLYWriter* writer) {
  if (file.parts.empty()) return;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Colour");
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(data->GetNumberOfCells());
  forEachFace(
      file, [&](const MeshPart& part, vtkIdType face) { colours->SetTypedTuple(face, part.colour.data()); });
  data->GetCellData()->SetScalars(colours);
  writer->SetArrayName("Colour");
}

bool writeStl(const MeshFile& file, const std::string& temporary) {
  vtkNew<vtkSTLWriter> writer;
  // A binary header must not begin with "solid".
  const std::string header = spaceMark(file.space) + " Handlebody binary STL, mm";
  writer->SetHeader(header.c_str());
  writer->SetFileTypeToBinary();
  writer->SetFileName(temporary.c_str());
  const auto data = toVtk(file);
  writer->SetInputData(data);
  return writer->Write() == 1 && writer->GetErrorCode() == 0;
}

bool writePly(const MeshFile& file, const std::string& temporary) {
  vtkNew<vtkPLYWriter> writer;
  writer->AddComment(spaceMark(file.space));
  writer->SetFileTypeToBinary();
  writer->SetDataByteOrderToLittleEndian();
  writer->SetFileName(temporary.c_str());
  const auto data = toVtk(file);
  addColours(file, data, writer);
  writer->SetInputData(data);
  return writer->Write() == 1 && writer->GetErrorCode() == 0;
}

void addValues(const MeshFile& file, vtkPolyData& data) {
  vtkNew<vtkFloatArray> array;
  array->SetName(file.valueName.c_str());
  for (const double value : file.values) array->InsertNextValue(static_cast<float>(value));
  data.GetPointData()->SetScalars(array);
}

bool writeVtp(const MeshFile& file, const std::string& temporary) {
  const auto data = toVtk(file);
  if (!file.values.empty()) addValues(file, *data);
  vtkNew<vtkStringArray> space;
  space->SetName("SPACE");
  space->InsertNextValue(file.space == CoordinateSpace::lps ? "LPS" : "RAS");
  data->GetFieldData()->AddArray(space);
  addLabels(file, data);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(temporary.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetInputData(data);
  return writer->Write() == 1 && writer->GetErrorCode() == 0;
}

bool writeAny(const MeshFile& file, const std::string& ending, const std::string& temporary) {
  if (ending == ".stl") return writeStl(file, temporary);
  if (ending == ".ply") return writePly(file, temporary);
  if (ending == ".vtp") return writeVtp(file, temporary);
  writeObj(file, temporary);
  return true;
}

//! VTK does not notice a full disk in every format: read it back before the file gets its name. A file of our
//! own needs no process of its own to read it in.
bool arrived(const MeshFile& file, const std::string& temporary) {
  const PhaseScope noPhases({});  // it is a part of writing
  try {
    const TriangleSoup back =
        endingOf(temporary) == ".vtp" ? readVtpHere(temporary).mesh : readMesh(temporary);
    return back.triangles.size() == file.mesh.triangles.size() &&
           (endingOf(temporary) == ".stl" || back.points.size() == file.mesh.points.size());
  } catch (const InputError&) {
    return false;
  }
}

void writeWhole(const MeshFile& file, const std::string& path, FileSet* set) {
  for (const Vec3& p : file.mesh.points)
    if (!p.allFinite()) refuseOutput(path, FindingKind::badCoordinate);
  const auto write = [&](const std::string& temporary) {
    const VtkSilence silence;
    bool written = false;
    try {
      written = writeAny(file, endingOf(path), temporary) && arrived(file, temporary);
    } catch (const OutputError&) {
      // Said below, with the right name.
    }
    if (!written) refuseOutput(path, FindingKind::notOnDisk);
  };
  writeAtomically(path, write, set);
}

}  // namespace

bool isMeshPath(const std::string& path) {
  const std::string ending = endingOf(path);
  return ending == ".stl" || ending == ".vtp" || ending == ".ply" || ending == ".obj";
}

void writeMesh(const TriangleSoup& mesh, const std::string& path, CoordinateSpace space,
               const std::vector<MeshPart>& parts, FileSet* set) {
  if (!isMeshPath(path)) throw Told<UsageError>(Finding(FindingKind::noMeshEnding, {{"file", path}}));
  MeshFile file{mesh, space};
  file.parts = parts;
  if (space == CoordinateSpace::ras)
    for (Vec3& p : file.mesh.points) p = Vec3(-p.x(), -p.y(), p.z());  // a rotation: the winding stays
  writeWhole(file, path, set);
}

void writeMeshWithValues(const TriangleSoup& mesh, const std::vector<double>& values, const std::string& name,
                         const std::string& path) {
  if (endingOf(path) != ".vtp")
    throw Told<UsageError>(Finding(FindingKind::noValuesEnding, {{"file", path}}));
  writeWhole({mesh, CoordinateSpace::lps, values, name}, path, nullptr);
}

}  // namespace handlebody
