#include "core/evolution/leak_alarm.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

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
}

//! Where the surface is already is no leak.
void LeakAlarm::begin(const Mesh& mesh, const Scene& scene) {
  chart(mesh, scene);
  const std::vector<int> all = allVertices(mesh);
  enteredBy(mesh, all);
  std::vector<Vec3> places;
  for (const int v : all) places.push_back(mesh.position(v));
  first_ = std::make_shared<const std::vector<Vec3>>(std::move(places));
  told_.clear();
}

//! What the narrower box did not show to be a passage may lie behind the surface: it is told now. The spaces
//! of those that were told are starts, so that other parts of them may look as if they lay behind a passage.
std::vector<LeakAlarm::Entry> LeakAlarm::widen(const Mesh& mesh, const Scene& scene) {
  const std::shared_ptr<const PassageMap> before = map_;
  const std::vector<bool> entered = entered_;
  chart(mesh, scene);
  const std::vector<Passage>& passages = map_->passages();
  for (std::size_t k = 0; k < passages.size(); ++k)
    if (const int old = before->behindWhich(passages[k].widest); old >= 0 && entered[old]) setEntered(k);
  for (const std::vector<Vec3>* places : {first_.get(), &std::as_const(told_)})
    for (const Vec3& place : *places)
      if (const int k = map_->behindWhich(place); k >= 0) setEntered(idx(k));
  std::vector<Entry> fresh = enteredBy(mesh, allVertices(mesh));
  // What finer cells have seen is not to be told for the rounding of coarser ones.
  if (map_->cellSize() > before->cellSize())
    std::erase_if(fresh, [&](const Entry& e) { return !map_->isSure(passages[e.passage]); });
  return fresh;
}

void LeakAlarm::setEntered(std::size_t passage) {
  if (entered_[passage]) return;
  entered_[passage] = true;
  known_.push_back(map_->passages()[passage].widest);
}

std::vector<LeakAlarm::Entry> LeakAlarm::enteredBy(const Mesh& mesh, std::span<const int> vertices) {
  std::vector<Entry> fresh;
  if (map_->passages().empty()) return fresh;
  for (const int v : vertices) {
    if (!mesh.isVertex(v)) continue;
    const int passage = map_->behindWhich(mesh.position(v));
    if (passage < 0 || entered_[passage]) continue;
    setEntered(idx(passage));
    told_.push_back(mesh.position(v));
    fresh.push_back({idx(passage), v});
  }
  return fresh;
}

std::vector<Leak> LeakAlarm::look(const Mesh& mesh, std::span<const int> moving, const Scene& scene) {
  std::vector<Entry> entries;
  if (!map_)
    begin(mesh, scene);
  else if (!isCovered(mesh, moving))
    entries = widen(mesh, scene);
  const std::vector<Entry> moved = enteredBy(mesh, moving);
  entries.insert(entries.end(), moved.begin(), moved.end());
  std::vector<Leak> leaks;
  for (const Entry& entry : entries) {
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
