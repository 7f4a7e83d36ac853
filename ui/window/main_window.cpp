#include "ui/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFile>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QStackedWidget>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/view/slice_view.h"
#include "ui/view/surface_view.h"
#include "ui/window/correct/correct_panel.h"
#include "ui/window/correct/local_section.h"
#include "ui/window/correct/tunnels_list.h"
#include "ui/window/correct/wall_section.h"
#include "ui/window/export/export_panel.h"
#include "ui/window/grow/grow_panel.h"
#include "ui/window/grow/held_section.h"
#include "ui/window/grow/topology_section.h"
#include "ui/window/grow/touch_section.h"
#include "ui/window/help/help_window.h"
#include "ui/window/menus.h"
#include "ui/window/objects/objects_panel.h"
#include "ui/window/open/file_work.h"
#include "ui/window/open/open_panel.h"
#include "ui/window/open/start_page.h"
#include "ui/window/seed/seed_panel.h"
#include "ui/window/steps_panel.h"
#include "ui/window/time/time_bar.h"
#include "ui/window/timeline/event_inspector.h"
#include "ui/window/timeline/timeline_panel.h"
#include "ui/window/tune/tune_panel.h"
#include "ui/window/views/status_fields.h"
#include "ui/window/views/view_grid.h"
#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/key_guard.h"
#include "ui/window/widgets/label_face.h"
#include "ui/window/widgets/message_bar.h"
#include "ui/window/widgets/panel_area.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

bool isDicomFile(const QString& path) {
  constexpr int kPreamble = 128;  // bytes before the mark
  QFile file(path);
  return file.open(QIODevice::ReadOnly) && file.read(kPreamble + 4).endsWith("DICM");
}

//! Of several files of one folder, the first of which is DICOM: they are meant as a series. Else empty.
QString folderOfSlices(const QList<QUrl>& urls) {
  if (urls.size() < 2 || !isDicomFile(urls.front().toLocalFile())) return {};
  const auto folderOf = [](const QUrl& url) { return QFileInfo(url.toLocalFile()).absolutePath(); };
  const QString folder = folderOf(urls.front());
  const bool isOne =
      std::all_of(urls.begin(), urls.end(), [&](const QUrl& url) { return folderOf(url) == folder; });
  return isOne ? folder : QString();
}

}  // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), commands_(document_.undoStack(), nullptr) {
  readLabelsWithTheirValues();
  setWindowIcon(programIcon());
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  buildCentre();
  buildDocks();
  buildStatusBar();
  files_ = new FileWork(document_, *views_, *export_, *messages_, this);
  const OpenMenus menus = buildMenus(*this, commands_);
  recent_ = menus.recent;
  panels_ = menus.panels;
  for (QDockWidget* dock : {stepsDock_, timelineDock_, overTimeDock_, measuresDock_})
    panels_->addAction(dock->toggleViewAction());
  buildToolbar(*this, commands_);
  connectFileCommands();
  connectViewCommands();
  connectDisplayCommands();
  connectSeedCommands();
  connectGrowCommands();
  connectCorrectCommands();
  connectObjectCommands();
  connectTimeCommands();
  connectMeasureCommands();
  connectHelpCommands();
  connect(&document_, &Document::opened, this, &MainWindow::showOpened);
  connect(&document_, &Document::openFailed, this, &MainWindow::sayDropFailed);
  connect(&document_, &Document::openingCancelled, this, &MainWindow::forgetDrop);
  connect(&document_, &Document::seriesChoiceNeeded, this, &MainWindow::forgetDrop);
  connect(&document_, &Document::fileNeeded, this, &MainWindow::forgetDrop);
  connect(&document_, &Document::opening, this, [this](const QString& path) {
    if (path != dropped_) forgetDrop();
  });
  connect(&document_, &Document::modifiedChanged, this, &MainWindow::updateTitle);
  connect(files_, &FileWork::recentChanged, this, &MainWindow::fillRecent);
  connect(files_, &FileWork::aboutToSave, this, &MainWindow::keepView);
  qApp->installEventFilter(new KeyGuard(this));
  fillRecent();
  restoreSettings();
  updateCommands();
  updateTitle();
}

// The views and panels use the document and the state, which are members and would die first.
MainWindow::~MainWindow() {
  delete help_;
  delete centralWidget();
  delete stepsDock_;
  delete timelineDock_;
  delete overTimeDock_;
  delete measuresDock_;
}

void MainWindow::buildCentre() {
  auto* centre = new QWidget(this);
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  centre_ = new QStackedWidget(centre);
  start_ = new StartPage(commands_, centre_);
  views_ = new ViewGrid(document_, state_, centre_);
  centre_->addWidget(start_);
  centre_->addWidget(views_);
  layout->addWidget(centre_, 1);
  layout->addWidget(new TimeBar(document_, commands_, centre));
  messages_ = new MessageBar(centre_);  // not over the bar of the frames
  setCentralWidget(centre);
}

void MainWindow::buildDocks() {
  steps_ = new StepsPanel(commands_);
  steps_->setTop(new ObjectsPanel(document_, commands_, steps_));
  open_ = new OpenPanel(document_, commands_);
  steps_->add(Command::stepOpen, open_);
  steps_->add(Command::stepSeed, new SeedPanel(document_, state_, commands_));
  steps_->add(Command::stepTune, new TunePanel(document_, state_));
  grow_ = new GrowPanel(document_, views_->surface(), commands_);
  steps_->add(Command::stepGrow, grow_);
  buildCorrectPanel();
  export_ = new ExportPanel(document_, commands_);
  steps_->add(Command::stepExport, export_);
  steps_->show(Command::stepOpen);
  stepsDock_ = new QDockWidget(tr("Steps"), this);
  stepsDock_->setObjectName(QStringLiteral("steps"));
  stepsDock_->setWidget(steps_);
  addDockWidget(Qt::LeftDockWidgetArea, stepsDock_);

  timeline_ = new TimelinePanel(document_);
  connect(timeline_, &TimelinePanel::eventChosen, this, &MainWindow::goToEvent);
  connect(&document_, &Document::leaked, this, &MainWindow::showLeak);
  connect(&document_, &Document::leakedElsewhere, this, &MainWindow::tellLeakOf);
  connect(&document_, &Document::asked, this, &MainWindow::showQuestion);
  connect(&document_, &Document::askedElsewhere, this, &MainWindow::tellQuestionOf);
  connect(&grow_->topology(), &TopologySection::answered, this, &MainWindow::answerQuestion);
  timelineDock_ = new QDockWidget(tr("Timeline"), this);
  timelineDock_->setObjectName(QStringLiteral("timeline"));
  timelineDock_->setWidget(new PanelArea(timeline_));
  addDockWidget(Qt::BottomDockWidgetArea, timelineDock_);
  buildTime();
  buildMeasures();
}

// The sections stand in the order in which they are added.
void MainWindow::buildCorrectPanel() {
  auto* panel = new CorrectPanel;
  panel->addSection(tr("Walls"),
                    tr("Paint in the slices where the surface may not go, from the shown iteration on. "
                       "Ctrl+wheel changes the radius."),
                    new WallSection(document_, state_, commands_));
  panel->addSection(
      tr("On the surface"),
      tr("With the brush, in the slices and in 3D: drag to pin or unpin, click to smooth, drag a "
         "point to pull it. The radius is the same. A line drawn across it in a slice cuts it."),
      new TouchSection(document_, state_, commands_));
  panel->addSection(
      tr("Held back"),
      tr("Limits, vetoes, pins and discs. The crosshair goes to the chosen one; lifted, it holds no more "
         "from the shown iteration on."),
      new HeldSection(document_, state_));
  auto* local = new LocalSection(document_, state_, commands_);
  panel->addSection(tr("At the crosshair"),
                    tr("A pin holds the surface in a ball. To smooth, pull and cut is the next step."),
                    local);
  connect(local, &LocalSection::pinned, this, [this] {
    messages_->show(MessageBar::Kind::information,
                    tr("The surface is pinned here from iteration %1 on.").arg(document_.iteration()));
  });
  panel->addSection(
      tr("Tunnels and pieces"),
      tr("What the shown surface holds, and what can be done to it: each edit is the next step."),
      new TunnelsList(document_, state_));
  connect(&document_, &Document::meshEdited, this, &MainWindow::tellOfEdit);
  steps_->add(Command::stepCorrect, panel);
}

void MainWindow::buildStatusBar() {
  status_ = new StatusFields(statusBar(), document_);
  for (Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) {
    connect(&views_->slice(plane), &SliceView::hovered, status_, &StatusFields::showCursor);
    connect(&views_->slice(plane), &SliceView::left, status_, &StatusFields::clearCursor);
  }
}

EventInspector& MainWindow::inspector() { return grow_->inspector(); }

void MainWindow::showStep(Command step) { steps_->show(step); }

void MainWindow::goToEvent(int index) {
  if (index < 0 || index >= static_cast<int>(document_.events().size())) return;
  const Event event = document_.events()[index];
  if (document_.iteration() != event.iteration) document_.goTo(event.iteration);
  state_.setCrosshair(event.location);
  grow_->inspector().setEvent(index);
  timeline_->setEvent(index);
}

void MainWindow::fillRecent() {
  recent_->clear();
  const QStringList paths = files_->recent();
  constexpr int kWidest = 300;  // pixels, of the name and of the folder
  const auto shown = [this](const QString& part) { return pathText(part, recent_->fontMetrics(), kWidest); };
  for (const QString& path : paths) {
    const QFileInfo file(path);
    recent_->addAction(shown(file.fileName()) + QStringLiteral("  —  ") + shown(file.absolutePath()), this,
                       [this, path] { files_->open(path); });
  }
  recent_->setEnabled(!paths.isEmpty());
  start_->setRecent(paths);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->setAccepted(files_->mayClose());
  if (!event->isAccepted()) return;
  saveSettings();
  if (help_) help_->close();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (urls.isEmpty()) return;
  event->acceptProposedAction();
  const QString folder = folderOfSlices(urls);
  const bool isOnlyFirst = urls.size() > 1 && folder.isEmpty();
  const QString note =
      tr("Several files were dropped; the first one is opened. For a DICOM series drop its folder.");
  if (isOnlyFirst) messages_->show(MessageBar::Kind::warning, note);
  dropped_ = folder.isEmpty() ? urls.front().toLocalFile() : folder;
  forgetDrop();
  files_->open(dropped_);
  // What is said before goes when a volume is there: told once more, with what came of it.
  if (isOnlyFirst && document_.isOpening()) dropNote_ = note;
}

void MainWindow::sayDropFailed(const QString& sentence, bool needsSpacing) {
  if (const QString note = std::exchange(dropNote_, {}); !note.isEmpty() && !needsSpacing)
    messages_->show(MessageBar::Kind::error, sentence + QLatin1Char(' ') + note);
}

// Icons are drawn in the colour of the text, which Qt does not know of.
void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update();
}

}  // namespace handlebody::ui
