#pragma once
// What others must know of the subcommand `segment`.

#include <string>
#include <vector>

namespace handlebody::cli {

//! A long option of `segment`.
struct SegmentOption {
  std::string name;         //!< without dashes
  std::string type;         //!< as the help calls its value; LABELMAP: a file
  bool isFlag = false;      //!< it has no value
  bool isRepeated = false;  //!< it may be given several times
};

//! All of them, in the order of the help.
std::vector<SegmentOption> segmentOptions();

//! `arguments` as on a command line behind `segment`. Throws UsageError for what would be refused before the
//! volume is read, apart from files that cannot be written.
void checkSegmentArguments(const std::vector<std::string>& arguments);

}  // namespace handlebody::cli
