#include "tests/fuzz/corpus.h"

#include "core/io/dicom/dicom_writer.h"
#include "core/io/formats/label_map.h"
#include "core/io/formats/volume_io.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/meshes/three_mf.h"
#include "core/io/report/session.h"
#include "tests/io/dicom_test_support.h"
#include "tests/io/mesh_test_support.h"
#include "tests/io/overlapping_segments.h"

namespace handlebody::test {

namespace {

void addVolumes(const std::string& folder, std::vector<Sample>& corpus) {
  for (const VoxelType type : {VoxelType::uint8, VoxelType::int16, VoxelType::float32})
    for (const char* name : {"v.nii", "v.nii.gz", "v.nrrd", "v.mha"}) {
      const std::string path = folder + "/" + name;
      writeVolume(randomVolume(obliqueGrid(), type), path);
      corpus.push_back({name, readBytes(path)});
    }
  const std::string voxels(2 * 3 * 4 * 5, 'x');
  corpus.push_back(
      {"list.nrrd",
       "NRRD0005\ntype: short\ndimension: 4\nspace: right-anterior-superior\nsizes: 2 3 4 5\nkinds: "
       "list domain domain domain\nspace directions: none (1,0,0) (0,2,0) (0,0,3)\nspace origin: "
       "(1,2,3)\nendian: little\nencoding: raw\n\n" +
           voxels + voxels});
  corpus.push_back(
      {"text.nrrd",
       "NRRD0001\ntype: float\ndimension: 3\nsizes: 2 2 2\nspacings: 1 2 3\nencoding: ascii\n\n1 2 3 4 "
       "5.5 6 7 8\n"});
  corpus.push_back(
      {"v.mha",
       "ObjectType = Image\nNDims = 3\nBinaryData = True\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 0 0 "
       "0\nElementSpacing = 1 1 2\nDimSize = 2 3 4\nElementNumberOfChannels = 3\nElementType = "
       "MET_UCHAR\nElementDataFile = LOCAL\n" +
           voxels});
  corpus.push_back(
      {"v.gipl", giplBytes({2, 3, 4}, Vec3(1, 1, 2), Vec3::Zero(), std::vector<std::int16_t>(24, 5))});
  std::string second(544, '\0');  // NIfTI-2
  patch(second, 0, std::int32_t{540});
  second.replace(4, 3, "n+2");
  patch(second, 12, std::int16_t{2});
  for (std::size_t i = 0; i < 4; ++i) patch(second, 16 + 8 * i, std::int64_t{i == 0 ? 3 : 4});
  for (std::size_t i = 0; i < 4; ++i) patch(second, 104 + 8 * i, 1.5);
  patch(second, 168, std::int64_t{544});
  patch(second, 344, std::int32_t{1});
  corpus.push_back({"two.nii", second + std::string(64, 'x')});
}

void addDicom(std::vector<Sample>& corpus) {
  Slice s = evenStack(1)[0];
  s.frames = 4;
  for (int k = 0; k < 4; ++k) s.framePositions.push_back(s.position + 2.5 * k * s.direction.col(2));
  corpus.push_back({"enhanced.dcm", dicomBytes(s, "1.2")});
  Slice us = evenStack(1)[0];
  us.frames = 4;
  us.placed = false;
  us.spacing = "";
  us.regionDelta = 0.02;
  corpus.push_back({"us.dcm", dicomBytes(us, "1.2")});
}

//! Of a series of that many slices.
DicomOrigin originOf(int slices) {
  DicomOrigin origin;
  origin.studyUid = "1.2.3";
  origin.seriesUid = "1.2.3.4";
  for (int k = 0; k < slices; ++k)
    origin.images.push_back({"1.2.840.10008.5.1.4.1.1.4", "1.2.3.4." + std::to_string(k + 1), 0});
  return origin;
}

//! Two segments, in every format that holds some: in DICOM their frames do not fill whole bytes. And two that
//! overlap.
void addSegmentations(const std::string& folder, std::vector<Sample>& corpus) {
  const Grid grid = obliqueGrid();
  void* buffer = nullptr;
  const Volume labels = makeVolume(grid, VoxelType::uint8, &buffer);
  for (std::size_t i = 0; i < grid.voxelCount(); ++i)
    static_cast<std::uint8_t*>(buffer)[i] = static_cast<std::uint8_t>(i % 3);
  std::vector<ExportedObject> objects(2);
  objects[1].label.value = 2;
  writeDicomSegmentation(labels, objects, originOf(grid.size[2]), {}, folder + "/s.seg.dcm");
  writeSlicerSegmentation(labels, objects, folder + "/s.seg.nrrd");
  writeVolume(labels, folder + "/s.mha");
  const std::vector<Segment> layers{{"all", "1 0 0", [](const Vec3&) { return true; }},
                                    {"some", "0 1 0", [](const Vec3& p) { return p.x() > 1; }}};
  writeOverlappingDicom(layers, grid, folder + "/s.seg.layers.dcm");
  writeLayers(layers, grid, folder + "/s.seg.layers.nrrd");
  for (const char* name : {"s.seg.dcm", "s.seg.nrrd", "s.seg.layers.dcm", "s.seg.layers.nrrd", "s.mha"})
    corpus.push_back({name, readBytes(folder + "/" + name)});
}

//! What damage to the archive hardly reaches: its checksums find that first.
const std::string kPlacedModel =
    "<?xml version=\"1.0\"?><model unit=\"inch\" "
    "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
    "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" requiredextensions=\"p\">"
    "<metadata name=\"Title\">T &amp; t</metadata><resources><object id=\"1\" type=\"model\"><mesh><vertices>"
    "<vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"1.5e0\" z=\"0\"/>"
    "<vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/>"
    "<triangle v1=\"0\" v2=\"1\" v3=\"3\"/><triangle v1=\"0\" v2=\"3\" v3=\"2\"/>"
    "<triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles></mesh></object><object id=\"2\"><components>"
    "<component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"
    "<component objectid=\"1\" p:path=\"/3D/m.model\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/></components>"
    "</object></resources><build><item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 1 2 "
    "3\"/></build></model>";

void addPrint(const std::string& folder, std::vector<Sample>& corpus) {
  writeThreeMf({{{}, sphere(Vec3(1, 2, 3), 4, 1)}}, folder + "/p.3mf", CoordinateSpace::lps);
  corpus.push_back({"p.3mf", readBytes(folder + "/p.3mf")});
  corpus.push_back({"p.3mf", kPlacedModel, true});
}

void addMeshes(const std::string& folder, std::vector<Sample>& corpus) {
  for (const char* name : {"m.stl", "m.ply", "m.obj", "m.vtp"}) {
    const std::string path = folder + "/" + name;
    writeMesh(sphere(Vec3(1, 2, 3), 4, 1), path);
    corpus.push_back({name, readBytes(path)});
  }
  writeDicomStl({{{}, sphere(Vec3(1, 2, 3), 4, 1)}}, originOf(2), {}, folder + "/m.stl.dcm");
  corpus.push_back({"m.stl.dcm", readBytes(folder + "/m.stl.dcm")});
}

void addSession(const std::string& folder, std::vector<Sample>& corpus) {
  Session session;
  session.version = "1.0.0";
  session.volume = {folder + "/v.nii", std::string(64, 'a'), {}};
  session.volume.selection.spacing = Vec3(1, 2, 3);
  session.seeds = {{{1, 2, 3}, 4.0}, {{5, 6, 7}, {}}, {{8, 9, 1}, {}, true}};
  session.requested.candidate = 2;
  session.label = {"Cyst", {1, 2, 3}, 4, "cyst"};
  writeSession(session, folder + "/s.json");
  corpus.push_back({"s.json", readBytes(folder + "/s.json")});
}

}  // namespace

std::vector<Sample> fuzzCorpus(const std::string& folder) {
  std::vector<Sample> corpus;
  addVolumes(folder, corpus);
  addMeshes(folder, corpus);
  addSession(folder, corpus);
  addDicom(corpus);
  addSegmentations(folder, corpus);
  addPrint(folder, corpus);
  return corpus;
}

}  // namespace handlebody::test
