#pragma once
// Sentences for the user: errors, warnings, offers. They wait; nothing is blocked meanwhile.

#include <QFrame>
#include <functional>
#include <vector>

class QAbstractButton;
class QHBoxLayout;
class QLabel;
class QTimer;

namespace handlebody::ui {

//! Lies over the middle of the lower rim of its parent, as large as its sentence, so that nothing moves when
//! it comes and goes. There it hides least of four views: their names, slices and buttons are above, and the
//! lower corners of the window stay free. Escape or its button closes it.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  enum class Kind { information, warning, error };
  //! A button of a message; the message goes when it was pressed.
  struct Answer {
    QString text;
    std::function<void()> action;
  };

  explicit MessageBar(QWidget* parent);

  //! Replaces what is shown. Informations without answers go by themselves after some seconds.
  void show(Kind kind, const QString& sentence, const std::vector<Answer>& answers = {});
  QString text() const;
  void dismiss();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QAbstractButton* makeCloseButton();
  void setAnswers(const std::vector<Answer>& answers);
  void place();
  void announce(Kind kind);

  QLabel* symbol_;
  QLabel* text_;
  QString sentence_;
  QWidget* answers_ = nullptr;
  QHBoxLayout* layout_;
  QTimer* timer_;
};

}  // namespace handlebody::ui
