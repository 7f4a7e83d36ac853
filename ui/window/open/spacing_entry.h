#pragma once
// The size of a voxel, for files that do not give it.

#include <QWidget>
#include <array>

#include "core/geometry/vec.h"

class QDoubleSpinBox;

namespace handlebody::ui {

class SpacingEntry : public QWidget {
  Q_OBJECT

 public:
  explicit SpacingEntry(QWidget* parent = nullptr);

  //! mm along the three axes of the volume.
  void show(const Vec3& spacing);
  Vec3 spacing() const;

 Q_SIGNALS:
  void entered(const handlebody::Vec3& spacing);

 private:
  std::array<QDoubleSpinBox*, 3> axes_;
};

}  // namespace handlebody::ui
