#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/tunnel_text.h"
#include "core/collision/certify.h"
#include "core/io/edit_json.h"
#include "core/io/mesh_io.h"

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

int check(const CheckOptions& o) {
  const TriangleSoup mesh = readMesh(o.path);
  const Certificate certificate = certify(mesh);
  const std::optional<TunnelList> tunnels = findTunnelsQuickly(mesh, certificate);
  if (o.json) {
    Json json = certificateToJson(certificate);
    json["tunnels"] = tunnels ? tunnelsToJson(*tunnels) : Json(nullptr);
    std::fputs(jsonText(json).c_str(), stdout);
  } else {
    printText(certificate);
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
  command->add_option("MESH", options->path, "A .stl, .vtp, .ply or .obj file")->required();
  command->add_flag("--json", options->json, "As JSON, like \"mesh\" in a report");
  command->callback([&action, options] { action = [options] { return check(*options); }; });
}

}  // namespace handlebody::cli
