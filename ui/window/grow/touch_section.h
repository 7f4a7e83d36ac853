#pragma once
// The brush on the surface: pinning, unpinning, smoothing, pulling; and how many pins there are.

#include <QWidget>

class QLabel;

namespace handlebody::ui {

class Commands;
class Document;
class ViewState;

class TouchSection : public QWidget {
  Q_OBJECT

 public:
  TouchSection(Document& document, ViewState& state, const Commands& commands, QWidget* parent = nullptr);

 private:
  void showPins();

  Document& document_;
  QLabel* pins_;
};

}  // namespace handlebody::ui
