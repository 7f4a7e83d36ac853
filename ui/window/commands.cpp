#include "ui/window/commands.h"

#include <QActionGroup>
#include <QUndoStack>

#include "ui/model/translate.h"
#include "ui/window/widgets/icons.h"

namespace handlebody::ui {

namespace {

QList<QKeySequence> keysOf(const CommandSpec& spec) {
  QList<QKeySequence> keys;
  const auto texts = QString::fromLatin1(spec.keys).split(QStringLiteral("; "), Qt::SkipEmptyParts);
  for (const QString& text : texts) keys << QKeySequence(text, QKeySequence::PortableText);
  return keys;
}

bool belongsToSurfaceView(Command id) {
  return id == Command::lookFromAbove || id == Command::lookFromFront || id == Command::lookFromLeft;
}

//! Those that go on by a little each time. A key that is held a moment too long is no second command else.
bool repeats(Command id) {
  switch (id) {
    case Command::undo:
    case Command::redo:
    case Command::growSeed:
    case Command::shrinkSeed:
    case Command::largerBrush:
    case Command::smallerBrush:
    case Command::stepForward:
    case Command::stepBack:
    case Command::previousFrame:
    case Command::nextFrame:
      return true;
    default:
      return false;
  }
}

QString tipOf(const QAction& action) {
  const QString keys = Commands::keysText(action);
  return QStringLiteral("<p>%1%2</p>")
      .arg(action.statusTip().toHtmlEscaped(),
           keys.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(keys.toHtmlEscaped()));
}

}  // namespace

Commands::Commands(QUndoStack* undoStack, QObject* parent) : QObject(parent) {
  for (const CommandSpec& spec : table()) actions_[spec.id] = make(spec, undoStack);
}

QAction* Commands::make(const CommandSpec& spec, QUndoStack* undoStack) {
  QAction* action = nullptr;
  if (spec.id == Command::undo)
    action = undoStack->createUndoAction(this, translated(spec.text));
  else if (spec.id == Command::redo)
    action = undoStack->createRedoAction(this, translated(spec.text));
  else
    action = new QAction(translated(spec.text), this);
  action->setShortcuts(keysOf(spec));
  action->setAutoRepeat(repeats(spec.id));
  if (belongsToSurfaceView(spec.id)) action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  if (*spec.icon) action->setIcon(icon(QString::fromLatin1(spec.icon)));
  action->setStatusTip(translated(spec.tip));
  action->setToolTip(tipOf(*action));
  action->setCheckable(spec.kind != CommandSpec::plain);
  if (spec.kind == CommandSpec::choice) exclude(spec, action);
  return action;
}

void Commands::setHindrance(Command id, const QString& why) {
  QAction* action = actions_.at(id);
  const QString tip = tipOf(*action);
  action->setToolTip(why.isEmpty() ? tip : tip + QStringLiteral("<p>%1</p>").arg(why.toHtmlEscaped()));
}

void Commands::exclude(const CommandSpec& spec, QAction* action) {
  QActionGroup*& group = groups_[QString::fromLatin1(spec.submenu)];
  if (!group) group = new QActionGroup(this);
  group->addAction(action);
}

QString Commands::translated(const char* text) { return ui::tr(text); }

QString Commands::keysText(const QAction& action) {
  return action.shortcut().toString(QKeySequence::NativeText);
}

}  // namespace handlebody::ui
