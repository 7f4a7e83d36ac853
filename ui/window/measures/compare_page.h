#pragma once
// The active object against a reference, a file or another object: figures, and distances in colour on the
// surface.

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ui/model/comparing.h"
#include "ui/window/widgets/file_writer.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace handlebody::ui {

class Document;
class ViewState;

class ComparePage : public QWidget {
  Q_OBJECT

 public:
  ComparePage(Document& document, ViewState& state, QWidget* parent = nullptr);

  //! A mesh or a label map, all but 0 of that. Takes the place of the reference before; asks no one. Nothing
  //! without a surface.
  void compareWith(const QString& path);
  //! The same with another object that has a surface, by its index.
  void compareWithObject(int index);
  //! Null: nothing yet.
  const ComparedPair* shown() const { return answer_.pair.get(); }
  bool isComparing() const { return isComparing_; }
  void setAnonymous(bool anonymous) { isAnonymous_ = anonymous; }

 Q_SIGNALS:
  void saveRequested(const QString& title, const QString& extension, const std::string& text);
  //! `write` may be called on any thread, and throws.
  void saveFileRequested(const QString& title, const QString& extension,
                         const handlebody::ui::FileWriter& write);

 private:
  using ObjectKey = std::weak_ptr<const void>;

  QWidget* buildTools();
  QWidget* buildLabelRow(QWidget* tools);
  QPushButton* addButton(const QString& text, const QString& tip);
  void connectTools();
  void choose();
  void chooseFile();
  void refer(const QString& path, const ObjectKey& object);
  void compareOrCancel();
  void start();
  template <typename Result>
  std::function<void(Result)> onThisThread(void (ComparePage::*take)(Result));
  void showLabels(ReferenceLabels labels);
  void showAnswer(CompareAnswer answer);
  void showTable();
  void showState();
  void showReference();
  void colour();
  void clear();
  void forget();
  void saveDistances();

  std::optional<MeasuredSurface> surfaceOf(int index) const;
  std::vector<int> otherObjects() const;
  std::optional<CompareQuestion> question() const;
  bool isEarlier() const;
  QString stateText() const;
  std::shared_ptr<const ComparedPair> told() const;

  Document& document_;
  ViewState& state_;
  QLabel *reference_, *labelNote_, *note_;
  QWidget* labelRow_;
  QComboBox* label_;
  QCheckBox* colours_;
  QProgressBar* progress_;
  QPushButton *choose_, *again_, *csv_, *json_, *vtp_;
  QTableWidget* table_;
  QString path_;             //!< of the reference; empty: it is an object, or none
  bool isLabelMap_ = false;  //!< as the file was when it was chosen
  ObjectKey object_;         //!< that is the reference
  QString objectName_;       //!< and what it was called when it was last seen
  bool knowsLabels_ = false;
  QString labelError_;
  CompareAnswer answer_;
  CompareQuestion asked_;                         //!< of that answer
  std::shared_ptr<const MeshSnapshot> compared_;  //!< the shown mesh that was compared
  bool isComparing_ = false;
  bool isAnonymous_ = false;
  int number_ = 0;

  Comparer comparer_;  // last: its thread ends before what it reports to
};

}  // namespace handlebody::ui
