#include "core/io/report/option_effects.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/evolution/wall_guard.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/option_error.h"
#include "core/mesh/topology.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

using K = FindingKind;

constexpr std::array<std::string_view, 10> kOfGrowth{
    "--object",    "--range",   "--candidate", "--smoothing",      "--edge-length",
    "--direction", "--balloon", "--curvature", "--max-iterations", "--resolution"};
//! Of the steps, which a given object makes for edits alone.
constexpr std::array<std::string_view, 2> kOfChanges{"--allow", "--hold"};
constexpr std::array<std::string_view, 3> kOfLabels{"--start-smooth", "--start-keep-largest",
                                                    "--start-genus"};

template <typename Names>
bool isIn(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

[[noreturn]] void refuse(const std::string& option, Finding why) {
  throw OptionError(option, std::move(why), " ");
}

}  // namespace

void requireEffect(const std::vector<std::string>& names, const Constraints& constraints) {
  const auto& start = constraints.start;
  const bool isGiven = start && start->isDone;
  const bool isMesh = start && !start->path.empty() && isMeshInputPath(start->path);
  for (const std::string& name : names) {
    if (isGiven && (isIn(kOfGrowth, name) || (constraints.edits.empty() && isIn(kOfChanges, name))))
      refuse(name, K::noEffectOnGiven);
    if (isMesh && isIn(kOfLabels, name)) refuse(name, {K::noEffectOnMesh, {{"file", start->path}}});
    if (name == "--candidate" && isIn(names, "--range")) refuse(name, K::noEffectWithRange);
  }
}

namespace {

double longestEdge(const TriangleSoup& mesh) {
  double longest = 0;
  for (const Triangle& t : mesh.triangles)
    for (int c = 0; c < 3; ++c)
      longest = std::max(longest, (mesh.points[t[(c + 1) % 3]] - mesh.points[t[c]]).norm());
  return longest;
}

void requireClear(const TriangleSoup& surface, const Mesh& mesh, WallList walls, const Grid& grid) {
  walls.objects.clear();  // these refuse by themselves
  const double longest = longestEdge(surface);
  WallGuard guard;
  guard.choose(walls, grid, longest, longest);
  if (const auto place = guard.brokenAnywhere(mesh))
    throw Told<UsageError>(Finding(K::wallOverGiven, {{"place", placeValue(*place)}}));
}

void requireAtMost(const char* option, K why, const std::string& file, int count, std::optional<int> most) {
  if (most && count > *most)
    throw OptionError(option, Finding(why, {{"file", file}, {"count", count}, {"most", *most}}));
}

}  // namespace

void requireGivenHolds(const Constraints& constraints, const Grid& grid) {
  const auto& start = constraints.start;
  if (!start || !start->isDone) return;
  requireSensible(constraints, grid);
  const Mesh mesh(*start->mesh);
  requireClear(*start->mesh, mesh, constraints.walls, grid);
  if (!constraints.edits.empty()) return;
  const TopologyNumbers has = topologyNumbers(mesh);
  const TopologyLimits& limits = constraints.topology;
  requireAtMost("--components", K::givenComponents, start->path, has.components, limits.components);
  requireAtMost("--genus", K::givenTunnels, start->path, has.genus, limits.genus);
}

}  // namespace handlebody
