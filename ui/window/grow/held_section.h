#pragma once
// What holds the active object back: limits, vetoes, pins, places that are allowed, discs, a map of walls,
// and what is held in the shown iteration; each can be lifted.

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "core/geometry/vec.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace handlebody::ui {

class Document;
class ViewState;

class HeldSection : public QWidget {
  Q_OBJECT

 public:
  HeldSection(Document& document, ViewState& state, QWidget* parent = nullptr);

 protected:
  //! Delete lifts the chosen one: the window's key would delete a seed.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Row {
    QString text;
    std::optional<Vec3> place;  // mm
    QString lifting;            // on the button
    std::function<void()> lift;
  };
  std::vector<Row> rowsNow() const;
  void addTopology(std::vector<Row>& rows) const;
  void addPins(std::vector<Row>& rows) const;
  void addWalls(std::vector<Row>& rows) const;
  void addHeld(std::vector<Row>& rows) const;
  void showRows();
  const Row* chosen() const;  // null: none
  void showButton();
  void showChosen();
  void liftChosen();

  Document& document_;
  ViewState& state_;
  QLabel* none_;
  QTableWidget* table_;
  QPushButton* lift_;
  std::vector<Row> rows_;
};

}  // namespace handlebody::ui
