#pragma once
// Internal: a program run to its end, or not so far.

#include <string>
#include <vector>

namespace handlebody {

//! How it ended.
struct ProgramEnd {
  bool isStarted = false;
  bool isTooLong = false;  //!< it was ended at the time limit
  int exitCode = -1;       //!< -1: it did not get so far
  int signal = 0;          //!< that ended it; 0: none
};

//! Starts command[0], a path, without a shell, in a process group of its own; what it says goes to the file
//! `log`. Numbers have a point there, whatever the user's language. When it has ended, after `seconds` by the
//! clock, or when the stop token is set (cancellation.h: Cancelled is thrown), it is killed with all that
//! it has started and that is of its group. It ends with this thread, even if that is killed.
ProgramEnd runLimited(std::vector<std::string> command, const std::string& log, double seconds);

}  // namespace handlebody
