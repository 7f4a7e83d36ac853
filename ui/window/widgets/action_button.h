#pragma once
// A push button for an action: text, icon, tip and whether it can be pressed follow the action.

#include <QPushButton>

class QAction;

namespace handlebody::ui {

class ActionButton : public QPushButton {
  Q_OBJECT

 public:
  //! The focus is reached by Tab only: a click leaves the keyboard with the views, where Space runs and
  //! pauses.
  explicit ActionButton(QAction* action, QWidget* parent = nullptr);
  //! In place of the action's.
  void setOwnText(const QString& text);

 private:
  void follow();

  QAction* action_;
  QString ownText_;
};

}  // namespace handlebody::ui
