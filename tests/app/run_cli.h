#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/temp_folder.h"

namespace handlebody::test {

//! What a run of handlebody-cli left behind.
struct Outcome {
  int exitCode = -1;  //!< minus the signal's number if one ended it
  std::string out, err;
};

//! A run that goes on while the test does something else.
class RunningCli {
 public:
  explicit RunningCli(const std::vector<std::string>& arguments);
  //! Kills it if it still runs.
  ~RunningCli();
  RunningCli(const RunningCli&) = delete;
  RunningCli& operator=(const RunningCli&) = delete;

  int process() const { return child_; }
  //! Processes that it has started and that still run.
  std::vector<int> children() const;
  //! Waits until it has started one that is at work, and gives that.
  int waitForChild() const;
  //! Waits for its end.
  Outcome wait();

 private:
  TempFolder folder_;
  int child_ = -1;
};

//! Runs the program that was built beside the tests, with nothing on its standard input.
//! With `interruptAfter` > 0 it gets an interrupt (Ctrl-C) after so many milliseconds.
Outcome runCli(const std::vector<std::string>& arguments, int interruptAfter = 0);

//! The same with a terminal as its standard error, whose text is Outcome::err.
Outcome runCliAtTerminal(const std::vector<std::string>& arguments);

//! Runs it and requires exit code 0; the standard output as JSON.
nlohmann::json runForJson(const std::vector<std::string>& arguments);

//! A small phantom on disk, and a seed in it as an option's value: X,Y,Z,R.
struct PhantomFile {
  std::string path, seed;
  nlohmann::json json;  //!< what the program printed
};
PhantomFile makePhantomFile(const TempFolder& folder, const std::string& name = "sphere.mha",
                            const std::vector<std::string>& more = {}, const std::string& phantom = "sphere");

}  // namespace handlebody::test
