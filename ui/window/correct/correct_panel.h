#pragma once
// Step 5: what mends a surface that has grown wrong, in sections.

#include <QWidget>

namespace handlebody::ui {

class CorrectPanel : public QWidget {
  Q_OBJECT

 public:
  explicit CorrectPanel(QWidget* parent = nullptr);

  //! Below those that are there: a heading, what it is for in a line, and its controls, which the panel owns.
  void addSection(const QString& title, const QString& help, QWidget* controls);
};

}  // namespace handlebody::ui
