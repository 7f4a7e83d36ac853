// What the commands of the window do.

#include <algorithm>

#include "ui/view/slice_view.h"
#include "ui/view/surface_view.h"
#include "ui/window/export/export_panel.h"
#include "ui/window/grow/grow_panel.h"
#include "ui/window/help/help_window.h"
#include "ui/window/main_window.h"
#include "ui/window/open/file_work.h"
#include "ui/window/open/open_panel.h"
#include "ui/window/open/start_page.h"
#include "ui/window/timeline/event_inspector.h"
#include "ui/window/timeline/timeline_panel.h"
#include "ui/window/views/view_grid.h"
#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/language.h"
#include "ui/window/widgets/message_bar.h"
#include "ui/window/widgets/value_field.h"

namespace handlebody::ui {

namespace {

template <typename Value>
struct Choice {
  Command command;
  Value value;
};

constexpr Choice<const char*> kLanguages[] = {
    {Command::languageOfSystem, "system"}, {Command::languageEnglish, "en"},
    {Command::languageGerman, "de"},       {Command::languageFrench, "fr"},
    {Command::languageSpanish, "es"},      {Command::languageChinese, "zh_CN"}};
constexpr Choice<ColourMap> kMaps[] = {{Command::mapGrey, ColourMap::grey},
                                       {Command::mapInverted, ColourMap::inverted},
                                       {Command::mapHot, ColourMap::hot},
                                       {Command::mapContrast, ColourMap::contrast}};
constexpr Choice<MeshColouring> kColourings[] = {{Command::meshPlain, MeshColouring::plain},
                                                 {Command::meshEdges, MeshColouring::edges},
                                                 {Command::meshState, MeshColouring::state},
                                                 {Command::meshSupport, MeshColouring::support}};
constexpr Choice<std::optional<Cell>> kLayouts[] = {{Command::fourViews, std::nullopt},
                                                    {Command::onlyAxial, Cell::axial},
                                                    {Command::onlyCoronal, Cell::coronal},
                                                    {Command::onlySagittal, Cell::sagittal},
                                                    {Command::onlySurface, Cell::surface}};

struct WindowPreset {
  Command command;
  double window, level;  // HU
};
constexpr WindowPreset kPresets[] = {{Command::windowSoftTissue, 400, 40},
                                     {Command::windowLung, 1500, -600},
                                     {Command::windowBone, 1800, 400},
                                     {Command::windowBrain, 80, 40},
                                     {Command::windowVessels, 600, 170}};

}  // namespace

void MainWindow::on(Command id, std::function<void()> action) {
  connect(commands_[id], &QAction::triggered, this, [action = std::move(action)] { action(); });
}

void MainWindow::connectFileCommands() {
  on(Command::openFile, [this] { files_->chooseFile(); });
  on(Command::openFolder, [this] { files_->chooseFolder(); });
  on(Command::openObjects, [this] { files_->chooseObjects(); });
  on(Command::saveSession, [this] { files_->save(); });
  on(Command::saveSessionAs, [this] { files_->saveAs(); });
  on(Command::exportResult, [this] { files_->exportResult(); });
  on(Command::exportReport, [this] { files_->exportReport(); });
  on(Command::exportAnonymousSession, [this] { files_->exportAnonymousSession(); });
  on(Command::exportPicture, [this] { files_->exportPicture(); });
  on(Command::quit, [this] { close(); });
  connect(start_, &StartPage::openRequested, files_, [this](const QString& path) { files_->open(path); });
  connect(start_, &StartPage::sampleRequested, files_, &FileWork::openSample);
  connect(open_, &OpenPanel::openRequested, files_, &FileWork::open);
  connect(export_, &ExportPanel::whichChanged, this, &MainWindow::updateCommands);
  connect(files_, &FileWork::spacingNeeded, this,
          [this](const QString& path, const VolumeSelection& selection) {
            showStep(Command::stepOpen);
            open_->askSpacing(path, selection);
          });
  connect(&document_, &Document::seriesChoiceNeeded, this, [this] { showStep(Command::stepOpen); });
}

void MainWindow::connectViewCommands() {
  for (const auto& layout : kLayouts)
    on(layout.command, [this, cell = layout.value] { views_->maximise(cell); });
  connect(views_, &ViewGrid::maximisedChanged, this, &MainWindow::showLayout);
  on(Command::resetViews, [this] { views_->resetViews(); });
  SurfaceView& surface = views_->surface();
  on(Command::lookFromAbove, [&surface] { surface.lookFrom(Plane::axial); });
  on(Command::lookFromFront, [&surface] { surface.lookFrom(Plane::coronal); });
  on(Command::lookFromLeft, [&surface] { surface.lookFrom(Plane::sagittal); });
  for (Command id : {Command::lookFromAbove, Command::lookFromFront, Command::lookFromLeft})
    surface.addAction(commands_[id]);
  on(Command::fullScreen, [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  showLayout();
}

void MainWindow::showLayout() {
  for (const auto& layout : kLayouts)
    if (layout.value == views_->maximised()) commands_[layout.command]->setChecked(true);
}

void MainWindow::connectDisplayCommands() {
  connect(commands_[Command::windowLevelTool], &QAction::toggled, &state_, &ViewState::setWindowLevelTool);
  connect(commands_[Command::slicesIn3d], &QAction::toggled, &state_, &ViewState::setSlicesIn3d);
  connect(commands_[Command::wallsAndPins], &QAction::toggled, &state_, &ViewState::setShowsConstraints);
  on(Command::autoWindow, [this] { state_.setAutomaticWindow(document_.volume()); });
  for (const WindowPreset& preset : kPresets)
    on(preset.command, [this, preset] { state_.setWindowLevel(preset.window, preset.level); });
  for (const auto& map : kMaps) on(map.command, [this, value = map.value] { state_.setColourMap(value); });
  for (const auto& c : kColourings)
    on(c.command, [this, value = c.value] { state_.setMeshColouring(value); });
  on(Command::coloursOfSystem, [this] { setAppearance(Appearance::system); });
  on(Command::coloursLight, [this] { setAppearance(Appearance::light); });
  on(Command::coloursDark, [this] { setAppearance(Appearance::dark); });
  connectLanguageCommands();
  connect(&state_, &ViewState::changed, this, &MainWindow::showViewState);
  showViewState();
}

//! The window is not built anew: what is chosen holds from the next start on.
void MainWindow::connectLanguageCommands() {
  const QString chosen = chosenLanguage();
  for (const auto& [command, code] : kLanguages) {
    const QString language = QString::fromLatin1(code);
    if (language == chosen) commands_[command]->setChecked(true);
    on(command, [this, language] {
      chooseLanguage(language);
      if (languageToUse(language) != languageInUse())
        messages_->show(MessageBar::Kind::information,
                        tr("The language changes when the program is started again."));
    });
  }
}

void MainWindow::showViewState() {
  commands_[Command::windowLevelTool]->setChecked(state_.windowLevelTool());
  commands_[Command::slicesIn3d]->setChecked(state_.slicesIn3d());
  commands_[Command::wallsAndPins]->setChecked(state_.showsConstraints());
  for (const auto& map : kMaps)
    if (map.value == state_.colourMap()) commands_[map.command]->setChecked(true);
  for (const auto& c : kColourings)
    if (c.value == state_.meshColouring()) commands_[c.command]->setChecked(true);
}

void MainWindow::setAppearance(Appearance appearance) {
  appearance_ = appearance;
  applyAppearance(appearance);
  const Command chosen[] = {Command::coloursOfSystem, Command::coloursLight, Command::coloursDark};
  commands_[chosen[static_cast<int>(appearance)]]->setChecked(true);
}

void MainWindow::connectSeedCommands() {
  on(Command::addSeed, [this] { addSeedAtCrosshair(false); });
  on(Command::addOutside, [this] { addSeedAtCrosshair(true); });
  on(Command::deleteSeed, [this] { document_.removeSeed(document_.selectedSeed()); });
  on(Command::growSeed, [this] { resizeSelectedSeed(1); });
  on(Command::shrinkSeed, [this] { resizeSelectedSeed(-1); });
  on(Command::nextSeed, [this] { selectNextSeed(); });
  on(Command::smallerObject, [this] { document_.chooseCandidate(SizeStep::smaller); });
  on(Command::largerObject, [this] { document_.chooseCandidate(SizeStep::larger); });
  for (auto changed :
       {&Document::seedsChanged, &Document::parametersChanged, &Document::resolvedChanged, &Document::opened,
        &Document::stateChanged, &Document::snapshotChanged, &Document::summariesChanged})
    connect(&document_, changed, this, &MainWindow::updateCommands);
  connect(&document_, &Document::selectedSeedChanged, this, &MainWindow::updateCommands);
}

void MainWindow::addSeedAtCrosshair(bool outside) {
  const Grid& grid = document_.volume().grid;
  if (grid.contains(grid.toIndex(state_.crosshair())))
    document_.addSeed({state_.crosshair(), std::nullopt, outside});
}

void MainWindow::resizeSelectedSeed(double direction) {
  const int index = document_.selectedSeed();
  const double step = document_.volume().grid.meanSpacing() / 2;
  const double radius = std::max(document_.shownRadius(index) + direction * step, step);
  document_.setSeedRadius(index, radius, gestureOf(this));
}

void MainWindow::selectNextSeed() {
  const auto count = static_cast<int>(document_.seeds().size());
  const int next = (document_.selectedSeed() + 1) % count;
  document_.selectSeed(next);
  state_.setCrosshair(document_.seeds()[next].centre);
}

void MainWindow::connectGrowCommands() {
  on(Command::run, [this] {
    seekingEvent_ = false;
    if (document_.state() == GrowthState::running || document_.state() == GrowthState::preparing)
      return document_.pause();
    document_.run();
    showStep(Command::stepGrow);
  });
  on(Command::stepForward, [this] { document_.stepForward(); });
  on(Command::stepBack, [this] { document_.stepBack(); });
  on(Command::nextEvent, [this] { seekEvent(true); });
  on(Command::previousEvent, [this] { seekEvent(false); });
  on(Command::toStart, [this] { document_.goToStart(); });
  on(Command::toEnd, [this] { document_.goTo(document_.lastIteration()); });
  const auto follow = [this] {
    if (!seekingEvent_ || document_.state() == GrowthState::running) return;
    const int event = grow_->inspector().event();
    if (event >= 0) goToEvent(event);
    seekingEvent_ = event < 0 && document_.state() == GrowthState::preparing;
  };
  connect(&document_, &Document::snapshotChanged, this, follow);
  connect(&document_, &Document::stateChanged, this, follow);
}

void MainWindow::seekEvent(bool next) {
  seekingEvent_ = true;
  if (next)
    document_.goToNextEvent();
  else
    document_.goToPreviousEvent();
}

void MainWindow::connectHelpCommands() {
  const auto show = [this](HelpWindow::Page page) {
    if (!help_) help_ = new HelpWindow(this);
    help_->show(page);
  };
  on(Command::guide, [show] { show(HelpWindow::Page::guide); });
  on(Command::shortcuts, [show] { show(HelpWindow::Page::shortcuts); });
  on(Command::about, [show] { show(HelpWindow::Page::about); });
}

void MainWindow::updateCommands() {
  const auto enable = [this](std::initializer_list<Command> ids, bool on) {
    for (Command id : ids) commands_[id]->setEnabled(on);
  };
  const bool open = document_.hasVolume();
  const bool grown = document_.iteration() >= 0;
  const bool running =
      document_.state() == GrowthState::running || document_.state() == GrowthState::preparing;
  const bool seeded = open && document_.isSeeded();
  enable({Command::openObjects, Command::saveSession, Command::saveSessionAs, Command::exportAnonymousSession,
          Command::exportPicture, Command::addSeed, Command::addOutside, Command::autoWindow,
          Command::windowSoftTissue, Command::windowLung, Command::windowBone, Command::windowBrain,
          Command::windowVessels, Command::resetViews},
         open);
  enable({Command::deleteSeed, Command::growSeed, Command::shrinkSeed},
         open && document_.selectedSeed() >= 0);
  const bool atRest =
      document_.state() == GrowthState::finished && document_.iteration() == document_.lastIteration();
  enable({Command::nextSeed}, open && !document_.seeds().empty());
  const CandidateChoice choice = document_.candidateChoice();
  enable({Command::smallerObject}, neighbour(choice, SizeStep::smaller).has_value());
  enable({Command::largerObject}, neighbour(choice, SizeStep::larger).has_value());
  enable({Command::run, Command::stepForward, Command::nextEvent}, seeded && !atRest);
  const auto snapshot = document_.snapshot();
  bool something = snapshot && !snapshot->mesh.triangles.empty(), anything = grown;
  for (int i = 0; i < document_.objectCount() && document_.objectCount() > 1; ++i) {
    const auto other = document_.objectInfo(i).snapshot;
    something = something || (other && !other->mesh.triangles.empty());
    anything = anything || other;
  }
  const QString grows = document_.allFault();
  const bool isOther = !running && export_->which() == ExportPanel::Objects::active;
  enable({Command::exportResult}, something && (isOther || grows.isEmpty()));
  enable({Command::exportReport}, anything && grows.isEmpty());
  commands_.setHindrance(Command::exportResult, isOther ? QString() : grows);
  commands_.setHindrance(Command::exportReport, grows);
  enable({Command::stepBack, Command::previousEvent, Command::toStart}, document_.iteration() > 0);
  enable({Command::toEnd}, grown && document_.iteration() < document_.lastIteration());
  QAction* run = commands_[Command::run];
  const bool isOld = !document_.objectInfo(document_.activeObject()).madeWithEarlier.isEmpty();
  run->setText(running ? tr("P&ause") : (grown && !isOld ? tr("&Go on") : tr("&Start")));
  run->setIcon(icon(running ? QStringLiteral("pause") : QStringLiteral("run")));
  updateWallCommands();
  updateTimeCommands();
  updateMeasureCommands();
  updateObjectCommands();
}

}  // namespace handlebody::ui
