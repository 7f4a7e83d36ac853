#pragma once
// Step 1: what is open, its warnings, and the choice where a source holds several volumes.

#include <QWidget>
#include <vector>

#include "core/io/formats/volume_io.h"

class QFormLayout;
class QLabel;
class QSpinBox;
class QVBoxLayout;

namespace handlebody::ui {

class Commands;
class Document;
class SeriesList;
class SpacingEntry;

class OpenPanel : public QWidget {
  Q_OBJECT

 public:
  OpenPanel(Document& document, const Commands& commands, QWidget* parent = nullptr);

  //! Asks for the spacing of a file that cannot be opened without it.
  void askSpacing(const QString& path, const VolumeSelection& selection);
  //! The warnings of what is open, a sentence each.
  void showWarnings(const std::vector<Finding>& warnings);

 Q_SIGNALS:
  void openRequested(const QString& path, const handlebody::VolumeSelection& selection);

 private:
  void buildChoice();
  void buildFacts();
  void buildTime(QVBoxLayout* layout);
  void addFact(QFormLayout* form, const QString& name, QLabel*& field);
  void listSeries(const QString& path, const std::vector<SeriesInfo>& series);
  void offerSeries(const QString& path, const std::vector<SeriesInfo>& series);
  void openSeries();
  void offerSpacing();
  void openWithSpacing(const Vec3& spacing);
  void showOpened();

  Document& document_;
  QLabel* hint_;
  QWidget* choice_;
  SeriesList* series_;
  QString choicePath_;
  SpacingEntry* spacingEntry_;
  QString spacingPath_;  //!< what the spacing is for
  VolumeSelection spacingSelection_;
  QWidget* facts_;
  QLabel *name_, *format_, *size_, *spacing_, *extent_, *type_, *axes_, *warnings_;
  QWidget* time_;
  QSpinBox* frame_;
};

}  // namespace handlebody::ui
