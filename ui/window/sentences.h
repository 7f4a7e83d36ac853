#pragma once
// Sentences of the engine and the readers, which name options of the command line, in the words of the
// window.

#include <QString>
#include <string>
#include <vector>

#include "core/io/volume_io.h"

namespace handlebody::ui {

//! The sentence with the panels' fields in the place of options, and the stacks of a series named as the list
//! in the step Open names them, not by their UID.
QString inWordsOfWindow(QString sentence);
//! Those of the volume that the window shows: which time point is used is seen in the bar of time.
std::vector<std::string> warningsOfWindow(const VolumeInfo& info);
//! Of those the one that is said first: that lengths mean nothing, where it is so. Empty: there is none.
QString mainWarning(const VolumeInfo& info);
//! With places where an overlong word (a path, a UID) may go on in the next line, which are not seen: no text
//! of a file may widen a panel.
QString breakable(const QString& text);

}  // namespace handlebody::ui
