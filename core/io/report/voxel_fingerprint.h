#pragma once
// Which series of a folder an anonymous session means. It names none, since a UID leads to the patient: it
// keeps what its voxels are.

#include <string>

#include "core/io/report/session.h"

namespace handlebody {

//! SHA-256 of what a volume holds: size, type and voxels, without anything of where they lie and whose they
//! are; lower-case hex.
std::string sha256OfVoxels(const Volume& volume);

//! Keeps the voxels of a volume whose series was chosen (VolumeReference::voxels). `volume`: as the reference
//! is read.
void keepVoxels(VolumeReference& reference, const Volume& volume);

//! Chooses the series by the voxels that the reference keeps, if it names none and its path is a folder that
//! holds several: the first that has them. Reads all up to that one. Throws InputError that names the folder
//! if none has them.
void findSeries(VolumeReference& reference);

//! Throws InputError that names path and series if the reference keeps other voxels than these.
void verifyVoxels(const VolumeReference& reference, const Volume& volume);

}  // namespace handlebody
