#pragma once
// Under the views of a 4D volume: play, step, a slider over its frames, which frame and when.

#include <QWidget>

class QLabel;

namespace handlebody::ui {

class Commands;
class Document;
class FrameSlider;

//! Not shown for a volume of one time point.
class TimeBar : public QWidget {
  Q_OBJECT

 public:
  TimeBar(Document& document, const Commands& commands, QWidget* parent = nullptr);

 private:
  void showTime();
  void showMarks();

  Document& document_;
  FrameSlider* slider_;
  QLabel *text_, *fault_;
};

//! "frame 7 of 0–19, 350 ms"
QString frameText(const Document& document, int frame);
//! That the shown surface is out of date, as a sentence. Precondition: it is.
QString outOfDateText(const Document& document);

}  // namespace handlebody::ui
