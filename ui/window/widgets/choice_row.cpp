#include "ui/window/widgets/choice_row.h"

#include <QButtonGroup>
#include <QHBoxLayout>

#include "ui/window/widgets/panel_tools.h"
#include "ui/window/widgets/toggle_button.h"

namespace handlebody::ui {

QWidget* choiceRow(const QString& name, const QStringList& texts, const QStringList& tips,
                   QButtonGroup*& group, QWidget* parent) {
  auto* row = new QWidget(parent);
  row->setAccessibleName(name);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  group = new QButtonGroup(row);
  for (int i = 0; i < texts.size(); ++i) {
    auto* button = new ToggleButton(texts[i], row);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    describe(button, QStringLiteral("%1: %2").arg(name, texts[i]), tips[i]);
    group->addButton(button, i);
    layout->addWidget(button);
  }
  // Tab comes to the choice that holds, also where it was not made by hand; Qt sees to that by hand only.
  QObject::connect(group, &QButtonGroup::idToggled, row, [group = group](int id, bool on) {
    group->button(id)->setFocusPolicy(on ? Qt::StrongFocus : Qt::ClickFocus);
  });
  return row;
}

}  // namespace handlebody::ui
