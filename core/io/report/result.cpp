#include "core/io/report/result.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>

#include "core/cancellation.h"
#include "core/collision/certify.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/formats/label_map.h"
#include "core/io/meshes/gltf.h"
#include "core/io/meshes/three_mf.h"
#include "core/io/report/session_files.h"
#include "core/io/report/single_precision.h"
#include "core/io/report/start_surface.h"
#include "core/io/tetrahedra/tetrahedra.h"
#include "core/measure/intensity_inside.h"
#include "core/phase.h"
#include "core/polish/polish.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

constexpr double kHardlyMoved = 0.15;  // part of the radius of a seed

void requirePass(const Certificate& c) {
  if (c.boundsBody()) return;
  const auto word = [](bool yes) { return yes ? "yes" : "no"; };
  throw std::runtime_error(std::string("the mesh failed its certificate and nothing was written (closed: ") +
                           word(c.closed) + ", manifold: " + word(c.manifold) + ", oriented: " +
                           word(c.oriented) + ", self-intersections: " + std::to_string(c.selfIntersections) +
                           ", misplaced components: " + std::to_string(c.misplaced) + ").");
}

//! Why a surface that is at rest may not be the object's all the same; none if there is no such reason.
Finding unfinished(const RunReport& report) {
  if (report.stopped == StopReason::stuck) return FindingKind::stuck;
  if (report.stopped == StopReason::frozen) return FindingKind::frozen;
  return FindingKind::none;
}

//! Of a surface that is still where its seeds were. A front of less radius than curvature times edge length
//! over balloon stands still.
Finding hardlyGrown(const ResolvedParameters& p) {
  const double held = p.curvature * p.edgeLength / p.balloon;
  const std::vector<Seed> seeds = seedsOfSide(p.seeds, false);
  const bool small = std::any_of(seeds.begin(), seeds.end(), [&](const Seed& s) { return *s.radius < held; });
  if (!small) return FindingKind::hardlyGrown;
  return {FindingKind::heldByCurvature, {{"radius_mm", held}}};
}

//! The surface is still where the seeds were: no vertex has gone further than kHardlyMoved of a radius.
bool atItsSeeds(const RunReport& report, const TriangleSoup& mesh) {
  const std::vector<Seed> seeds = seedsOfSide(report.session.resolved->seeds, false);
  return std::all_of(mesh.points.begin(), mesh.points.end(), [&](const Vec3& p) {
    return std::any_of(seeds.begin(), seeds.end(), [&](const Seed& s) {
      return std::abs((p - s.centre).norm() - *s.radius) < kHardlyMoved * *s.radius;
    });
  });
}

//! Of an object that another one nearly outranks; none where the choice is clear, or has been made by asking
//! for a later candidate.
Finding closeChoice(const RunReport& report) {
  const std::vector<ObjectCandidate>& all = report.candidates;
  if (!report.isCloseChoice || all.size() < 2 || report.session.resolved->candidate != 1) return {};
  return {FindingKind::closeChoice,
          {{"objects", all.size()},
           {"dice", all[0].score},
           {"next_ml", all[1].volume / 1000},
           {"this_ml", all[0].volume / 1000}}};
}

}  // namespace

CertifiedMesh certifiedForExport(const TriangleSoup& mesh) {
  CertifiedMesh out{roundedToSingle(mesh), {}};
  out.certificate = certify(out.mesh);
  requirePass(out.certificate);
  return out;
}

namespace {

//! Of a mesh that was given, and is not polished though the others are.
Finding givenWithThin(const Session& session, const TriangleSoup& mesh) {
  if (!session.polish || !isMeshAsItIs(session.constraints)) return {};
  const PolishCount bad = countBad(mesh);
  if (bad.faces + bad.edges == 0) return {};
  return {FindingKind::givenWithThin, {{"thin_faces", bad.faces}, {"sharp_edges", bad.edges}}};
}

//! Of the files of walls and of starts; of one that stands in several places once.
void addWarningsOfFiles(const Session& session, std::vector<Finding>& warnings) {
  std::set<std::string> told;
  const auto add = [&](const auto& file) {
    if (told.insert(file.path).second)
      warnings.insert(warnings.end(), file.warnings.begin(), file.warnings.end());
  };
  forEachWallMap(session, add);
  forEachStart(session, add);
}

}  // namespace

std::vector<Finding> resultWarnings(const RunReport& report, const TriangleSoup& mesh) {
  std::vector<Finding> out;
  if (Finding why = unfinished(report); why.any()) out.push_back(std::move(why));
  if (!report.session.constraints.start && atItsSeeds(report, mesh))
    out.push_back(hardlyGrown(*report.session.resolved));
  if (Finding choice = closeChoice(report); choice.any()) out.push_back(std::move(choice));
  if (Finding shared = sharedVoxels(report.session.constraints); shared.any())
    out.push_back(std::move(shared));
  addWarningsOfFiles(report.session, out);
  if (Finding thin = givenWithThin(report.session, mesh); thin.any()) out.push_back(std::move(thin));
  return out;
}

namespace {

bool isDicomResult(const std::string& path) { return isDicomSegmentationPath(path) || isDicomStlPath(path); }

}  // namespace

bool isResultPath(const std::string& path) {
  return isMeshPath(path) || isLabelMapPath(path) || isThreeMfPath(path) || isGltfPath(path) ||
         isDicomResult(path) || isTetrahedraPath(path) || isLabelDescriptionPath(path);
}

bool areSpacesFixed(const std::vector<std::string>& paths) {
  const auto isFixed = [](const std::string& path) {
    return isGltfPath(path) || isDicomResult(path) || isLabelMapPath(path) || isLabelDescriptionPath(path);
  };
  const auto isFree = [](const std::string& path) {
    return isMeshPath(path) || isThreeMfPath(path) || isTetrahedraPath(path);
  };
  return std::any_of(paths.begin(), paths.end(), isFixed) && std::none_of(paths.begin(), paths.end(), isFree);
}

namespace {

void requireMesher(const std::string& path) try {
  if (!tetrahedraFault().empty())
    throw Told<UsageError>(Finding(FindingKind::fileRefused, {{"file", path}}, FindingKind::noMesher));
  requireTemporaryFolder();
} catch (const OutputError& error) {
  throw Told<UsageError>(Finding(FindingKind::fileRefusedWith, {{"file", path}}, saidBy(error)));
}

}  // namespace

void checkResult(const std::string& path, const ExportContext& context) {
  if (isTetrahedraPath(path)) requireMesher(path);
  if (!isDicomResult(path)) return;
  if (const Finding fault = dicomFinding(context.dicom.get()); fault.any()) refuseDicom(path, fault);
}

std::vector<Finding> labelMapWarnings(const TriangleSoup& mesh, const Grid& grid,
                                      const std::vector<std::string>& paths) {
  const auto isOfVoxels = [](const std::string& path) {
    return isLabelMapPath(path) || isDicomSegmentationPath(path);
  };
  if (std::none_of(paths.begin(), paths.end(), isOfVoxels)) return {};
  const VoxelsInside inside = voxelsInside(mesh, grid);
  std::vector<Finding> warnings;
  if (!inside.isWhole) warnings.push_back(FindingKind::surfacePartlyOutside);
  if (inside.count == 0) warnings.push_back(FindingKind::noVoxelInside);
  return warnings;
}

const char* resultEndings() {
  return "a mesh is .stl, .vtp, .ply, .obj, .3mf, .gltf or .stl.dcm, tetrahedra are .msh, .vtu or .inp, a "
         "label map .seg.nrrd, .seg.dcm, .nii, .nii.gz, .nrrd or .mha, a label description .label";
}

namespace {

TriangleSoup together(const std::vector<ExportedObject>& objects) {
  TriangleSoup all;
  for (const ExportedObject& object : objects) {
    const int first = static_cast<int>(all.points.size());
    const TriangleSoup& mesh = object.mesh;
    all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
    for (const Triangle& t : mesh.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

//! What a mesh of several objects is made of; nothing of a single one.
std::vector<MeshPart> partsOf(const std::vector<ExportedObject>& objects) {
  std::vector<MeshPart> parts;
  if (objects.size() > 1)
    for (const auto& [label, mesh] : objects)
      parts.push_back({label.name, label.value, label.colour, mesh.triangles.size()});
  return parts;
}

//! Writes to one path after the other; the label map and the tetrahedra are made once, for the first that
//! needs it.
class Writer {
 public:
  Writer(const std::vector<ExportedObject>& objects, const ExportContext& context)
      : objects_(objects), context_(context) {}

  void prepare(const std::string& path) {
    checkResult(path, context_);
    tetrahedra(path);
  }
  void write(const std::string& path) {
    checkResult(path, context_);
    if (isDicomSegmentationPath(path))
      return writeDicomSegmentation(labels(), objects_, *context_.dicom, context_.content, path);
    if (isDicomStlPath(path)) return writeDicomStl(objects_, *context_.dicom, context_.content, path);
    if (isThreeMfPath(path)) return writeThreeMf(objects_, path, context_.space);
    if (isGltfPath(path)) return writeGltf(objects_, path);
    if (isTetrahedraPath(path)) return writeTetrahedra(tetrahedra(path), objects_, path, context_.space);
    if (isMeshPath(path)) return writeMesh(together(objects_), path, context_.space, partsOf(objects_));
    if (isLabelDescriptionPath(path)) return writeTextAtomically(path, labelDescription(objects_));
    if (isSlicerSegmentationPath(path)) return writeSlicerSegmentation(labels(), objects_, path);
    writeVolume(labels(), path);
  }

 private:
  const Tetrahedra& tetrahedra(const std::string& path) {
    try {
      if (!tetrahedra_) tetrahedra_ = fillWithTetrahedra(objects_, context_.mesherSeconds);
    } catch (const OutputError& error) {
      throw Told<OutputError>(Finding(FindingKind::fileRefusedWith, {{"file", path}}, saidBy(error)));
    }
    return *tetrahedra_;
  }
  const Volume& labels() {
    if (!labels_) labels_ = labelMap(objects_, context_.grid);
    return *labels_;
  }
  const std::vector<ExportedObject>& objects_;
  const ExportContext& context_;
  std::optional<Volume> labels_;
  std::optional<Tetrahedra> tetrahedra_;
};

}  // namespace

void writeResults(const std::vector<ExportedObject>& objects, const ExportContext& context,
                  const std::vector<std::string>& paths) {
  const Phase phase("writing");
  Writer writer(objects, context);
  for (const std::string& path : paths)
    if (isTetrahedraPath(path)) writer.prepare(path);  // before any file: another program may fail
  for (const std::string& path : paths) writer.write(path);
}

void writeEachResult(const std::vector<ExportedObject>& objects, const ExportContext& context,
                     const std::vector<std::string>& paths) {
  const Phase phase("writing");
  std::vector<std::vector<ExportedObject>> alone;
  for (const ExportedObject& object : objects) alone.push_back({object});
  std::vector<std::unique_ptr<Writer>> writers;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    writers.push_back(std::make_unique<Writer>(alone[i], context));
    if (isTetrahedraPath(paths[i])) writers[i]->prepare(paths[i]);
  }
  giveUpIfCancelled();
  const CancelScope whole(nullptr);  // once there is a file, all of them are written
  for (std::size_t i = 0; i < objects.size(); ++i) {
    writers[i]->write(paths[i]);
    writers[i].reset();  // and its label map
  }
}

}  // namespace handlebody
