#include "ui/window/menus.h"

#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <map>

#include "ui/model/translate.h"
#include "ui/window/commands.h"
#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kIcon = 20;  // logical pixels

QMenu* submenu(QMenu& menu, const QString& title, std::map<QString, QMenu*>& known) {
  QMenu*& sub = known[menu.title() + title];
  if (!sub) sub = menu.addMenu(title);
  return sub;
}

void addSpecialMenus(const CommandSpec& last, QMenu& menu, OpenMenus& special) {
  if (last.id == Command::openFolder) {
    special.recent = menu.addMenu(tr("Open &recent"));
    special.recent->setEnabled(false);
  }
  if (last.id == Command::stepExport) special.panels = menu.addMenu(tr("&Panels"));
}

}  // namespace

OpenMenus buildMenus(QMainWindow& window, const Commands& commands) {
  OpenMenus special;
  std::map<QString, QMenu*> menus, submenus;
  for (const CommandSpec& spec : Commands::table()) {
    QMenu*& menu = menus[QString::fromLatin1(spec.menu)];
    if (!menu) menu = window.menuBar()->addMenu(Commands::translated(spec.menu));
    if (spec.separatorBefore) menu->addSeparator();
    QMenu* target = *spec.submenu ? submenu(*menu, Commands::translated(spec.submenu), submenus) : menu;
    target->addAction(commands[spec.id]);
    addSpecialMenus(spec, *menu, special);
  }
  return special;
}

void buildToolbar(QMainWindow& window, const Commands& commands) {
  auto* bar = new QToolBar(tr("Tools"), &window);
  bar->setObjectName(QStringLiteral("tools"));
  bar->setIconSize(QSize(kIcon, kIcon));
  bar->setMovable(false);
  const std::vector<std::vector<Command>> groups{
      {Command::openFile, Command::openFolder, Command::saveSession},
      {Command::undo, Command::redo},
      {Command::addSeed, Command::addOutside, Command::deleteSeed, Command::shrinkSeed, Command::growSeed},
      {Command::toStart, Command::previousEvent, Command::stepBack, Command::run, Command::stepForward,
       Command::nextEvent},
      {Command::windowLevelTool, Command::autoWindow},
      {Command::fourViews, Command::resetViews},
      {Command::exportResult, Command::exportPicture},
      {Command::guide}};
  for (const auto& group : groups) {
    if (!bar->actions().isEmpty()) bar->addSeparator();
    for (Command id : group) {
      bar->addAction(commands[id]);
      QWidget* button = bar->widgetForAction(commands[id]);
      button->setFocusPolicy(Qt::TabFocus);
      button->setAccessibleName(withoutKey(commands[id]->text()));
    }
  }
  window.addToolBar(bar);
}

}  // namespace handlebody::ui
