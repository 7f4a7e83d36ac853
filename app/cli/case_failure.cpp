#include "app/cli/case_failure.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

#include "app/cli/csv.h"
#include "core/io/report/json.h"

namespace handlebody::cli {

namespace {

//! Bytes. With what stands around it less than a page, which every pipe holds: a case never waits for its
//! batch, which reads at the end.
constexpr std::size_t kLongestTold = 3000;

}  // namespace

Started startedWith(std::vector<std::string> arguments) {
  if (arguments.empty() || arguments[0] != kAsCase) return {std::move(arguments), false};
  arguments.erase(arguments.begin());
  // The children of a case tell nothing.
  return {std::move(arguments), ::fcntl(kFailurePipe, F_SETFD, FD_CLOEXEC) == 0};
}

void tellFailure(const CaseFailure& failure) noexcept try {
  // CBOR: the message may name files, which are any bytes.
  const Json told{{"message", shortened(failure.message, kLongestTold)},
                  {"out_of_memory", failure.isOutOfMemory}};
  const std::vector<std::uint8_t> bytes = Json::to_cbor(told);
  [[maybe_unused]] const ssize_t count = ::write(kFailurePipe, bytes.data(), bytes.size());
} catch (const std::exception&) {  // the log has the sentence
}

CaseFailure toldFailure(int pipe) {
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 4096> part{};
  for (ssize_t count = 0; (count = ::read(pipe, part.data(), part.size())) != 0;) {
    if (count < 0 && errno != EINTR) break;
    if (count > 0) bytes.insert(bytes.end(), part.begin(), part.begin() + count);
  }
  try {
    const Json told = Json::from_cbor(bytes);
    return {told.at("message").get<std::string>(), told.at("out_of_memory").get<bool>()};
  } catch (const Json::exception&) {
    return {};
  }
}

}  // namespace handlebody::cli
