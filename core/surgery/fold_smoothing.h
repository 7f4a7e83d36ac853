#pragma once

#include <span>
#include <vector>

#include "core/mesh/forbidden.h"
#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"
#include "core/surgery/face_blocks.h"

namespace handlebody {

//! Smooths a lone colliding set Λ and its ring by Taubin's method (paper, section 4, "Deleting components")
//! until its faces intersect nothing, lie nowhere and have
//! swept over nothing that is forbidden; pinned vertices stay. Returns false, with the mesh unchanged, if
//! they still do after kFoldPasses passes. `ignored` marks faces that collide elsewhere; touched[v] = 1 for
//! moved vertices, and `blocks` are those of the mesh.
bool smoothFold(Mesh& mesh, FaceBlocks& blocks, const std::vector<int>& lambda, FaceMarkSpan ignored,
                const Forbidden& forbidden, VertexMarks& touched);

inline constexpr int kFoldPasses = 4;

}  // namespace handlebody
