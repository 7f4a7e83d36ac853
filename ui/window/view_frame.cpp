#include "ui/window/view_frame.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/window/icons.h"

namespace handlebody::ui {

namespace {
constexpr int kTitleHeight = 24;
constexpr int kStripe = 3;
}  // namespace

ViewFrame::ViewFrame(const QString& name, const QColor& colour, QWidget* view, QWidget* parent)
    : QWidget(parent), name_(name), colour_(colour), button_(new QToolButton(this)) {
  auto* title = new QHBoxLayout;
  title->setContentsMargins(8, kStripe, 2, 0);
  auto* label = new QLabel(name, this);
  title->addWidget(label);
  title->addStretch();
  title->addWidget(button_);
  button_->setAutoRaise(true);
  button_->setFocusPolicy(Qt::TabFocus);
  button_->setIconSize(QSize(14, 14));
  button_->setFixedSize(22, kTitleHeight - kStripe);
  connect(button_, &QToolButton::clicked, this, &ViewFrame::maximiseRequested);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(title);
  layout->addWidget(view, 1);
  setMinimumSize(160, 120);
  setMaximised(false);
}

void ViewFrame::setMaximised(bool maximised) {
  button_->setIcon(icon(maximised ? QStringLiteral("restore") : QStringLiteral("maximise")));
  button_->setToolTip(maximised ? tr("Show all four views (double click)")
                                : tr("Let this view fill the window (double click)"));
  button_->setAccessibleName(maximised ? tr("Show all four views") : tr("Maximise the %1 view").arg(name_));
}

void ViewFrame::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(QRect(0, 0, width(), kStripe), colour_);
}

}  // namespace handlebody::ui
