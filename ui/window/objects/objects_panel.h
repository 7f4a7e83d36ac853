#pragma once
// The list of objects, over the steps; hidden while there is one.

#include <QWidget>
#include <functional>
#include <vector>

class QLabel;
class QTableWidget;
class QToolButton;

namespace handlebody::ui {

class Commands;
class Document;
struct ObjectInfo;

class ObjectsPanel : public QWidget {
  Q_OBJECT

 public:
  ObjectsPanel(Document& document, const Commands& commands, QWidget* parent = nullptr);

 private:
  struct Row {
    QToolButton *visible, *locked;
  };
  void buildTable();
  void addRow();
  QToolButton* cellButton(int row, int column, const std::function<void(int)>& change);
  void showAll();
  void showRow(int row, const ObjectInfo& info);
  void showNotice();

  Document& document_;
  QTableWidget* table_;
  QLabel* notice_;
  std::vector<Row> rows_;
};

//! What is told of an object's surface in one word or number.
QString progressText(const ObjectInfo& info);

}  // namespace handlebody::ui
