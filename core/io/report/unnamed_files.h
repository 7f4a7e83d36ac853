#pragma once
// Files that an anonymous session needs and does not name: asked for one after the other, and known again by
// the SHA-256 that it keeps of them.

#include <optional>
#include <string>
#include <vector>

#include "core/finding.h"
#include "core/io/report/session.h"

namespace handlebody {

struct UnnamedFile {
  //! sessionWithoutVolume, sessionWithoutWalls (the label map of its walls) or sessionWithoutStart (the
  //! surface that it begins with).
  FindingKind missing = FindingKind::none;
  std::string sha256{};  //!< empty: not known, any file is taken
};

//! The first file that sessions of one volume do not name: their volume, then label maps of walls, then
//! surfaces to begin with. None: they name all that they need.
std::optional<UnnamedFile> unnamedFile(const std::vector<Session>& sessions);

//! Names it in all places where it is meant. Throws InputError that names the path if that is another file or
//! cannot be read; the sessions stay as they were then.
void nameFile(std::vector<Session>& sessions, const UnnamedFile& file, const std::string& path);

//! The same of several files of one kind (sessionWithoutWalls or sessionWithoutStart), in any order, for
//! sessions that may name some of them where they were. A file is meant where its SHA-256 is kept; where none
//! is, the one that is left when all that are kept have theirs. Throws InputError that names a file that is
//! meant nowhere, cannot be read, or would be one of several that are left.
void placeFiles(std::vector<Session>& sessions, FindingKind missing, const std::vector<std::string>& paths);

}  // namespace handlebody
