#pragma once
// Internal: limits on the memory of child processes.

#include <cstdint>

namespace handlebody {

//! Bytes of address space of a process; 0 if not known.
std::uint64_t addressSpace(int process);

//! False in a program with the address sanitizer: it reserves terabytes, and nothing can be limited there.
bool canLimitAddressSpace(std::uint64_t atRest);

}  // namespace handlebody
