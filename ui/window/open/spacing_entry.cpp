#include "ui/window/open/spacing_entry.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/window/widgets/decimal_field.h"
#include "ui/window/widgets/eliding_label.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr double kSmallest = 0.0001, kLargest = 1000;  // mm

QDoubleSpinBox* makeAxis(const QString& name, QWidget* parent) {
  auto* field = new DecimalField(parent);
  field->setDecimals(4);
  field->setRange(kSmallest, kLargest);
  field->setValue(1);
  field->setMinimumWidth(field->fontMetrics().horizontalAdvance(QStringLiteral("00.0000 mm")) + 14);
  field->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field->setSuffix(SpacingEntry::tr(" mm"));
  field->setKeyboardTracking(false);
  describe(field, name, SpacingEntry::tr("Distance between the middles of neighbouring voxels"));
  ignoreWheelWithoutFocus(field);
  return field;
}

}  // namespace

SpacingEntry::SpacingEntry(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Size of a voxel"), this));
  file_ = new ElidingLabel(this);
  file_->setAccessibleName(tr("File without a spacing"));
  file_->setTextFormat(Qt::PlainText);
  layout->addWidget(file_);
  layout->addWidget(
      hint(tr("The file does not give it. Lengths and volumes are right only with the true spacing along "
              "columns, rows and slices."),
           this));
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  const QString names[] = {tr("Spacing of columns"), tr("Spacing of rows"), tr("Spacing of slices")};
  for (std::size_t axis = 0; axis < 3; ++axis) row->addWidget(axes_[axis] = makeAxis(names[axis], this), 1);
  layout->addLayout(row);
  setFocusProxy(axes_[0]);
  auto* use = new QPushButton(tr("Open with this spacing"), this);
  use->setMinimumHeight(30);
  layout->addWidget(use);
  connect(use, &QPushButton::clicked, this, [this] { Q_EMIT entered(spacing()); });
}

void SpacingEntry::show(const QString& path, const Vec3& spacing) {
  file_->setText(QFileInfo(path).fileName());
  file_->setToolTip(path);
  for (std::size_t axis = 0; axis < 3; ++axis) axes_[axis]->setValue(spacing[static_cast<int>(axis)]);
  QWidget::show();
}

Vec3 SpacingEntry::spacing() const { return {axes_[0]->value(), axes_[1]->value(), axes_[2]->value()}; }

}  // namespace handlebody::ui
