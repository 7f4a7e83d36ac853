#include "core/mesh/tree_cotree.h"
#include "core/indices.h"

#include <algorithm>

namespace handlebody {

namespace {

void growTree(const Mesh& mesh, TreeCotree& out, std::vector<unsigned char>& used) {
  out.vertexParent.assign(idx(mesh.vertexSlots()), -1);
  out.vertexDepth.assign(idx(mesh.vertexSlots()), -1);
  std::vector<int> queue{0};
  out.vertexDepth[0] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i)
    mesh.forEachOutgoing(queue[i], [&](int h) {
      const int w = mesh.target(h);
      if (out.vertexDepth[idx(w)] >= 0) return;
      out.vertexDepth[idx(w)] = out.vertexDepth[idx(queue[i])] + 1;
      out.vertexParent[idx(w)] = h;
      used[idx(h)] = used[idx(mesh.opposite(h))] = 1;
      queue.push_back(w);
    });
}

void growCotree(const Mesh& mesh, TreeCotree& out, std::vector<unsigned char>& used) {
  out.faceParent.assign(idx(mesh.faceSlots()), -1);
  out.faceDepth.assign(idx(mesh.faceSlots()), -1);
  std::vector<int> queue{0};
  out.faceDepth[0] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (int h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
      const int g = mesh.opposite(h), f = Mesh::faceOf(g);
      if (used[idx(h)] != 0 || out.faceDepth[idx(f)] >= 0) continue;
      out.faceDepth[idx(f)] = out.faceDepth[idx(queue[i])] + 1;
      out.faceParent[idx(f)] = g;
      used[idx(h)] = used[idx(g)] = 1;
      queue.push_back(f);
    }
}

}  // namespace

TreeCotree treeCotree(const Mesh& mesh) {
  TreeCotree out;
  if (mesh.faceSlots() == 0) return out;
  std::vector<unsigned char> used(3 * idx(mesh.faceSlots()), 0);
  growTree(mesh, out, used);
  growCotree(mesh, out, used);
  for (int h = 0; h < 3 * mesh.faceSlots(); ++h)
    if (used[idx(h)] == 0 && h < mesh.opposite(h)) out.generators.push_back(h);
  return out;
}

std::vector<int> primalLoop(const Mesh& mesh, const TreeCotree& trees, int k) {
  const int generator = trees.generators[idx(k)];
  int u = mesh.origin(generator), w = mesh.target(generator);
  std::vector<int> there{generator}, back;  // back: from u towards the common ancestor, still turned round
  while (u != w) {
    if (trees.vertexDepth[idx(u)] > trees.vertexDepth[idx(w)]) {
      const int h = trees.vertexParent[idx(u)];
      back.push_back(h);
      u = mesh.origin(h);
    } else {
      const int h = trees.vertexParent[idx(w)];
      there.push_back(mesh.opposite(h));
      w = mesh.origin(h);
    }
  }
  there.insert(there.end(), back.rbegin(), back.rend());
  return there;
}

std::vector<int> dualLoop(const Mesh& mesh, const TreeCotree& trees, int k) {
  const int generator = trees.generators[idx(k)];
  int f = Mesh::faceOf(generator), g = Mesh::faceOf(mesh.opposite(generator));
  std::vector<int> there{generator}, back;
  while (f != g) {
    if (trees.faceDepth[idx(f)] > trees.faceDepth[idx(g)]) {
      const int h = trees.faceParent[idx(f)];
      back.push_back(mesh.opposite(h));
      f = Mesh::faceOf(mesh.opposite(h));
    } else {
      const int h = trees.faceParent[idx(g)];
      there.push_back(h);
      g = Mesh::faceOf(mesh.opposite(h));
    }
  }
  there.insert(there.end(), back.rbegin(), back.rend());
  return there;
}

}  // namespace handlebody
