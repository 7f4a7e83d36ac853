#pragma once
// The list of rulers and angles, and the tools that place them.

#include <QWidget>
#include <string>

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

 Q_SIGNALS:
  //! Asks for a place to write `text` to, with this title and ending.
  void saveRequested(const QString& title, const QString& extension, const std::string& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QLayout* buildButtons(QWidget* parent);
  void showRows();
  void showHint();
  void goToChosen();

  Document& document_;
  ViewState& state_;
  QLabel* hint_;
  QTableWidget* table_;
  QPushButton *delete_, *csv_, *json_;
};

}  // namespace handlebody::ui
