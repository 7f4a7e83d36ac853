#include "ui/window/widgets/action_button.h"

#include <QAction>

#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {
constexpr int kHeight = 30;
}

ActionButton::ActionButton(QAction* action, QWidget* parent) : QPushButton(parent), action_(action) {
  setFocusPolicy(Qt::TabFocus);
  setMinimumHeight(kHeight);
  connect(this, &QPushButton::clicked, action_, &QAction::trigger);
  connect(action_, &QAction::changed, this, &ActionButton::follow);
  follow();
}

void ActionButton::setOwnText(const QString& text) {
  ownText_ = text;
  follow();
}

void ActionButton::follow() {
  const QString text = ownText_.isEmpty() ? withoutKey(action_->text()) : ownText_;
  setText(text);
  setAccessibleName(text);
  setIcon(action_->icon());
  setToolTip(action_->toolTip());
  setEnabled(action_->isEnabled());
}

}  // namespace handlebody::ui
