#pragma once
// Step 6: what is written, and how.

#include <QWidget>
#include <optional>

#include "core/io/mesh_io.h"
#include "ui/window/view_grid.h"

class QButtonGroup;
class QComboBox;
class QFormLayout;
class QLabel;
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
  //! All objects in one file; else the active one.
  bool takesAll() const;
  //! The view of which a picture is wanted; none: all four.
  std::optional<Cell> pictureOf() const;

 private:
  void buildResult(const Commands& commands);
  void buildRest(const Commands& commands);
  void showWhatIsWritten();
  void showAllObjects();

  Document& document_;
  QLabel *hint_, *numbers_;
  QComboBox *objects_, *format_, *picture_;
  QFormLayout* form_;
  QWidget* spaceRow_;
  QButtonGroup* space_;
};

}  // namespace handlebody::ui
