// The table of all commands, in the order of the menus.

#include "ui/window/commands.h"

namespace handlebody::ui {

namespace {

// For lupdate, which is told that it is QT_TR_NOOP (resources/translations/CMakeLists.txt).
#define T(text) text

constexpr auto kPlain = CommandSpec::plain;
constexpr auto kToggle = CommandSpec::toggle;
constexpr auto kChoice = CommandSpec::choice;

void addFileCommands(std::vector<CommandSpec>& t) {
  const char* menu = T("&File");
  t.insert(t.end(),
           {{Command::openFile, menu, "", T("&Open file…"), "Ctrl+O", "open",
             T("Open a volume (NIfTI, NRRD, MetaImage, GIPL, TIFF, DICOM) or a session"), kPlain, false},
            {Command::openFolder, menu, "", T("Open &folder…"), "Ctrl+Shift+O", "folder",
             T("Open a folder with a DICOM series"), kPlain, false},
            {Command::openObjects, menu, "", T("Open o&bjects…"), "", "",
             T("Take surfaces of a mesh (STL, VTP, PLY, OBJ, 3MF) or a label map (DICOM, 3D Slicer, NIfTI, "
               "NRRD, MetaImage) as objects: as they are, or to grow from"),
             kPlain, false},
            {Command::saveSession, menu, "", T("&Save session"), "Ctrl+S", "save",
             T("Save volume reference, seeds and parameters, to go on later or to replay"), kPlain, true},
            {Command::saveSessionAs, menu, "", T("Save session &as…"), "Ctrl+Shift+S", "session",
             T("Save the session under another name"), kPlain, false},
            {Command::exportResult, menu, "", T("&Export result…"), "Ctrl+E", "export",
             T("Write the surface or its label map to a file"), kPlain, true},
            {Command::exportReport, menu, "", T("Export repor&t…"), "Ctrl+Shift+E", "report",
             T("Write parameters, numbers and events as JSON"), kPlain, false},
            {Command::exportAnonymousSession, menu, "", T("Export a&nonymous session…"), "", "session",
             T("Write a session that names neither the patient nor a file: it asks for its volume when it is "
               "opened"),
             kPlain, false},
            {Command::exportPicture, menu, "", T("Export &picture…"), "Ctrl+Shift+P", "picture",
             T("Write what the views show as PNG"), kPlain, false},
            {Command::quit, menu, "", T("&Quit"), "Ctrl+Q", "", T("Close the program"), kPlain, true}});
}

void addEditCommands(std::vector<CommandSpec>& t) {
  const char* menu = T("&Edit");
  t.insert(t.end(), {{Command::undo, menu, "", T("Undo"), "Ctrl+Z", "undo", T("Take back the last change"),
                      kPlain, false},
                     {Command::redo, menu, "", T("Redo"), "Ctrl+Shift+Z; Ctrl+Y", "redo",
                      T("Do again what was taken back"), kPlain, false}});
}

void addViewCommands(std::vector<CommandSpec>& t) {
  const char* menu = T("&View");
  const char* layout = T("&Layout");
  const char* steps = T("&Step");
  const char* camera = T("3D &camera");
  t.insert(
      t.end(),
      {{Command::fourViews, menu, layout, T("All &four"), "Ctrl+0", "four-views",
        T("Axial, 3D, coronal and sagittal view together"), kChoice, false},
       {Command::onlyAxial, menu, layout, T("&Axial only"), "Ctrl+1", "", T("Only the axial slice"), kChoice,
        false},
       {Command::onlyCoronal, menu, layout, T("&Coronal only"), "Ctrl+2", "", T("Only the coronal slice"),
        kChoice, false},
       {Command::onlySagittal, menu, layout, T("&Sagittal only"), "Ctrl+3", "", T("Only the sagittal slice"),
        kChoice, false},
       {Command::onlySurface, menu, layout, T("&3D only"), "Ctrl+4", "", T("Only the surface in 3D"), kChoice,
        false},
       {Command::stepOpen, menu, steps, T("1 &Open"), "Alt+1", "open", T("Choose a volume"), kChoice, false},
       {Command::stepSeed, menu, steps, T("2 &Seed"), "Alt+2", "seed", T("Place seeds in the object"),
        kChoice, false},
       {Command::stepTune, menu, steps, T("3 &Tune"), "Alt+3", "tune", T("Set range and forces"), kChoice,
        false},
       {Command::stepGrow, menu, steps, T("4 &Grow"), "Alt+4", "grow", T("Grow the surface and watch it"),
        kChoice, false},
       {Command::stepCorrect, menu, steps, T("5 &Correct"), "Alt+5", "correct",
        T("Walls, and what is held back: mend what has grown wrong"), kChoice, false},
       {Command::stepExport, menu, steps, T("6 &Export"), "Alt+6", "export", T("Write the results"), kChoice,
        false},
       {Command::resetViews, menu, "", T("&Reset views"), "Ctrl+R", "reset",
        T("Whole slices, camera from the front"), kPlain, true},
       {Command::lookFromAbove, menu, camera, T("From &above (superior)"), "Home", "look",
        T("3D view: look from superior; with the 3D view in focus"), kPlain, false},
       {Command::lookFromFront, menu, camera, T("From the &front (anterior)"), "End", "look",
        T("3D view: look from anterior; with the 3D view in focus"), kPlain, false},
       {Command::lookFromLeft, menu, camera, T("From the &left"), "PgDown", "look",
        T("3D view: look from the patient's left; with the 3D view in focus"), kPlain, false},
       {Command::slicesIn3d, menu, "", T("Slices &in 3D"), "Ctrl+D", "",
        T("Show the three slices in the 3D view"), kToggle, false},
       {Command::wallsAndPins, menu, "", T("Walls a&nd pins"), "Ctrl+Shift+H", "",
        T("Draw the active object's walls, and what of its surface is pinned"), kToggle, false}});
}

void addDisplayCommands(std::vector<CommandSpec>& t) {
  const char* menu = T("&View");
  const char* presets = T("CT pr&esets");
  const char* maps = T("C&olour map");
  const char* mesh = T("Sur&face");
  const char* colours = T("&Appearance");
  const char* language = T("Langua&ge");
  const char* languageTip = T("Language of the texts and numbers in the window, from the next start on");
  t.insert(
      t.end(),
      {{Command::windowLevelTool, menu, "", T("&Window and level by dragging"), "W", "window-level",
        T("Drag in a slice: sideways for the window (contrast), up and down for the level (brightness)"),
        kToggle, true},
       {Command::autoWindow, menu, "", T("Au&to window"), "Ctrl+J", "auto-window",
        T("Window and level from the intensities of the volume"), kPlain, false},
       {Command::windowSoftTissue, menu, presets, T("&Soft tissue (400 / 40 HU)"), "", "",
        T("Window 400, level 40"), kPlain, false},
       {Command::windowLung, menu, presets, T("&Lung (1500 / −600 HU)"), "", "", T("Window 1500, level −600"),
        kPlain, false},
       {Command::windowBone, menu, presets, T("&Bone (1800 / 400 HU)"), "", "", T("Window 1800, level 400"),
        kPlain, false},
       {Command::windowBrain, menu, presets, T("B&rain (80 / 40 HU)"), "", "", T("Window 80, level 40"),
        kPlain, false},
       {Command::windowVessels, menu, presets, T("&Vessels (600 / 170 HU)"), "", "",
        T("Window 600, level 170"), kPlain, false},
       {Command::mapGrey, menu, maps, T("&Grey"), "", "", T("Black to white"), kChoice, false},
       {Command::mapInverted, menu, maps, T("&Inverted"), "", "", T("White to black"), kChoice, false},
       {Command::mapHot, menu, maps, T("&Hot"), "", "", T("Black over red and yellow to white"), kChoice,
        false},
       {Command::mapContrast, menu, maps, T("&Contrast-enhancing"), "", "",
        T("Dark intensities spread over many colours, for ultrasound"), kChoice, false},
       {Command::meshPlain, menu, mesh, T("&Plain"), "", "", T("One colour, shaded"), kChoice, false},
       {Command::meshEdges, menu, mesh, T("With &edges"), "", "", T("The triangles' edges are drawn"),
        kChoice, false},
       {Command::meshState, menu, mesh, T("By &state"), "", "",
        T("Moving, settled, new handle and colliding faces in their colours"), kChoice, false},
       {Command::meshSupport, menu, mesh, T("Support by the &image"), "", "",
        T("Blue where the image shows no edge, in 3D and on the slices"), kChoice, false},
       {Command::coloursOfSystem, menu, colours, T("As the &system"), "", "",
        T("Light or dark as the desktop"), kChoice, false},
       {Command::coloursLight, menu, colours, T("&Light"), "", "", T("Dark text on light ground"), kChoice,
        false},
       {Command::coloursDark, menu, colours, T("&Dark"), "", "", T("Light text on dark ground"), kChoice,
        false},
       {Command::languageOfSystem, menu, language, T("As the &system"), "", "", languageTip, kChoice, false},
       // Each in its own language.
       {Command::languageEnglish, menu, language, "English", "", "", languageTip, kChoice, false},
       {Command::languageGerman, menu, language, "Deutsch", "", "", languageTip, kChoice, false},
       {Command::languageFrench, menu, language, "Français", "", "", languageTip, kChoice, false},
       {Command::languageSpanish, menu, language, "Español", "", "", languageTip, kChoice, false},
       {Command::languageChinese, menu, language, "简体中文", "", "", languageTip, kChoice, false},
       {Command::fullScreen, menu, "", T("F&ull screen"), "F11", "", T("The window fills the screen"),
        kToggle, true}});
}

void addSeedCommands(std::vector<CommandSpec>& t) {
  const char* menu = T("&Seed");
  t.insert(t.end(),
           {{Command::addSeed, menu, "", T("&Add at the crosshair"), "Return; Enter", "seed-add",
             T("Place a seed where the crosshair is"), kPlain, false},
            {Command::addOutside, menu, "", T("Add &outside of the object"), "Shift+Return; Shift+Enter",
             "seed-outside", T("Place a click outside of the object where the crosshair is"), kPlain, false},
            {Command::deleteSeed, menu, "", T("&Delete"), "Backspace; Delete", "seed-delete",
             T("Delete the selected seed or click outside"), kPlain, false},
            {Command::growSeed, menu, "", T("&Larger radius"), "+; =", "seed-bigger",
             T("Radius of the selected seed half a voxel larger"), kPlain, true},
            {Command::shrinkSeed, menu, "", T("&Smaller radius"), "-", "seed-smaller",
             T("Radius of the selected seed half a voxel smaller"), kPlain, false},
            {Command::nextSeed, menu, "", T("Select the &next"), "S", "",
             T("Select the next seed and move the crosshair there"), kPlain, true},
            {Command::smallerObject, menu, "", T("S&maller object"), "[", "object-smaller",
             T("Take the next smaller of the objects that the clicks may mean"), kPlain, true},
            {Command::largerObject, menu, "", T("La&rger object"), "]", "object-larger",
             T("Take the next larger of the objects that the clicks may mean"), kPlain, false}});
}

void addGrowCommands(std::vector<CommandSpec>& t) {
  const char* menu = T("&Grow");
  t.insert(t.end(), {{Command::run, menu, "", T("&Start"), "Space", "run", T("Grow the surface, or pause"),
                      kPlain, false},
                     {Command::stepForward, menu, "", T("One step &forward"), ".", "step-forward",
                      T("One iteration forward"), kPlain, true},
                     {Command::stepBack, menu, "", T("One step &back"), ",", "step-back",
                      T("One iteration back, exactly"), kPlain, false},
                     {Command::nextEvent, menu, "", T("&Next event"), "N", "next-event",
                      T("To the next change of topology; grows until there is one"), kPlain, true},
                     {Command::previousEvent, menu, "", T("&Previous event"), "P", "previous-event",
                      T("To the previous change of topology"), kPlain, false},
                     {Command::toStart, menu, "", T("Back to the s&tart"), "Ctrl+Home", "to-start",
                      T("To the seed spheres"), kPlain, true},
                     {Command::toEnd, menu, "", T("To the &last step"), "Ctrl+End", "to-end",
                      T("To the last iteration that was worked out"), kPlain, false}});
}

void addCorrectCommands(std::vector<CommandSpec>& t) {
  const char* menu = T("&Correct");
  t.insert(
      t.end(),
      {{Command::paintWalls, menu, "", T("&Paint walls"), "B", "wall-paint",
        T("Drag in a slice: the surface may not go where it is painted"), kToggle, false},
       {Command::eraseWalls, menu, "", T("&Erase walls"), "E", "wall-erase",
        T("Drag in a slice: what the eraser touches is no wall any more"), kToggle, false},
       {Command::largerBrush, menu, "", T("&Larger brush"), "Ctrl+]", "",
        T("Radius of the brush a tenth larger"), kPlain, true},
       {Command::smallerBrush, menu, "", T("S&maller brush"), "Ctrl+[", "",
        T("Radius of the brush a tenth smaller"), kPlain, false},
       {Command::wallAtCrosshair, menu, "", T("&Wall at the crosshair"), "Shift+B", "",
        T("A wall as large as the brush where the crosshair is"), kPlain, true},
       {Command::eraseAtCrosshair, menu, "", T("E&rase at the crosshair"), "Shift+E", "",
        T("No walls where the eraser would touch them at the crosshair"), kPlain, false},
       {Command::goOnBeforeWalls, menu, "", T("Go &on from before the walls"), "Ctrl+B", "",
        T("Back to before the surface came to the new walls, and on from there"), kPlain, true},
       {Command::removeWalls, menu, "", T("Remo&ve all walls"), "Ctrl+Shift+B", "",
        T("Nothing that was painted is a wall any more"), kPlain, false},
       {Command::pinByBrush, menu, "", T("Pin &by brush"), "L", "pin",
        T("Drag over the surface, in a slice or in 3D: what the brush covers stays as it is from the shown "
          "iteration on"),
        kToggle, true},
       {Command::unpinByBrush, menu, "", T("Unp&in by brush"), "Shift+L", "unpin",
        T("Drag over the surface, in a slice or in 3D: pins that the brush touches hold no more"), kToggle,
        false},
       {Command::smoothByBrush, menu, "", T("Smoot&h by brush"), "M", "smooth",
        T("Click on the surface, in a slice or in 3D: it is smoothed under the brush, as the next step"),
        kToggle, false},
       {Command::pullByDragging, menu, "", T("Pull by &dragging"), "U", "pull",
        T("Drag a point of the surface, in a slice or in 3D: it goes there, and what lies within the brush's "
          "radius less and less, as the next step"),
        kToggle, false},
       {Command::cutByLine, menu, "", T("Cut alon&g a line"), "X", "cut",
        T("Draw a line across the surface in a slice: it is cut there at right angles to the slice, and "
          "closed on "
          "both sides, as the next step"),
        kToggle, false},
       {Command::removePins, menu, "", T("Remove &all pins"), "Ctrl+Shift+L", "",
        T("Nothing of the surface is pinned any more"), kPlain, false},
       {Command::pinHere, menu, "", T("Pi&n here"), "Shift+P", "pin",
        T("The surface around the crosshair stays as it is from the shown iteration on"), kPlain, true},
       {Command::smoothHere, menu, "", T("&Smooth here"), "Shift+S", "smooth",
        T("Smooth the surface around its point nearest to the crosshair, as the next step"), kPlain, false},
       {Command::pullHere, menu, "", T("P&ull here"), "Shift+U", "pull",
        T("Pull the point of the surface nearest to the crosshair there, as the next step"), kPlain, false},
       {Command::cutHere, menu, "", T("&Cut here"), "Shift+C", "cut",
        T("Cut along the chosen plane through the crosshair, as the next step"), kPlain, false}});
}

void addObjectCommands(std::vector<CommandSpec>& t) {
  const char* menu = T("&Objects");
  t.insert(t.end(),
           {{Command::addObject, menu, "", T("&Add object"), "Ctrl+N", "object-add",
             T("Another object in this volume; the surfaces before it are walls for it"), kPlain, false},
            {Command::duplicateObject, menu, "", T("&Duplicate"), "Ctrl+Shift+D", "object-duplicate",
             T("Another object with the same seeds and parameters"), kPlain, false},
            {Command::deleteObject, menu, "", T("D&elete object"), "Ctrl+Backspace", "object-delete",
             T("Delete the active object with its seeds and surface"), kPlain, false},
            {Command::editObject, menu, "", T("&Properties…"), "F2", "object-edit",
             T("Name, colour, label value and term of the active object"), kPlain, false},
            {Command::moveObjectUp, menu, "", T("Move &up"), "Ctrl+Shift+Up", "move-up",
             T("The active object earlier in the list: what two claim belongs to the first"), kPlain, true},
            {Command::moveObjectDown, menu, "", T("Move do&wn"), "Ctrl+Shift+Down", "move-down",
             T("The active object later in the list"), kPlain, false},
            {Command::nextObject, menu, "", T("&Next object"), "Ctrl+PgDown", "",
             T("The next object of the list is active"), kPlain, true},
            {Command::previousObject, menu, "", T("P&revious object"), "Ctrl+PgUp", "",
             T("The object before it in the list is active"), kPlain, false},
            {Command::objectVisible, menu, "", T("&Visible"), "Ctrl+H", "",
             T("Draw the surface of the active object"), kToggle, true},
            {Command::objectLocked, menu, "", T("&Locked"), "Ctrl+L", "",
             T("Change nothing of the active object"), kToggle, false},
            {Command::growAll, menu, "", T("&Grow all"), "Ctrl+Space", "grow",
             T("Grow all objects that are not done, in the order of the list"), kPlain, true}});
}

void addTimeCommands(std::vector<CommandSpec>& t) {
  const char* menu = T("&Time");
  t.insert(
      t.end(),
      {{Command::playFrames, menu, "", T("&Play"), "T", "play", T("Play the frames of the volume, or stop"),
        kPlain, false},
       {Command::previousFrame, menu, "", T("P&revious frame"), "Alt+Left", "frame-back",
        T("The frame before the shown one"), kPlain, false},
       {Command::nextFrame, menu, "", T("&Next frame"), "Alt+Right", "frame-forward",
        T("The frame after the shown one"), kPlain, false},
       {Command::toGrownFrame, menu, "", T("&Back to where it is grown"), "Alt+Down", "",
        T("The frame in which the surface is grown"), kPlain, false},
       {Command::growHere, menu, "", T("&Grow in this frame"), "Ctrl+G", "grow",
        T("Grow in the shown frame with the same clicks; what was grown in the other one is gone"), kPlain,
        true},
       {Command::carryOverTime, menu, "", T("&Over time"), "Ctrl+T", "over-time",
        T("Carry the surface from its frame through the others, both ways, in the background"), kPlain,
        false},
       {Command::correctFrame, menu, "", T("&Correct this frame"), "Ctrl+Shift+G", "correct",
        T("Change the surface of the shown frame with clicks, walls and edits, from that of the frame beside "
          "it "
          "on"),
        kPlain, true},
       {Command::endCorrection, menu, "", T("Carry on &from here"), "", "over-time",
        T("The correction counts: the frames beyond this one are carried again from it"), kPlain, false},
       {Command::leaveCorrection, menu, "", T("&Drop the correction"), "", "close",
        T("Back to the frame that is grown; what was carried stays as it was"), kPlain, false},
       {Command::showOverTime, menu, "", T("&Volume over time"), "Ctrl+Shift+T", "measures",
        T("The volume of every frame, ejection fraction, and what went wrong in which frame"), kPlain, true},
       {Command::exportFrameMeshes, menu, "", T("Export &meshes of all frames…"), "", "export",
        T("Write the surface of every frame, numbered, with a list for ParaView (.pvd) beside .vtp"), kPlain,
        true},
       {Command::exportFrameLabels, menu, "", T("Export 4D &label map…"), "", "export",
        T("Write the surfaces of all frames as one label map with four dimensions"), kPlain, false}});
}

void addMeasureCommands(std::vector<CommandSpec>& t) {
  const char* menu = T("&Measure");
  t.insert(
      t.end(),
      {{Command::showMeasures, menu, "", T("&Measures"), "Ctrl+M", "measures",
        T("Volume, area, diameters, intensities and distances of the objects, as a table"), kPlain, false},
       {Command::ruler, menu, "", T("&Ruler"), "R", "ruler",
        T("Click two points in the slices or on the surface: their distance in mm"), kToggle, true},
       {Command::angle, menu, "", T("&Angle"), "A", "angle",
        T("Click three points, the second where the legs meet: the angle in degrees"), kToggle, false},
       {Command::centreLine, menu, "", T("&Centre line"), "C", "centre-line",
        T("Click two places of an object: the line along its middle and the sections across it"), kToggle,
        false},
       {Command::sensitivity, menu, "", T("&Sensitivity"), "Ctrl+Shift+M", "sensitivity",
        T("Grow it again with clicks, smoothing and noise a little different: how much do volume and surface "
          "change?"),
        kPlain, true}});
}

void addHelpCommands(std::vector<CommandSpec>& t) {
  const char* menu = T("&Help");
  t.insert(t.end(),
           {{Command::guide, menu, "", T("&Guide"), "F1", "help", T("How to use the program"), kPlain, false},
            {Command::shortcuts, menu, "", T("&Keyboard and mouse"), "Shift+F1", "keyboard",
             T("All keys and mouse buttons"), kPlain, false},
            {Command::about, menu, "", T("&About Handlebody"), "", "info", T("Version, purpose, licences"),
             kPlain, true}});
}

}  // namespace

const std::vector<CommandSpec>& Commands::table() {
  static const std::vector<CommandSpec> all = [] {
    std::vector<CommandSpec> t;
    for (auto add : {addFileCommands, addEditCommands, addViewCommands, addDisplayCommands, addSeedCommands,
                     addGrowCommands, addCorrectCommands, addObjectCommands, addTimeCommands,
                     addMeasureCommands, addHelpCommands})
      add(t);
    return t;
  }();
  return all;
}

}  // namespace handlebody::ui
