#pragma once
// Step 1: what is open, what is doubtful about it, and the choice where a source holds several volumes.

#include <QWidget>
#include <array>
#include <vector>

#include "core/io/volume_io.h"

class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QListWidget;
class QSpinBox;
class QVBoxLayout;

namespace handlebody::ui {

class Commands;
class Document;

class OpenPanel : public QWidget {
  Q_OBJECT

 public:
  OpenPanel(Document& document, const Commands& commands, QWidget* parent = nullptr);

 private:
  void buildChoice();
  void buildFacts();
  void buildTime(QVBoxLayout* layout);
  void buildCalibration(QVBoxLayout* layout);
  void showCalibration();
  void addFact(QFormLayout* form, const QString& name, QLabel*& field);
  void listSeries(const QString& path, const std::vector<SeriesInfo>& series);
  void offerSeries(const QString& path, const std::vector<SeriesInfo>& series);
  void openSeries();
  void showOpened();
  void showWarnings(const std::vector<std::string>& warnings);

  Document& document_;
  QLabel* hint_;
  QWidget* choice_;
  QListWidget* series_;
  QString choicePath_;
  QWidget* facts_;
  QLabel *name_, *format_, *size_, *spacing_, *extent_, *type_, *axes_, *warnings_;
  QWidget* time_;
  QSpinBox* frame_;
  QWidget* calibration_;
  std::array<QDoubleSpinBox*, 3> mm_;
};

}  // namespace handlebody::ui
