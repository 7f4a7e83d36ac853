#pragma once
// A view with its title bar: the colour of its plane, its name, the button that lets it fill the grid.

#include <QColor>
#include <QWidget>

class QToolButton;

namespace handlebody::ui {

class ViewFrame : public QWidget {
  Q_OBJECT

 public:
  ViewFrame(const QString& name, const QColor& colour, QWidget* view, QWidget* parent = nullptr);

  //! Which of the two the button offers.
  void setMaximised(bool maximised);

 Q_SIGNALS:
  void maximiseRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString name_;
  QColor colour_;
  QToolButton* button_;
};

}  // namespace handlebody::ui
