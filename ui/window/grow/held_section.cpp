#include "ui/window/grow/held_section.h"

#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/model/document.h"
#include "ui/view/view_state.h"
#include "ui/window/timeline/event_inspector.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kTableHeight = 130;  // pixels
enum Column { kWhat, kWhere };

template <typename T>
std::vector<T> without(std::vector<T> list, std::size_t index) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
  return list;
}

//! Without limits there is nothing left to allow, to hold or to ask about.
void clearUnlimited(TopologyLimits& limits) {
  if (!limits.components && !limits.genus) limits = {};
}

//! Balls that hold nothing of their own are left out of a stroke, so that there may be gaps in it.
bool isOneStroke(const Pin& a, const Pin& b) {
  constexpr double kNear = 2;  // radii
  return a.iteration == b.iteration && a.radius == b.radius &&
         (a.centre - b.centre).norm() <= kNear * a.radius;
}

}  // namespace

HeldSection::HeldSection(Document& document, ViewState& state, QWidget* parent)
    : QWidget(parent), document_(document), state_(state) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  none_ = value(tr("What is held back"), this);
  none_->setText(tr("Nothing is held back."));
  layout->addWidget(none_);
  table_ = listTable({tr("What"), tr("Where (mm LPS)")}, this);
  table_->setAccessibleName(tr("What is held back, each with its place"));
  table_->setFixedHeight(kTableHeight);
  table_->installEventFilter(this);
  layout->addWidget(table_);
  lift_ = new QPushButton(tr("Lift"), this);
  lift_->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard with the views
  layout->addWidget(lift_);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &HeldSection::showChosen);
  connect(table_, &QTableWidget::cellClicked, this, &HeldSection::showChosen);  // again, too
  connect(lift_, &QPushButton::clicked, this, &HeldSection::liftChosen);
  for (auto changed : {&Document::constraintsChanged, &Document::snapshotChanged, &Document::opened,
                       &Document::activeObjectChanged})
    connect(&document_, changed, this, &HeldSection::showRows);
  showRows();
}

bool HeldSection::eventFilter(QObject*, QEvent* event) {
  const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  const int key = isKey ? static_cast<QKeyEvent*>(event)->key() : 0;
  if (key != Qt::Key_Delete && key != Qt::Key_Backspace) return false;
  event->accept();  // no shortcut
  if (event->type() == QEvent::KeyPress) liftChosen();
  return true;
}

void HeldSection::addTopology(std::vector<Row>& rows) const {
  const Constraints& now = document_.constraints();
  const auto add = [&](const QString& text, const std::optional<Vec3>& place, const QString& undo,
                       Constraints after) {
    rows.push_back({text, place, tr("Lift"),
                    [this, after = std::move(after), undo] { document_.setConstraints(after, undo); }});
  };
  if (now.topology.components) {
    Constraints after = now;
    after.topology.components.reset();
    clearUnlimited(after.topology);
    add(tr("At most %1 components").arg(*now.topology.components), {}, tr("Lift the limit"), after);
  }
  if (now.topology.genus) {
    Constraints after = now;
    after.topology.genus.reset();
    clearUnlimited(after.topology);
    add(tr("Genus at most %1").arg(*now.topology.genus), {}, tr("Lift the limit"), after);
  }
  for (std::size_t i = 0; i < now.topology.allowed.size(); ++i) {
    Constraints after = now;
    after.topology.allowed = without(now.topology.allowed, i);
    add(tr("May break the limits"), now.topology.allowed[i], tr("Allow no more"), after);
  }
  for (std::size_t i = 0; i < now.topology.kept.size(); ++i) {
    Constraints after = now;
    after.topology.kept = without(now.topology.kept, i);
    add(tr("Held, as you decided"), now.topology.kept[i], tr("Decide again"), after);
  }
  for (std::size_t i = 0; i < now.vetoes.size(); ++i) {
    Constraints after = now;
    after.vetoes = without(now.vetoes, i);
    add(tr("Veto at iteration %1").arg(now.vetoes[i].iteration), now.vetoes[i].place, tr("Lift the veto"),
        after);
  }
}

//! The balls of a stroke are one row.
void HeldSection::addPins(std::vector<Row>& rows) const {
  const Constraints& now = document_.constraints();
  for (std::size_t begin = 0; begin < now.pins.size();) {
    std::size_t end = begin + 1;
    while (end < now.pins.size() && isOneStroke(now.pins[end - 1], now.pins[end])) ++end;
    Constraints after = now;
    after.pins.erase(after.pins.begin() + static_cast<std::ptrdiff_t>(begin),
                     after.pins.begin() + static_cast<std::ptrdiff_t>(end));
    const QString one = tr("Pin at iteration %1").arg(now.pins[begin].iteration);
    const auto balls = static_cast<int>(end - begin);
    rows.push_back({balls == 1 ? one : tr("%1, %2 balls").arg(one).arg(balls), now.pins[begin].centre,
                    tr("Lift"), [this, after] { document_.setConstraints(after, tr("Lift the pin")); }});
    begin = end;
  }
}

void HeldSection::addWalls(std::vector<Row>& rows) const {
  const Constraints& now = document_.constraints();
  for (std::size_t i = 0; i < now.walls.discs.size(); ++i) {
    Constraints after = now;
    after.walls.discs = without(now.walls.discs, i);
    const WallDisc& disc = now.walls.discs[i];
    rows.push_back({tr("Disc, radius %1").arg(millimetres(disc.radius)), disc.centre, tr("Lift"),
                    [this, after] { document_.setConstraints(after, tr("Lift the disc")); }});
  }
  if (now.walls.map) {
    Constraints after = now;
    after.walls.map.reset();
    rows.push_back({tr("Walls of %1").arg(QFileInfo(QString::fromStdString(now.walls.map->path)).fileName()),
                    {},
                    tr("Lift"),
                    [this, after] { document_.setConstraints(after, tr("Lift the map of walls")); }});
  }
}

//! What comes of them in the shown iteration.
void HeldSection::addHeld(std::vector<Row>& rows) const {
  const auto shown = document_.snapshot();
  if (!shown) return;
  const std::vector<HeldPlace> open = document_.openQuestions();
  for (const HeldPlace& held : shown->held) {
    const bool isOpen = std::find(open.begin(), open.end(), held) != open.end();
    QString text = (isOpen ? tr("To decide: %1") : tr("Held: %1")).arg(eventName(held.kind));
    if (held.size.part > 0) text += QStringLiteral(", ") + millilitres(held.size.part);
    if (held.size.tunnel > 0)
      text += QStringLiteral(", ") + tr("%1 around").arg(millimetres(held.size.tunnel));
    rows.push_back({text, held.place, tr("Let it happen"), [this, held] { document_.allow(held); }});
  }
}

std::vector<HeldSection::Row> HeldSection::rowsNow() const {
  std::vector<Row> rows;
  addTopology(rows);
  addPins(rows);
  addWalls(rows);
  addHeld(rows);
  return rows;
}

//! The table is filled anew only where it would look another way: a growth tells of every frame.
void HeldSection::showRows() {
  const auto isSame = [](const Row& a, const Row& b) { return a.text == b.text && a.place == b.place; };
  std::vector<Row> now = rowsNow();
  const bool same = std::equal(now.begin(), now.end(), rows_.begin(), rows_.end(), isSame);
  rows_ = std::move(now);
  if (!same) {
    const QSignalBlocker quiet(table_);
    table_->clearSelection();
    table_->setCurrentCell(-1, -1);
    table_->setRowCount(static_cast<int>(rows_.size()));
    for (int i = 0; i < table_->rowCount(); ++i) {
      const Row& row = rows_[i];
      table_->setItem(i, kWhat, listCell(row.text));
      table_->setItem(
          i, kWhere,
          listCell(row.place ? place(*row.place, document_.volume().grid).chopped(3) : QStringLiteral("–")));
    }
  }
  none_->setVisible(rows_.empty());
  table_->setVisible(!rows_.empty());
  lift_->setVisible(!rows_.empty());
  showButton();
}

const HeldSection::Row* HeldSection::chosen() const {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  return rows.isEmpty() ? nullptr : &rows_[rows.front().row()];
}

void HeldSection::showButton() {
  const Row* row = chosen();
  lift_->setEnabled(row);
  lift_->setText(row ? row->lifting : tr("Lift"));
  describe(lift_, lift_->text(), tr("From the shown iteration on the chosen one holds nothing back"));
}

void HeldSection::showChosen() {
  showButton();
  const Row* row = chosen();
  if (row && row->place) state_.setCrosshair(*row->place);
}

void HeldSection::liftChosen() {
  const Row* row = chosen();
  if (!row) return;
  const std::function<void()> lift = row->lift;  // the rows are others after it
  lift();
}

}  // namespace handlebody::ui
