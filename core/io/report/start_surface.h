#pragma once
// Surfaces that are there before anything has grown: of a mesh or a label map, as what a growth begins with,
// or as an object that is done.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/io/report/session.h"

namespace handlebody {

//! Reads the surfaces that the sessions of one volume begin with (Constraints::start), at their beginning and
//! in their changes. Those of one label map that name the same labels (`among`) become surfaces together;
//! where they have none, and several are of the same label map, they get them. Voxels that several of these
//! hold are the smallest one's (StartSurface::shared). Throws InputError that names the file: it cannot be
//! read, is not the one that the session was made with, fails its certificate, holds no voxel of that label,
//! or two of them meet. Each decodes as its volume (VolumeSelection::decoder). Takes long: gives up when the
//! stop token is set (cancellation.h).
void loadStarts(const std::vector<Session*>& sessions);
void loadStarts(Session& session);

//! Puts the number in the place of a label's name. Throws as labelCalled.
void findByName(StartSurface& start);

//! How many voxels of its label were left to smaller ones; none if there are none, or there is no label.
Finding sharedVoxels(const Constraints& constraints);

//! The object is a mesh as it is, which nothing is to change: neither growth nor polishing. Of starts that
//! have been read.
bool isMeshAsItIs(const Constraints& constraints);

//! What of `source` stands in the files of a surface that has been shown at `iteration` under `constraints`:
//! how it was made only if it is still as in its file. A growth or an edit makes it ours.
SegmentSource sourceInFiles(SegmentSource source, const Constraints& constraints, int iteration,
                            bool isAnonymous);

}  // namespace handlebody
