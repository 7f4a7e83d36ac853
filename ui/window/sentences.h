#pragma once
// Sentences of the engine and the readers, which name options of the command line, in the words of the
// window.

#include <QString>

#include "core/io/volume_io.h"

namespace handlebody::ui {

//! The sentence with the panels' fields in the place of options, and the stacks of a series named as the list
//! in the step Open names them, not by their UID.
QString inWordsOfWindow(QString sentence);
//! The warning that is said first: that lengths mean nothing, where it is so. Precondition: there is one.
QString mainWarning(const VolumeInfo& info);
//! With places where an overlong word (a path, a UID) may go on in the next line, which are not seen: no text
//! of a file may widen a panel.
QString breakable(const QString& text);
//! True if the sentence asks for the spacing of a file's voxels.
bool asksForSpacing(const QString& sentence);

}  // namespace handlebody::ui
