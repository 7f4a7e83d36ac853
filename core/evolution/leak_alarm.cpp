#include "core/evolution/leak_alarm.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/evolution/passage_disc.h"
#include "core/indices.h"

namespace handlebody {

namespace {

constexpr std::size_t kSmall = 2'000'000;  // voxels: a volume that is looked at as a whole
constexpr int kWiden = 24;                 // voxels around the surface, at least
constexpr double kWidenPart = 0.35;        // and of its extent
constexpr int kNear = 4;                   // voxels from the box's end at which it is widened

std::vector<int> allVertices(const Mesh& mesh) {
  std::vector<int> all;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) all.push_back(v);
  return all;
}

VoxelBox boxAround(const Grid& grid, const Mesh& mesh) {
  VoxelBox box;
  for (std::size_t a = 0; a < 3; ++a) box.high[a] = grid.size[a] - 1;
  if (grid.voxelCount() <= kSmall || mesh.vertexCount() == 0) return box;
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const int v : allVertices(mesh)) {
    const Vec3 index = grid.toIndex(mesh.position(v));
    low = low.cwiseMin(index);
    high = high.cwiseMax(index);
  }
  const double extent = (high - low).cwiseProduct(grid.spacing).maxCoeff();
  for (int a = 0; a < 3; ++a) {
    const double wide = std::max<double>(kWiden, kWidenPart * extent / grid.spacing[a]);
    const double last = grid.size[a] - 1.0;
    box.low[a] = static_cast<int>(std::clamp(std::floor(low[a] - wide), 0.0, last));
    box.high[a] = static_cast<int>(std::clamp(std::ceil(high[a] + wide), 0.0, last));
  }
  return box;
}

}  // namespace

Finding findingOf(const Leak& leak) {
  const Passage& p = leak.passage;
  Finding out(p.isSeen ? FindingKind::passage : FindingKind::passageTooNarrow,
              {{"place", placeValue(leak.place)}, {"before_mm", 2 * p.before}, {"behind_mm", 2 * p.behind}});
  if (p.isSeen) out.values.emplace_back("width_mm", 2 * p.radius);
  return out;
}

//! Maps that some copy still goes by.
struct LeakAlarm::Charts {
  struct Chart {
    VoxelBox box;
    std::vector<Vec3> starts;
    std::weak_ptr<const PassageMap> map;
  };
  std::mutex mutex;  // copies may look on several threads
  std::vector<Chart> all;

  std::shared_ptr<const PassageMap> find(const VoxelBox& box, const std::vector<Vec3>& starts) {
    const std::lock_guard lock(mutex);
    for (const Chart& c : all)
      if (c.box == box && c.starts == starts)
        if (auto map = c.map.lock()) return map;
    return nullptr;
  }
  void add(const VoxelBox& box, std::vector<Vec3> starts, const std::shared_ptr<const PassageMap>& map) {
    const std::lock_guard lock(mutex);
    std::erase_if(all, [](const Chart& c) { return c.map.expired(); });
    all.push_back({box, std::move(starts), map});
  }
};

LeakAlarm::LeakAlarm() : charts_(std::make_shared<Charts>()) {}

void LeakAlarm::forget() {
  map_ = nullptr;
  charts_ = std::make_shared<Charts>();  // what is copied already keeps the others
}

bool LeakAlarm::isCovered(const Mesh& mesh, std::span<const int> vertices) const {
  if (!map_) return false;
  Vec3 low, high;
  for (int a = 0; a < 3; ++a) {
    low[a] = box_.low[a] == 0 ? -1e300 : box_.low[a] + kNear;
    high[a] = box_.high[a] == grid_.size[a] - 1 ? 1e300 : box_.high[a] - kNear;
  }
  if (low.maxCoeff() == -1e300 && high.minCoeff() == 1e300) return true;
  return std::all_of(vertices.begin(), vertices.end(), [&](int v) {
    if (!mesh.isVertex(v)) return true;
    const Vec3 index = grid_.toIndex(mesh.position(v));
    return (index.array() >= low.array()).all() && (index.array() <= high.array()).all();
  });
}

//! Where the surface is already is no leak.
void LeakAlarm::chart(const Mesh& mesh, const Scene& scene) {
  grid_ = scene.image.volume().grid();
  box_ = boxAround(grid_, mesh);
  std::vector<Vec3> starts(scene.seeds.begin(), scene.seeds.end());
  starts.insert(starts.end(), known_.begin(), known_.end());
  map_ = charts_->find(box_, starts);
  if (!map_) {
    map_ = std::make_shared<const PassageMap>(scene.image, scene.walls, box_, starts, scene.threads);
    charts_->add(box_, std::move(starts), map_);
  }
  entered_.assign(map_->passages().size(), false);
  enteredBy(mesh, allVertices(mesh));
}

std::vector<LeakAlarm::Entry> LeakAlarm::enteredBy(const Mesh& mesh, std::span<const int> vertices) {
  std::vector<Entry> fresh;
  if (map_->passages().empty()) return fresh;
  for (const int v : vertices) {
    if (!mesh.isVertex(v)) continue;
    const int passage = map_->behindWhich(mesh.position(v));
    if (passage < 0 || entered_[passage]) continue;
    entered_[passage] = true;
    fresh.push_back({idx(passage), v});
  }
  for (const Entry& e : fresh) known_.push_back(map_->passages()[e.passage].widest);
  return fresh;
}

std::vector<Leak> LeakAlarm::look(const Mesh& mesh, std::span<const int> moving, const Scene& scene) {
  std::vector<Leak> leaks;
  if (!isCovered(mesh, moving)) chart(mesh, scene);
  for (const Entry& entry : enteredBy(mesh, moving)) {
    Leak leak{scene.iteration, map_->passages()[entry.passage], {}, {}};
    // The narrowest place of a space that widens may lie anywhere in it; what has widened begins here.
    if (!leak.passage.isSeen || leak.passage.isWidening) leak.passage.place = mesh.position(entry.vertex);
    leak.disc = discAcross(scene.image, leak.passage);
    leak.place = leak.disc.centre;
    leaks.push_back(leak);
  }
  return leaks;
}

}  // namespace handlebody
