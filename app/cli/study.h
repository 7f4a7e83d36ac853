#pragma once
// The study of `batch`: a CSV file, one row a case.

#include <cstdint>
#include <string>
#include <vector>

namespace handlebody::cli {

//! What a case may take. 0: as much as there is.
struct CaseLimits {
  double seconds = 0;       //!< by the clock
  std::uint64_t bytes = 0;  //!< of address space
};

//! A file that an option of `segment` names: walls, a surface to begin with.
struct StudyInput {
  std::string option;  //!< without dashes
  std::string path;    //!< absolute
};

//! --OPTION=PATH
std::string argumentOf(const StudyInput& input);

struct StudyCase {
  int line = 0;                      //!< of the CSV file
  std::string name;                  //!< of its folder
  bool isAnonymous = false;          //!< no file that is written may name its source
  std::string volume;                //!< as the file says it; empty if anonymous
  std::string volumePath;            //!< absolute
  std::vector<StudyInput> inputs;    //!< further files, in the order of the columns
  std::vector<std::string> options;  //!< of `segment`, --NAME=VALUE, without inputs and outputs
  std::vector<std::string> outputs;  //!< names of files in its folder
  CaseLimits limits;
  bool isOverTime() const;  //!< a surface is carried through the frames of a 4D volume
  std::string fault;        //!< a sentence with line and column why it cannot run; empty: it can
  std::string toldFault;    //!< the same for what is written: without the value if anonymous
};

//! The names of the columns, for messages and help.
std::string studyColumns();

//! For the rows that say nothing else.
struct StudyDefaults {
  CaseLimits limits;
  std::string format = "stl";  //!< ending of the mesh's file
  std::string folder;          //!< where relative paths begin; empty: the folder of the CSV file
};

//! Where relative paths of the study at `path` begin, absolute.
std::string folderOfPaths(const std::string& path, const StudyDefaults& defaults);

//! Reads and checks all rows of `text`, what is in the file at `path`. Throws InputError if there are no rows
//! to tell: a column is not known or missing, a quotation mark is not closed.
std::vector<StudyCase> readStudy(const std::string& text, const std::string& path,
                                 const StudyDefaults& defaults);

//! Seconds, and megabytes as bytes; 0: no limit. Throw UsageError that names the option.
double parseTimeLimit(const std::string& option, const std::string& text);
std::uint64_t parseMemoryLimit(const std::string& option, const std::string& text);

}  // namespace handlebody::cli
