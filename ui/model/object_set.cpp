#include "ui/model/object_set.h"

#include <algorithm>

namespace handlebody::ui {

void ObjectSet::hold(std::vector<Object> all, Object active) {
  all_ = std::move(all);
  active_ = std::move(active);
}

int ObjectSet::indexOf(const ObjectWork& object) const {
  const auto at =
      std::find_if(all_.begin(), all_.end(), [&](const auto& other) { return other.get() == &object; });
  return at == all_.end() ? -1 : static_cast<int>(at - all_.begin());
}

std::vector<ObjectSet::Object> ObjectSet::after(const ObjectWork& object) const {
  const int at = indexOf(object);
  if (at < 0) return {};
  return {all_.begin() + at + 1, all_.end()};
}

ObjectList ObjectSet::list() const {
  ObjectList list;
  for (const auto& object : all_) list.entries.push_back({object, object->traits});
  list.active = active_;
  return list;
}

std::vector<ObjectLabel> ObjectSet::labels() const {
  std::vector<ObjectLabel> labels;
  for (const auto& object : all_) labels.push_back(object->traits.label);
  return labels;
}

bool ObjectSet::isGrown() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const auto& object) { return object->growth().exists() || object->isBusy(); });
}

bool ObjectSet::isSeeded() const {
  return std::any_of(all_.begin(), all_.end(), [](const auto& object) { return object->isSeeded(); });
}

bool ObjectSet::isAsSaved() const {
  return std::all_of(all_.begin(), all_.end(), [](const auto& object) { return object->isAsSaved(); });
}

std::vector<FinishedWall> ObjectSet::wallsFor(const ObjectWork& object) const {
  std::vector<FinishedWall> walls;
  for (const auto& other : all_) {
    if (other.get() == &object) break;
    if (auto mesh = other->finished())
      walls.push_back({QString::fromStdString(other->traits.label.name), std::move(mesh)});
  }
  return walls;
}

bool ObjectSet::mustWait(const ObjectWork& object) const {
  for (const auto& other : all_) {
    if (other.get() == &object) return false;
    if (other->isBusy()) return true;
  }
  return false;
}

QString ObjectSet::madeWithEarlier(const ObjectWork& object) const {
  if (!object.isOutOfDate()) return {};
  const std::vector<FinishedWall> now = wallsFor(object), &then = object.grownWith();
  for (const FinishedWall& wall : now)
    if (std::find(then.begin(), then.end(), wall) == then.end()) return wall.name;
  for (const FinishedWall& wall : then)
    if (std::find(now.begin(), now.end(), wall) == now.end()) return wall.name;
  return now.front().name;  // in another order
}

}  // namespace handlebody::ui
