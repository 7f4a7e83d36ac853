#pragma once
// Every command of the window in one table: text, keys, icon, tip. Menus, toolbar, panels and the page of
// shortcuts are made from it, so that none of them can leave one out.

#include <QAction>
#include <QObject>
#include <map>
#include <vector>

class QActionGroup;
class QUndoStack;

namespace handlebody::ui {

enum class Command {
  openFile,
  openFolder,
  openObjects,
  saveSession,
  saveSessionAs,
  exportResult,
  exportReport,
  exportAnonymousSession,
  exportPicture,
  quit,
  undo,
  redo,
  fourViews,
  onlyAxial,
  onlyCoronal,
  onlySagittal,
  onlySurface,
  resetViews,
  lookFromAbove,
  lookFromFront,
  lookFromLeft,
  windowLevelTool,
  autoWindow,
  windowSoftTissue,
  windowLung,
  windowBone,
  windowBrain,
  windowVessels,
  mapGrey,
  mapInverted,
  mapHot,
  mapContrast,
  meshPlain,
  meshEdges,
  meshState,
  meshSupport,
  slicesIn3d,
  wallsAndPins,
  stepOpen,
  stepSeed,
  stepTune,
  stepGrow,
  stepCorrect,
  stepExport,
  coloursOfSystem,
  coloursLight,
  coloursDark,
  languageOfSystem,
  languageEnglish,
  languageGerman,
  languageFrench,
  languageSpanish,
  languageChinese,
  fullScreen,
  addSeed,
  addOutside,
  deleteSeed,
  growSeed,
  shrinkSeed,
  nextSeed,
  smallerObject,
  largerObject,
  run,
  stepForward,
  stepBack,
  nextEvent,
  previousEvent,
  toStart,
  toEnd,
  paintWalls,
  eraseWalls,
  largerBrush,
  smallerBrush,
  wallAtCrosshair,
  eraseAtCrosshair,
  goOnBeforeWalls,
  removeWalls,
  pinByBrush,
  unpinByBrush,
  smoothByBrush,
  pullByDragging,
  cutByLine,
  removePins,
  pinHere,
  smoothHere,
  pullHere,
  cutHere,
  addObject,
  duplicateObject,
  deleteObject,
  editObject,
  moveObjectUp,
  moveObjectDown,
  nextObject,
  previousObject,
  objectVisible,
  objectLocked,
  growAll,
  playFrames,
  previousFrame,
  nextFrame,
  toGrownFrame,
  growHere,
  carryOverTime,
  correctFrame,
  endCorrection,
  leaveCorrection,
  showOverTime,
  exportFrameMeshes,
  exportFrameLabels,
  showMeasures,
  ruler,
  angle,
  centreLine,
  sensitivity,
  guide,
  shortcuts,
  about,
};

//! One row of the table.
struct CommandSpec {
  Command id;
  const char* menu;  //!< top menu, untranslated
  const char*
      submenu;  //!< empty: directly in the menu; commands of one submenu with a group exclude each other
  const char* text;
  const char* keys;  //!< portable text; several are separated by "; "
  const char* icon;  //!< empty: none
  const char* tip;
  enum Kind { plain, toggle, choice } kind;
  bool separatorBefore;
};

class Commands : public QObject {
  Q_OBJECT

 public:
  Commands(QUndoStack* undoStack, QObject* parent);

  QAction* operator[](Command id) const { return actions_.at(id); }
  //! Its tip says why it cannot be used now; empty: nothing of the kind.
  void setHindrance(Command id, const QString& why);
  //! In the order of the menus.
  static const std::vector<CommandSpec>& table();
  static QString translated(const char* text);
  //! The keys of a command as they are written on this system, "Ctrl+O".
  static QString keysText(const QAction& action);

 private:
  QAction* make(const CommandSpec& spec, QUndoStack* undoStack);
  void exclude(const CommandSpec& spec, QAction* action);

  std::map<Command, QAction*> actions_;
  std::map<QString, QActionGroup*> groups_;
};

}  // namespace handlebody::ui
