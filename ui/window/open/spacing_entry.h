#pragma once
// The size of a voxel, for files that do not give it.

#include <QWidget>
#include <array>

#include "core/geometry/vec.h"

class QDoubleSpinBox;
class QLabel;

namespace handlebody::ui {

class SpacingEntry : public QWidget {
  Q_OBJECT

 public:
  explicit SpacingEntry(QWidget* parent = nullptr);

  //! mm along the three axes of the volume at `path`.
  void show(const QString& path, const Vec3& spacing);
  Vec3 spacing() const;

 Q_SIGNALS:
  void entered(const handlebody::Vec3& spacing);

 private:
  QLabel* file_;
  std::array<QDoubleSpinBox*, 3> axes_;
};

}  // namespace handlebody::ui
