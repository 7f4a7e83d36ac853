#pragma once
// How much the shown surface depends on what might as well have been a little different: one button, the
// volume with its spread, and the surface coloured by how far it moves.

#include <QWidget>
#include <optional>
#include <string>

#include "ui/model/sensing.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace handlebody::ui {

class Document;
class ViewState;

class SensitivityPage : public QWidget {
  Q_OBJECT

 public:
  SensitivityPage(Document& document, ViewState& state, QWidget* parent = nullptr);

  //! Begins, unless it is at it already; nothing where that cannot be.
  void start();
  bool isAsking() const { return isAsking_; }
  //! Null: nothing yet.
  const Sensitivity* shown() const { return answer_.found ? &*answer_.found : nullptr; }

 Q_SIGNALS:
  void saveRequested(const QString& title, const QString& extension, const std::string& text);

 private:
  QWidget* buildTools();
  void startOrCancel();
  void showAnswer(SensitivityAnswer answer);
  void showTable();
  void showState();
  void colour();
  void forget();

  Document& document_;
  ViewState& state_;
  QSpinBox* runs_;
  QPushButton *start_, *csv_;
  QProgressBar* progress_;
  QCheckBox* colours_;
  QLabel *volume_, *note_;
  QTableWidget* table_;
  SensitivityAnswer answer_;
  std::shared_ptr<const MeshSnapshot> asked_;  //!< the shown mesh that it is of
  bool isAsking_ = false;
  int number_ = 0;

  Sensor sensor_;  // last: its thread ends before what it reports to
};

}  // namespace handlebody::ui
