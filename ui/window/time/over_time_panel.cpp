#include "ui/window/time/over_time_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTableWidget>
#include <QToolButton>
#include <algorithm>

#include "core/io/report/over_time_report.h"
#include "ui/model/document.h"
#include "ui/model/finding_text.h"
#include "ui/model/time_series.h"
#include "ui/view/view_state.h"
#include "ui/window/commands.h"
#include "ui/window/time/frame_slider.h"
#include "ui/window/time/volume_plot.h"
#include "ui/window/widgets/action_button.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kTimeTools = 320, kTable = 290;  // pixels
const QString kNoValue = QStringLiteral("–");

QString stateOf(const TimeSeries& time, int frame) {
  const FrameResult* result = time.resultOf(frame);
  if (frame == time.grownFrame() && (!result || result->faults.empty())) return OverTimePanel::tr("grown");
  if (!result) return {};
  QString text;
  for (const ToldFault& f : result->faults)
    text += (text.isEmpty() ? QString() : QStringLiteral("; ")) + findingText(f.finding);
  if (text.isEmpty() && result->isCorrected)
    return OverTimePanel::tr("corrected, from frame %1").arg(result->from.value_or(0));
  if (text.isEmpty()) return OverTimePanel::tr("carried from frame %1").arg(result->from.value_or(0));
  return (result->isTrusted() ? OverTimePanel::tr("⚠ %1") : OverTimePanel::tr("✗ %1")).arg(text);
}

QString volumeOf(const TimeSeries& time, int frame) {
  const FrameResult* result = time.resultOf(frame);
  return result && result->volume > 0 ? fineNumber(result->volume / 1000) : kNoValue;
}

}  // namespace

OverTimePanel::OverTimePanel(Document& document, const Commands& commands, QWidget* parent)
    : QWidget(parent),
      document_(document),
      firstGesture_(ViewState::nextGesture()),
      lastGesture_(ViewState::nextGesture()) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 6, 6, 6);
  row->addWidget(buildTools(commands));
  plot_ = new VolumePlot(document_, this);
  row->addWidget(plot_, 1);
  table_ = listTable({tr("Frame"), tr("ms"), tr("ml"), tr("State")}, this);
  table_->setAccessibleName(tr("What has become of each frame"));
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(3, QHeaderView::Stretch);
  table_->setFixedWidth(kTable);
  row->addWidget(table_);
  connect(table_, &QTableWidget::cellClicked, this, [this](int index) { document_.time().show(index); });
  connect(table_, &QTableWidget::cellActivated, this, [this](int index) { document_.time().show(index); });
  TimeSeries& time = document_.time();
  connect(&time, &TimeSeries::requestChanged, this, &OverTimePanel::showRequest);
  for (auto changed : {&TimeSeries::carriedChanged, &TimeSeries::carryingChanged, &TimeSeries::shownChanged})
    connect(&time, changed, this, &OverTimePanel::showFrames);
  connect(&document_, &Document::opened, this, [this] {
    showRequest();
    showFrames();
  });
  for (auto changed : {&Document::stateChanged, &Document::snapshotChanged, &Document::objectsChanged})
    connect(&document_, changed, this, &OverTimePanel::showState);
  showRequest();
  showFrames();
}

QWidget* OverTimePanel::buildTools(const Commands& commands) {
  auto* tools = new QWidget(this);
  auto* grid = new QGridLayout(tools);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  grid->addWidget(new ActionButton(commands[Command::carryOverTime], tools), 0, 0, 1, 2);
  grid->addWidget(new ActionButton(commands[Command::growHere], tools), 0, 2, 1, 2);
  addOptions(*grid, tools);
  correct_ = new ActionButton(commands[Command::correctFrame], tools);
  grid->addWidget(correct_, 3, 0, 1, 4);
  ends_ = new QWidget(tools);  // in its place while a frame is corrected
  auto* row = new QHBoxLayout(ends_);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new ActionButton(commands[Command::endCorrection], ends_), 1);
  row->addWidget(smallButton(commands[Command::leaveCorrection], ends_));
  grid->addWidget(ends_, 3, 0, 1, 4);
  progress_ = new QProgressBar(tools);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(12);
  progress_->setAccessibleName(tr("How far the surface is carried"));
  grid->addWidget(progress_, 4, 0, 1, 4);
  note_ = value(tr("State of what is carried"), tools);
  grid->addWidget(note_, 5, 0, 1, 4);
  figures_ = value(tr("Figures over time"), tools);
  grid->addWidget(figures_, 6, 0, 1, 4);
  grid->setRowStretch(7, 1);
  addSaving(*grid, tools, commands);
  tools->setFixedWidth(std::max(kTimeTools, grid->minimumSize().width()));
  return tools;
}

void OverTimePanel::addOptions(QGridLayout& grid, QWidget* tools) {
  topology_ = new QComboBox(tools);
  topology_->addItem(tr("held"), true);
  topology_->addItem(tr("free"), false);
  describe(topology_, tr("Topology over time"),
           tr("Held: no frame has other components or tunnels than the first surface. Free: it may change."));
  check_ = new QComboBox(tools);
  check_->addItem(tr("back"), static_cast<int>(DriftCheck::back));
  check_->addItem(tr("round the cycle"), static_cast<int>(DriftCheck::wrap));
  check_->addItem(tr("none"), static_cast<int>(DriftCheck::none));
  describe(check_, tr("Check of the way"),
           tr("Back: carried back from the ends, to see how far it is off. Round the cycle: from the last "
              "frame to "
              "the first, which lie beside each other."));
  first_ = new QSpinBox(tools);
  last_ = new QSpinBox(tools);
  describe(first_, tr("First frame"), tr("The surface is carried from here …"));
  describe(last_, tr("Last frame"), tr("… to here"));
  for (QWidget* field : std::initializer_list<QWidget*>{topology_, check_, first_, last_})
    ignoreWheelWithoutFocus(field);
  grid.addWidget(new QLabel(tr("Topology"), tools), 1, 0);
  grid.addWidget(topology_, 1, 1);
  grid.addWidget(new QLabel(tr("Check"), tools), 1, 2);
  grid.addWidget(check_, 1, 3);
  grid.addWidget(new QLabel(tr("Frames"), tools), 2, 0);
  grid.addWidget(first_, 2, 1);
  grid.addWidget(new QLabel(tr("to"), tools), 2, 2);
  grid.addWidget(last_, 2, 3);
  connect(topology_, &QComboBox::activated, this, [this] { ask(tr("Topology over time"), -1); });
  connect(check_, &QComboBox::activated, this, [this] { ask(tr("Check over time"), -1); });
  connect(first_, &QSpinBox::valueChanged, this, [this] { ask(tr("First frame"), firstGesture_); });
  connect(last_, &QSpinBox::valueChanged, this, [this] { ask(tr("Last frame"), lastGesture_); });
}

void OverTimePanel::addSaving(QGridLayout& grid, QWidget* tools, const Commands& commands) {
  csv_ = new QPushButton(tr("CSV…"), tools);
  svg_ = new QPushButton(tr("Plot…"), tools);
  describe(csv_, tr("Save the curve as CSV"),
           tr("The same table as “handlebody-cli segment --curve F.csv” writes"));
  describe(svg_, tr("Save the curve as a plot"),
           tr("The same picture (SVG) as “handlebody-cli segment --curve F.svg” writes"));
  for (QPushButton* button : {csv_, svg_}) button->setFocusPolicy(Qt::TabFocus);
  auto* meshes = new ActionButton(commands[Command::exportFrameMeshes], tools);
  meshes->setOwnText(tr("Meshes…"));
  auto* labels = new ActionButton(commands[Command::exportFrameLabels], tools);
  labels->setOwnText(tr("Labels…"));
  grid.addWidget(csv_, 8, 0);
  grid.addWidget(svg_, 8, 1);
  grid.addWidget(meshes, 8, 2);
  grid.addWidget(labels, 8, 3);
  connect(csv_, &QPushButton::clicked, this, [this] {
    Q_EMIT saveRequested(tr("Save the volume over time"), QStringLiteral("curve"), QStringLiteral(".csv"),
                         curveCsv(told()));
  });
  connect(svg_, &QPushButton::clicked, this, [this] {
    Q_EMIT saveRequested(tr("Save the volume over time"), QStringLiteral("curve"), QStringLiteral(".svg"),
                         curveSvg(told()));
  });
}

//! What is saved.
OverTimeReport OverTimePanel::told() const {
  OverTimeReport report = document_.time().report();
  return isAnonymous_ ? anonymous(std::move(report)) : report;
}

void OverTimePanel::ask(const QString& undoText, int gesture) {
  const TimeSeries& time = document_.time();
  OverTimeRequest request = time.request();
  request.holdTopology = topology_->currentData().toBool();
  request.drift = static_cast<DriftCheck>(check_->currentData().toInt());
  request.frames = OverTimeRequest::Range{first_->value(), last_->value()};
  if (first_->value() == 0 && last_->value() == time.frameCount() - 1) request.frames.reset();
  document_.setOverTime(request, undoText, gesture);
}

void OverTimePanel::showRequest() {
  const TimeSeries& time = document_.time();
  const QSignalBlocker one(topology_), two(check_), three(first_), four(last_);
  topology_->setCurrentIndex(topology_->findData(time.request().holdTopology));
  check_->setCurrentIndex(check_->findData(static_cast<int>(time.request().drift)));
  const OverTimeRequest::Range range = time.range();
  first_->setRange(0, time.grownFrame());
  last_->setRange(time.grownFrame(), std::max(0, time.frameCount() - 1));
  first_->setValue(range.first);
  last_->setValue(range.last);
}

void OverTimePanel::showFrames() {
  const TimeSeries& time = document_.time();
  const int frames = time.hasTime() ? time.frameCount() : 0;
  table_->setRowCount(frames);
  for (int f = 0; f < frames; ++f) {
    const auto when = time.timeOf(f);
    const QStringList cells{QString::number(f), when ? number(*when) : kNoValue, volumeOf(time, f),
                            stateOf(time, f)};
    for (int c = 0; c < cells.size(); ++c) {
      if (table_->item(f, c) && table_->item(f, c)->text() == cells[c]) continue;
      table_->setItem(f, c, listCell(cells[c]));
      if (c < 3) table_->item(f, c)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
  }
  if (frames > 0) {
    table_->selectRow(time.shownFrame());
    table_->scrollToItem(table_->item(time.shownFrame(), 0));
  }
  showRequest();
  showState();
}

QString OverTimePanel::figures() const {
  const TimeSeries& time = document_.time();
  const VolumeCurve c = time.curve();
  if (!c.endDiastole) return {};
  const VolumePoint &d = c.points[*c.endDiastole], &s = c.points[*c.endSystole];
  QString text =
      tr("End-diastole %1 (frame %2), end-systole %3 (frame %4), stroke volume %5, "
         "<b>ejection fraction %6 %</b>.")
          .arg(millilitres(*d.volume), QString::number(d.frame), millilitres(*s.volume),
               QString::number(s.frame), millilitres(c.strokeVolume), number(100 * c.ejectionFraction, 3));
  for (const Drift& drift : time.drifts())
    text += QStringLiteral("<br>") +
            (drift.isBack ? tr("From frame %1 back at frame %2: Dice %3, %4 off.")
                                .arg(QString::number(drift.from), QString::number(drift.at),
                                     number(drift.dice, 4), millimetres(drift.mean))
                          : tr("The surface was lost on its way from frame %1 back to frame %2.")
                                .arg(drift.from)
                                .arg(drift.at));
  return text;
}

void OverTimePanel::showState() {
  const TimeSeries& time = document_.time();
  const bool any = time.carriedFrom() != nullptr;
  const bool isOfThis = any && document_.isCarriedCurrent();
  correct_->setVisible(!document_.correctedFrame());
  ends_->setVisible(document_.correctedFrame().has_value());
  progress_->setVisible(time.isCarrying());
  progress_->setValue(static_cast<int>(1000 * time.progress()));
  figures_->setText(figures());
  figures_->setVisible(any);
  figures_->setEnabled(isOfThis);
  const QString fault = document_.framesFault();
  for (QPushButton* button : {csv_, svg_}) button->setEnabled(fault.isEmpty());
  QString text;
  if (document_.correctedFrame())
    text =
        tr("Frame %1 is being corrected: change it with clicks, walls and edits, then carry on from there.")
            .arg(*document_.correctedFrame());
  else if (time.isCarrying())
    text = tr("Carrying the surface through the frames…");
  else if (!time.carryError().isEmpty())
    text = time.carryError();
  else if (any && !isOfThis)
    text = tr("These are of an earlier surface of frame %1: carry it anew.").arg(time.grownFrame());
  else if (any)
    text = fault;
  else
    text = document_.carryFault();
  note_->setText(text);
  note_->setVisible(!text.isEmpty());
}

}  // namespace handlebody::ui
