#pragma once
// The history of the growth: plot, slider, events.

#include <QWidget>

class QCheckBox;
class QLabel;
class QTableView;

namespace handlebody::ui {

class Document;
class EventTable;
class TimelineSlider;

class TimelinePanel : public QWidget {
  Q_OBJECT

 public:
  explicit TimelinePanel(Document& document, QWidget* parent = nullptr);

  //! Marks the row of an event (index into Document::events()); -1: none.
  void setEvent(int index);

 Q_SIGNALS:
  //! The user wants to see this event.
  void eventChosen(int index);

 private:
  QWidget* buildTime();
  QWidget* buildTable();
  void showIterations();

  Document& document_;
  TimelineSlider* slider_;
  EventTable* events_;
  QTableView* table_;
  QLabel* empty_;
  QCheckBox* repairs_;
};

}  // namespace handlebody::ui
