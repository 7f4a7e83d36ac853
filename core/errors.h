#pragma once
// The typed errors a caller or a file can cause. Messages are whole sentences that name the file or the
// option.

#include <stdexcept>
#include <string>

namespace handlebody {

//! A file cannot be read, is damaged, or holds something that is not supported. The message names the file.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

//! A file cannot be written. The message names the file.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

//! An option or parameter has no meaning (negative length, empty range …). The message names the option.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

//! A seed is outside the volume or not in an object.
class SeedError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace handlebody
