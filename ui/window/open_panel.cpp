#include "ui/window/open_panel.h"

#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/model/document.h"
#include "ui/window/action_button.h"
#include "ui/window/commands.h"
#include "ui/window/eliding_label.h"
#include "ui/window/numbers.h"
#include "ui/window/panel_tools.h"

namespace handlebody::ui {

namespace {

// How far the volume's axes may be off the patient's before it is called oblique, as |cos| of the angle: the
// one degree of the pictures.
constexpr double kStraight = 0.99985;

QString axesText(const Grid& grid) {
  const bool straight = (grid.direction.cwiseAbs().colwise().maxCoeff().array() > kStraight).all();
  return straight ? OpenPanel::tr("along the patient's axes")
                  : OpenPanel::tr("oblique: slices follow the volume's own axes");
}

Vec3 sizeOf(const Grid& grid) { return {double(grid.size[0]), double(grid.size[1]), double(grid.size[2])}; }

// Which stack of several it is stands behind its UID.
QString seriesText(const SeriesInfo& s) {
  const QString uid = QString::fromStdString(s.uid);
  const qsizetype stack = uid.indexOf(u'#');
  QString name = s.description.empty() ? uid : QString::fromStdString(s.description);
  if (stack >= 0 && !s.description.empty()) name += OpenPanel::tr(", stack %1").arg(uid.mid(stack + 1));
  if (!s.note.empty()) return OpenPanel::tr("%1\nNo volume: %2").arg(name, QString::fromStdString(s.note));
  const Vec3 size(s.size[0], s.size[1], s.size[2]);
  return OpenPanel::tr("%1\n%2 voxels of %3 mm, slices: %4")
      .arg(name, times(size, 0), times(s.spacing, 2))
      .arg(s.slices);
}

}  // namespace

OpenPanel::OpenPanel(Document& document, const Commands& commands, QWidget* parent)
    : QWidget(parent), document_(document) {
  auto* layout = panelLayout(this);
  layout->addWidget(new ActionButton(commands[Command::openFile], this));
  layout->addWidget(new ActionButton(commands[Command::openFolder], this));
  hint_ = hint(tr("Open a CT, MR or ultrasound volume, a DICOM folder or a saved session; files can also be "
                  "dropped on the window."),
               this);
  layout->addWidget(hint_);
  buildChoice();
  layout->addWidget(choice_);
  buildFacts();
  layout->addWidget(facts_);
  layout->addStretch();
  connect(&document_, &Document::opened, this, &OpenPanel::showOpened);
  connect(&document_, &Document::seriesChoiceNeeded, this, &OpenPanel::offerSeries);
}

void OpenPanel::buildChoice() {
  choice_ = new QWidget(this);
  auto* layout = new QVBoxLayout(choice_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Series and stacks in the folder: choose one"), choice_));
  series_ = new QListWidget(choice_);
  series_->setAccessibleName(tr("Series in the folder"));
  series_->setWordWrap(true);
  series_->setMinimumHeight(140);
  layout->addWidget(series_);
  auto* open = new QPushButton(tr("Open this series"), choice_);
  layout->addWidget(open);
  connect(open, &QPushButton::clicked, this, &OpenPanel::openSeries);
  connect(series_, &QListWidget::itemActivated, this, &OpenPanel::openSeries);
  choice_->hide();
}

void OpenPanel::addFact(QFormLayout* form, const QString& name, QLabel*& field) {
  field = value(name, facts_);
  form->addRow(name, field);
}

void OpenPanel::buildFacts() {
  facts_ = new QWidget(this);
  auto* layout = new QVBoxLayout(facts_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Open now"), facts_));
  QFormLayout* form = panelForm();
  name_ = new ElidingLabel(facts_);
  name_->setAccessibleName(tr("Name"));
  form->addRow(tr("Name"), name_);
  addFact(form, tr("Format"), format_);
  addFact(form, tr("Voxels"), size_);
  addFact(form, tr("Spacing"), spacing_);
  addFact(form, tr("Extent"), extent_);
  addFact(form, tr("Type"), type_);
  addFact(form, tr("Axes"), axes_);
  layout->addLayout(form);

  buildTime(layout);
  buildCalibration(layout);
  warnings_ = value(tr("Warnings"), facts_);
  layout->addWidget(warnings_);
  facts_->hide();
}

void OpenPanel::buildTime(QVBoxLayout* layout) {
  time_ = new QWidget(facts_);
  auto* row = new QHBoxLayout(time_);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Time point"), time_));
  frame_ = new QSpinBox(time_);
  describe(frame_, tr("Time point"), tr("The volume has several time points; one is shown and segmented"));
  row->addWidget(frame_, 1);
  auto* load = new QPushButton(tr("Load"), time_);
  row->addWidget(load);
  layout->addWidget(time_);
  connect(load, &QPushButton::clicked, this, [this] {
    VolumeSelection selection = document_.selection();
    selection.frame = frame_->value();
    document_.open(document_.path(), selection);
  });
}

void OpenPanel::buildCalibration(QVBoxLayout* layout) {
  calibration_ = new QWidget(facts_);
  auto* row = new QHBoxLayout(calibration_);
  row->setContentsMargins(0, 0, 0, 0);
  const QString names[] = {tr("Spacing along x"), tr("Spacing along y"), tr("Spacing along z")};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto* field = mm_[axis] = new QDoubleSpinBox(calibration_);
    field->setRange(0.001, 1000);
    field->setDecimals(4);
    describe(field, names[axis], tr("Distance of two voxels in mm; the file does not give it"));
    ignoreWheelWithoutFocus(field);
    row->addWidget(field, 1);
  }
  auto* use = new QPushButton(tr("Set mm"), calibration_);
  describe(use, tr("Set spacing"), tr("Opens the volume again with this spacing"));
  row->addWidget(use);
  layout->addWidget(calibration_);
  connect(use, &QPushButton::clicked, this, [this] {
    VolumeSelection selection = document_.selection();
    selection.spacing = Vec3(mm_[0]->value(), mm_[1]->value(), mm_[2]->value());
    document_.open(document_.path(), selection);
  });
}

// Only where the file leaves it open, and where it was given before.
void OpenPanel::showCalibration() {
  calibration_->setVisible(!document_.info().calibrated || document_.selection().spacing);
  for (std::size_t axis = 0; axis < 3; ++axis)
    mm_[axis]->setValue(document_.volume().grid.spacing[static_cast<Eigen::Index>(axis)]);
}

void OpenPanel::listSeries(const QString& path, const std::vector<SeriesInfo>& series) {
  choicePath_ = path;
  series_->clear();
  for (const SeriesInfo& s : series) {
    auto* item = new QListWidgetItem(seriesText(s), series_);
    item->setData(Qt::UserRole, QString::fromStdString(s.uid));
    item->setToolTip(QString::fromStdString(s.uid));
  }
  series_->setCurrentRow(0);
  choice_->setVisible(series.size() > 1);
}

void OpenPanel::offerSeries(const QString& path, const std::vector<SeriesInfo>& series) {
  listSeries(path, series);
  choice_->show();
  series_->setFocus();
}

void OpenPanel::openSeries() {
  if (!series_->currentItem()) return;
  VolumeSelection selection;
  selection.series = series_->currentItem()->data(Qt::UserRole).toString().toStdString();
  document_.open(choicePath_, selection);
}

void OpenPanel::showOpened() {
  const VolumeInfo& info = document_.info();
  listSeries(document_.path(), info.series);  // another one may be opened from here
  const Grid& grid = document_.volume().grid;
  name_->setText(QFileInfo(document_.path()).fileName());
  name_->setToolTip(document_.path());
  format_->setText(QString::fromStdString(info.format));
  size_->setText(times(sizeOf(grid), 0));
  spacing_->setText(times(grid.spacing, 3) + tr(" mm"));
  extent_->setText(times(sizeOf(grid).cwiseProduct(grid.spacing), 0) + tr(" mm"));
  const VoxelType type = document_.volume().type;
  const double size = double(grid.voxelCount()) * double(bytesPerVoxel(type));
  type_->setText(QStringLiteral("%1, %2").arg(QString::fromLatin1(voxelTypeName(type)), bytes(size)));
  axes_->setText(axesText(grid));
  time_->setVisible(info.frames > 1);
  frame_->setRange(0, info.frames - 1);
  frame_->setSuffix(tr(" of 0 to %1").arg(info.frames - 1));
  showCalibration();
  showWarnings(info.warnings);
  hint_->hide();
  facts_->show();
}

void OpenPanel::showWarnings(const std::vector<std::string>& warnings) {
  QStringList lines;
  for (const std::string& warning : warnings)
    lines << QStringLiteral("<p>⚠ %1</p>").arg(QString::fromStdString(warning).toHtmlEscaped());
  warnings_->setText(lines.join(QString()));
  warnings_->setVisible(!lines.isEmpty());
}

}  // namespace handlebody::ui
