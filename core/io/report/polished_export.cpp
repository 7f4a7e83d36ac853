#include "core/io/report/polished_export.h"

#include <memory>

#include "core/evolution/walls.h"
#include "core/io/report/start_surface.h"
#include "core/mesh/quality.h"
#include "core/number_text.h"

namespace handlebody {

double polishDistance(const Grid& grid) { return kPolishVoxels * grid.spacing.minCoeff(); }

double polishDistance(const TriangleSoup& mesh) { return kPolishVoxels * meshQuality(mesh).edges.median; }

bool isPolished(const Session& session) { return session.polish && !isMeshAsItIs(session.constraints); }

PolishOptions polishOptions(const GrownUnder& grown, const TriangleSoup& mesh) {
  PolishOptions options;
  options.bounds.distance = polishDistance(grown.grid);
  const double edge = grown.edgeLength;
  if (!grown.walls.empty()) {
    const auto walls = std::make_shared<const Walls>(grown.walls, grown.grid, edge, edge);
    options.bounds.forbids = [walls](const Vec3& a, const Vec3& b, const Vec3& c) {
      return walls->touches(a, b, c);
    };
  }
  for (const PinnedPart& part : grown.pinned) {
    if (part.vertices == 0) continue;
    options.bounds.isHeld.resize(mesh.points.size(), 0);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if ((mesh.points[v] - part.pin.centre).norm() <= part.pin.radius) options.bounds.isHeld[v] = 1;
  }
  return options;
}

PolishReport polish(CertifiedMesh& made, const PolishOptions& options) {
  PolishedMesh done = polished(made.mesh, options);
  if (done.report.isChanged()) {
    made.mesh = std::move(done.mesh);
    made.certificate = std::move(done.certificate);
  }
  return done.report;
}

std::string polishText(const PolishReport& report) {
  const PolishCount &was = report.before, &is = report.after;
  if (was.faces == 0 && was.edges == 0) return {};
  const auto range = [](double from, double to) { return numberText(from, 3) + " to " + numberText(to, 3); };
  return "polished: " + counted(was.faces, "thin triangle") + " and " + counted(was.edges, "sharp edge") +
         ", now " + std::to_string(is.faces) + " and " + std::to_string(is.edges) + "; least angle " +
         range(was.leastAngle, is.leastAngle) + " degrees, least dihedral angle " +
         range(was.leastDihedral, is.leastDihedral) + "; " + std::to_string(report.changedFaces) +
         " faces changed, by up to " + numberText(report.farthest, 3) + " mm";
}

namespace {

Json countToJson(const PolishCount& count) {
  return {{"thin_faces", count.faces},
          {"sharp_edges", count.edges},
          {"least_angle_degrees", count.leastAngle},
          {"least_dihedral_angle_degrees", count.leastDihedral}};
}

}  // namespace

Json polishToJson(const PolishReport& report) {
  Json left = Json::array();
  for (const Vec3& p : report.left) left.push_back(vectorToJson(p));
  return {{"limit_mm", report.limit},
          {"farthest_mm", report.farthest},
          {"changed_faces", report.changedFaces},
          {"before", countToJson(report.before)},
          {"after", countToJson(report.after)},
          {"cut_short", report.isCutShort},
          {"refused", report.isRefused},
          {"worst_left", std::move(left)}};
}

}  // namespace handlebody
