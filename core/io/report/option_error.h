#pragma once
// What is wrong with one option.

#include <string>
#include <utility>

#include "core/errors.h"
#include "core/finding.h"

namespace handlebody {

//! A UsageError of one option, for those who must know of which.
class OptionError : public UsageError {
 public:
  //! `option` as on the command line: "--edge-length", "-o". The message is "option: reason"; `between` is a
  //! space where the reason begins with the option's value.
  OptionError(std::string option, const std::string& reason, std::string between = ": ")
      : OptionError(std::move(option), Finding(FindingKind::other, {{"text", reason}}), std::move(between)) {}
  OptionError(std::string option, Finding reason, std::string between = ": ")
      : UsageError(option + between + sentence(reason)),
        option_(std::move(option)),
        between_(std::move(between)),
        reason_(std::move(reason)) {}

  const std::string& option() const { return option_; }
  std::string reason() const { return sentence(reason_); }
  //! The message with options as Python or another door writes them.
  std::string message(OptionSpelling spelled) const {
    const bool isLong = option_.starts_with("--");
    return (isLong ? spelled(std::string_view(option_).substr(2)) : option_) + between_ +
           sentence(reason_, spelled);
  }

 private:
  std::string option_, between_;
  Finding reason_;
};

}  // namespace handlebody
