#include "ui/window/open/label_choice.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kFewestRows = 4;

//! As the object will be coloured; one whose file says nothing gets a colour of its own when it is opened.
QIcon swatchOf(const FileLabel& label) {
  return label.hasLook() ? swatch(labelledAs(label, {}).colour) : QIcon();
}

QString textOfLabel(const NamedLabel& label) {
  return label.name.empty() ? LabelChoice::tr("Label %1").arg(label.value)
                            : LabelChoice::tr("%1: %2").arg(QString::number(label.value),
                                                            QString::fromStdString(label.name));
}

}  // namespace

LabelChoice::LabelChoice(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* title = new QLabel(tr("&Labels to open"), this);
  list_ = new QListWidget(this);
  list_->setMinimumHeight(kFewestRows * fontMetrics().lineSpacing() + 2 * list_->frameWidth());
  describe(list_, tr("Labels to open"),
           tr("Each that is checked becomes an object, called and coloured as the file says"));
  title->setBuddy(list_);
  setFocusProxy(list_);
  auto* row = new QHBoxLayout;
  row->addWidget(title, 1);
  addButton(row, tr("&All"), tr("Checks all labels"), Qt::Checked);
  addButton(row, tr("&None"), tr("Checks no label"), Qt::Unchecked);
  layout->addLayout(row);
  layout->addWidget(list_, 1);
  connect(list_, &QListWidget::itemChanged, this, &LabelChoice::changed);
}

//! Return answers the dialog, also from here; Space presses the button.
void LabelChoice::addButton(QHBoxLayout* row, const QString& text, const QString& tip, Qt::CheckState state) {
  auto* button = new QPushButton(text, this);
  button->setAutoDefault(false);
  describe(button, withoutKey(text), tip);
  connect(button, &QPushButton::clicked, this, [this, state] { checkAll(state); });
  row->addWidget(button);
}

void LabelChoice::offer(const std::vector<NamedLabel>& labels) {
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const NamedLabel& label : labels) {
    auto* item = new QListWidgetItem(swatchOf(label), textOfLabel(label), list_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Checked);
    item->setData(Qt::UserRole, label.value);
    item->setToolTip(QStringLiteral("<p>%1</p>").arg(item->text().toHtmlEscaped()));
  }
  list_->setCurrentRow(0);
}

std::vector<int> LabelChoice::checked() const {
  std::vector<int> values;
  for (int row = 0; row < list_->count(); ++row)
    if (const QListWidgetItem* item = list_->item(row); item->checkState() == Qt::Checked)
      values.push_back(item->data(Qt::UserRole).toInt());
  return values;
}

void LabelChoice::checkAll(Qt::CheckState state) {
  {
    const QSignalBlocker quiet(list_);
    for (int row = 0; row < list_->count(); ++row) list_->item(row)->setCheckState(state);
  }
  list_->viewport()->update();
  Q_EMIT changed();
}

}  // namespace handlebody::ui
