// In the place of handlebody-cli's DICOM decoder: does what the name of the folder asks for.

#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

namespace {

using Message = nlohmann::json;
constexpr int kSocket = 3;

void tell(const Message& message) {
  const std::vector<std::uint8_t> bytes = Message::to_cbor(message);
  const auto length = static_cast<std::uint32_t>(bytes.size());
  if (write(kSocket, &length, 4) != 4 || write(kSocket, bytes.data(), length) != length) std::exit(7);
}

std::string pathOfRequest() {
  std::uint32_t length = 0;
  if (recv(kSocket, &length, 4, MSG_WAITALL) != 4) std::exit(7);
  std::vector<std::uint8_t> bytes(length);
  if (recv(kSocket, bytes.data(), length, MSG_WAITALL) != length) std::exit(7);
  return Message::from_cbor(bytes).at("path").get<std::string>();
}

void eat(const std::string& path) {
  constexpr std::size_t kBite = 16u << 20;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  constexpr int kMaxBites = 50;  // sanitizers need so much address space that there is no limit
#else
  constexpr int kMaxBites = 1000;
#endif
  int bites = 0;
  while (void* memory = bites < kMaxBites ? std::malloc(kBite) : nullptr) {
    std::memset(memory, 1, kBite);
    ++bites;
  }
  tell({{"input", path + ": ate " + std::to_string(16 * bites) + " MB."}});
}

}  // namespace

int main() {
  tell({{"ready", true}});
  const std::string path = pathOfRequest();
  const auto asked = [&](const char* what) { return path.find(what) != std::string::npos; };
  tell({{"part", 0.5}, {"file", path + "/slice-7"}, {"bytes", 1000}});
  if (asked("crash")) std::abort();
  if (asked("leave")) return 9;
  if (asked("eat")) eat(path);
  if (asked("nonsense")) tell({{"header", {{"grid", 7}}}});
  if (asked("noise") && write(kSocket, "\xff\xff\xff\xff rubbish", 12) != 12) return 7;
  if (asked("slow")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    tell({{"input", path + ": it was slow."}});
  }
  if (asked("spin"))
    for (volatile unsigned turns = 0;;) turns = turns + 1;
  if (asked("hang")) std::this_thread::sleep_for(std::chrono::seconds(60));
  return 0;
}
