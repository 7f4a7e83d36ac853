#pragma once
// What a local edit leaves: another mesh that is certified, or the reason why nothing was changed.

#include "core/finding.h"
#include "core/mesh/topology.h"

namespace handlebody {

struct TouchedMesh {
  Mesh mesh;                                 //!< as it was, if the edit was refused
  FindingKind refusal = FindingKind::none;   //!< none: it was done
  TopologyNumbers before, after;             //!< counted
  double volumeBefore = 0, volumeAfter = 0;  //!< mm³, of the whole mesh

  bool isDone() const { return refusal == FindingKind::none; }
};

//! Nothing was changed.
TouchedMesh refused(const Mesh& mesh, FindingKind why);

//! `edited`, if it passes the certificate as a whole, exactly, and no more components are in each other's way
//! than before; else a refusal for that reason. An edit that leaves nothing is refused, too.
TouchedMesh certifiedEdit(const Mesh& before, Mesh edited);

}  // namespace handlebody
