#pragma once
// Menus and toolbar, made from the table of commands.

#include <QMainWindow>

class QMenu;

namespace handlebody::ui {

class Commands;

//! The menus that somebody fills later.
struct OpenMenus {
  QMenu* recent = nullptr;  //!< File ▸ Open recent
  QMenu* panels = nullptr;  //!< View ▸ Panels
};

OpenMenus buildMenus(QMainWindow& window, const Commands& commands);
void buildToolbar(QMainWindow& window, const Commands& commands);

}  // namespace handlebody::ui
