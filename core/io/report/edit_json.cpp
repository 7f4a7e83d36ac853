#include "core/io/report/edit_json.h"

namespace handlebody {

namespace {

Json numbersToJson(const TopologyNumbers& n) {
  return {{"components", n.components}, {"euler", n.euler}, {"genus", n.genus}};
}

constexpr double kMlPerMm3 = 1e-3;

}  // namespace

Json tunnelsToJson(const TunnelList& list) {
  Json out = Json::array();
  for (const Tunnel& t : list.tunnels)
    out.push_back({{"position", vectorToJson(t.position)},
                   {"handle_loop_mm", t.handle.length},
                   {"tunnel_loop_mm", t.tunnel.length},
                   {"handle_loop_bounds", t.handleBounds},
                   {"tunnel_loop_bounds", t.tunnelBounds},
                   {"component", t.component}});
  return out;
}

Json piecesToJson(const std::vector<Piece>& pieces) {
  Json out = Json::array();
  for (const Piece& p : pieces)
    out.push_back({{"cavity", p.isCavity},
                   {"volume_ml", p.volume * kMlPerMm3},
                   {"size_mm", vectorToJson(p.size)},
                   {"centre", vectorToJson(p.centre)},
                   {"genus", p.genus},
                   {"vertices", p.vertices},
                   {"within", p.within < 0 ? Json(nullptr) : Json(p.within)}});
  return out;
}

Json editToJson(const Event& edit) {
  const EditMeasures measures = edit.edit.value_or(EditMeasures{});
  return {{"kind", eventKindName(edit.kind)},
          {"location", vectorToJson(edit.location)},
          {"loop_mm", measures.loop > 0 ? Json(measures.loop) : Json(nullptr)},
          {"volume_before_ml", measures.volumeBefore * kMlPerMm3},
          {"volume_after_ml", measures.volumeAfter * kMlPerMm3},
          {"before", numbersToJson(edit.before)},
          {"after", numbersToJson(edit.after)}};
}

Json openTunnelToJson(const OpenTunnel& tunnel) {
  return {{"position", vectorToJson(tunnel.location)},
          {"handle_loop_mm", tunnel.handleLength},
          {"tunnel_loop_mm", tunnel.tunnelLength}};
}

}  // namespace handlebody
