#pragma once
// Objects from a mesh or a label map: what the Document adds to its list.

#include <QString>
#include <atomic>
#include <vector>

#include "core/io/report/label_file.h"
#include "core/io/report/session.h"
#include "core/volume/volume.h"
#include "ui/model/document.h"

namespace handlebody::ui {

//! The labels of a map, to choose from.
struct LabelsToOpen {
  std::vector<NamedLabel> labels;
  bool mayOverlap = false;  //!< the map is in layers: a voxel may be in several
  QString error{};          //!< why it has none; empty: all went well
};

//! Takes long: not on the GUI thread. Gives up when `cancelled`; the result means nothing then. Throws
//! nothing.
LabelsToOpen labelsToOpen(const QString& path, const std::atomic<bool>& cancelled);

struct OpenedObject {
  Session session;
  bool hasLook = false;  //!< its colour and term are those of the file
};

//! One for a mesh, one for each label that is asked for, called, coloured and termed as the file says. They
//! show the surface as it is read, and go no farther by themselves. Takes long: not on the GUI thread. Throws
//! InputError; Cancelled (cancellation.h).
std::vector<OpenedObject> readObjects(const ObjectsToOpen& asked, const Grid& grid);

}  // namespace handlebody::ui
