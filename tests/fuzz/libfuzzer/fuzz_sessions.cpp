// Sessions and reports.

#include "core/io/report/session.h"
#include "tests/fuzz/libfuzzer/scratch_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t n) {
  static const handlebody::test::ScratchFile file("s.json");
  return handlebody::test::answeredOrRefused([&] { handlebody::readSession(file.write(bytes, n)); });
}
