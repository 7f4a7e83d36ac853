#pragma once
// What is to become of the surfaces of a mesh or a label map, which of a map's labels are meant, and how they
// are made.

#include <QDialog>
#include <atomic>
#include <memory>

#include "ui/model/document.h"
#include "ui/model/opened_objects.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QStackedWidget;
class QVBoxLayout;

namespace handlebody::ui {

class LabelChoice;

//! It is gone when it has been answered. The labels of a map are read meanwhile, off the GUI thread; it goes
//! by itself if there are none to choose from.
class OpenObjectsDialog : public QDialog {
  Q_OBJECT

 public:
  explicit OpenObjectsDialog(const QString& path, QWidget* parent = nullptr);

  void done(int result) override;

 Q_SIGNALS:
  void chosen(const handlebody::ui::ObjectsToOpen& asked);
  //! Its labels cannot be read.
  void failed(const QString& sentence);

 private:
  enum Smoothing { kByVoxel, kByLength, kNone };

  void buildQuestion(QVBoxLayout* all);
  void buildLabels(QVBoxLayout* all);
  void buildShape(QVBoxLayout* all);
  QHBoxLayout* smoothingRow();
  QHBoxLayout* tunnelsRow();
  void buildAnswers(QVBoxLayout* all);
  QPushButton* answerButton(const QString& text, OpenAs as);
  void readLabels();
  void take(const LabelsToOpen& found);
  void enableAnswers();
  void growToFit();
  void answer(OpenAs as);
  LabelShape shape() const;

  QString path_;
  bool isMesh_;
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  // Null for a mesh.
  QStackedWidget* pages_ = nullptr;  // that it is reading, then the labels
  LabelChoice* labels_ = nullptr;
  QLabel* overlap_ = nullptr;
  QComboBox* smoothing_ = nullptr;
  QDoubleSpinBox* length_ = nullptr;
  QCheckBox *limitsTunnels_ = nullptr, *largest_ = nullptr;
  QSpinBox* tunnels_ = nullptr;
  QPushButton *done_ = nullptr, *start_ = nullptr;
};

}  // namespace handlebody::ui
