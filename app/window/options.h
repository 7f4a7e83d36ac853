#pragma once
// The command line of the window.

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>

namespace handlebody::app {

struct Options {
  QString file;        //!< volume, folder, session or report; empty: none
  QString screenshot;  //!< PNG to write, and then to end; empty: a window for a person
  QString view;        //!< window, all, axial, coronal, sagittal, 3d
  QString step;   //!< open, seed, tune, grow, correct, export, measure, sensitivity, time; empty: as it is
  QString stage;  //!< collide, refine, open, handle, close: of the event at that iteration; empty: none
  QString appearance;  //!< system, light, dark; empty: as set in the window
  QString language;    //!< system, en, de, fr, es, zh_CN; empty: HANDLEBODY_LANGUAGE, or as set in the window
  std::optional<int> iteration;  //!< the surface is grown to it
  QSize size{1280, 800};
};

//! Reads the command line. Where it asks for help or the version, or is wrong, that is printed and the exit
//! code returned.
std::optional<int> readOptions(int argc, char** argv, Options& options);

}  // namespace handlebody::app
