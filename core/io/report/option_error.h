#pragma once
// What is wrong with one option.

#include <string>

#include "core/errors.h"

namespace handlebody {

//! A UsageError of one option, for those who must know of which.
class OptionError : public UsageError {
 public:
  //! `option` with its dashes. The message is "option: reason"; `between` is a space where the reason begins
  //! with the option's value.
  OptionError(const std::string& option, const std::string& reason, const std::string& between = ": ")
      : UsageError(option + between + reason), option_(option), reason_(reason) {}
  const std::string& option() const { return option_; }
  const std::string& reason() const { return reason_; }

 private:
  std::string option_, reason_;
};

}  // namespace handlebody
