#include "core/io/report/sensitivity_json.h"

namespace handlebody {

namespace {

Json runToJson(const PerturbedRun& r) {
  if (!r.failure.empty()) return {{"failure", r.failure}};
  return {{"volume_mm3", r.volume},
          {"components", r.components},
          {"genus", r.genus},
          {"mean_distance_mm", r.distance}};
}

}  // namespace

Json sensitivityToJson(const Sensitivity& s) {
  Json json;
  json["perturbed_by"] = {
      {"click_voxels", s.by.clickVoxels}, {"smoothing", s.by.smoothing}, {"noise", s.by.noise}};
  Json& runs = json["runs"] = Json::array();
  for (const PerturbedRun& r : s.runs) runs.push_back(runToJson(r));
  json["grown"] = s.grown;
  json["same_topology"] = s.sameTopology;
  json["volume_mm3"] = json["spread_mm"] = nullptr;
  if (s.grown == 0) return json;
  json["volume_mm3"] = {
      {"mean", s.mean}, {"standard_deviation", s.deviation}, {"least", s.least}, {"most", s.most}};
  json["spread_mm"] = {{"mean", s.meanSpread}, {"percentile_95", s.spread95}, {"largest", s.largestSpread}};
  return json;
}

}  // namespace handlebody
