#include "core/surgery/mesh_edits.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

#include "core/indices.h"
#include "core/mesh/containment.h"
#include "core/mesh/structure.h"
#include "core/surgery/predicted_change.h"

namespace handlebody {

namespace {

using LoopChoice = std::pair<const SurfaceLoop*, EventKind>;

//! The loops that may be cut along, the one that is wanted first.
std::vector<LoopChoice> choices(const Tunnel& t, TunnelCut cut) {
  std::vector<LoopChoice> out;
  if (cut != TunnelCut::tunnel && t.handleBounds) out.emplace_back(&t.handle, EventKind::handleCut);
  if (cut != TunnelCut::handle && t.tunnelBounds) out.emplace_back(&t.tunnel, EventKind::tunnelClosed);
  if (out.size() == 2 && t.tunnel.length < t.handle.length) std::swap(out[0], out[1]);
  return out;
}

//! None, and the mesh as it was, if no caps fit.
std::optional<TunnelClosed> cutThrough(Mesh& mesh, const Tunnel& tunnel, const LoopChoice& choice) {
  const auto& [loop, kind] = choice;
  auto done = closeTunnel(mesh, tunnel, kind == EventKind::handleCut ? LoopKind::handle : LoopKind::tunnel);
  if (!done) return std::nullopt;
  TunnelClosed out;
  out.event.kind = kind;
  out.event.location = tunnel.position;
  out.event.before = done->before;
  out.event.after = done->after;
  out.event.edit = EditMeasures{loop->length, signedVolume(mesh), signedVolume(done->mesh)};
  out.touched = std::move(done->touched);
  mesh = std::move(done->mesh);
  return out;
}

//! Cuts along loops of one list of tunnels, as long as the surface beside them is as it was.
class TunnelCloser {
 public:
  TunnelCloser(Mesh& mesh, double shorterThan, TunnelCut cut, TunnelsClosed& out)
      : mesh_(mesh), shorterThan_(shorterThan), cut_(cut), out_(out) {}

  //! True if it closed any.
  bool round() {
    const TunnelList list = findTunnels(mesh_);
    out_.unlisted = list.unlisted;
    out_.open.clear();
    touched_.assign(mesh_.vertexSlots(), 0);
    bool any = false;
    for (const Tunnel& tunnel : list.tunnels) {
      const Result result = close(tunnel);
      any = any || result == Result::closed;
      if (result == Result::refused)
        out_.open.push_back({tunnel.position, tunnel.handle.length, tunnel.tunnel.length});
    }
    refused_ = out_.open;
    return any;
  }

 private:
  enum class Result { closed, refused, notNow };

  bool isTouched(const SurfaceLoop& loop) const {
    return std::any_of(loop.points.begin(), loop.points.end(),
                       [&](const SurfacePoint& p) { return touched_[p.from] != 0 || touched_[p.to] != 0; });
  }
  //! In the round before, with the same loops: it would cost as much again to fail once more.
  bool wasRefused(const Tunnel& t) const {
    return std::any_of(refused_.begin(), refused_.end(), [&](const OpenTunnel& o) {
      return o.location == t.position && o.handleLength == t.handle.length &&
             o.tunnelLength == t.tunnel.length;
    });
  }
  Result close(const Tunnel& tunnel) {
    if (wasRefused(tunnel)) return Result::refused;
    const auto loops = choices(tunnel, cut_);
    // A knotted tunnel or handle has no loop to cut along.
    bool refused =
        loops.empty() && (cut_ == TunnelCut::handle ? tunnel.handle : tunnel.tunnel).length < shorterThan_;
    for (const LoopChoice& choice : loops) {
      if (!(choice.first->length < shorterThan_)) continue;
      if (isTouched(*choice.first)) return Result::notNow;
      if (auto done = cutThrough(mesh_, tunnel, choice)) {
        accept(*std::move(done));
        return Result::closed;
      }
      refused = true;
    }
    return refused ? Result::refused : Result::notNow;
  }
  void accept(TunnelClosed done) {
    out_.edits.push_back(std::move(done.event));
    touched_.resize(mesh_.vertexSlots(), 0);
    for (const int v : done.touched)
      if (idx(v) < touched_.size()) touched_[v] = 1;
  }

  Mesh& mesh_;
  double shorterThan_;
  TunnelCut cut_;
  TunnelsClosed& out_;
  std::vector<OpenTunnel> refused_;  // in the round before
  VertexMarks touched_;              // per vertex slot, since the tunnels were listed
};

//! Removes the components that are marked, one edit each.
std::vector<Event> remove(Mesh& mesh, const Components& parts, const ComponentMarks& marked) {
  std::vector<Event> out;
  std::vector<Eigen::AlignedBox3d> boxes(parts.count());
  std::vector<int> vertex(parts.count(), -1);
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (const int c = parts.ofVertex[v]; c >= 0) {
      boxes[c].extend(mesh.position(v));
      vertex[c] = v;
    }
  TopologyNumbers now = topologyNumbers(mesh);
  double volume = signedVolume(mesh);
  for (int c = 0; c < parts.count(); ++c) {
    if (marked[c] == 0) continue;
    Event edit;
    edit.kind = parts.volume[c] < 0 ? EventKind::cavityFilled : EventKind::componentRemoved;
    edit.location = boxes[c].center();
    edit.before = now;
    edit.after = predictDeletion(now, parts, c);
    edit.edit = EditMeasures{0, volume, volume - parts.volume[c]};
    deleteComponent(mesh, vertex[c]);
    now = edit.after;
    volume = edit.edit->volumeAfter;
    out.push_back(std::move(edit));
  }
  // What is left has not been changed: only counts can be wrong.
  if (!(topologyNumbers(mesh) == now) || findStructureFault(mesh))
    throw std::logic_error("removing components did not leave what was predicted");
  return out;
}

//! Marks all that lies in a marked component.
void markWithin(ComponentMarks& marked, const std::vector<int>& surrounding) {
  for (std::size_t c = 0; c < marked.size(); ++c) {
    int around = surrounding[c];
    // As deep as there are components at most.
    for (std::size_t i = 0; i < marked.size() && around >= 0; ++i, around = surrounding[around])
      if (marked[around] != 0) marked[c] = 1;
  }
}

}  // namespace

TunnelsClosed closeTunnels(Mesh& mesh, double shorterThan, TunnelCut cut) {
  TunnelsClosed out;
  TunnelCloser closer(mesh, shorterThan, cut, out);
  while (closer.round()) {
  }
  return out;
}

std::optional<TunnelClosed> closeOneTunnel(Mesh& mesh, const Tunnel& tunnel, TunnelCut cut) {
  for (const LoopChoice& choice : choices(tunnel, cut))
    if (auto done = cutThrough(mesh, tunnel, choice)) return done;
  return std::nullopt;
}

std::vector<Event> removeComponent(Mesh& mesh, int component) {
  const Components parts = findComponents(mesh);
  ComponentMarks marked(idx(parts.count()), 0);
  marked[component] = 1;
  markWithin(marked, surroundingComponents(mesh, parts));
  return remove(mesh, parts, marked);
}

namespace {

std::vector<Event> keepBody(Mesh& mesh, const Components& parts, const std::vector<int>& bodyOf, int body) {
  ComponentMarks marked;
  for (const int b : bodyOf) marked.push_back(b != body);
  return remove(mesh, parts, marked);
}

}  // namespace

std::vector<Event> keepBodyOf(Mesh& mesh, int component) {
  const Components parts = findComponents(mesh);
  const std::vector<int> body = bodyOfComponents(parts, surroundingComponents(mesh, parts));
  return keepBody(mesh, parts, body, body[component]);
}

std::vector<Event> keepLargest(Mesh& mesh) {
  const Components parts = findComponents(mesh);
  if (parts.count() == 0) return {};
  const std::vector<int> body = bodyOfComponents(parts, surroundingComponents(mesh, parts));
  std::vector<double> volume(parts.count(), 0);
  for (int c = 0; c < parts.count(); ++c)
    if (body[c] >= 0) volume[body[c]] += parts.volume[c];
  const auto largest = static_cast<int>(std::max_element(volume.begin(), volume.end()) - volume.begin());
  return keepBody(mesh, parts, body, largest);
}

std::vector<Event> fillCavities(Mesh& mesh) {
  const Components parts = findComponents(mesh);
  ComponentMarks marked;
  for (const double volume : parts.volume) marked.push_back(volume < 0);
  markWithin(marked, surroundingComponents(mesh, parts));
  return remove(mesh, parts, marked);
}

}  // namespace handlebody
