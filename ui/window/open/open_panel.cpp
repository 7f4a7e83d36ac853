#include "ui/window/open/open_panel.h"

#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/model/document.h"
#include "ui/model/finding_text.h"
#include "ui/window/commands.h"
#include "ui/window/open/series_list.h"
#include "ui/window/open/spacing_entry.h"
#include "ui/window/widgets/action_button.h"
#include "ui/window/widgets/eliding_label.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"
#include "ui/window/widgets/sentences.h"

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
  spacingEntry_ = new SpacingEntry(this);
  spacingEntry_->hide();
  layout->addWidget(spacingEntry_);
  connect(spacingEntry_, &SpacingEntry::entered, this, &OpenPanel::openWithSpacing);
  layout->addStretch();
  connect(&document_, &Document::opened, this, &OpenPanel::showOpened);
  connect(&document_, &Document::seriesChoiceNeeded, this, &OpenPanel::offerSeries);
}

void OpenPanel::buildChoice() {
  choice_ = new QWidget(this);
  auto* layout = new QVBoxLayout(choice_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Series and stacks: choose one"), choice_));
  series_ = new SeriesList(choice_);
  layout->addWidget(series_);
  auto* open = new QPushButton(tr("Open this series"), choice_);
  open->setMinimumHeight(30);
  layout->addWidget(open);
  connect(open, &QPushButton::clicked, this, &OpenPanel::openSeries);
  connect(series_, &QListWidget::itemActivated, this, &OpenPanel::openSeries);
  choice_->hide();
}

void OpenPanel::addFact(QFormLayout* form, const QString& name, QLabel*& field) {
  field = value(name, facts_);
  auto* label = new QLabel(name, facts_);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);  // beside the first of several lines
  form->addRow(label, field);
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
    Q_EMIT openRequested(document_.path(), selection);
  });
}

void OpenPanel::listSeries(const QString& path, const std::vector<SeriesInfo>& series) {
  choicePath_ = path;
  series_->offer(series);
  choice_->setVisible(series.size() > 1);
}

void OpenPanel::offerSeries(const QString& path, const std::vector<SeriesInfo>& series) {
  listSeries(path, series);
  choice_->show();
  series_->setFocus();
}

void OpenPanel::openSeries() {
  const std::optional<QString> series = series_->chosen();
  if (!series) return;
  VolumeSelection selection;
  selection.series = series->toStdString();
  Q_EMIT openRequested(choicePath_, selection);
}

void OpenPanel::askSpacing(const QString& path, const VolumeSelection& selection) {
  spacingPath_ = path;
  spacingSelection_ = selection;
  spacingEntry_->show(path, Vec3(1, 1, 1));
  spacingEntry_->setFocus(Qt::TabFocusReason);  // the number is selected: it can be typed at once
}

void OpenPanel::openWithSpacing(const Vec3& spacing) {
  VolumeSelection selection = spacingSelection_;
  selection.spacing = spacing;
  Q_EMIT openRequested(spacingPath_, selection);
}

void OpenPanel::offerSpacing() {
  spacingPath_ = document_.path();
  spacingSelection_ = document_.selection();
  const bool open = !document_.info().calibrated || spacingSelection_.spacing;
  if (open)
    spacingEntry_->show(spacingPath_, document_.volume().grid.spacing);
  else
    spacingEntry_->hide();
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
  frame_->setValue(document_.selection().frame.value_or(0));
  frame_->setSuffix(tr("  (0 to %1)").arg(info.frames - 1));
  showWarnings(warningsOfWindow(info));
  offerSpacing();
  hint_->hide();
  facts_->show();
}

void OpenPanel::showWarnings(const std::vector<Finding>& warnings) {
  QStringList lines;
  for (const Finding& warning : warnings)
    lines << QStringLiteral("<p style='margin: 4px 0 0 0'>⚠ %1</p>")
                 .arg(breakable(findingSentence(warning)).toHtmlEscaped());
  warnings_->setText(lines.join(QString()));
  warnings_->setVisible(!lines.isEmpty());
}

}  // namespace handlebody::ui
