#include "ui/window/timeline/event_table.h"

#include <algorithm>

#include "ui/model/document.h"
#include "ui/window/timeline/event_inspector.h"
#include "ui/window/widgets/numbers.h"

namespace handlebody::ui {

namespace {
enum Column { kIteration, kKind, kPlace, kGenus, kComponents, kColumns };
}

EventTable::EventTable(Document& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
  for (auto changed : {&Document::summariesChanged, &Document::stateChanged})
    connect(&document_, changed, this, &EventTable::refresh);
  for (auto changed : {&Document::activeObjectChanged, &Document::opened})
    connect(&document_, changed, this, &EventTable::reset);
  refresh();
}

std::vector<int> EventTable::shownEvents() const {
  std::vector<int> rows;
  const std::vector<Event>& events = document_.events();
  for (int i = 0; i < static_cast<int>(events.size()); ++i)
    if (repairs_ || changesTopology(events[i].kind)) rows.push_back(i);
  return rows;
}

// Of another object: rows with the same numbers are other events.
void EventTable::reset() {
  beginResetModel();
  rows_ = shownEvents();
  endResetModel();
}

// Events come at the end or are dropped from there; rows that stay are not touched, so that a selection
// stays.
void EventTable::refresh() {
  std::vector<int> rows = shownEvents();
  const bool grew = rows.size() > rows_.size() && std::equal(rows_.begin(), rows_.end(), rows.begin());
  if (grew) {
    beginInsertRows({}, static_cast<int>(rows_.size()), static_cast<int>(rows.size()) - 1);
    rows_ = std::move(rows);
    endInsertRows();
  } else if (rows != rows_) {
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
  }
}

void EventTable::showRepairs(bool on) {
  repairs_ = on;
  refresh();
}

int EventTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int EventTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

int EventTable::eventOf(int row) const { return row >= 0 && row < rowCount() ? rows_[row] : -1; }

int EventTable::rowOf(int event) const {
  const auto found = std::find(rows_.begin(), rows_.end(), event);
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

QString EventTable::text(int row, int column) const {
  const auto index = static_cast<std::size_t>(eventOf(row));
  if (index >= document_.events().size()) return {};
  const Event& event = document_.events()[index];
  switch (column) {
    case kIteration:
      return QString::number(event.iteration);
    case kKind:
      return eventName(event);
    case kPlace:
      return place(event.location, document_.volume().grid);
    case kGenus:
      return changeText(event.before.genus, event.after.genus);
    default:
      return changeText(event.before.components, event.after.components);
  }
}

QVariant EventTable::data(const QModelIndex& index, int role) const {
  if (role == Qt::DisplayRole) return text(index.row(), index.column());
  if (role == Qt::TextAlignmentRole && index.column() != kKind && index.column() != kPlace)
    return int(Qt::AlignCenter);
  return {};
}

QVariant EventTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || orientation != Qt::Horizontal) return {};
  const QString names[] = {tr("Step"), tr("Event"), tr("Place (LPS)"), tr("Genus"), tr("Parts")};
  return names[section];
}

}  // namespace handlebody::ui
