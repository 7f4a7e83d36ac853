#include "ui/window/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

#include "ui/window/icons.h"
#include "ui/window/sentences.h"

namespace handlebody::ui {

namespace {

constexpr int kInformationStays = 8000;  // ms

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

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), symbol_(new QLabel(this)), text_(new QLabel(this)), timer_(new QTimer(this)) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::ToolTipBase);
  text_->setForegroundRole(QPalette::ToolTipText);
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setAccessibleName(tr("Message"));
  auto* close = new QToolButton(this);
  close->setIcon(icon(QStringLiteral("close")));
  close->setAutoRaise(true);
  close->setFocusPolicy(Qt::TabFocus);
  close->setAccessibleName(tr("Close the message"));
  close->setToolTip(tr("Close the message"));
  layout_ = new QHBoxLayout(this);
  layout_->setContentsMargins(10, 6, 6, 6);
  layout_->addWidget(symbol_, 0, Qt::AlignTop);
  layout_->addWidget(text_, 1);
  layout_->addWidget(close, 0, Qt::AlignTop);
  timer_->setSingleShot(true);
  connect(timer_, &QTimer::timeout, this, &MessageBar::dismiss);
  connect(close, &QToolButton::clicked, this, &MessageBar::dismiss);
  hide();
}

void MessageBar::show(Kind kind, const QString& sentence, const std::vector<Answer>& answers) {
  symbol_->setPixmap(icon(symbolName(kind)).pixmap(QSize(20, 20), devicePixelRatioF()));
  sentence_ = sentence;
  text_->setText(breakable(sentence));
  setAnswers(answers);
  if (kind == Kind::information && answers.empty())
    timer_->start(kInformationStays);
  else
    timer_->stop();
  QFrame::show();
}

void MessageBar::setAnswers(const std::vector<Answer>& answers) {
  if (answers_) answers_->deleteLater();
  answers_ = new QWidget(this);
  auto* row = new QHBoxLayout(answers_);
  row->setContentsMargins(0, 0, 0, 0);
  for (const Answer& answer : answers) {
    auto* button = new QPushButton(answer.text, answers_);
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QPushButton::clicked, this, [this, action = answer.action] {
      dismiss();
      action();
    });
    row->addWidget(button);
  }
  layout_->insertWidget(2, answers_);
}

QString MessageBar::text() const { return sentence_; }

void MessageBar::dismiss() { hide(); }

}  // namespace handlebody::ui
