#pragma once
// What the window says of a volume that was opened.

#include <QString>
#include <vector>

#include "core/io/formats/volume_io.h"

namespace handlebody::ui {

//! Those of the volume that the window shows: which time point is used is seen in the bar of time.
std::vector<Finding> warningsOfWindow(const VolumeInfo& info);
//! Of those the one that is said first: that lengths mean nothing, where it is so. Empty: there is none.
QString mainWarning(const VolumeInfo& info);
//! With places where an overlong word (a path, a UID) may go on in the next line, which are not seen: no text
//! of a file may widen a panel.
QString breakable(const QString& text);

}  // namespace handlebody::ui
