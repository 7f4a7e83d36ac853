#pragma once
// Files that are written whole or not at all.

#include <functional>
#include <memory>
#include <string>

#include "core/finding.h"

namespace handlebody {

class FileSet;

//! Throws OutputError: "path: cannot be written: cause.", with the finding.
[[noreturn]] void refuseOutput(const std::string& path, const Finding& cause);

//! What an errno says, as the end of a sentence.
Finding systemFinding(int error);

//! Where a file of that name is written: where its symbolic links lead to, also if there is nothing yet. Of
//! links in a circle one of them.
std::string behindLinks(const std::string& path);

//! Absolute, as the system finds it and without links but for the last name: what that leads to may have
//! another ending, and other files beside it.
std::string inRealFolder(const std::string& path);

//! Calls `write` with a temporary name in the folder of `path` (same ending in lower case, so that a
//! writer can choose its format by it) and then renames that file to `path`. If anything fails or throws, the
//! temporary file is removed and what was at `path` before stays. A symbolic link stays, too: what it leads
//! to is written, in that folder. A file that is replaced leaves its permissions to the new one. Throws
//! OutputError (which names `path`) if the file cannot be created or renamed, or would replace what is not a
//! file, and whatever `write` throws.
//! With `set` it is FileSet::commit that renames it.
void writeAtomically(const std::string& path, const std::function<void(const std::string& temporary)>& write,
                     FileSet* set = nullptr);

//! Writes `text` to `path`, whole or not at all. Throws OutputError. `set` as above.
void writeTextAtomically(const std::string& path, const std::string& text, FileSet* set = nullptr);

//! Files that belong together. What is written as one of it keeps its temporary name until commit(); what was
//! not committed is removed.
class FileSet {
 public:
  FileSet();
  ~FileSet();
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;

  //! All get their names. Throws OutputError where one cannot: those that were written before it have theirs.
  void commit();

 private:
  friend void writeAtomically(const std::string&, const std::function<void(const std::string&)>&, FileSet*);
  struct Waiting;
  std::unique_ptr<Waiting> waiting_;
};

}  // namespace handlebody
