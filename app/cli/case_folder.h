#pragma once
// The folder of a batch: cases/NAME for each case that is done, failed/NAME.txt for the log of each that is
// not, failed/NAME.json for why. A case's folder appears whole: it is filled under a temporary name and then
// renamed.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/case_process.h"
#include "app/cli/study.h"

namespace handlebody::cli {

//! Who else may work in the folder: nobody, or others that share it, each case being one process's alone.
enum class FolderUse { alone, shared };

//! A case is this process's while it lives.
class CaseHold {
 public:
  //! Without waiting. Throws OutputError.
  explicit CaseHold(const std::string& path);
  ~CaseHold();
  CaseHold(const CaseHold&) = delete;
  CaseHold& operator=(const CaseHold&) = delete;
  bool isMine() const { return file_ >= 0; }

 private:
  int file_ = -1;
};

class BatchFolder {
 public:
  //! Of all cases; beside the folders of each.
  static constexpr std::array kTables{"summary.csv", "summary.json", "index.html"};

  //! Makes what is not there; throws UsageError if something is there that would be replaced and that no
  //! batch has made. Holds the folder while it lives. Alone: takes away what a batch that was killed has left
  //! half-done; throws UsageError if others are at work in it. Shared: waits a minute for one that is there
  //! alone. Throws OutputError.
  explicit BatchFolder(const std::string& path, FolderUse use = FolderUse::alone);
  ~BatchFolder();
  BatchFolder(const BatchFolder&) = delete;
  BatchFolder& operator=(const BatchFolder&) = delete;

  //! Throws UsageError if the study's file or an input of a case is what a batch in the folder `path` writes,
  //! or an input is that folder. It need not be there yet.
  static void requireApart(const std::string& path, const std::string& study,
                           const std::vector<StudyCase>& cases);
  //! Throws UsageError if a case's folder is of somebody else.
  void requireOwn(const std::vector<StudyCase>& cases) const;

  //! Absolute, without links.
  const std::string& path() const { return path_; }
  //! Of the results; relative to this one.
  static std::string folderOf(const StudyCase& c) { return "cases/" + c.name; }
  //! Of the log of a failure; relative to this one.
  static std::string logOf(const StudyCase& c) { return "failed/" + c.name + ".txt"; }
  std::string absolute(const std::string& relative) const { return path_ + "/" + relative; }

  //! The names of the result files in the folder: of a case over time as its report there says which frames
  //! have a surface.
  static std::vector<std::string> resultsOf(const StudyCase& c, const std::string& folder);
  //! There are results, of these inputs or of others.
  bool hasResults(const StudyCase& c) const;
  //! There are results, by this version of the program from the same voxels and options, and no file of them
  //! has gone or changed its size. Reads the whole volume. May be called on several threads.
  bool isDone(const StudyCase& c) const;

  //! An empty folder for a case to work in.
  std::string begin(const StudyCase& c) const;
  //! Where it writes what it says there.
  std::string logOfWork(const StudyCase& c) const { return temporary(c) + "/log.txt"; }
  //! Makes results of that folder, in one step, in place of what was there. Throws OutputError, InputError if
  //! something is missing in it.
  void finish(const StudyCase& c, const CaseEnd& end) const;
  //! Keeps its log (unless it is anonymous) as that of a failure with the sentence why, and takes the rest
  //! away. Never throws.
  void fail(const StudyCase& c, const std::string& why) const;
  //! Takes away what is kept of a failure: there is a result, which was made after it or of other options.
  void forgetFailure(const StudyCase& c) const;
  //! The last failure has left a log.
  bool hasLogOfFailure(const StudyCase& c) const;
  //! The sentence of the last failure of this request; empty if there is none.
  std::string failureOf(const StudyCase& c) const;
  //! Somebody has begun it, and neither finished nor failed: is at work on it, or was killed.
  bool isBegun(const StudyCase& c) const;
  //! Precondition: the folder is shared.
  std::unique_ptr<CaseHold> hold(const StudyCase& c) const;
  //! Takes it away.
  void abandon(const StudyCase& c) const;

 private:
  std::string temporary(const StudyCase& c) const;
  void writeRecord(const StudyCase& c, const CaseEnd& end, const std::string& folder) const;
  std::string path_;
  int lock_ = -1;
};

}  // namespace handlebody::cli
