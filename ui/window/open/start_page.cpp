#include "ui/window/open/start_page.h"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/window/commands.h"
#include "ui/window/widgets/action_button.h"
#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kMaxShown = 6;
constexpr int kPageWidth = 460;

QLabel* title(QWidget* parent) {
  auto* label = new QLabel(StartPage::tr("Open a volume to begin"), parent);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * 1.5);
  label->setFont(font);
  label->setAlignment(Qt::AlignHCenter);
  return label;
}

QLabel* symbol(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setPixmap(programIcon().pixmap(QSize(72, 72), parent->devicePixelRatioF()));
  label->setAlignment(Qt::AlignHCenter);
  return label;
}

}  // namespace

StartPage::StartPage(const Commands& commands, QWidget* parent)
    : QWidget(parent), recent_(new QWidget(this)), recentLayout_(new QVBoxLayout(recent_)) {
  auto* column = new QWidget(this);
  column->setFixedWidth(kPageWidth);
  auto* layout = new QVBoxLayout(column);
  layout->setSpacing(10);
  layout->addWidget(symbol(column));
  layout->addWidget(title(column));
  QLabel* text = hint(tr("Drop a CT, MR or ultrasound volume here, or choose one."), column);
  text->setAlignment(Qt::AlignHCenter);
  layout->addWidget(text);
  layout->addWidget(new ActionButton(commands[Command::openFile], column));
  layout->addWidget(new ActionButton(commands[Command::openFolder], column));
  auto* sample = new QPushButton(tr("Try the ultrasound sample"), column);
  sample->setMinimumHeight(30);
  sample->setToolTip(tr("A simulated cyst with a needle through it, with its seed placed"));
  connect(sample, &QPushButton::clicked, this, &StartPage::sampleRequested);
  layout->addWidget(sample);
  recentLayout_->setContentsMargins(0, 8, 0, 0);
  recentLayout_->setSpacing(2);
  layout->addWidget(recent_);

  auto* outer = new QVBoxLayout(this);
  outer->addStretch(1);
  auto* row = new QHBoxLayout;  // not by alignment: that asks for no height of wrapped text
  row->addStretch();
  row->addWidget(column);
  row->addStretch();
  outer->addLayout(row);
  outer->addStretch(2);
}

void StartPage::setRecent(const QStringList& paths) {
  qDeleteAll(recent_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
  if (!paths.isEmpty()) recentLayout_->addWidget(heading(tr("Opened before"), recent_));
  for (const QString& path : paths.mid(0, kMaxShown)) {
    auto* button = new QToolButton(recent_);
    button->setText(pathText(QFileInfo(path).fileName(), button->fontMetrics(), kPageWidth - 40));
    button->setToolTip(path);
    button->setAccessibleName(tr("Open %1").arg(path));
    button->setAutoRaise(true);
    button->setCursor(Qt::PointingHandCursor);
    connect(button, &QToolButton::clicked, this, [this, path] { Q_EMIT openRequested(path); });
    recentLayout_->addWidget(button);
  }
}

}  // namespace handlebody::ui
