#pragma once
// Which of the objects that the clicks may mean is taken, and the buttons to a smaller and a larger one.

#include <QWidget>

#include "ui/model/candidate_choice.h"

class QLabel;

namespace handlebody::ui {

class ActionButton;
class Commands;

class ObjectChoice : public QWidget {
  Q_OBJECT

 public:
  explicit ObjectChoice(const Commands& commands, QWidget* parent = nullptr);
  //! `unknown`: what is said without candidates.
  void showChoice(const CandidateChoice& choice, const QString& unknown);

 private:
  QLabel *chosen_, *close_;
  ActionButton *smaller_, *larger_;
};

}  // namespace handlebody::ui
