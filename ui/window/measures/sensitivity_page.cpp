#include "ui/window/measures/sensitivity_page.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

#include "core/io/report/sensitivity_table.h"
#include "ui/model/document.h"
#include "ui/model/finding_text.h"
#include "ui/view/distance_colours.h"
#include "ui/view/view_state.h"
#include "ui/window/measures/measure_texts.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kSensingTools = 330;  // pixels
constexpr int kMinRuns = 2, kUsual = 8, kMaxRuns = 1000;

const QString kNotGrown = QStringLiteral("–");

}  // namespace

SensitivityPage::SensitivityPage(Document& document, ViewState& state, QWidget* parent)
    : QWidget(parent), document_(document), state_(state) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(buildTools());
  table_ = listTable({tr("Run"), tr("Volume (ml)"), tr("Components"), tr("Tunnels"), tr("Away (mm)")}, this);
  table_->setAccessibleName(tr("The perturbed runs"));
  layout->addWidget(table_, 1);
  connect(start_, &QPushButton::clicked, this, &SensitivityPage::startOrCancel);
  connect(colours_, &QCheckBox::toggled, this, &SensitivityPage::colour);
  connect(csv_, &QPushButton::clicked, this, [this] {
    Q_EMIT saveRequested(tr("Save the perturbed runs"), QStringLiteral(".csv"),
                         sensitivityCsv(*answer_.found));
  });
  connect(&document_, &Document::opened, this, &SensitivityPage::forget);
  for (auto changed : {&Document::snapshotChanged, &Document::objectsChanged, &Document::stateChanged,
                       &Document::constraintsChanged, &Document::activeObjectChanged})
    connect(&document_, changed, this, &SensitivityPage::showState);
  showState();
}

QWidget* SensitivityPage::buildTools() {
  auto* tools = new QWidget(this);
  tools->setFixedWidth(kSensingTools);
  auto* grid = new QGridLayout(tools);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  start_ = new QPushButton(tools);
  start_->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard with the views
  describe(start_, tr("Sensitivity"),
           tr("Grow the surface several times again, with clicks, smoothing and noise a little different: "
              "how much "
              "do volume and surface change?"));
  runs_ = new QSpinBox(tools);
  runs_->setRange(kMinRuns, kMaxRuns);
  runs_->setValue(kUsual);
  runs_->setSuffix(tr(" runs"));
  describe(runs_, tr("Number of runs"),
           tr("How often it is grown again; each takes about as long as the growth"));
  ignoreWheelWithoutFocus(runs_);
  volume_ = value(tr("Volume with its spread"), tools);
  QFont large = volume_->font();
  large.setPointSizeF(1.25 * large.pointSizeF());
  large.setBold(true);
  volume_->setFont(large);
  note_ = value(tr("State of the sensitivity"), tools);
  colours_ = new QCheckBox(tr("How far it moves, in colour on the surface"), tools);
  colours_->setFocusPolicy(Qt::TabFocus);
  colours_->setChecked(true);
  describe(colours_, colours_->text(),
           tr("White where the surface is certain, red where it moves from run to run"));
  progress_ = new QProgressBar(tools);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(12);
  progress_->setAccessibleName(tr("How many runs have ended"));
  csv_ = new QPushButton(tr("Save as CSV…"), tools);
  csv_->setFocusPolicy(Qt::TabFocus);
  describe(csv_, tr("Save the runs as CSV"), tr("Volume, topology and distance of every run"));
  grid->addWidget(start_, 0, 0);
  grid->addWidget(runs_, 0, 1);
  grid->addWidget(progress_, 1, 0, 1, 2);
  grid->addWidget(volume_, 2, 0, 1, 2);
  grid->addWidget(note_, 3, 0, 1, 2);
  grid->addWidget(colours_, 4, 0, 1, 2);
  grid->setRowStretch(5, 1);
  grid->addWidget(csv_, 6, 0);
  return tools;
}

void SensitivityPage::startOrCancel() {
  if (!isAsking_) return start();
  sensor_.cancel();
  isAsking_ = false;
  showState();
}

void SensitivityPage::start() {
  if (isAsking_ || !sensitivityFault(document_).isEmpty()) return;
  answer_ = {};
  colour();
  showTable();
  asked_ = document_.snapshot();
  isAsking_ = true;
  progress_->setRange(0, runs_->value());
  progress_->setValue(0);
  const int number = ++number_;
  sensor_.ask(
      sensitivityQuestion(document_, runs_->value()),
      [this, number](int ended) {
        QMetaObject::invokeMethod(
            this,
            [this, number, ended] {
              if (number == number_) progress_->setValue(ended);
            },
            Qt::QueuedConnection);
      },
      [this, number](SensitivityAnswer answer) {
        QMetaObject::invokeMethod(
            this,
            [this, number, answer = std::make_shared<SensitivityAnswer>(std::move(answer))] {
              if (number == number_ && isAsking_) showAnswer(std::move(*answer));
            },
            Qt::QueuedConnection);
      });
  showState();
}

void SensitivityPage::showAnswer(SensitivityAnswer answer) {
  isAsking_ = false;
  answer_ = std::move(answer);
  showTable();
  colour();
  showState();
}

void SensitivityPage::forget() {
  sensor_.cancel();
  isAsking_ = false;
  answer_ = {};
  colour();
  asked_.reset();
  showTable();
  showState();
}

void SensitivityPage::colour() {
  const bool any = colours_->isChecked() && asked_ && answer_.found && answer_.found->grown > 0 &&
                   answer_.found->spread.size() == asked_->mesh.points.size();
  if (!any) return state_.setDistances(DistancesOf::sensitivity, nullptr);
  DistanceColours colours = distanceColours(asked_, answer_.found->spread, false);
  colours.title = tr("moves by");
  state_.setDistances(DistancesOf::sensitivity, std::make_shared<const DistanceColours>(std::move(colours)));
}

void SensitivityPage::showTable() {
  table_->setRowCount(0);
  if (!answer_.found) return;
  int counted = 0;
  for (const PerturbedRun& run : answer_.found->runs) {
    const int at = table_->rowCount();
    table_->insertRow(at);
    const bool grew = run.failure.empty();
    const QStringList cells{
        grew ? QString::number(++counted) : tr("%1: %2").arg(QString::number(++counted), failureText(run)),
        grew ? fineNumber(run.volume / 1000) : kNotGrown, grew ? QString::number(run.components) : kNotGrown,
        grew ? QString::number(run.genus) : kNotGrown, grew ? fineNumber(run.distance) : kNotGrown};
    for (int c = 0; c < cells.size(); ++c) {
      table_->setItem(at, c, listCell(cells[c]));
      if (c > 0) table_->item(at, c)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
  }
}

void SensitivityPage::showState() {
  const QString fault = sensitivityFault(document_);
  start_->setEnabled(isAsking_ || fault.isEmpty());
  start_->setText(isAsking_ ? tr("Cancel") : tr("Sensitivity"));
  start_->setAccessibleName(start_->text());
  runs_->setEnabled(!isAsking_);
  progress_->setVisible(isAsking_);
  csv_->setEnabled(answer_.found.has_value());
  QString text, volume;
  if (answer_.found && answer_.found->grown > 0) {
    const Sensitivity& s = *answer_.found;
    volume = tr("%1 ± %2 ml").arg(fineNumber(s.mean / 1000), fineNumber(s.deviation / 1000, 2));
    text = tr("%1 to %2 in %3 of %4 runs, %5 of the same topology. The surface moves by %6, 95 % of it by "
              "less than "
              "%7.")
               .arg(millilitres(s.least), millilitres(s.most), QString::number(s.grown),
                    QString::number(s.runs.size()), QString::number(s.sameTopology),
                    millimetres(s.meanSpread), millimetres(s.spread95));
    for (const Finding& warning : sensitivityWarnings(s)) text += tr(" ⚠ %1.").arg(findingText(warning));
  } else if (answer_.found) {
    text = tr("None of the runs left a surface.");
  }
  if (isAsking_)
    text = tr("Growing it again…");
  else if (!answer_.error.isEmpty())
    text = answer_.error;
  else if (answer_.found && asked_ != document_.snapshot())
    text = tr("These are figures of an earlier surface, or of another object.");
  else if (!answer_.found)
    text = fault;
  volume_->setText(volume);
  volume_->setVisible(!volume.isEmpty() && !isAsking_);
  note_->setText(text);
  note_->setVisible(!text.isEmpty());
}

}  // namespace handlebody::ui
