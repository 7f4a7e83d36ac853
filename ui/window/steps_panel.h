#pragma once
// The six steps of the work in their order; one is shown at a time.

#include <QWidget>
#include <vector>

#include "ui/window/commands.h"

class QStackedWidget;

namespace handlebody::ui {

class StepsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit StepsPanel(const Commands& commands, QWidget* parent = nullptr);

  //! Adds the panel of a step; it scrolls if it is higher than the dock.
  void add(Command step, QWidget* panel);
  //! What concerns all steps stands over them.
  void setTop(QWidget* widget);
  void show(Command step);
  Command shown() const;
  QSize sizeHint() const override { return {312, 560}; }

 private:
  const Commands& commands_;
  QStackedWidget* pages_;
  std::vector<Command> steps_;
};

}  // namespace handlebody::ui
