#pragma once
// Keys that mean something to the control in focus stay with it, though they are shortcuts of the window:
// Space presses a focused button, Return ends an entry or opens a row, Ctrl+Backspace deletes a word, a
// letter chooses in a combo box, and Delete in a list deletes no seed.

#include <QObject>

class QAbstractItemView;

namespace handlebody::ui {

class KeyGuard : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  //! Of a list whose rows a shortcut of the window deletes.
  static void leaveDeletion(QAbstractItemView& view);

  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace handlebody::ui
