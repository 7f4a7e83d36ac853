#include "ui/window/correct/correct_panel.h"

#include <QLabel>
#include <QVBoxLayout>

#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

CorrectPanel::CorrectPanel(QWidget* parent) : QWidget(parent) { panelLayout(this)->addStretch(); }

void CorrectPanel::addSection(const QString& title, const QString& help, QWidget* controls) {
  auto* all = qobject_cast<QVBoxLayout*>(layout());
  int at = all->count() - 1;  // before the stretch
  for (QWidget* part :
       {static_cast<QWidget*>(heading(title, this)), static_cast<QWidget*>(hint(help, this)), controls})
    all->insertWidget(at++, part);
}

}  // namespace handlebody::ui
