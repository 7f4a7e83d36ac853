#pragma once
// The brush for walls: painting or erasing, its radius, and how many walls there are.

#include <QWidget>

class QLabel;

namespace handlebody::ui {

class Commands;
class Document;
class ViewState;

class WallSection : public QWidget {
  Q_OBJECT

 public:
  WallSection(Document& document, ViewState& state, const Commands& commands, QWidget* parent = nullptr);

 private:
  void showWalls();

  Document& document_;
  QLabel* walls_;
};

}  // namespace handlebody::ui
