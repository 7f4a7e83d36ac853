#pragma once
// A button that stays pressed. Drawn here and not by a style sheet: those keep the colours of the appearance
// in which they were set, and Fusion's pressed buttons are hardly told apart from the others.

#include <QToolButton>

class QAction;

namespace handlebody::ui {

class ToggleButton : public QToolButton {
  Q_OBJECT

 public:
  //! Checkable; takes the focus by Tab only.
  explicit ToggleButton(const QString& text, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QColor ground() const;
  QColor rim() const;
};

//! Pressed and enabled as the action is, which a click triggers. `text`: in place of the action's, which
//! stays its name.
ToggleButton* toggleFor(QAction* action, QWidget* parent, const QString& text = {});

}  // namespace handlebody::ui
