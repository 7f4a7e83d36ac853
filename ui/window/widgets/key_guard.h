#pragma once
// Keys that mean something to the control in focus stay with it, though they are shortcuts of the window:
// Space presses a focused button, Return ends an entry or opens a row, Ctrl+Backspace deletes a word.

#include <QObject>

namespace handlebody::ui {

class KeyGuard : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace handlebody::ui
