#include "ui/window/widgets/toggle_button.h"

#include <QAction>
#include <QPainter>

#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {
constexpr int kAside = 7, kAbove = 6;  // pixels between text and rim
constexpr double kRound = 3;
}  // namespace

ToggleButton::ToggleButton(const QString& text, QWidget* parent) : QToolButton(parent) {
  setText(text);
  setCheckable(true);
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
}

QSize ToggleButton::sizeHint() const {
  const QFontMetrics metrics = fontMetrics();
  return {metrics.horizontalAdvance(text()) + 2 * kAside + 2, metrics.height() + 2 * kAbove};
}

QColor ToggleButton::ground() const {
  const QPalette& p = palette();
  if (!isEnabled()) return p.color(isChecked() ? QPalette::Button : QPalette::Window);
  if (isChecked()) return p.color(QPalette::Highlight);
  return isDown() ? p.color(QPalette::Button).darker(110) : p.color(QPalette::Button);
}

QColor ToggleButton::rim() const {
  const QPalette& p = palette();
  if (isEnabled() && hasFocus()) return p.color(QPalette::Link);
  if (isEnabled() && underMouse()) return p.color(QPalette::Highlight);
  QColor faint = p.color(QPalette::WindowText);
  faint.setAlphaF(0.35F);
  return faint;
}

void ToggleButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double line = isEnabled() && hasFocus() ? 2 : 1;
  painter.setPen(QPen(rim(), line));
  painter.setBrush(ground());
  const double inset = line / 2;
  painter.drawRoundedRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset), kRound, kRound);
  const bool lit = isEnabled() && isChecked();
  painter.setPen(palette().color(lit ? QPalette::HighlightedText : QPalette::ButtonText));
  painter.drawText(rect(), Qt::AlignCenter, text());
}

ToggleButton* toggleFor(QAction* action, QWidget* parent, const QString& text) {
  const QString name = withoutKey(action->text());
  auto* button = new ToggleButton(text.isEmpty() ? name : text, parent);
  button->setAccessibleName(name);
  button->setAccessibleDescription(action->statusTip());
  button->setToolTip(action->toolTip());
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  const auto follow = [button, action] {
    button->setChecked(action->isChecked());
    button->setEnabled(action->isEnabled());
  };
  QObject::connect(button, &QToolButton::clicked, action, &QAction::trigger);
  QObject::connect(action, &QAction::changed, button, follow);
  follow();
  return button;
}

}  // namespace handlebody::ui
