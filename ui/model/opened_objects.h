#pragma once
// Objects from a mesh or a label map: what the Document adds to its list.

#include <QString>
#include <vector>

#include "core/io/report/session.h"
#include "core/volume/volume.h"
#include "ui/model/document.h"

namespace handlebody::ui {

struct OpenedObject {
  Session session;
  bool hasLook = false;  //!< its colour and term are those of the file
};

//! One for a mesh, one for each value of a label map, called, coloured and termed as the file says. They show
//! the surface as it is read, and go no farther by themselves. Takes long: not on the GUI thread. Throws
//! InputError; Cancelled (cancellation.h).
std::vector<OpenedObject> readObjects(const QString& path, OpenAs as, const Grid& grid);

}  // namespace handlebody::ui
