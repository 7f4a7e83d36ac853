#include "ui/window/widgets/message_bar.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QShortcut>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/sentences.h"

namespace handlebody::ui {

namespace {

constexpr int kInformationStays = 8000;  // ms
// Logical pixels: from the rim of the parent; the longest line that is read with ease; the symbol;
// beside the text of a button.
constexpr int kDistance = 12, kWidest = 640, kSymbol = 20, kBarPadding = 6;

QString symbolName(MessageBar::Kind kind) {
  switch (kind) {
    case MessageBar::Kind::warning:
      return QStringLiteral("warning");
    case MessageBar::Kind::error:
      return QStringLiteral("error");
    default:
      return QStringLiteral("info");
  }
}

QString spokenName(MessageBar::Kind kind) {
  switch (kind) {
    case MessageBar::Kind::warning:
      return MessageBar::tr("Warning");
    case MessageBar::Kind::error:
      return MessageBar::tr("Error");
    default:
      return MessageBar::tr("Information");
  }
}

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent),
      symbol_(new QLabel(this)),
      text_(new QLabel(this)),
      layout_(new QHBoxLayout(this)),
      timer_(new QTimer(this)) {
  setBackgroundRole(QPalette::ToolTipBase);
  text_->setForegroundRole(QPalette::ToolTipText);
  text_->setTextFormat(Qt::PlainText);  // whatever a file is called
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setAccessibleName(tr("Message"));
  layout_->setContentsMargins(12, 8, 8, 8);
  layout_->setSpacing(8);
  layout_->addWidget(symbol_, 0, Qt::AlignTop);
  layout_->addWidget(text_, 1);
  layout_->addWidget(makeCloseButton(), 0, Qt::AlignTop);
  timer_->setSingleShot(true);
  connect(timer_, &QTimer::timeout, this, &MessageBar::dismiss);
  connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, &MessageBar::putAway);
  parent->installEventFilter(this);
  hide();
}

QAbstractButton* MessageBar::makeCloseButton() {
  auto* close = new QToolButton(this);
  close->setIcon(icon(QStringLiteral("close")));
  close->setAutoRaise(true);
  close->setFocusPolicy(Qt::TabFocus);
  close->setAccessibleName(tr("Close the message"));
  close->setToolTip(tr("Close the message (Esc)"));
  connect(close, &QToolButton::clicked, this, &MessageBar::putAway);
  return close;
}

void MessageBar::show(Kind kind, const QString& sentence, const std::vector<Answer>& answers) {
  showsQuestion_ = false;
  present({kind, sentence, answers});
}

void MessageBar::ask(Kind kind, const QString& sentence, const std::vector<Answer>& answers) {
  question_ = {kind, sentence, answers};
  showsQuestion_ = true;
  present(*question_);
}

void MessageBar::present(const Message& message) {
  const auto& [kind, sentence, answers] = message;
  symbol_->setPixmap(icon(symbolName(kind)).pixmap(QSize(kSymbol, kSymbol), devicePixelRatioF()));
  sentence_ = sentence;
  text_->setText(breakable(sentence));
  setAnswers(answers);
  if (kind == Kind::information && answers.empty())
    timer_->start(kInformationStays);
  else
    timer_->stop();
  place();
  QFrame::show();
  raise();
  announce(kind);
}

// As wide as the sentence on one line, or as there is room; then as high as its lines.
void MessageBar::place() {
  const QRect room = parentWidget()->rect().adjusted(kDistance, kDistance, -kDistance, -kDistance);
  const int beside = layout_->sizeHint().width() - text_->sizeHint().width();
  const int line = text_->fontMetrics().horizontalAdvance(text_->text()) + 2;
  const int width = std::min({beside + line, kWidest, room.width()});
  const int height = std::max(layout_->totalHeightForWidth(width), layout_->minimumSize().height());
  QRect here(0, 0, width, height);
  here.moveCenter(room.center());
  here.moveBottom(room.bottom());
  setGeometry(here);
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize && !isHidden()) place();
  return QFrame::eventFilter(watched, event);
}

// Solid, with a rim that is seen on black slices and on a light page.
void MessageBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor rim = palette().color(QPalette::ToolTipText);
  rim.setAlphaF(0.45F);
  painter.setPen(rim);
  painter.setBrush(palette().color(QPalette::ToolTipBase));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
}

// It takes no focus, so a screen reader has to be told.
void MessageBar::announce(Kind kind) {
  setAccessibleName(spokenName(kind));
  setAccessibleDescription(sentence_);
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void MessageBar::setAnswers(const std::vector<Answer>& answers) {
  if (answers_) {
    answers_->hide();
    answers_->deleteLater();  // it may be one of its buttons that was pressed
  }
  answers_ = new QWidget(this);
  auto* row = new QHBoxLayout(answers_);
  row->setContentsMargins(0, 0, 0, 0);
  for (const Answer& answer : answers) {
    auto* button = new QPushButton(answer.text, answers_);
    button->setFocusPolicy(Qt::TabFocus);
    button->setMinimumWidth(button->sizeHint().width() + 2 * kBarPadding);
    connect(button, &QPushButton::clicked, this, [this, action = answer.action] {
      putAway();
      action();
    });
    row->addWidget(button);
  }
  layout_->insertWidget(2, answers_);
  answers_->setVisible(!answers.empty());  // now, so that place() counts it
}

QString MessageBar::text() const { return sentence_; }

void MessageBar::dismiss() {
  timer_->stop();
  if (!question_) return hide();
  if (showsQuestion_) return;
  showsQuestion_ = true;
  present(*question_);
}

//! By the user: it is answered, or not to be seen any more.
void MessageBar::putAway() {
  if (showsQuestion_) question_.reset();
  dismiss();
}

}  // namespace handlebody::ui
