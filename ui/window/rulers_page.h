#pragma once
// The list of rulers and angles, and the tools that place them.

#include <QWidget>

class QLabel;
class QPushButton;
class QTableWidget;

namespace handlebody::ui {

class Commands;
class Document;
class ViewState;

class RulersPage : public QWidget {
  Q_OBJECT

 public:
  RulersPage(Document& document, ViewState& state, const Commands& commands, QWidget* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showRows();
  void showHint();
  void goToChosen();

  Document& document_;
  ViewState& state_;
  QLabel* hint_;
  QTableWidget* table_;
  QPushButton* delete_;
};

}  // namespace handlebody::ui
