#pragma once
// Small valid files of every format, by the project's own writers.

#include <string>
#include <vector>

namespace handlebody::test {

struct Sample {
  std::string name;  //!< with the extension that its reader expects
  std::string bytes;
  bool isModel = false;  //!< the XML of a .3mf, which is packed when it has been damaged
};

//! `folder`: an empty one to work in.
std::vector<Sample> fuzzCorpus(const std::string& folder);

}  // namespace handlebody::test
