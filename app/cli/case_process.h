#pragma once
// A case of a batch as a child process of this program: what it breaks is its own.

#include <chrono>
#include <string>
#include <vector>

#include "app/cli/case_failure.h"
#include "app/cli/study.h"

namespace handlebody::cli {

//! How it ended.
struct CaseEnd {
  int exitCode = -1;  //!< -1: it did not get so far
  int signal = 0;     //!< that ended it; 0: none
  bool isTimedOut = false;
  double seconds = 0;  //!< by the clock
  double cpuSeconds = 0;
  double peakMegabytes = 0;  //!< of resident memory
  CaseFailure failure;       //!< as it told
};

class CaseProcess {
 public:
  //! Starts `handlebody-cli arguments` in a process group of its own, without a shell, its standard error in
  //! the file `log`. It ends with this process, even if that is killed. Precondition: called on the thread
  //! that lives as long as the process. Throws OutputError, std::runtime_error if it cannot be started.
  CaseProcess(const std::vector<std::string>& arguments, const std::string& log, const CaseLimits& limits);
  //! Kills it with what it has started.
  ~CaseProcess();
  CaseProcess(const CaseProcess&) = delete;
  CaseProcess& operator=(const CaseProcess&) = delete;

  //! True once it has ended, by itself or at its time limit; does not wait.
  bool hasEnded();
  //! Precondition: it has ended.
  const CaseEnd& end() const { return end_; }

 private:
  void kill() const;
  void note();
  int child_ = -1;
  int failurePipe_ = -1;
  CaseLimits limits_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  CaseEnd end_;
};

//! The sentence for one that failed: what it told, or what stopped it; else the last line of its log.
std::string failureSentence(const CaseEnd& end, const CaseLimits& limits, const std::string& log);
//! The same without what the case said, which may name its volume: for what is written of an anonymous one.
std::string anonymousFailureSentence(const CaseEnd& end, const CaseLimits& limits);

}  // namespace handlebody::cli
