#include "ui/window/measures/rulers_page.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "core/io/report/measured.h"
#include "ui/model/document.h"
#include "ui/model/measurements.h"
#include "ui/view/length_decimals.h"
#include "ui/view/view_state.h"
#include "ui/window/commands.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"
#include "ui/window/widgets/toggle_button.h"

namespace handlebody::ui {

namespace {
constexpr int kRulerTools = 250;  // pixels
}

RulersPage::RulersPage(Document& document, ViewState& state, const Commands& commands, QWidget* parent)
    : QWidget(parent), document_(document), state_(state) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  auto* tools = new QWidget(this);
  tools->setFixedWidth(kRulerTools);
  auto* column = new QVBoxLayout(tools);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  row->setSpacing(2);
  for (Command id : {Command::ruler, Command::angle}) row->addWidget(toggleFor(commands[id], tools));
  column->addLayout(row);
  hint_ = hint(QString(), tools);
  column->addWidget(hint_);
  column->addStretch(1);
  column->addLayout(buildButtons(tools));
  layout->addWidget(tools);
  table_ = listTable({tr("What"), tr("Value"), tr("Begins at (LPS)")}, this);
  table_->setAccessibleName(tr("Rulers and angles"));
  table_->installEventFilter(this);
  layout->addWidget(table_, 1);
  Measurements& list = document_.measurements();
  connect(delete_, &QPushButton::clicked, this, [&list] { list.remove(list.selected()); });
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this, &list] { list.select(table_->currentRow()); });
  connect(table_, &QTableWidget::cellClicked, this, &RulersPage::goToChosen);
  connect(&list, &Measurements::changed, this, &RulersPage::showRows);
  connect(&state_.measure(), &MeasureTool::changed, this, &RulersPage::showHint);
  connect(&document_, &Document::opened, this, &RulersPage::showHint);
  showRows();
  showHint();
}

QLayout* RulersPage::buildButtons(QWidget* parent) {
  const auto add = [parent](const QString& text, const QString& tip) {
    auto* button = new QPushButton(text, parent);
    button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard with the views
    describe(button, text, tip);
    return button;
  };
  delete_ = add(tr("Delete"), tr("Delete the chosen ruler or angle"));
  csv_ =
      add(tr("Save as CSV…"), tr("Lengths in mm, angles in degrees and their points (mm, LPS) as a table"));
  json_ = add(tr("Save as JSON…"), tr("The same as “handlebody-cli measure --json” writes of them"));
  connect(csv_, &QPushButton::clicked, this, [this] {
    Q_EMIT saveRequested(tr("Save the rulers and angles"), QStringLiteral(".csv"),
                         measurementsCsv(document_.measurements().all()));
  });
  connect(json_, &QPushButton::clicked, this, [this] {
    Q_EMIT saveRequested(tr("Save the rulers and angles"), QStringLiteral(".json"),
                         measurementsJson(document_.measurements().all()));
  });
  auto* rows = new QVBoxLayout;
  rows->setSpacing(4);
  rows->addWidget(delete_);
  auto* row = new QHBoxLayout;
  for (QPushButton* button : {csv_, json_}) row->addWidget(button);
  rows->addLayout(row);
  return rows;
}

bool RulersPage::eventFilter(QObject*, QEvent* event) {
  const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  const int key = isKey ? static_cast<QKeyEvent*>(event)->key() : 0;
  if (key != Qt::Key_Delete && key != Qt::Key_Backspace) return false;
  event->accept();  // no shortcut
  if (event->type() == QEvent::KeyPress) document_.measurements().remove(document_.measurements().selected());
  return true;
}

void RulersPage::showRows() {
  const QSignalBlocker quiet(table_);
  const Measurements& list = document_.measurements();
  const int count = static_cast<int>(list.all().size());
  table_->setRowCount(count);
  for (int i = 0; i < count; ++i) {
    const Measurement& m = list.all()[i];
    table_->setItem(i, 0, listCell(list.nameOf(i)));
    const Grid& grid = document_.volume().grid;
    table_->setItem(i, 1, listCell(measuredValue(m, lengthDecimals(grid))));
    table_->item(i, 1)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table_->setItem(i, 2, listCell(place(m.points.front(), grid)));
  }
  if (list.selected() >= 0)
    table_->selectRow(list.selected());
  else
    table_->clearSelection();
  delete_->setEnabled(list.selected() >= 0);
  for (QPushButton* button : {csv_, json_}) button->setEnabled(count > 0);
}

//! What a click does now.
void RulersPage::showHint() {
  const MeasureTool& tool = state_.measure();
  const auto placed = tool.placed().size();
  QString text = tr("Places points in the slices or on the surface in 3D. Their ends can be dragged.");
  if (tool.mode() == MeasureTool::Mode::ruler)
    text = placed == 0 ? tr("Click where the ruler begins, or press Return for the crosshair.")
                       : tr("Click where it ends. Escape takes the beginning back.");
  if (tool.mode() == MeasureTool::Mode::angle)
    text = placed == 0   ? tr("Click the end of one leg, or press Return for the crosshair.")
           : placed == 1 ? tr("Click where the legs meet. Escape takes the last point back.")
                         : tr("Click the end of the other leg. Escape takes the last point back.");
  hint_->setText(text);
}

void RulersPage::goToChosen() {
  const int row = table_->currentRow();
  if (row < 0) return;
  const auto& points = document_.measurements().all().at(static_cast<std::size_t>(row)).points;
  // Both ends of a ruler are seen from its middle if they lie in one slice; an angle is at its vertex.
  state_.setCrosshair(points.size() == 2 ? Vec3((points[0] + points[1]) / 2) : points[1]);
}

}  // namespace handlebody::ui
