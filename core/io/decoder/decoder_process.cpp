#include "core/io/decoder/decoder_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <optional>

#include "core/cancellation.h"
#include "core/io/address_space.h"
#include "core/told_error.h"

extern char** environ;

namespace handlebody {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

//! Patience counts the processor's time: where others are at work a good file takes longer by the clock. One
//! that sleeps, or waits for a disk, has so many times as much by the clock.
constexpr double kPatienceOfAsleep = 8;

std::string decoderProgram(const DecoderSettings& settings) {
  if (!settings.program.empty()) return settings.program;
  std::error_code failed;
  const fs::path folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
  // In a build tree the tests lie two or three folders beside the programs.
  for (const char* app : {"", "../../app", "../../../app"})
    if (const fs::path program = folder / app / "handlebody-cli"; fs::exists(program, failed))
      return program.string();
  return (folder / "handlebody-cli").string();
}

//! Above the numbers that the child is to find, so that nothing is overwritten on the way.
int movedUp(int file) {
  constexpr int kFree = 10;
  const int up = ::fcntl(file, F_DUPFD_CLOEXEC, kFree);
  ::close(file);
  return up;
}

struct SpawnSetup {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  SpawnSetup(int socket, int memory) {
    posix_spawn_file_actions_init(&files);
    for (int standard : {0, 1, 2})
      posix_spawn_file_actions_addopen(&files, standard, "/dev/null", standard ? O_WRONLY : O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, socket, kDecoderSocket);
    posix_spawn_file_actions_adddup2(&files, memory, kDecoderMemory);
    posix_spawn_file_actions_addclosefrom_np(&files, kDecoderMemory + 1);
    posix_spawnattr_init(&attributes);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
};

//! Of all threads of a child that runs. None where the system does not tell.
std::optional<double> processorSeconds(pid_t child) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(child, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return std::nullopt;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

//! What the child says is wrong.
template <typename Error>
[[noreturn]] void throwTold(const Message& message, const char* key) {
  const auto text = message.at(key).get<std::string>();
  const Finding finding = message.contains("finding") ? findingFromMessage(message.at("finding")) : Finding();
  if (finding.any()) throw Told<Error>(finding, text);
  throw Error(text);
}

}  // namespace

//! By way of another constructor: so the destructor ends the child where this one throws.
DecoderProcess::DecoderProcess(std::string path, const DecoderSettings& settings)
    : DecoderProcess(std::move(path), settings.patience, NotStarted{}) {
  const std::string program = decoderProgram(settings);
  if (::access(program.c_str(), X_OK) != 0)
    refuseInput(path_, {FindingKind::decoderMissing, {{"program", program}}});
  start(program);
  receive({}, 0, 0);  // it is ready
  base_ = addressSpace(child_);
  constexpr std::uint64_t kForHeaders = 512u << 20;
  allowMemory(kForHeaders);
}

void DecoderProcess::start(const std::string& program) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    refuseInput(path_, {FindingKind::decoderNotStarted, {{"reason", std::string(std::strerror(errno))}}});
  socket_ = ends[0];
  const timeval longest{10, 0};  // between the bytes of one message
  ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &longest, sizeof longest);
  const int theirs = movedUp(ends[1]);
  memory_ = movedUp(::memfd_create("handlebody-dicom", MFD_CLOEXEC));
  SpawnSetup setup(theirs, memory_);
  char name[] = "handlebody-cli", command[] = "decode-dicom";
  char* arguments[] = {name, command, nullptr};
  const int failed =
      ::posix_spawn(&child_, program.c_str(), &setup.files, &setup.attributes, arguments, environ);
  ::close(theirs);
  if (failed == 0) return;
  child_ = -1;
  refuseInput(path_, {FindingKind::decoderNotRun,
                      {{"program", program}, {"reason", std::string(std::strerror(failed))}}});
}

DecoderProcess::~DecoderProcess() {
  kill();
  if (socket_ >= 0) ::close(socket_);
  if (memory_ >= 0) ::close(memory_);
}

void DecoderProcess::kill() {
  if (child_ < 0) return;
  ::kill(child_, SIGKILL);
  while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
}

void DecoderProcess::send(const Message& message) {
  if (!sendMessage(socket_, message)) explainDeath();
}

void DecoderProcess::refuseOn(FindingKind whole, FindingKind part, Finding::Values values) const {
  const bool isPart = !file_.empty() && file_ != path_;
  if (isPart) values.emplace_back("part", file_);
  refuseInput(path_, {isPart ? part : whole, std::move(values)});
}

void DecoderProcess::explainDeath() {
  int status = 0;
  // It has closed its end; give it a moment to end by itself, for the reason.
  pid_t ended = 0;
  for (int i = 0; i < 100 && (ended = ::waitpid(child_, &status, WNOHANG)) == 0; ++i) ::poll(nullptr, 0, 10);
  if (ended == child_) child_ = -1;  // its number may be another's by now
  const bool signalled = WIFSIGNALED(status);
  kill();
  const std::string how = signalled ? std::string("signal: ") + strsignal(WTERMSIG(status))
                                    : "exit code " + std::to_string(WEXITSTATUS(status));
  refuseOn(FindingKind::decoderBroke, FindingKind::decoderBrokeOn, {{"how", how}});
}

void DecoderProcess::refuseHang() {
  kill();
  refuseOn(FindingKind::decoderStuck, FindingKind::decoderStuckOn);
}

void DecoderProcess::waitForMessage() {
  constexpr double kSlowestDisk = 20e6;  // bytes per second
  const double patience = patience_ + static_cast<double>(bytes_) / kSlowestDisk;
  const auto start = Clock::now();
  const std::optional<double> before = processorSeconds(child_);
  for (;;) {
    pollfd waiting{socket_, POLLIN, 0};
    if (::poll(&waiting, 1, 20) > 0) return;
    giveUpIfCancelled();
    const double waited = std::chrono::duration<double>(Clock::now() - start).count();
    const std::optional<double> now = processorSeconds(child_);
    const double worked = before && now ? *now - *before : waited;
    if (worked > patience || waited > kPatienceOfAsleep * patience) refuseHang();
  }
}

void DecoderProcess::noteProgress(const Message& m, const ReadProgress& progress, double from, double to) {
  file_ = m.at("file").get<std::string>();
  bytes_ = m.at("bytes").get<std::uint64_t>();
  handlebody::tellProgress(progress, from + m.at("part").get<double>() * (to - from));
}

Message DecoderProcess::receive(const ReadProgress& progress, double from, double to) try {
  for (;;) {
    waitForMessage();
    const std::optional<Message> message = receiveMessage(socket_);
    if (!message) explainDeath();
    if (message->contains("input")) throwTold<InputError>(*message, "input");
    if (message->contains("usage")) throwTold<UsageError>(*message, "usage");
    if (!message->contains("part")) return *message;
    noteProgress(*message, progress, from, to);
  }
} catch (const Message::exception&) {
  refuseOn(FindingKind::decoderAnswerOnIt, FindingKind::decoderAnswerOn);
}

void DecoderProcess::allowMemory(std::uint64_t bytes) {
  if (!canLimitAddressSpace(base_)) return;
  const rlimit limit{base_ + bytes, RLIM_INFINITY};
  ::prlimit(child_, RLIMIT_AS, &limit, nullptr);
}

std::shared_ptr<void> DecoderProcess::takeMemory(std::uint64_t bytes) {
  kill();  // nobody may shrink the memory any more
  struct stat status {};
  if (::fstat(memory_, &status) != 0 || static_cast<std::uint64_t>(status.st_size) < bytes)
    refuseInput(path_, FindingKind::decoderGaveLess);
  // To be written, too: the reader puts numbers where there are none. Shared, since nobody shares it any more
  // and a private mapping that is populated for writing is a copy.
  void* memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE, memory_, 0);
  if (memory == MAP_FAILED) refuseInput(path_, FindingKind::notEnoughMemory);
  return {memory, [bytes](void* p) { ::munmap(p, bytes); }};
}

}  // namespace handlebody
