#pragma once
// Surfaces that are there before anything has grown: of a mesh or a label map, as what a growth begins with,
// or as an object that is done.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/io/formats/file_labels.h"
#include "core/io/report/session.h"

namespace handlebody {

//! Reads the surfaces that the sessions of one volume begin with (Constraints::start), at their beginning and
//! in their changes. Those of one label map that name the same labels (`among`) become surfaces together;
//! where they have none, and several are of the same label map, they get them. Throws InputError that names
//! the file: it cannot be read, is not the one that the session was made with, fails its certificate, holds
//! no voxel of that value, or two of them meet. Each decodes as its volume (VolumeSelection::decoder). Takes
//! long: gives up when the stop token is set (cancellation.h).
void loadStarts(const std::vector<Session*>& sessions);
void loadStarts(Session& session);

//! The object is a mesh as it is, which nothing is to change: neither growth nor polishing.
bool isMeshAsItIs(const Constraints& constraints);

//! A value of a label map, and what the file says of it.
struct NamedLabel : FileLabel {
  int value = 0;
};
//! The values of the voxels that are not 0, in ascending order, kMaxLabels at most. Throws InputError, also
//! if a voxel is no whole number or there is none of them.
std::vector<NamedLabel> labelsIn(const std::string& path);
//! What a file says of one of its labels, or of the only one that it knows, by its header alone. Nothing of a
//! mesh, of what says nothing and of what cannot be read, which is told by whoever reads the voxels.
FileLabel labelIn(const std::string& path, std::optional<int> value);

inline constexpr std::size_t kMaxLabels = 255;

}  // namespace handlebody
