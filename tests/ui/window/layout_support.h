#pragma once
// What is cut off, squeezed or overlapped in a window, found by walking its visible widgets.

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenuBar>
#include <QScrollArea>
#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QWidget>

namespace handlebody::test {

inline QString nameOf(const QWidget& widget) {
  QString name = widget.accessibleName();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget); button && name.isEmpty())
    name = button->text();
  if (const auto* label = qobject_cast<const QLabel*>(&widget); label && name.isEmpty()) name = label->text();
  return QStringLiteral("%1 \"%2\"").arg(QString::fromLatin1(widget.metaObject()->className()), name);
}

//! Parts of Qt's own composed widgets are not looked at.
inline bool isInner(const QWidget& widget) {
  for (const QWidget* w = &widget; w; w = w->parentWidget())
    if (w->objectName().startsWith(QLatin1String("qt_")) &&
        w->objectName() != QLatin1String("qt_toolbar_ext_button") &&
        w->objectName() != QLatin1String("qt_scrollarea_viewport"))
      return true;
  return widget.inherits("QHeaderView") || widget.inherits("QTableCornerButton");
}

//! Docks that lie behind others, and the tabs of docks where there are none, are kept by Qt out of sight.
inline bool isParked(const QWidget& widget) {
  return (qobject_cast<const QDockWidget*>(&widget) || qobject_cast<const QTabBar*>(&widget)) &&
         qobject_cast<const QMainWindow*>(widget.parentWidget()) && widget.visibleRegion().isEmpty();
}

//! A widget reaches out of its parent, or of the part of the scroll area that is seen (sideways only: one may
//! scroll down).
inline QString faultOfPlace(const QWidget& widget) {
  const QWidget* parent = widget.parentWidget();
  const bool scrolls = parent->objectName() == QLatin1String("qt_scrollarea_viewport");
  const QRect room = scrolls ? QRect(0, -100'000, parent->width(), 200'000) : parent->rect();
  if (room.contains(widget.geometry()) || isParked(widget)) return {};
  return QStringLiteral("%1 reaches out of its parent").arg(nameOf(widget));
}

inline QString faultOfLabel(const QLabel& label) {
  if (label.text().isEmpty()) return {};
  if (label.minimumSizeHint().width() > label.width() + 1)
    return QStringLiteral("%1 is narrower than its longest word").arg(nameOf(label));
  const int needed = label.wordWrap() ? label.heightForWidth(label.width()) : label.sizeHint().height();
  if (needed > label.height() + 1) return QStringLiteral("%1 is cut off below").arg(nameOf(label));
  return {};
}

inline QString faultOfTable(const QTableView& table) {
  int width = 0;
  for (int c = 0; c < table.model()->columnCount(); ++c) {
    width += table.columnWidth(c);
    const int cells = static_cast<const QAbstractItemView&>(table).sizeHintForColumn(c);
    const int wanted = std::max(cells, table.horizontalHeader()->sectionSizeHint(c));
    if (wanted > table.columnWidth(c))
      return QStringLiteral("column %1 of %2 is cut off").arg(c).arg(nameOf(table));
  }
  return width > table.viewport()->width() + 1
             ? QStringLiteral("%1 is wider than its place").arg(nameOf(table))
             : QString();
}

inline bool isIconOnly(const QAbstractButton& button) {
  const auto* tool = qobject_cast<const QToolButton*>(&button);
  return tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull();
}

//! Tabs are scrolled or their texts shortened.
inline QString faultOfTabs(const QTabBar& tabs) {
  if (isParked(tabs)) return {};
  for (int i = 0; i < tabs.count(); ++i)
    if (!tabs.rect().contains(tabs.tabRect(i)) ||
        tabs.fontMetrics().size(Qt::TextShowMnemonic, tabs.tabText(i)).width() > tabs.tabRect(i).width())
      return QStringLiteral("tab \"%1\" is cut off").arg(tabs.tabText(i));
  return {};
}

//! Menus that have no room in their bar.
inline QString faultOfMenuBar(const QMenuBar& bar) {
  const auto entries = bar.actions();
  for (QAction* entry : entries)
    if (entry->isVisible() && !bar.rect().contains(bar.actionGeometry(entry)))
      return QStringLiteral("menu \"%1\" does not fit").arg(entry->text());
  return {};
}

//! The title of a dock is shortened beside its two buttons.
inline QString faultOfDock(const QDockWidget& dock) {
  if (isParked(dock) || dock.titleBarWidget()) return {};
  int buttons = 0;
  const auto all = dock.findChildren<QAbstractButton*>(QString(), Qt::FindDirectChildrenOnly);
  for (const QAbstractButton* button : all) buttons += button->isVisible() ? button->width() : 0;
  const bool fits = dock.fontMetrics().horizontalAdvance(dock.windowTitle()) + buttons <= dock.width();
  return fits ? QString() : QStringLiteral("title \"%1\" is cut off").arg(dock.windowTitle());
}

//! What is typed, or what is said in its place.
inline QString faultOfLine(const QLineEdit& line) {
  const QString text = line.text().isEmpty() ? line.placeholderText() : line.text();
  const bool fits = line.fontMetrics().horizontalAdvance(text) + 4 <= line.width();
  return fits ? QString() : QStringLiteral("%1 is too narrow for %2").arg(nameOf(line), text);
}

//! What is no control with a text of its own: lists, bars, frames.
inline QString faultOfFrame(const QWidget& widget) {
  if (const auto* table = qobject_cast<const QTableView*>(&widget)) return faultOfTable(*table);
  if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) return faultOfTabs(*tabs);
  if (const auto* bar = qobject_cast<const QMenuBar*>(&widget)) return faultOfMenuBar(*bar);
  if (const auto* dock = qobject_cast<const QDockWidget*>(&widget)) return faultOfDock(*dock);
  return {};
}

//! The text of a button, a choice or a number does not fit into it.
inline QString faultOfText(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return faultOfLabel(*label);
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) return faultOfLine(*line);
  if (const QString fault = faultOfFrame(widget); !fault.isEmpty()) return fault;
  if (const auto* box = qobject_cast<const QAbstractSpinBox*>(&widget)) {
    const auto* edit = box->findChild<QLineEdit*>();
    const bool fits = edit->fontMetrics().horizontalAdvance(edit->text()) + 4 <= edit->width();
    return fits ? QString() : QStringLiteral("%1 is too narrow for %2").arg(nameOf(widget), edit->text());
  }
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  if (!button && !qobject_cast<const QComboBox*>(&widget)) return {};
  const QSize hint = widget.sizeHint();
  // A small button with a picture alone may be of a size of its own.
  const bool isPicture = button && (button->text().isEmpty() || isIconOnly(*button));
  const bool fixed = isPicture && widget.minimumSize() == widget.maximumSize();
  const bool fits = fixed || (hint.width() <= widget.width() && hint.height() <= widget.height());
  return fits ? QString() : QStringLiteral("%1 is smaller than its text").arg(nameOf(widget));
}

inline QStringList overlaps(const QWidget& parent) {
  QStringList faults;
  QList<const QWidget*> placed;
  for (int i = 0; parent.layout() && i < parent.layout()->count(); ++i)
    if (const QWidget* widget = parent.layout()->itemAt(i)->widget(); widget && widget->isVisible())
      placed << widget;
  for (qsizetype i = 0; i < placed.size(); ++i)
    for (qsizetype j = i + 1; j < placed.size(); ++j)
      if (placed[i]->geometry().intersects(placed[j]->geometry()))
        faults << QStringLiteral("%1 lies over %2").arg(nameOf(*placed[i]), nameOf(*placed[j]));
  return faults;
}

//! One sentence per fault; empty if everything that is shown can be seen whole.
inline QStringList layoutFaults(const QWidget& window) {
  QStringList faults;
  const auto widgets = window.findChildren<QWidget*>();
  for (const QWidget* widget : widgets) {
    if (!widget->isVisible() || widget->window() != &window || isInner(*widget)) continue;
    if (widget->objectName() == QLatin1String("qt_toolbar_ext_button")) faults << "the toolbar does not fit";
    faults << faultOfPlace(*widget) << faultOfText(*widget);
    if (!qobject_cast<const QComboBox*>(widget)) faults << overlaps(*widget);
  }
  faults.removeAll(QString());
  return faults;
}

//! The same when layouts have had time to settle, of which they need more where the machine has other work.
inline QStringList lastingLayoutFaults(const QWidget& window) {
  QTest::qWait(50);  // else what was there before would be looked at
  QStringList faults;
  static_cast<void>(QTest::qWaitFor([&] { return (faults = layoutFaults(window)).isEmpty(); }, 3000));
  return faults;
}

}  // namespace handlebody::test
