#include "ui/window/objects/objects_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/model/document.h"
#include "ui/window/commands.h"
#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

enum Column { kName, kProgress, kVisible, kLocked, kColumns };
constexpr int kRowHeight = 26, kMaxRows = 6, kSwatch = 14;  // pixels, and rows

//! On the ground of the chosen row it has the colour of its text.
QIcon iconOfRow(const QString& name, bool isActive) {
  constexpr int kSharp = 48;  // pixels, on any screen
  return isActive ? QIcon(icon(name).pixmap(QSize(kSharp, kSharp), QIcon::Selected)) : icon(name);
}

void setText(QTableWidgetItem* item, const QString& text, const QString& tip) {
  if (item->text() != text) item->setText(text);
  if (item->toolTip() != tip) item->setToolTip(tip);
}

}  // namespace

QString progressText(const ObjectInfo& info) {
  if (info.state == GrowthState::preparing) return ObjectsPanel::tr("preparing");
  if (info.snapshot) return millilitres(info.snapshot->certificate.volume, 3);
  return info.seeded ? ObjectsPanel::tr("not grown") : ObjectsPanel::tr("no seed");
}

ObjectsPanel::ObjectsPanel(Document& document, const Commands& commands, QWidget* parent)
    : QWidget(parent), document_(document) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 4, 12, 4);
  layout->setSpacing(4);
  auto* bar = new QHBoxLayout;
  bar->setSpacing(0);
  QLabel* title = heading(tr("Objects"), this);
  title->setContentsMargins(0, 0, 0, 0);
  bar->addWidget(title, 1);
  for (Command id : {Command::addObject, Command::duplicateObject, Command::editObject, Command::moveObjectUp,
                     Command::moveObjectDown, Command::deleteObject}) {
    QToolButton* button = smallButton(commands[id], this);
    button->setAutoRaise(true);
    bar->addWidget(button);
  }
  layout->addLayout(bar);
  buildTable();
  layout->addWidget(table_);
  notice_ = notice(tr("What the active object is made with"), this);
  layout->addWidget(notice_);
  for (auto changed : {&Document::objectsChanged, &Document::activeObjectChanged, &Document::snapshotChanged,
                       &Document::stateChanged, &Document::seedsChanged, &Document::opened})
    connect(&document_, changed, this, &ObjectsPanel::showAll);
  connect(table_, &QTableWidget::cellDoubleClicked, this,
          [edit = commands[Command::editObject]] { edit->trigger(); });
  showAll();
}

void ObjectsPanel::buildTable() {
  table_ = new QTableWidget(0, kColumns, this);
  table_->setAccessibleName(tr("Objects"));
  table_->horizontalHeader()->hide();
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setMinimumSectionSize(kRowHeight);
  table_->horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(kProgress, QHeaderView::ResizeToContents);
  for (int column : {kVisible, kLocked}) {
    table_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::Fixed);
    table_->setColumnWidth(column, kRowHeight);
  }
  table_->verticalHeader()->setDefaultSectionSize(kRowHeight);
  table_->setShowGrid(false);
  table_->setIconSize(QSize(kSwatch, kSwatch));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (row >= 0) document_.setActiveObject(row);
  });
}

//! In the row without choosing it: what is hidden or locked need not be the active one.
QToolButton* ObjectsPanel::cellButton(int row, int column, const std::function<void(int)>& change) {
  auto* button = new QToolButton(table_);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::NoFocus);  // keys: the menu's
  button->setIconSize(QSize(16, 16));
  connect(button, &QToolButton::clicked, this, [row, change] { change(row); });
  table_->setCellWidget(row, column, button);
  return button;
}

void ObjectsPanel::addRow() {
  const int row = table_->rowCount();
  table_->setRowCount(row + 1);
  table_->setItem(row, kName, new QTableWidgetItem);
  table_->setItem(row, kProgress, new QTableWidgetItem);
  table_->item(row, kProgress)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  const auto visible = [this](int r) { document_.setObjectVisible(r, !document_.objectInfo(r).visible); };
  const auto locked = [this](int r) { document_.setObjectLocked(r, !document_.objectInfo(r).locked); };
  rows_.push_back({cellButton(row, kVisible, visible), cellButton(row, kLocked, locked)});
}

void ObjectsPanel::showRow(int row, const ObjectInfo& info) {
  const QString name = QString::fromStdString(info.label.name);
  QTableWidgetItem* item = table_->item(row, kName);
  setText(item, name, tr("%1, label value %2").arg(name, QString::number(info.label.value)).toHtmlEscaped());
  const QVariant colour = QColor(info.label.colour[0], info.label.colour[1], info.label.colour[2]);
  if (item->data(Qt::UserRole) != colour) {
    item->setData(Qt::UserRole, colour);
    item->setIcon(swatch(info.label.colour));
  }
  const bool isOld = !info.madeWithEarlier.isEmpty();
  setText(table_->item(row, kProgress), progressText(info),
          isOld ? tr("Made with an earlier “%1”").arg(info.madeWithEarlier).toHtmlEscaped() : QString());
  table_->item(row, kProgress)->setIcon(isOld ? icon(QStringLiteral("warning")) : QIcon());
  const auto [visible, locked] = rows_[row];
  const bool isActive = row == document_.activeObject();
  visible->setIcon(iconOfRow(info.visible ? QStringLiteral("visible") : QStringLiteral("hidden"), isActive));
  describe(visible, info.visible ? tr("Hide %1").arg(name) : tr("Show %1").arg(name),
           info.visible ? tr("Its surface is drawn: hide it") : tr("Its surface is hidden: show it"));
  locked->setIcon(iconOfRow(info.locked ? QStringLiteral("locked") : QStringLiteral("unlocked"), isActive));
  describe(locked, info.locked ? tr("Unlock %1").arg(name) : tr("Lock %1").arg(name),
           info.locked ? tr("Nothing of it is changed: unlock it") : tr("Let nothing of it be changed"));
}

void ObjectsPanel::showAll() {
  const QSignalBlocker quiet(table_);
  const int count = document_.objectCount();
  setVisible(count > 1);
  if (count < 2) return;
  if (table_->rowCount() > count) {
    table_->setRowCount(count);
    rows_.resize(count);
  }
  while (table_->rowCount() < count) addRow();
  for (int i = 0; i < count; ++i) showRow(i, document_.objectInfo(i));
  constexpr int kFrame = 2;
  table_->setFixedHeight(std::min(count, kMaxRows) * kRowHeight + kFrame);
  if (table_->currentRow() != document_.activeObject()) table_->selectRow(document_.activeObject());
  showNotice();
}

void ObjectsPanel::showNotice() {
  const QString awaited = document_.waitsFor();
  const QString earlier = document_.objectInfo(document_.activeObject()).madeWithEarlier;
  QString text;
  if (!awaited.isEmpty())
    text = tr("Waits for “%1”, which comes before it and grows.").arg(awaited);
  else if (!earlier.isEmpty())
    text = tr("Made with an earlier “%1”. Start grows it anew.").arg(earlier);
  notice_->setText(text);
  notice_->setVisible(!text.isEmpty());
}

}  // namespace handlebody::ui
