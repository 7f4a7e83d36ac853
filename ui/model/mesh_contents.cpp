#include "ui/model/mesh_contents.h"

#include <limits>

#include "core/cancellation.h"
#include "core/mesh/topology.h"
#include "core/mesh/tunnels.h"
#include "ui/model/error_sentence.h"

namespace handlebody::ui {

namespace {

std::vector<Vec3> polygonOf(const Mesh& mesh, const SurfaceLoop& loop) {
  std::vector<Vec3> out;
  for (const SurfacePoint& p : loop.points) out.push_back(positionOf(mesh, p));
  return out;
}

std::vector<FoundPiece> piecesOf(const Mesh& mesh) {
  std::vector<FoundPiece> out;
  for (const Piece& p : listPieces(mesh)) out.push_back({p, p.centre});
  const Components parts = findComponents(mesh);
  std::vector<double> nearest(out.size(), std::numeric_limits<double>::infinity());
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    const int c = parts.ofVertex[v];
    if (c < 0) continue;
    const double distance = (mesh.position(v) - out[c].piece.centre).norm();
    if (distance >= nearest[c]) continue;
    nearest[c] = distance;
    out[c].place = mesh.position(v);
  }
  return out;
}

}  // namespace

MeshContents contentsOf(const std::shared_ptr<const MeshSnapshot>& snapshot) {
  MeshContents out;
  out.mesh = snapshot;
  const Mesh mesh(snapshot->mesh);
  out.pieces = piecesOf(mesh);
  giveUpIfCancelled();
  const TunnelList list = findTunnels(mesh);
  out.unlisted = list.unlisted;
  for (const Tunnel& t : list.tunnels)
    out.tunnels.push_back({t.position, polygonOf(mesh, t.handle), polygonOf(mesh, t.tunnel), t.handle.length,
                           t.tunnel.length, t.handleBounds, t.tunnelBounds});
  return out;
}

void ContentsFinder::cancel() { *cancelled_ = true; }

void ContentsFinder::find(std::shared_ptr<const MeshSnapshot> mesh, std::function<void(MeshContents)> done) {
  cancel();
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  thread_.postInstead([cancelled = cancelled_, mesh = std::move(mesh), done = std::move(done)] {
    MeshContents found;
    try {
      const CancelScope scope(*cancelled);
      found = contentsOf(mesh);
    } catch (const Cancelled&) {
      return;
    } catch (...) {
      found = {};
      found.mesh = mesh;
      found.error = errorSentence();
    }
    done(std::move(found));
  });
}

}  // namespace handlebody::ui
