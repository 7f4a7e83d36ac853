#pragma once
// A view with the button that lets it fill the grid, over its upper right corner.

#include <QWidget>

class QToolButton;

namespace handlebody::ui {

class ViewFrame : public QWidget {
  Q_OBJECT

 public:
  ViewFrame(const QString& name, QWidget* view, QWidget* parent = nullptr);

  //! Which of the two the button offers.
  void setMaximised(bool maximised);

 Q_SIGNALS:
  void maximiseRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QString name_;
  QToolButton* button_;
};

}  // namespace handlebody::ui
