#include "core/io/address_space.h"

#include <unistd.h>

#include <fstream>
#include <string>

namespace handlebody {

std::uint64_t addressSpace(int process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  std::uint64_t pages = 0;
  file >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGE_SIZE));
}

bool canLimitAddressSpace(std::uint64_t atRest) {
  constexpr std::uint64_t kSanitized = 1ULL << 40U;
  return atRest != 0 && atRest <= kSanitized;
}

}  // namespace handlebody
