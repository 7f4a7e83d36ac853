#pragma once
// Edits of the surface as steps of its growth: in place of motion, the step to `iteration` closes a tunnel,
// removes a component and the like. What is wanted is part of the constraints, so that it is recorded,
// replayed and undone as they are; what was done is an event with measures (surgery/event.h).
//
// Another kind of edit needs: a value here with its name, a case of makeEdit (edit_step.cpp), fields below if
// it has more to say, and their place in JSON (io/constraints_json.cpp). The step itself
// (ActiveContour::step) knows no kinds: it checks what makeEdit left as it checks any step, or takes it back.

#include <optional>
#include <string>

#include "core/geometry/vec.h"
#include "core/surgery/kept_side.h"
#include "core/surgery/tunnel_cut.h"

namespace handlebody {

enum class MeshEditKind {
  closeTunnel,      //!< the tunnel nearest to the place
  removeComponent,  //!< the component nearest to the place, with all that lies in it
  keepComponent,    //!< everything but the body that the nearest component bounds goes
  fillCavity,       //!< the cavity nearest to the place, with all that lies in it
  smooth,           //!< the surface within `radius` of the place (local_smoothing.h)
  pull,             //!< the point nearest to the place goes to `vector` (pulling.h)
  cut,              //!< along the plane through the place with the normal `vector` (plane_cut.h)
};

//! "close-tunnel", "remove-component", "keep-component", "fill-cavity", "smooth", "pull", "cut".
const char* meshEditName(MeshEditKind kind);
//! The inverse; none for another word.
std::optional<MeshEditKind> meshEditKind(const std::string& name);
//! "shorter", "handle", "tunnel".
const char* tunnelCutName(TunnelCut cut);
std::optional<TunnelCut> tunnelCutOf(const std::string& name);

//! "both", "positive", "negative".
const char* keptSideName(KeptSide side);
std::optional<KeptSide> keptSideOf(const std::string& name);

struct MeshEdit {
  int iteration = 0;  //!< of the step that it is; one edit per step
  MeshEditKind kind = MeshEditKind::closeTunnel;
  Vec3 place{0, 0, 0};                 //!< mm, LPS: of the tunnel, or on the component
  TunnelCut cut = TunnelCut::shorter;  //!< of closeTunnel
  Vec3 vector{0, 0, 0};                //!< of pull: mm, LPS; of cut: a direction, of any length above 0
  double radius = 0;                   //!< mm; of smooth and pull: > 0; of cut: 0 is wherever the plane cuts
  KeptSide keep = KeptSide::both;      //!< of cut
  bool operator==(const MeshEdit&) const = default;
};

}  // namespace handlebody
