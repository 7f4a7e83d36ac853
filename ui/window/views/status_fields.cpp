#include "ui/window/views/status_fields.h"

#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>
#include <cmath>

#include "ui/model/document.h"
#include "ui/window/grow/grow_panel.h"
#include "ui/window/widgets/eliding_label.h"
#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kAtTheRim = 6;  // pixels; a window that fills the screen has no frame and no grip

// As wide as its longest text, so that the numbers do not jump about.
QLabel* field(QStatusBar* bar, const QString& name, const QString& longest) {
  auto* label = new QLabel(bar);
  label->setMinimumWidth(label->fontMetrics().horizontalAdvance(longest) + 12);
  label->setAccessibleName(name);
  label->setToolTip(name);
  return label;
}

}  // namespace

StatusFields::StatusFields(QStatusBar* bar, Document& document)
    : QObject(bar),
      document_(document),
      position_(field(bar, tr("Position of the mouse, mm LPS"), QStringLiteral("-000.0, -000.0, -000.0 mm"))),
      voxel_(field(bar, tr("Voxel under the mouse"), tr("Voxel %1").arg(QStringLiteral("000, 000, 000")))),
      intensity_(field(bar, tr("Intensity of the voxel"), tr("Intensity %1").arg(QStringLiteral("-0000.0")))),
      uncalibrated_(new QLabel(tr("Uncalibrated"), bar)),
      state_(new ElidingLabel(bar)),
      progress_(new QProgressBar(bar)),
      cancel_(new QToolButton(bar)) {
  for (QLabel* label : {position_, voxel_, intensity_}) bar->addWidget(label);
  state_->setAccessibleName(tr("State of the growth"));
  bar->setContentsMargins(kAtTheRim, 0, kAtTheRim, 0);
  progress_->setFixedWidth(160);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(14);
  progress_->setAccessibleName(tr("Progress"));
  cancel_->setIcon(icon(QStringLiteral("close")));
  cancel_->setAutoRaise(true);
  describe(cancel_, tr("Cancel"), tr("Stop reading the volume; what is open stays open"));
  describe(
      uncalibrated_, tr("Uncalibrated"),
      tr("The file does not give the size of a voxel: lengths, areas and volumes mean nothing until it is "
         "entered in step 1, Open"));
  for (QWidget* widget : std::initializer_list<QWidget*>{uncalibrated_, progress_, cancel_, state_})
    bar->addPermanentWidget(widget);  // the state at the rim, where it stays
  connect(cancel_, &QToolButton::clicked, &document_, &Document::cancelOpening);
  connect(&document_, &Document::opening, this, &StatusFields::showProgress);
  connect(&document_, &Document::opened, this, &StatusFields::endProgress);
  connect(&document_, &Document::openingCancelled, this, &StatusFields::endProgress);
  connect(&document_, &Document::openFailed, this, &StatusFields::endProgress);
  connect(&document_, &Document::seriesChoiceNeeded, this, &StatusFields::endProgress);
  connect(&document_, &Document::fileNeeded, this, &StatusFields::endProgress);
  for (auto changed : {&Document::stateChanged, &Document::snapshotChanged, &Document::summariesChanged,
                       &Document::seedsChanged, &Document::opened})
    connect(&document_, changed, this, &StatusFields::showState);
  endProgress();
}

void StatusFields::showCursor(const Vec3& world, const Vec3& index, double intensity) {
  position_->setText(place(world, document_.volume().grid));
  QStringList voxel;
  for (int axis = 0; axis < 3; ++axis) voxel << QString::number(std::lround(index[axis]));
  voxel_->setText(tr("Voxel %1").arg(voxel.join(QStringLiteral(", "))));
  intensity_->setText(tr("Intensity %1").arg(fineNumber(intensity)));
}

void StatusFields::clearCursor() {
  for (QLabel* label : {position_, voxel_, intensity_}) label->clear();
}

void StatusFields::showState() {
  uncalibrated_->setVisible(document_.hasVolume() && !document_.info().calibrated);
  if (document_.isOpening()) return;
  say(document_.hasVolume() ? stateText(document_) : tr("Nothing is open"));
  const bool preparing = document_.state() == GrowthState::preparing;
  if (preparing) progress_->setRange(0, 0);  // how far it is, is not known
  progress_->setVisible(preparing);
}

void StatusFields::say(const QString& state) {
  state_->setText(state);
  state_->setToolTip(state);  // whole where the bar is too short for it
}

void StatusFields::showProgress(const QString& path, double progress) {
  say(tr("Reading %1…").arg(QFileInfo(path).fileName()));
  progress_->setRange(0, progress < 0 ? 0 : 100);
  progress_->setValue(static_cast<int>(100 * progress));
  progress_->show();
  cancel_->show();
}

void StatusFields::endProgress() {
  progress_->hide();
  cancel_->hide();
  showState();
}

}  // namespace handlebody::ui
