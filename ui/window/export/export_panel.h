#pragma once
// Step 6: what is written, and how.

#include <QStringList>
#include <QWidget>
#include <optional>

#include "core/io/dicom/dicom_writer.h"
#include "core/io/meshes/mesh_io.h"
#include "ui/window/views/view_grid.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace handlebody::ui {

class Commands;
class Document;

class ExportPanel : public QWidget {
  Q_OBJECT

 public:
  ExportPanel(Document& document, const Commands& commands, QWidget* parent = nullptr);

  //! ".stl" …
  QString extension() const;
  CoordinateSpace space() const;
  //! What is written where there are several objects; with one it is the active one.
  enum class Objects { together, each, active };
  Objects which() const;
  //! Nothing that names the patient is to stand in what is written.
  bool isAnonymous() const;
  //! What the user says for DICOM files, whether the format is one or not.
  DicomContent content() const;
  //! The view of which a picture is wanted; none: all four.
  std::optional<Cell> pictureOf() const;

 Q_SIGNALS:
  void anonymousChanged(bool anonymous);
  void whichChanged();

 private:
  void buildResult(const Commands& commands);
  void addFormats();
  void addContent();
  void addAnonymous();
  void addSession(const Commands& commands);
  void addPolish();
  void showManner();
  QWidget* buildProgress();
  void connectProgress();
  void begin(const QString& path);
  void end();
  void showWork(const QString& work);
  void buildRest(const Commands& commands);
  void showWhatIsWritten();
  void showAllObjects();
  void showFault();

  Document& document_;
  QLabel *hint_, *numbers_, *fault_, *writing_, *polished_;
  QWidget* progress_;
  QCheckBox *anonymous_, *polish_;
  QString failed_;        //!< what went wrong last with this format
  QStringList underWay_;  //!< what is written, one after the other
  QString work_;          //!< what is done to the first of them
  QComboBox *objects_, *format_, *picture_;
  QFormLayout* form_;
  QLineEdit *creator_, *description_;  //!< of DICOM files
  QWidget* spaceRow_;
  QButtonGroup* space_;
};

}  // namespace handlebody::ui
