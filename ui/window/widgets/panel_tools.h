#pragma once
// What all panels are built of, so that they look and behave alike.

#include <QFontMetrics>
#include <QLabel>
#include <QString>
#include <QStringList>

class QAction;
class QFormLayout;
class QTableWidget;
class QTableWidgetItem;
class QToolButton;
class QVBoxLayout;

namespace handlebody::ui {

//! The margins and spacing of a panel.
QVBoxLayout* panelLayout(QWidget* panel);
//! A heading over a part of a panel.
QLabel* heading(const QString& text, QWidget* parent);
//! Says what to do; wraps, in the colour of less important text.
QLabel* hint(const QString& text, QWidget* parent);
//! A form whose labels stand over or beside their fields as the width allows.
QFormLayout* panelForm();
//! A text beside a name in a form, that can be selected and wraps.
QLabel* value(const QString& name, QWidget* parent);
//! The same with a ground of its own: what the user should not miss.
QLabel* notice(const QString& name, QWidget* parent);
//! Icon only; the tooltip and the accessible name are the action's.
QToolButton* smallButton(QAction* action, QWidget* parent);
//! A command's text without the letter that its menu marks: "&Open", or "打开(&O)" where the script has none.
QString withoutKey(QString text);
//! Fields do not change under a wheel that was meant to scroll the panel.
void ignoreWheelWithoutFocus(QWidget* field);
//! Lets a field be found and read aloud: accessible name, tooltip, and the same text as "what is this".
void describe(QWidget* field, const QString& name, const QString& tip);

//! Rows to choose from, one at a time; the first column takes the room that is left.
QTableWidget* listTable(const QStringList& headers, QWidget* parent);
//! Of such a table: cannot be edited; its tip has the whole text.
QTableWidgetItem* listCell(const QString& text);

//! A path as a menu or a button shows it: shortened in its middle to `width` pixels, and an "&" in it is no
//! letter to press.
QString pathText(const QString& path, const QFontMetrics& metrics, int width);

}  // namespace handlebody::ui
