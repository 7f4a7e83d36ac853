#pragma once
// A centre line between two clicks: its sections as a plot, worked out in the background.

#include <QWidget>
#include <optional>

#include "ui/model/measuring.h"

class QLabel;
class QPushButton;

namespace handlebody::ui {

class Commands;
class Document;
class SectionPlot;
class ViewState;

class CentreLinePage : public QWidget {
  Q_OBJECT

 public:
  CentreLinePage(Document& document, ViewState& state, const Commands& commands, QWidget* parent = nullptr);

  //! What the plot shows; null: nothing yet.
  const MeasuredLine* shown() const { return shown_ ? &*shown_ : nullptr; }
  bool isSearching() const { return isSearching_; }
  //! From one place to another, mm LPS, in the object that holds the first.
  void find(const Vec3& from, const Vec3& to);
  void setAnonymous(bool anonymous) { isAnonymous_ = anonymous; }

 Q_SIGNALS:
  void saveRequested(const QString& title, const QString& extension, const std::string& text);
  void lineAsked();  //!< two places were clicked: the plot is wanted

 private:
  void buildTools(const Commands& commands);
  void showAnswer(LineAnswer answer);
  void showState();
  bool isCurrent() const;
  void showLine();
  void markPoint(int index);
  void forget();
  std::string json() const;

  Document& document_;
  ViewState& state_;
  SectionPlot* plot_;
  QLabel* text_;
  QPushButton *csv_, *json_, *remove_;
  std::optional<MeasuredLine> shown_;
  std::vector<MeasuredSurface> made_;  //!< of which surfaces
  QString error_;
  bool isSearching_ = false;
  bool isAnonymous_ = false;
  int number_ = 0;

  Measurer measurer_;  // last: its thread ends before what it reports to
};

}  // namespace handlebody::ui
