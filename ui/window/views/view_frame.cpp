#include "ui/window/views/view_frame.h"

#include <QToolButton>
#include <QVBoxLayout>

#include "ui/window/widgets/icons.h"

namespace handlebody::ui {

namespace {

constexpr int kButton = 24;
constexpr int kMargin = 8;

// On black in both appearances.
const char* const kStyle =
    "QToolButton { border: none; border-radius: 4px; background: rgba(0, 0, 0, 90); }"
    "QToolButton:hover, QToolButton:focus { background: rgba(120, 130, 140, 160); }";

}  // namespace

ViewFrame::ViewFrame(const QString& name, QWidget* view, QWidget* parent)
    : QWidget(parent), name_(name), button_(new QToolButton(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(view);
  button_->setStyleSheet(QString::fromLatin1(kStyle));
  button_->setFocusPolicy(Qt::TabFocus);
  button_->setIconSize(QSize(16, 16));
  button_->setFixedSize(kButton, kButton);
  button_->raise();
  connect(button_, &QToolButton::clicked, this, &ViewFrame::maximiseRequested);
  setMinimumSize(160, 120);
  setMaximised(false);
}

void ViewFrame::setMaximised(bool maximised) {
  button_->setIcon(iconOnBlack(maximised ? QStringLiteral("restore") : QStringLiteral("maximise")));
  button_->setToolTip(maximised ? tr("Show all four views (double click)")
                                : tr("Let this view fill the window (double click)"));
  button_->setAccessibleName(maximised ? tr("Show all four views") : tr("Maximise the %1 view").arg(name_));
}

void ViewFrame::resizeEvent(QResizeEvent*) { button_->move(width() - kButton - kMargin, kMargin); }

}  // namespace handlebody::ui
