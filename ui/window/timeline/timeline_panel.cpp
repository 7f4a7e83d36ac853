#include "ui/window/timeline/timeline_panel.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/model/document.h"
#include "ui/window/timeline/event_table.h"
#include "ui/window/timeline/timeline_plot.h"
#include "ui/window/timeline/timeline_slider.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

TimelinePanel::TimelinePanel(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 6);
  auto* split = new QSplitter(Qt::Horizontal, this);
  split->setChildrenCollapsible(false);
  split->addWidget(buildTime());
  split->addWidget(buildTable());
  split->setStretchFactor(0, 1);
  split->setStretchFactor(1, 0);
  layout->addWidget(split);
  for (auto changed : {&Document::snapshotChanged, &Document::summariesChanged, &Document::stateChanged})
    connect(&document_, changed, this, &TimelinePanel::showIterations);
  showIterations();
}

QWidget* TimelinePanel::buildTime() {
  auto* part = new QWidget(this);
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* plot = new TimelinePlot(document_, part);
  slider_ = new TimelineSlider(part);
  layout->addWidget(plot, 1);
  layout->addWidget(slider_);
  connect(plot, &TimelinePlot::iterationChosen, slider_, &QSlider::setValue);
  connect(slider_, &QSlider::valueChanged, this, [this](int iteration) { document_.goTo(iteration); });
  return part;
}

QWidget* TimelinePanel::buildTable() {
  auto* part = new QWidget(this);
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  events_ = new EventTable(document_, this);
  table_ = new QTableView(part);
  table_->setModel(events_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setTabKeyNavigation(false);
  table_->setShowGrid(false);
  table_->setAlternatingRowColors(true);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 8);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
  table_->setAccessibleName(tr("Events"));
  part->setMinimumWidth(430);  // the same with and without events: nothing jumps when the first comes
  empty_ = hint(tr("Changes of topology are listed here."), part);
  empty_->setAlignment(Qt::AlignCenter);
  layout->addWidget(table_, 1);
  layout->addWidget(empty_, 1);
  repairs_ = new QCheckBox(tr("Show repairs of the mesh, too"), part);
  repairs_->setFocusPolicy(Qt::TabFocus);
  repairs_->setToolTip(
      tr("<p>Folds that were smoothed away, and parts of the surface whose step would have left an invalid "
         "mesh and that returned to where they were. The topology is the same before and after.</p>"));
  QSizePolicy kept = repairs_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  repairs_->setSizePolicy(kept);
  layout->addWidget(repairs_);
  const auto fit = [table = table_] { table->resizeColumnsToContents(); };
  connect(events_, &EventTable::rowsInserted, table_, fit);
  connect(events_, &EventTable::modelReset, table_, fit);
  connect(repairs_, &QCheckBox::toggled, events_, &EventTable::showRepairs);
  connect(repairs_, &QCheckBox::toggled, this, &TimelinePanel::showIterations);
  const auto choose = [this](const QModelIndex& row) { Q_EMIT eventChosen(events_->eventOf(row.row())); };
  connect(table_, &QTableView::clicked, this, choose);
  connect(table_, &QTableView::activated, this, choose);
  return part;
}

void TimelinePanel::setEvent(int index) {
  const int row = events_->rowOf(index);
  if (row < 0)
    table_->clearSelection();
  else
    table_->selectRow(row);
}

void TimelinePanel::showIterations() {
  const QSignalBlocker quiet(slider_);
  slider_->setEnabled(document_.lastIteration() > 0);
  slider_->setRange(0, std::max(0, document_.lastIteration()));
  slider_->setValue(std::max(0, document_.iteration()));
  std::vector<int> marks, rollBacks;
  for (const IterationSummary& s : document_.summaries()) {
    if (s.events > 0) marks.push_back(s.iteration);
    if (s.rollBacks > 0) rollBacks.push_back(s.iteration);
  }
  slider_->setMarks(std::move(marks), std::move(rollBacks));
  const bool any = events_->rowCount() > 0;
  table_->setVisible(any);
  empty_->setVisible(!any);
  repairs_->setVisible(!document_.events().empty());
}

}  // namespace handlebody::ui
