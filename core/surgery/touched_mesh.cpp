#include "core/surgery/touched_mesh.h"

#include "core/collision/certify.h"
#include "core/mesh/structure.h"

namespace handlebody {

TouchedMesh refused(const Mesh& mesh, FindingKind why) {
  TouchedMesh out{mesh, why, topologyNumbers(mesh), {}, signedVolume(mesh), 0};
  out.after = out.before;
  out.volumeAfter = out.volumeBefore;
  return out;
}

TouchedMesh certifiedEdit(const Mesh& before, Mesh edited) {
  if (edited.faceCount() == 0) return refused(before, FindingKind::nothingWouldBeLeft);
  if (findStructureFault(edited)) return refused(before, FindingKind::meetsItself);
  const Certificate c = certify(edited.compact());
  if (!c.passes() || (c.misplaced > 0 && c.misplaced > examine(before).misplaced))
    return refused(before, FindingKind::meetsItself);
  TouchedMesh out = refused(before, FindingKind::none);
  out.mesh = std::move(edited);
  out.after = topologyNumbers(out.mesh);
  out.volumeAfter = c.volume;
  return out;
}

}  // namespace handlebody
