#pragma once
// A Document with two objects in one torus, and what is asked of it.

#include <map>
#include <string>

#include "tests/ui/model/output_support.h"

namespace handlebody::ui {

//! Two objects in one torus: what the first has grown to when it is stopped is a wall for the second.
struct ObjectsWork : OutputWork {
  Seed opposite() const { return {testing::kMiddle - Vec3(testing::kTorusR, 0, 0), 3.0}; }

  void growFirst(int iterations = 25) {
    document.addSeed(torus.seed);
    REQUIRE(stepTo(iterations));
  }
  void growSecond() {
    document.addObject();
    document.addSeed(opposite());
    REQUIRE(runToEnd(document));
  }
  bool exportAll(const QString& path) {
    written.clear();
    failed.clear();
    document.exportObjects(path, CoordinateSpace::lps);
    return isWritten(path);
  }
  bool exportActive(const QString& path) {
    written.clear();
    failed.clear();
    document.exportResult(path, CoordinateSpace::lps);
    return isWritten(path);
  }
  bool save(const QString& path) {
    written.clear();
    failed.clear();
    document.saveSession(path);
    return isWritten(path);
  }
};

inline std::string nameOf(const Document& document, int index) {
  return document.objectInfo(index).label.name;
}

inline std::string namesOf(const Document& document) {
  std::string names;
  for (int i = 0; i < document.objectCount(); ++i) names += (i > 0 ? "," : "") + nameOf(document, i);
  return names;
}

inline void rename(Document& document, int index, const char* name) {
  ObjectLabel label = document.objectInfo(index).label;
  label.name = name;
  document.setObjectLabel(index, label, QStringLiteral("Rename object"));
}

inline bool areAllAtRest(const Document& document) {
  for (int i = 0; i < document.objectCount(); ++i) {
    const GrowthState state = document.objectInfo(i).state;
    if (state != GrowthState::paused && state != GrowthState::finished) return false;
  }
  return true;
}

//! Voxels of each label value.
inline std::map<int, int> voxelsOf(const QString& path) {
  std::map<int, int> counts;
  const Volume map = readVolume(path.toStdString());
  visitVoxels(map, [&](const auto* voxels) {
    for (std::size_t i = 0; i < map.grid.voxelCount(); ++i)
      if (voxels[i] != 0) ++counts[static_cast<int>(voxels[i])];
  });
  return counts;
}

}  // namespace handlebody::ui
