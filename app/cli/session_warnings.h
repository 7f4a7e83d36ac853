#pragma once
// What is to be known of a session before it is grown again: what `replay` and `measure` share.

#include <string>
#include <vector>

#include "core/io/report/session.h"

namespace handlebody::cli {

//! Takes away the objects that nobody has clicked into yet, which a window keeps; tells of each. What the
//! window keeps of its own stays the first one's.
std::vector<Finding> leaveOutUnseeded(std::vector<Session>& sessions);

//! Where another version of the program has made it. `called`: what the session is called.
std::vector<Finding> warningsOfVersion(const std::string& called, const std::string& version);

//! A line each on standard error.
void tellWarnings(const std::vector<Finding>& warnings);

}  // namespace handlebody::cli
