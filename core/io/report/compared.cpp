#include "core/io/report/compared.h"

#include <cmath>
#include <numeric>

#include "core/io/meshes/mesh_io.h"
#include "core/io/refuse_input.h"
#include "core/io/report/anonymous_names.h"
#include "core/io/report/comparison_json.h"
#include "core/io/report/label_file.h"
#include "core/version.h"

namespace handlebody {

namespace {

bool hasTopology(const Solid& s) { return s.isClosed() && (s.empty() || s.certificate.manifold); }

//! Components and cavities are both components of the surface.
int cavitiesOf(const Solid& s) { return s.empty() ? 0 : s.certificate.cavities; }
int componentsOf(const Solid& s) { return s.certificate.components - (hasTopology(s) ? cavitiesOf(s) : 0); }
int genusOf(const Solid& s) {
  return std::accumulate(s.certificate.genus.begin(), s.certificate.genus.end(), 0);
}

Json orNull(bool known, const Json& value) { return known ? value : Json(nullptr); }

Json volumeJson(const Solid& s) { return s.isClosed() ? Json(s.volume()) : Json(nullptr); }

Json objectJson(const ComparedObject& o) {
  const Solid& s = o.solid;
  Json json = {{"path", orNull(!o.path.empty(), o.path)}, {"kind", s.mask ? "label map" : "mesh"}};
  json["label"] = o.label ? Json(*o.label) : Json(nullptr);
  json["volume_mm3"] = volumeJson(s);
  json["area_mm2"] = s.certificate.area;
  json["components"] = orNull(!s.isMisplaced(), componentsOf(s));
  json["genus"] = orNull(hasTopology(s), genusOf(s));
  json["cavities"] = orNull(hasTopology(s), cavitiesOf(s));
  json["closed"] = s.isClosed();
  return json;
}

Json directedJson(const DirectedDistances& d) {
  return {{"mean_mm", d.mean},
          {"percentile_95_mm", d.percentile95},
          {"largest_mm", d.largest},
          {"samples", d.samples}};
}

Json optionalJson(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

ComparedObject comparedMask(const std::string& name, const Mask& mask, std::optional<int> label) try {
  return {name, label, solidOf(mask)};
} catch (const InputError& error) {
  refuseSurface(name, error);
}

std::optional<double> volumeDifference(const ComparedPair& p) {
  if (!p.a.solid.isClosed() || !p.b.solid.isClosed()) return std::nullopt;
  return p.a.solid.volume() - p.b.solid.volume();
}

std::optional<double> volumeDifferencePercent(const ComparedPair& p) {
  const auto difference = volumeDifference(p);
  if (!difference || !(p.b.solid.volume() > 0)) return std::nullopt;
  return 100 * *difference / p.b.solid.volume();
}

}  // namespace

ComparedObject comparedMesh(const std::string& name, TriangleSoup mesh) {
  Solid solid = solidOf(std::move(mesh));
  if (solid.empty() || !(solid.certificate.area > 0) || !std::isfinite(solid.certificate.area))
    refuseInput(name, FindingKind::trianglesWithoutArea);
  return {name, std::nullopt, std::move(solid)};
}

ComparedObject comparedLabels(const std::string& name, const Volume& labels, std::optional<int> label) {
  return comparedMask(name, maskOf(labels, label), label);
}

ComparedObject readCompared(const std::string& path, std::optional<int> label, std::vector<Finding>& warnings,
                            const DecoderSettings& decoder) {
  if (isMeshInputPath(path)) return comparedMesh(path, readMesh(path, decoder));
  LabelFile file(path, decoder);
  return comparedLabels(path, file, label, warnings);
}

ComparedObject comparedLabels(const std::string& path, LabelFile& file, std::optional<int> label,
                              std::vector<Finding>& warnings) {
  for (const Finding& w : file.info().warnings)
    warnings.push_back({FindingKind::ofFile, {{"file", path}}, w});
  return comparedMask(path, file.mask(label), label);
}

void compare(ComparedPair& pair, const ComparisonOptions& how) {
  pair.found = compare(pair.a.solid, pair.b.solid, how);
  pair.warnings.insert(pair.warnings.end(), pair.found.warnings.begin(), pair.found.warnings.end());
}

std::vector<double> distancesFromReference(const ComparedPair& pair, int threads) {
  const Solid& reference = pair.b.solid;
  return vertexDistances(pair.a.solid.surface, reference.surface, reference.isClosed(), threads);
}

void writeDistances(const ComparedPair& pair, const std::vector<double>& distances, const std::string& path) {
  writeMeshWithValues(pair.a.solid.surface, distances,
                      pair.b.solid.isClosed() ? "signed_distance_mm" : "distance_mm", path);
}

ComparedPair anonymous(ComparedPair pair) {
  for (Finding& warning : pair.warnings) {
    if (warning.kind != FindingKind::ofFile) continue;
    const bool isOfA = std::get<std::string>(*warning.find("file")) == pair.a.path;
    warning = {
        FindingKind::ofFile, {{"file", std::string(isOfA ? "A" : "B")}}, unnamed(warning.causes.at(0))};
  }
  pair.a.path.clear();
  pair.b.path.clear();
  return pair;
}

Json comparisonToJson(const ComparedPair& p) {
  Json json = {{"version", HANDLEBODY_VERSION}, {"notice", kNotice}};
  json["a"] = objectJson(p.a);
  json["b"] = objectJson(p.b);
  json["dice"] = optionalJson(p.found.dice);
  json["iou"] = optionalJson(p.found.iou);
  json["volume_difference_mm3"] = optionalJson(volumeDifference(p));
  json["volume_difference_percent"] = optionalJson(volumeDifferencePercent(p));
  json["overlap"] = nullptr;
  if (const auto& o = p.found.overlap)
    json["overlap"] = {{"points", o->onVoxels ? "voxels" : "lattice"},
                       {"spacing_mm", vectorToJson(o->spacing)},
                       {"a_mm3", o->a},
                       {"b_mm3", o->b},
                       {"both_mm3", o->both}};
  json["distances"] = nullptr;
  if (const auto& d = p.found.distances)
    json["distances"] = {{"mean_symmetric_mm", d->mean()}, {"hausdorff_95_mm", d->percentile95()},
                         {"hausdorff_mm", d->hausdorff()}, {"smallest_mm", d->smallest()},
                         {"sampling_mm", d->sampling},     {"a_to_b", directedJson(d->ofA)},
                         {"b_to_a", directedJson(d->ofB)}};
  json["warnings"] = sentences(p.warnings);
  return json;
}

std::string comparisonJson(const ComparedPair& pair) { return jsonText(comparisonToJson(pair)); }

}  // namespace handlebody
