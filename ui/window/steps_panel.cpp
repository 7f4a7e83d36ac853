#include "ui/window/steps_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr Command kSteps[] = {Command::stepOpen, Command::stepSeed,    Command::stepTune,
                              Command::stepGrow, Command::stepCorrect, Command::stepExport};

// As wide as its panel at least, and room for the scroll bar: nothing is cut off at the right.
class Page : public QScrollArea {
 public:
  using QScrollArea::QScrollArea;

  QSize minimumSizeHint() const override {
    constexpr int kWidest = 420, kHeight = 120;  // pixels; no text of a file may push the views away
    const int width = widget()->minimumSizeHint().width() + style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    return {std::min(width, kWidest), kHeight};
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(watched, event);
  }
};

// With a line under the step that is shown: its ground alone looks like that of a button under the mouse.
class StepButton : public QToolButton {
 public:
  using QToolButton::QToolButton;

  // Six stand side by side: with less room beside the text than a tool button has, the views keep theirs.
  QSize sizeHint() const override {
    constexpr int kBeside = 8;  // pixels
    const int text = fontMetrics().size(Qt::TextShowMnemonic, this->text()).width();
    return {std::max(text, iconSize().width()) + kBeside, QToolButton::sizeHint().height()};
  }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override {
    QToolButton::paintEvent(event);
    constexpr int kLine = 3, kInset = 6;  // pixels
    if (isChecked())
      QPainter(this).fillRect(kInset, height() - kLine, width() - 2 * kInset, kLine,
                              palette().color(QPalette::Highlight));
  }
};

QToolButton* stepButton(QAction* action, QWidget* parent) {
  auto* button = new StepButton(parent);
  button->setDefaultAction(action);
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setAccessibleName(StepsPanel::tr("Step %1").arg(withoutKey(action->text())));
  return button;
}

}  // namespace

StepsPanel::StepsPanel(const Commands& commands, QWidget* parent)
    : QWidget(parent), commands_(commands), pages_(new QStackedWidget(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->setSpacing(4);
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(6, 0, 6, 0);
  bar->setSpacing(2);
  for (Command step : kSteps) {
    bar->addWidget(stepButton(commands_[step], this));
    connect(commands_[step], &QAction::triggered, this, [this, step] { show(step); });
  }
  layout->addLayout(bar);
  layout->addWidget(pages_, 1);
}

void StepsPanel::add(Command step, QWidget* panel) {
  auto* scroll = new Page(pages_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(panel);
  pages_->addWidget(scroll);
  steps_.push_back(step);
}

void StepsPanel::setTop(QWidget* widget) { static_cast<QVBoxLayout*>(layout())->insertWidget(0, widget); }

void StepsPanel::show(Command step) {
  for (std::size_t i = 0; i < steps_.size(); ++i)
    if (steps_[i] == step) pages_->setCurrentIndex(static_cast<int>(i));
  commands_[step]->setChecked(true);
}

Command StepsPanel::shown() const { return steps_[pages_->currentIndex()]; }

}  // namespace handlebody::ui
