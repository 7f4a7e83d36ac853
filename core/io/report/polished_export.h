#pragma once
// Polishing (core/polish) of meshes as they are written, and what is told of it.

#include <string>

#include "core/evolution/grown_under.h"
#include "core/io/report/json.h"
#include "core/io/report/result.h"
#include "core/polish/polish.h"

namespace handlebody {

//! How far polishing may move the surface of an object of this grid, mm.
double polishDistance(const Grid& grid);
//! The same for a mesh without a grid: a part of its median edge.
double polishDistance(const TriangleSoup& mesh);

//! True if the surface of a session is polished before it is written: that was asked for, and it is no mesh
//! that is to stay as it is (isMeshAsItIs). Of a session whose starts have been read.
bool isPolished(const Session& session);

//! What the constraints of the growth leave to polishing: no face in a wall, nothing of what is pinned.
PolishOptions polishOptions(const GrownUnder& grown, const TriangleSoup& mesh);
inline PolishOptions polishOptions(const ActiveContour& contour, const TriangleSoup& mesh) {
  return polishOptions(grownUnder(contour), mesh);
}

//! Betters bad triangles of a mesh of certifiedForExport; its certificate is that of the new mesh. A mesh
//! without any stays as it is.
PolishReport polish(CertifiedMesh& made, const PolishOptions& options);

//! One line without a line break: what was changed, and the least angles; empty if nothing was bad.
std::string polishText(const PolishReport& report);
Json polishToJson(const PolishReport& report);

}  // namespace handlebody
