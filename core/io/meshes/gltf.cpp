#include "core/io/meshes/gltf.h"

#include <vtkCellArray.h>
#include <vtkGLTFWriter.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/io/atomic_file.h"
#include "core/io/lowered.h"
#include "core/io/meshes/mesh_files.h"
#include "core/version.h"

namespace handlebody {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kMetres = 1e-3;  // of a mm
constexpr double kRoughness = 0.6;

vtkNew<vtkPolyData> toVtk(const TriangleSoup& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vec3 p = kMetres * mesh.points[i];
    points->SetPoint(static_cast<vtkIdType>(i), p.x(), p.z(), -p.y());
  }
  vtkNew<vtkCellArray> polygons;
  polygons->AllocateExact(static_cast<vtkIdType>(mesh.triangles.size()),
                          static_cast<vtkIdType>(3 * mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) polygons->InsertNextCell({t[0], t[1], t[2]});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

//! What VTK writes of the meshes: a list of objects, each of one piece.
Json written(const std::vector<ExportedObject>& objects, const std::string& temporary) {
  vtkNew<vtkMultiBlockDataSet> all;
  for (const ExportedObject& object : objects) {
    vtkNew<vtkMultiBlockDataSet> one;
    one->SetBlock(0, toVtk(object.mesh));
    all->SetBlock(all->GetNumberOfBlocks(), one);
  }
  vtkNew<vtkGLTFWriter> writer;
  writer->SetFileName(temporary.c_str());
  writer->SetInputDataObject(all);
  writer->SetInlineData(true);
  if (writer->Write() == 0) return nullptr;
  std::ifstream in(temporary, std::ios::binary);
  return Json::parse(in, nullptr, false);
}

//! The format's colours are linear.
double linear(std::uint8_t srgb) {
  const double v = srgb / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

Json materialOf(const ObjectLabel& label) {
  Json colour = Json::array();
  for (const std::uint8_t part : label.colour) colour.push_back(linear(part));
  colour.push_back(1.0);
  return {
      {"name", label.name},
      {"pbrMetallicRoughness",
       {{"baseColorFactor", std::move(colour)}, {"metallicFactor", 0.0}, {"roughnessFactor", kRoughness}}}};
}

//! Names and colours, which VTK's writer knows nothing of, and nothing of the camera that it adds. False if
//! it is not what was expected.
bool complete(Json& json, const std::vector<ExportedObject>& objects) {
  if (!json.is_object() || !json.contains("meshes") || json["meshes"].size() != objects.size()) return false;
  json["asset"] = {{"version", "2.0"}, {"generator", "Handlebody " HANDLEBODY_VERSION}};
  Json nodes = Json::array(), materials = Json::array(), scene = Json::array();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    json["meshes"][i]["name"] = objects[i].label.name;
    for (Json& primitive : json["meshes"][i]["primitives"]) primitive["material"] = i;
    nodes.push_back({{"name", objects[i].label.name}, {"mesh", i}});
    materials.push_back(materialOf(objects[i].label));
    scene.push_back(i);
  }
  json.erase("cameras");
  json["materials"] = std::move(materials);
  json["nodes"] = std::move(nodes);
  json["scenes"] = Json::array({{{"nodes", std::move(scene)}}});
  json["scene"] = 0;
  return true;
}

}  // namespace

bool isGltfPath(const std::string& path) { return lowered(path).ends_with(".gltf"); }

void writeGltf(const std::vector<ExportedObject>& objects, const std::string& path) {
  writeAtomically(path, [&](const std::string& temporary) {
    const VtkSilence silence;
    Json json = written(objects, temporary);
    if (!json.is_object()) refuseOutput(path, FindingKind::notOnDisk);  // it ends before its end
    if (!complete(json, objects)) refuseOutput(path, FindingKind::noScene);
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    out << json.dump(1) << '\n';
    if (!out.flush()) refuseOutput(path, FindingKind::diskMayBeFull);
  });
}

}  // namespace handlebody
