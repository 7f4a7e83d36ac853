#include "ui/window/widgets/key_guard.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace handlebody::ui {

namespace {

constexpr char kDeletesByShortcut[] = "deletesByShortcut";

//! A closed combo box looks for the choice that begins with what is typed.
bool isTyped(const QString& text) { return !text.isEmpty() && text.front().isPrint(); }

bool wants(const QObject* control, const QKeyEvent& event) {
  const int key = event.key();
  const bool space = key == Qt::Key_Space, enter = key == Qt::Key_Return || key == Qt::Key_Enter;
  const bool isDelete = key == Qt::Key_Delete || key == Qt::Key_Backspace;
  if (qobject_cast<const QAbstractButton*>(control)) return space;
  if (qobject_cast<const QComboBox*>(control)) return space || enter || isTyped(event.text());
  if (qobject_cast<const QAbstractItemView*>(control))
    return space || enter || (isDelete && !control->property(kDeletesByShortcut).toBool());
  if (qobject_cast<const QAbstractSpinBox*>(control) || qobject_cast<const QLineEdit*>(control)) return enter;
  return false;
}

//! Qt's fields know how to delete a word, but leave its key to whoever has it as a shortcut.
bool deletesWord(const QObject* control, const QKeyEvent& key) {
  if (!key.matches(QKeySequence::DeleteStartOfWord) && !key.matches(QKeySequence::DeleteEndOfWord))
    return false;
  const auto* line = qobject_cast<const QLineEdit*>(control);
  const auto* spin = qobject_cast<const QAbstractSpinBox*>(control);
  return (line && !line->isReadOnly()) || (spin && !spin->isReadOnly());
}

//! Qt takes a choice in a combo box's list when it asks whose key it is, in a filter that runs after this
//! one: the key is the list's, and goes on to it.
bool isChoiceInPopup(const QObject* control, int key) {
  const auto* list = qobject_cast<const QAbstractItemView*>(control);
  return list && list->window()->windowType() == Qt::Popup && key != Qt::Key_Space;
}

}  // namespace

void KeyGuard::leaveDeletion(QAbstractItemView& view) { view.setProperty(kDeletesByShortcut, true); }

bool KeyGuard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool isPlain = !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
  if (!(isPlain && wants(watched, *key)) && !deletesWord(watched, *key)) return false;
  event->accept();
  return !isChoiceInPopup(watched, key->key());
}

}  // namespace handlebody::ui
