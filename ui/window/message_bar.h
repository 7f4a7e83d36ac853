#pragma once
// Sentences for the user over the views: errors, warnings, offers. They wait; nothing is blocked meanwhile.

#include <QFrame>
#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QTimer;

namespace handlebody::ui {

class MessageBar : public QFrame {
  Q_OBJECT

 public:
  enum class Kind { information, warning, error };
  //! A button of a message; the message goes when it was pressed.
  struct Answer {
    QString text;
    std::function<void()> action;
  };

  explicit MessageBar(QWidget* parent = nullptr);

  //! Replaces what is shown. Informations without answers go by themselves after some seconds.
  void show(Kind kind, const QString& sentence, const std::vector<Answer>& answers = {});
  QString text() const;
  void dismiss();

 private:
  void setAnswers(const std::vector<Answer>& answers);

  QLabel* symbol_;
  QLabel* text_;
  QString sentence_;
  QWidget* answers_ = nullptr;
  QHBoxLayout* layout_;
  QTimer* timer_;
};

}  // namespace handlebody::ui
