#pragma once
// What a case of a batch tells the batch when it fails, apart from the sentence for people in its log.

#include <string>
#include <vector>

namespace handlebody::cli {

struct CaseFailure {
  std::string message;  //!< a line; empty: it told nothing
  bool isOutOfMemory = false;
};

//! The first word behind the name of a program that is started as a case: this end of a pipe is open then.
//! Not for users.
inline constexpr const char* kAsCase = "as-case";
inline constexpr int kFailurePipe = 3;

//! How a program was started.
struct Started {
  std::vector<std::string> arguments;  //!< without that word
  bool isCase = false;
};
//! Called once, before anything is opened.
Started startedWith(std::vector<std::string> arguments);
//! Does nothing where it cannot be written. Precondition: this process is a case.
void tellFailure(const CaseFailure& failure) noexcept;

//! What was written into a pipe by a process that has ended.
CaseFailure toldFailure(int pipe);

}  // namespace handlebody::cli
