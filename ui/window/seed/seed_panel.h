#pragma once
// Step 2: the clicks inside and outside of the object, where they lie and how large they are, and which
// object they mean.

#include <QWidget>

class QLabel;
class QTableWidget;

namespace handlebody::ui {

class Commands;
class Document;
class ObjectChoice;
class ValueField;
class ViewState;

class SeedPanel : public QWidget {
  Q_OBJECT

 public:
  SeedPanel(Document& document, ViewState& state, const Commands& commands, QWidget* parent = nullptr);

 private:
  void buildTable();
  void boundRadius();
  void showSeeds();
  void showSelected();
  void showChoice();
  void select(int row);

  Document& document_;
  ViewState& state_;
  QLabel *hint_, *error_;
  QTableWidget* table_;
  QWidget* details_;
  ValueField* radius_;
  ObjectChoice* object_;
};

}  // namespace handlebody::ui
