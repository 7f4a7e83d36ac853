#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/progress.h"
#include "app/cli/tunnel_text.h"
#include "core/collision/certify.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/edit_json.h"
#include "core/io/report/measures_json.h"
#include "core/io/report/single_precision.h"

namespace handlebody::cli {

namespace {

struct CheckOptions {
  std::string path;
  bool json = false;
};

void printText(const Certificate& c) {
  const auto word = [](bool yes) { return yes ? "yes" : "no"; };
  std::string genus;
  for (int g : c.genus) genus += " " + std::to_string(g);
  std::printf("%s\n", c.passes() ? "passes" : "does not pass");
  std::printf("closed %s, manifold %s, oriented %s, self-intersections %d\n", word(c.closed),
              word(c.manifold), word(c.oriented), c.selfIntersections);
  std::printf("vertices %d, faces %d, components %d, Euler number %d, genus%s\n", c.vertices, c.faces,
              c.components, c.euler, genus.empty() ? " undefined" : genus.c_str());
  std::printf("volume %.6g mm3, area %.6g mm2\n", c.volume, c.area);
  if (c.cavities > 0) std::printf("cavities %d\n", c.cavities);
  if (c.misplaced > 0)
    std::printf(
        "%d of the components %s where a body's cannot: a body directly in a body, or a cavity outside of "
        "any\n",
        c.misplaced, c.misplaced == 1 ? "lies" : "lie");
}

void printSpread(const char* name, const Spread& s) {
  std::printf("%s: least %.4g, 5 %% up to %.4g, median %.4g, largest %.4g\n", name, s.least, s.percent5,
              s.median, s.largest);
}

void printQuality(const MeshQuality& q) {
  printSpread("angles (degrees)", q.angles);
  printSpread("dihedral angles (degrees)", q.dihedral);
  printSpread("radius ratio", q.radiusRatio);
  printSpread("edges (mm)", q.edges);
  if (q.flat > 0) std::printf("%d faces without area\n", q.flat);
}

//! What is left of a mesh in programs that read single precision.
struct InSingle {
  double farthest = 0;  // mm
  Certificate certificate;
};

InSingle lookInSingle(const TriangleSoup& mesh, const Certificate& certificate) {
  const ReadInSingle read = readInSingle(mesh);
  return {read.farthest, read.farthest > 0 ? certify(read.mesh) : certificate};
}

void printSingle(const InSingle& s) {
  if (!(s.farthest > 0)) {
    std::puts("single precision: nothing is lost");
    return;
  }
  std::printf("single precision: vertices move by up to %.3g mm, and the mesh %s (self-intersections %d)\n",
              s.farthest, s.certificate.passes() ? "passes" : "does not pass",
              s.certificate.selfIntersections);
}

Json singleToJson(const InSingle& s) {
  return {{"farthest_mm", s.farthest},
          {"passes", s.certificate.passes()},
          {"self_intersections", s.certificate.selfIntersections}};
}

int check(const CheckOptions& o) {
  const PhaseLine line(false);
  const TriangleSoup mesh = readMesh(o.path);
  const Certificate certificate = certify(mesh);
  const MeshQuality quality = meshQuality(mesh);
  const InSingle single = lookInSingle(mesh, certificate);
  const std::optional<TunnelList> tunnels = findTunnelsQuickly(mesh, certificate);
  if (o.json) {
    Json json = certificateToJson(certificate);
    json["tunnels"] = tunnels ? tunnelsToJson(*tunnels) : Json(nullptr);
    json["quality"] = qualityToJson(quality);
    json["single_precision"] = singleToJson(single);
    std::fputs(jsonText(json).c_str(), stdout);
  } else {
    printText(certificate);
    printQuality(quality);
    printSingle(single);
    if (tunnels)
      std::fputs(tunnelsText(*tunnels).c_str(), stdout);
    else if (certificate.passes())
      std::puts("tunnels: too many, or too large a mesh, to be listed here; see `edit`");
  }
  return certificate.passes() ? kDone : kInternalError;
}

}  // namespace

void addCheck(CLI::App& app, Action& action) {
  CLI::App* command = addCommand(app, "check", "The certificate of a mesh; exit code 1 if it does not pass");
  auto options = std::make_shared<CheckOptions>();
  command->add_option("MESH", options->path, "A .stl, .vtp, .ply, .obj, .3mf or .stl.dcm file")->required();
  command->add_flag("--json", options->json, "As JSON, like \"mesh\" in a report");
  command->callback([&action, options] { action = [options] { return check(*options); }; });
}

}  // namespace handlebody::cli
