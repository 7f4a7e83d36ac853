#include "ui/window/widgets/panel_tools.h"

#include <QAction>
#include <QEvent>
#include <QFormLayout>
#include <QHeaderView>
#include <QRegularExpression>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace handlebody::ui {

namespace {

class WheelGuard : public QObject {
 public:
  using QObject::QObject;

  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
    event->ignore();
    return true;
  }
};

}  // namespace

QVBoxLayout* panelLayout(QWidget* panel) {
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(12, 10, 12, 12);
  layout->setSpacing(8);
  return layout;
}

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  label->setContentsMargins(0, 6, 0, 0);
  return label;
}

QLabel* hint(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  label->setForegroundRole(QPalette::PlaceholderText);
  return label;
}

QFormLayout* panelForm() {
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  form->setFormAlignment(Qt::AlignLeft | Qt::AlignTop);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  return form;
}

QLabel* value(const QString& name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setWordWrap(true);
  label->setAccessibleName(name);
  return label;
}

QLabel* notice(const QString& name, QWidget* parent) {
  QLabel* label = value(name, parent);
  label->setTextFormat(Qt::PlainText);  // an object may be called "<b>1</b>"
  label->setMargin(6);
  label->setAutoFillBackground(true);
  label->setBackgroundRole(QPalette::ToolTipBase);
  label->setForegroundRole(QPalette::ToolTipText);
  return label;
}

QToolButton* smallButton(QAction* action, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setDefaultAction(action);
  button->setFocusPolicy(Qt::TabFocus);
  button->setMinimumSize(30, 30);
  button->setAccessibleName(withoutKey(action->text()));
  return button;
}

QString withoutKey(QString text) {
  static const QRegularExpression added(QStringLiteral(" *\\(&[^)]\\)"));
  return text.remove(added).remove(QLatin1Char('&'));
}

void ignoreWheelWithoutFocus(QWidget* field) {
  field->setFocusPolicy(Qt::StrongFocus);  // a wheel does not give the focus
  field->installEventFilter(new WheelGuard(field));
}

void describe(QWidget* field, const QString& name, const QString& tip) {
  field->setAccessibleName(name);
  field->setAccessibleDescription(tip);
  field->setToolTip(QStringLiteral("<p>%1</p>").arg(tip.toHtmlEscaped()));  // rich text, so that it wraps
}

QTableWidget* listTable(const QStringList& headers, QWidget* parent) {
  auto* table = new QTableWidget(0, static_cast<int>(headers.size()), parent);
  table->setHorizontalHeaderLabels(headers);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->horizontalHeader()->setHighlightSections(false);
  table->verticalHeader()->hide();
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setTabKeyNavigation(false);
  return table;
}

QTableWidgetItem* listCell(const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  item->setToolTip(text.toHtmlEscaped());
  return item;
}

QString pathText(const QString& path, const QFontMetrics& metrics, int width) {
  return metrics.elidedText(path, Qt::ElideMiddle, width).replace(QLatin1Char('&'), QLatin1String("&&"));
}

}  // namespace handlebody::ui
