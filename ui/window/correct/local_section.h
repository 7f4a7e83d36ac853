#pragma once
// What is done to the shown surface where the crosshair is: a part of it pinned, smoothed, pulled, cut.

#include <QWidget>

#include "ui/view/view_state.h"

class QButtonGroup;
class QDoubleSpinBox;

namespace handlebody::ui {

class Commands;
class Document;
enum class Command;

class LocalSection : public QWidget {
  Q_OBJECT

 public:
  //! Does what the commands Pin here, Smooth here, Pull here and Cut here ask for, and enables them.
  LocalSection(Document& document, ViewState& state, const Commands& commands, QWidget* parent = nullptr);

 Q_SIGNALS:
  void pinned();

 private:
  QWidget* button(Command id, const QString& text);
  QWidget* buildRadius();
  QWidget* buildCut();
  void startWithVolume();
  void showSides();
  void updateCommands();
  void pin();
  void smooth();
  void pull();
  void cut();

  Document& document_;
  ViewState& state_;
  const Commands& commands_;
  QDoubleSpinBox* radius_ = nullptr;
  QButtonGroup *plane_ = nullptr, *kept_ = nullptr;
};

}  // namespace handlebody::ui
