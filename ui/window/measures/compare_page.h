#pragma once
// The active object against a reference from a file: figures, and distances in colour on the surface.

#include <QWidget>
#include <optional>
#include <string>

#include "ui/model/comparing.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace handlebody::ui {

class Document;
class ViewState;

class ComparePage : public QWidget {
  Q_OBJECT

 public:
  ComparePage(Document& document, ViewState& state, QWidget* parent = nullptr);

  //! Takes the place of the reference before; asks no one. Nothing without a surface.
  void compareWith(const QString& path);
  //! Null: nothing yet.
  const ComparedPair* shown() const { return answer_.pair.get(); }
  bool isComparing() const { return isComparing_; }
  void setAnonymous(bool anonymous) { isAnonymous_ = anonymous; }

 Q_SIGNALS:
  void saveRequested(const QString& title, const QString& extension, const std::string& text);

 private:
  QWidget* buildTools();
  QPushButton* addButton(const QString& text, const QString& tip);
  void choose();
  void compareOrCancel();
  void showAnswer(CompareAnswer answer);
  void showTable();
  void showState();
  void colour();
  void forget();
  std::shared_ptr<const ComparedPair> told() const;

  Document& document_;
  ViewState& state_;
  QLabel *reference_, *note_;
  QSpinBox* label_;
  QCheckBox* colours_;
  QProgressBar* progress_;
  QPushButton *choose_, *again_, *csv_, *json_;
  QTableWidget* table_;
  QString path_;
  CompareAnswer answer_;
  QString anonymousName_;                         //!< of the object that was compared
  std::shared_ptr<const MeshSnapshot> compared_;  //!< the shown mesh that was compared
  bool isComparing_ = false;
  bool isAnonymous_ = false;
  int number_ = 0;

  Comparer comparer_;  // last: its thread ends before what it reports to
};

}  // namespace handlebody::ui
