// Writes the handle database to standard output: make_handles > resources/handles/handles.txt

#include <exception>
#include <iostream>

#include "core/handles/handle_database.h"

int main() {
  try {
    std::cout << handlebody::makeHandleDatabase() << std::flush;
    return std::cout.good() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "make_handles: " << error.what() << '\n';
    return 1;
  }
}
