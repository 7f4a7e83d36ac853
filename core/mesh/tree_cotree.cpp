#include "core/mesh/tree_cotree.h"

#include <algorithm>

#include "core/indices.h"

namespace handlebody {

namespace {

void growTree(const Mesh& mesh, TreeCotree& out, std::vector<unsigned char>& used) {
  out.vertexParent.assign(mesh.vertexSlots(), -1);
  out.vertexDepth.assign(mesh.vertexSlots(), -1);
  std::vector<int> queue{0};
  out.vertexDepth[0] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i)
    mesh.forEachOutgoing(queue[i], [&](int h) {
      const int w = mesh.target(h);
      if (out.vertexDepth[w] >= 0) return;
      out.vertexDepth[w] = out.vertexDepth[queue[i]] + 1;
      out.vertexParent[w] = h;
      used[h] = used[mesh.opposite(h)] = 1;
      queue.push_back(w);
    });
}

void growCotree(const Mesh& mesh, TreeCotree& out, std::vector<unsigned char>& used) {
  out.faceParent.assign(mesh.faceSlots(), -1);
  out.faceDepth.assign(mesh.faceSlots(), -1);
  std::vector<int> queue{0};
  out.faceDepth[0] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (int h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
      const int g = mesh.opposite(h), f = Mesh::faceOf(g);
      if (used[h] != 0 || out.faceDepth[f] >= 0) continue;
      out.faceDepth[f] = out.faceDepth[queue[i]] + 1;
      out.faceParent[f] = g;
      used[h] = used[g] = 1;
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
    if (used[h] == 0 && h < mesh.opposite(h)) out.generators.push_back(h);
  return out;
}

std::vector<int> primalLoop(const Mesh& mesh, const TreeCotree& trees, int k) {
  const int generator = trees.generators[k];
  int u = mesh.origin(generator), w = mesh.target(generator);
  std::vector<int> there{generator}, back;  // back: from u towards the common ancestor, still turned round
  while (u != w) {
    if (trees.vertexDepth[u] > trees.vertexDepth[w]) {
      const int h = trees.vertexParent[u];
      back.push_back(h);
      u = mesh.origin(h);
    } else {
      const int h = trees.vertexParent[w];
      there.push_back(mesh.opposite(h));
      w = mesh.origin(h);
    }
  }
  there.insert(there.end(), back.rbegin(), back.rend());
  return there;
}

std::vector<int> dualLoop(const Mesh& mesh, const TreeCotree& trees, int k) {
  const int generator = trees.generators[k];
  int f = Mesh::faceOf(generator), g = Mesh::faceOf(mesh.opposite(generator));
  std::vector<int> there{generator}, back;
  while (f != g) {
    if (trees.faceDepth[f] > trees.faceDepth[g]) {
      const int h = trees.faceParent[f];
      back.push_back(mesh.opposite(h));
      f = Mesh::faceOf(mesh.opposite(h));
    } else {
      const int h = trees.faceParent[g];
      there.push_back(h);
      g = Mesh::faceOf(mesh.opposite(h));
    }
  }
  there.insert(there.end(), back.rbegin(), back.rend());
  return there;
}

}  // namespace handlebody
