#pragma once
// What is done to the shown surface where the crosshair is: a part of it pinned, smoothed, cut.

#include <QWidget>

#include "core/surgery/kept_side.h"
#include "ui/view/view_state.h"

class QButtonGroup;
class QDoubleSpinBox;

namespace handlebody::ui {

class Commands;
class Document;

class LocalSection : public QWidget {
  Q_OBJECT

 public:
  //! Does what the commands Pin here, Smooth here and Cut here ask for, and enables them.
  LocalSection(Document& document, ViewState& state, const Commands& commands, QWidget* parent = nullptr);

 private:
  QWidget* buildRadius();
  QWidget* buildCut();
  void startWithVolume();
  void showSides();
  void updateCommands();
  void pin();
  void smooth();
  void cut();

  Document& document_;
  ViewState& state_;
  const Commands& commands_;
  QDoubleSpinBox* radius_ = nullptr;
  QButtonGroup *plane_ = nullptr, *kept_ = nullptr;
};

}  // namespace handlebody::ui
