#pragma once
// Step 1: what is open, what is doubtful about it, and the choice where a source holds several volumes.

#include <QWidget>
#include <vector>

#include "core/io/volume_io.h"

class QFormLayout;
class QLabel;
class QListWidget;
class QSpinBox;

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
  void addFact(QFormLayout* form, const QString& name, QLabel*& field);
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
};

}  // namespace handlebody::ui
