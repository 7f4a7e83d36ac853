#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCommand.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <unordered_map>

#include "core/io/lowered.h"
#include "core/io/meshes/mesh_files.h"
#include "core/io/meshes/three_mf.h"
#include "core/io/refuse_input.h"
#include "core/phase.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path, const Finding& cause) { refuseInput(path, cause); }

std::string bytesOfFile(const std::string& path, std::uint64_t from, std::size_t n) {
  std::string text(n, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(from));
  stream.read(text.data(), static_cast<std::streamsize>(n));
  text.resize(std::max<std::streamsize>(0, stream.gcount()));
  return text;
}

//! Runs a VTK reader; any error event refuses the file.
template <typename Reader>
vtkPolyData* run(Reader* reader, const std::string& path) {
  bool failed = false;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&failed);
  observer->SetCallback(
      [](vtkObject*, unsigned long, void* flag, void*) { *static_cast<bool*>(flag) = true; });
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->SetFileName(path.c_str());
  reader->Update();
  if (failed || reader->GetErrorCode() != 0 || !reader->GetOutput()) refuse(path, FindingKind::meshDamaged);
  return reader->GetOutput();
}

TriangleSoup fromVtk(vtkPolyData* data, const std::string& path) {
  TriangleSoup soup;
  const vtkIdType count = data->GetNumberOfPoints();
  if (data->GetNumberOfStrips() > 0) refuse(path, FindingKind::triangleStrips);
  soup.points.resize(count);
  for (vtkIdType i = 0; i < count; ++i) data->GetPoint(i, soup.points[i].data());
  const auto cells = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType n = 0;
    const vtkIdType* v = nullptr;
    cells->GetCurrentCell(n, v);
    for (vtkIdType i = 0; i < n; ++i)
      if (v[i] < 0 || v[i] >= count) refuse(path, FindingKind::faceVertexMissing);
    for (vtkIdType i = 2; i < n; ++i)
      soup.triangles.push_back({static_cast<int>(v[0]), static_cast<int>(v[i - 1]), static_cast<int>(v[i])});
  }
  return soup;
}

// --- STL ---

struct VecHash {
  std::size_t operator()(const std::array<std::uint64_t, 3>& key) const {
    return static_cast<std::size_t>((key[0] * 73856093u) ^ (key[1] * 19349663u) ^ (key[2] * 83492791u)) *
               0x9E3779B97F4A7C15u >>
           7;
  }
};

//! Merges corners with equal coordinates (-0 equals 0); vertices in order of first use.
class Merger {
 public:
  int vertex(const Vec3& p) {
    std::array<std::uint64_t, 3> key{};
    for (int a = 0; a < 3; ++a) {
      const double value = p[a] == 0 ? 0.0 : p[a];
      std::memcpy(&key[a], &value, sizeof value);
    }
    const auto [found, fresh] = indices_.try_emplace(key, static_cast<int>(soup.points.size()));
    if (fresh) soup.points.push_back(p);
    return found->second;
  }
  TriangleSoup soup;

 private:
  std::unordered_map<std::array<std::uint64_t, 3>, int, VecHash> indices_;
};

constexpr std::size_t kStlHeader = 84, kStlRecord = 50;

//! The number of triangles that a header of kStlHeader bytes gives.
std::uint32_t trianglesIn(std::string_view header) {
  std::uint32_t count = 0;
  std::memcpy(&count, header.data() + 80, sizeof count);
  return count;
}

void addTriangle(const char* record, Merger& merger) {
  float corners[9];
  std::memcpy(corners, record + 12, sizeof corners);
  Triangle t{};
  for (std::size_t c = 0; c < 3; ++c)
    t[c] = merger.vertex(Vec3(corners[3 * c], corners[3 * c + 1], corners[3 * c + 2]));
  merger.soup.triangles.push_back(t);
}

TriangleSoup readBinaryStl(const std::string& path, std::size_t count) {
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(kStlHeader);
  Merger merger;
  for (std::size_t i = 0; i < count; ++i) {
    char record[kStlRecord];
    if (!stream.read(record, kStlRecord))
      refuse(path, {FindingKind::truncatedFormat, {{"format", std::string("STL")}}});
    addTriangle(record, merger);
  }
  return std::move(merger.soup);
}

TriangleSoup readTextStl(const std::string& path) {
  vtkNew<vtkSTLReader> reader;
  reader->MergingOff();
  const TriangleSoup loose = fromVtk(run(reader.Get(), path), path);
  Merger merger;
  for (const Triangle& t : loose.triangles) {
    Triangle merged{};
    for (std::size_t c = 0; c < 3; ++c) merged[c] = merger.vertex(loose.points[t[c]]);
    merger.soup.triangles.push_back(merged);
  }
  return std::move(merger.soup);
}

MeshFile readStl(const std::string& path) {
  const std::string start = bytesOfFile(path, 0, kStlHeader);
  const std::uint64_t size = fs::file_size(path);
  MeshFile file;
  file.space = spaceIn(start);
  const std::uint32_t count = start.size() == kStlHeader ? trianglesIn(start) : 0;
  if (start.size() == kStlHeader && size == kStlHeader + kStlRecord * std::uint64_t{count})
    file.mesh = readBinaryStl(path, count);
  else if (start.rfind("solid", 0) == 0 && bytesOfFile(path, 0, 4096).find("facet") != std::string::npos) {
    if (bytesOfFile(path, size > 256 ? size - 256 : 0, 256).find("endsolid") == std::string::npos)
      refuse(path, {FindingKind::truncatedFormat, {{"format", std::string("STL")}}});
    file.mesh = readTextStl(path);
  } else {
    refuse(path, FindingKind::notStl);
  }
  return file;
}

// --- VTP ---

}  // namespace

MeshFile readStlBytes(std::string_view bytes, const std::string& path) {
  if (bytes.size() < kStlHeader ||
      bytes.size() != kStlHeader + kStlRecord * std::uint64_t{trianglesIn(bytes)})
    refuse(path, FindingKind::notStl);
  Merger merger;
  for (std::size_t at = kStlHeader; at < bytes.size(); at += kStlRecord)
    addTriangle(bytes.data() + at, merger);
  MeshFile file;
  file.space = spaceIn(std::string(bytes.substr(0, kStlHeader)));
  file.mesh = std::move(merger.soup);
  return file;
}

MeshFile readVtpHere(const std::string& path) {
  const VtkSilence silence;
  const std::string start = bytesOfFile(path, 0, 1024);
  if (start.find("<VTKFile") == std::string::npos || start.find("PolyData") == std::string::npos)
    refuse(path, {FindingKind::notOfFormat, {{"format", std::string("VTP")}}});
  const std::uint64_t size = fs::file_size(path);
  if (bytesOfFile(path, size > 64 ? size - 64 : 0, 64).find("</VTKFile>") == std::string::npos)
    refuse(path, {FindingKind::truncatedFormat, {{"format", std::string("VTP")}}});
  vtkNew<vtkXMLPolyDataReader> reader;
  vtkPolyData* data = run(reader.Get(), path);
  MeshFile file;
  file.mesh = fromVtk(data, path);
  const auto* space = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("SPACE"));
  if (space && const_cast<vtkStringArray*>(space)->GetNumberOfValues() > 0 &&
      const_cast<vtkStringArray*>(space)->GetValue(0) == "RAS")
    file.space = CoordinateSpace::ras;
  return file;
}

namespace {

MeshFile readAny(const std::string& path, const DecoderSettings& decoder) {
  const std::string name = lowered(path);
  if (name.ends_with(".stl")) return readStl(path);
  if (name.ends_with(".ply")) return readPly(path);
  if (name.ends_with(".vtp")) return readVtp(path, decoder);
  if (name.ends_with(".obj")) return readObj(path);
  if (isThreeMfPath(path)) return readThreeMf(path);
  return readDicomStl(path);
}

}  // namespace

bool isMeshInputPath(const std::string& path) {
  return isMeshPath(path) || isThreeMfPath(path) || lowered(path).ends_with(".stl.dcm") ||
         isEncapsulatedStlFile(path);
}

TriangleSoup readMesh(const std::string& path, const DecoderSettings& decoder) {
  const Phase phase("reading");
  std::error_code failed;
  if (!fs::exists(path, failed)) refuse(path, FindingKind::noSuchFile);
  if (!fs::is_regular_file(path, failed)) refuse(path, FindingKind::notAFile);
  if (!isMeshInputPath(path)) refuse(path, FindingKind::notAMesh);
  if (fs::file_size(path) == 0) refuse(path, FindingKind::emptyFile);
  if (!std::ifstream(path)) refuse(path, FindingKind::notOpened);
  const VtkSilence silence;
  MeshFile file;
  try {
    file = readAny(path, decoder);
  } catch (const std::bad_alloc&) {
    refuse(path, FindingKind::notEnoughMemory);
  }
  if (file.mesh.triangles.empty()) refuse(path, FindingKind::noTriangles);
  for (Vec3& p : file.mesh.points) {
    if (!p.allFinite()) refuse(path, FindingKind::badCoordinate);
    if (file.space == CoordinateSpace::ras) p = Vec3(-p.x(), -p.y(), p.z());
  }
  return std::move(file.mesh);
}

}  // namespace handlebody
