#pragma once
// The measures of all objects as a table, worked out in the background.

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/model/measuring.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;
class QTimer;

namespace handlebody::ui {

class Document;
class ViewState;

class ObjectMeasuresPage : public QWidget {
  Q_OBJECT

 public:
  ObjectMeasuresPage(Document& document, ViewState& state, QWidget* parent = nullptr);

  //! What the table shows; null: nothing yet.
  const Measured* shown() const { return shown_ ? &*shown_ : nullptr; }
  bool isMeasuring() const { return isMeasuring_; }
  //! Table and details without the numbers' rounding, columns apart by tabs.
  QString copyText() const;
  //! As they are saved.
  std::string csv() const;
  std::string json() const;
  //! The names of files are left out of what is saved.
  void setAnonymous(bool anonymous) { isAnonymous_ = anonymous; }

 Q_SIGNALS:
  void saveRequested(const QString& title, const QString& extension, const std::string& text);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  using Surfaces = std::vector<MeasuredSurface>;

  QWidget* buildBelow();
  QPushButton* addButton(const QString& text, const QString& tip, QWidget* parent);
  bool isGrowing() const;
  bool isStale() const;
  void follow();
  void measureOrCancel();
  void measure();
  void showAnswer(MeasureAnswer answer);
  void showTable();
  void showDetails();
  void showState();
  void fillWalls();
  MeasureQuestion question() const;
  Measured told() const;

  Document& document_;
  ViewState& state_;
  QTableWidget* table_;
  QLabel *details_, *note_;
  QComboBox* walls_;
  QProgressBar* progress_;
  QPushButton *measure_, *copy_, *csv_, *json_;
  QTimer* settle_;
  std::optional<Measured> shown_;
  Surfaces measured_, asked_;  //!< what is shown, and what is being measured, is made of
  QString error_;
  bool isMeasuring_ = false;
  bool isAnonymous_ = false;
  bool declined_ = false;  //!< cancelled: not begun anew before something changes
  int number_ = 0;         //!< of the newest question

  Measurer measurer_;  // last: its thread ends before what it reports to
};

}  // namespace handlebody::ui
