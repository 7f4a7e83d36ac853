#pragma once
// The frame: views in the middle, the steps at the left, the timeline below, menus, toolbar and status bar.

#include <QMainWindow>
#include <functional>
#include <memory>

#include "ui/model/document.h"
#include "ui/view/view_state.h"
#include "ui/window/commands.h"
#include "ui/window/widgets/appearance.h"

class QDockWidget;
class QMenu;
class QStackedWidget;

namespace handlebody::ui {

class EventInspector;
class ExportPanel;
class FileWork;
class GrowPanel;
class HelpWindow;
class MeasuresPanel;
class MessageBar;
class OpenPanel;
class OverTimePanel;
class StartPage;
class StatusFields;
class StepsPanel;
class TimelinePanel;
class ViewGrid;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  Document& document() { return document_; }
  ViewState& viewState() { return state_; }
  ViewGrid& views() { return *views_; }
  FileWork& files() { return *files_; }
  const Commands& commands() const { return commands_; }
  EventInspector& inspector();
  MessageBar& messages() { return *messages_; }
  MeasuresPanel& measures() { return *measures_; }
  OverTimePanel& overTime() { return *overTime_; }

  void showStep(Command step);
  void setAppearance(Appearance appearance);
  //! Time, all views and the inspector go to an event (index into Document::events()).
  void goToEvent(int index);
  //! Recovery of lost work, and at the first start what the program is for.
  void greet();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void buildCentre();
  void buildDocks();
  void buildCorrectPanel();
  void buildStatusBar();
  void fillRecent();
  // main_window_commands.cpp
  void connectFileCommands();
  void connectViewCommands();
  void connectDisplayCommands();
  void connectLanguageCommands();
  void connectSeedCommands();
  void connectGrowCommands();
  void connectHelpCommands();
  void on(Command id, std::function<void()> action);
  void addSeedAtCrosshair(bool outside);
  void resizeSelectedSeed(double direction);
  void selectNextSeed();
  void seekEvent(bool next);
  void updateCommands();
  // main_window_objects.cpp
  void connectObjectCommands();
  void showObject();
  void updateObjectCommands();
  void showLayout();
  void showViewState();
  // main_window_session.cpp
  void restoreSettings();
  void saveSettings();
  void showOpened();
  void sayDropFailed(const QString& sentence, bool needsSpacing);
  void forgetDrop() { dropNote_.clear(); }
  // main_window_measures.cpp
  void buildMeasures();
  void connectMeasureCommands();
  void showMeasures();
  void updateMeasureCommands();
  // main_window_time.cpp
  void buildTime();
  void connectTimeCommands();
  void showOverTime();
  void growHere();
  void updateTimeCommands();
  // main_window_edits.cpp
  void tellOfEdit();
  // main_window_leaks.cpp
  bool goToObject(const std::weak_ptr<const void>& object);
  void showLeak(int index);
  void showQuestion();
  void answerQuestion(const HeldPlace& held, bool allows);
  void tellQuestionOf(int object);
  void offerObject(int object, const QString& text, const std::function<void()>& show);
  // main_window_walls.cpp
  void connectCorrectCommands();
  void brushAtCrosshair(bool erases);
  void showWallConflict();
  void updateWallCommands();
  void tellLeakOf(int object);
  void keepView();
  void restoreView();
  void updateTitle();

  Document document_;
  ViewState state_;
  Commands commands_;
  ViewGrid* views_ = nullptr;
  StartPage* start_ = nullptr;
  QStackedWidget* centre_ = nullptr;
  MessageBar* messages_ = nullptr;
  StepsPanel* steps_ = nullptr;
  OpenPanel* open_ = nullptr;
  ExportPanel* export_ = nullptr;
  GrowPanel* grow_ = nullptr;
  TimelinePanel* timeline_ = nullptr;
  MeasuresPanel* measures_ = nullptr;
  OverTimePanel* overTime_ = nullptr;
  StatusFields* status_ = nullptr;
  FileWork* files_ = nullptr;
  HelpWindow* help_ = nullptr;
  QDockWidget *stepsDock_ = nullptr, *timelineDock_ = nullptr, *measuresDock_ = nullptr,
              *overTimeDock_ = nullptr;
  QMenu *recent_ = nullptr, *panels_ = nullptr;
  QString dropped_;   //!< what was dropped last
  QString dropNote_;  //!< that it was one of several files; empty: it was not, or it is told
  Appearance appearance_ = Appearance::system;
  bool justOpened_ = false;    //!< the views are as the session says
  bool seekingEvent_ = false;  //!< N or P was pressed: the views follow to the event that is reached
};

}  // namespace handlebody::ui
