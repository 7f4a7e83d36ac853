#pragma once
// Sentences for the user: errors, warnings, offers. They wait; nothing is blocked meanwhile.

#include <QFrame>
#include <functional>
#include <optional>
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
  //! The same of a question that waits until it is answered or closed: what is shown meanwhile only covers
  //! it.
  void ask(Kind kind, const QString& sentence, const std::vector<Answer>& answers);
  QString text() const;
  //! What is shown is no longer so; a question that waits stays, or is seen again.
  void dismiss();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Message {
    Kind kind;
    QString sentence;
    std::vector<Answer> answers;
  };
  QAbstractButton* makeCloseButton();
  void present(const Message& message);
  void putAway();
  void setAnswers(const std::vector<Answer>& answers);
  void place();
  void announce(Kind kind);

  QLabel* symbol_;
  QLabel* text_;
  QString sentence_;
  std::optional<Message> question_;  //!< waits for its answer
  bool showsQuestion_ = false;       //!< it is what is shown, or was last
  QWidget* answers_ = nullptr;
  QHBoxLayout* layout_;
  QTimer* timer_;
};

}  // namespace handlebody::ui
