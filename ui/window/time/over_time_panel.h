#pragma once
// The surface through the frames of a 4D volume: carried on, what came of each frame, the volume over time.

#include <QWidget>
#include <string>

#include "core/io/report/over_time_report.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace handlebody::ui {

class Commands;
class Document;
class VolumePlot;

class OverTimePanel : public QWidget {
  Q_OBJECT

 public:
  OverTimePanel(Document& document, const Commands& commands, QWidget* parent = nullptr);

  VolumePlot& plot() { return *plot_; }
  //! Nothing that names the patient is to stand in what is saved.
  void setAnonymous(bool anonymous) { isAnonymous_ = anonymous; }

 Q_SIGNALS:
  void saveRequested(const QString& title, const QString& what, const QString& extension,
                     const std::string& text);

 private:
  QWidget* buildTools(const Commands& commands);
  void addOptions(QGridLayout& grid, QWidget* tools);
  void addSaving(QGridLayout& grid, QWidget* tools, const Commands& commands);
  void ask(const QString& undoText, int gesture);
  void showRequest();
  void showFrames();
  void showState();
  QString figures() const;
  OverTimeReport told() const;

  Document& document_;
  QComboBox *topology_, *check_;
  QSpinBox *first_, *last_;
  QProgressBar* progress_;
  QLabel *figures_, *note_;
  QPushButton *csv_, *svg_;
  QWidget *correct_, *ends_;
  VolumePlot* plot_;
  QTableWidget* table_;
  int firstGesture_, lastGesture_;
  bool isAnonymous_ = false;
};

}  // namespace handlebody::ui
