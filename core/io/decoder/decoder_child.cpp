// The child process's side of decoding: one request, a header, the voxels (or a mesh) into shared memory.

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "core/io/decoder/decoder_channel.h"
#include "core/io/dicom/dicom_source.h"
#include "core/io/meshes/mesh_files.h"
#include "core/told_error.h"

#ifdef HANDLEBODY_COVERAGE
extern "C" {  // GCC 12's header does not say so
#include <gcov.h>
}
#endif

namespace handlebody {
namespace {

//! For builds that count which lines run: those so far count, though the parent may end this process as soon
//! as it has the answer.
void countLines() {
#ifdef HANDLEBODY_COVERAGE
  __gcov_dump();
  __gcov_reset();
#endif
}

//! The last that is said, or nearly so.
bool sendAnswer(const Message& message) {
  countLines();
  return sendMessage(kDecoderSocket, message);
}

//! Says which file comes next, so that the parent can name it if this process dies, and when to be patient.
class Teller {
 public:
  void operator()(double part, const std::string& file, std::uint64_t bytes) {
    const auto now = std::chrono::steady_clock::now();
    if (file == last_ && now - told_ < std::chrono::milliseconds(20)) return;
    last_ = file;
    told_ = now;
    sendMessage(kDecoderSocket, {{"part", part}, {"file", file}, {"bytes", bytes}});
  }

 private:
  std::string last_;
  std::chrono::steady_clock::time_point told_{};
};

//! Fills the parent's memory file; throws InputError if the machine has not so much.
void fillMemory(DecodedSource& source, int frame, const std::string& path, const DecodingProgress& tell) {
  const std::uint64_t bytes = source.header().bytesPerFrame();
  if (::ftruncate(kDecoderMemory, static_cast<off_t>(bytes)) != 0)
    refuseInput(path, FindingKind::notEnoughMemory);
  void* memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, kDecoderMemory, 0);
  if (memory == MAP_FAILED) refuseInput(path, FindingKind::notEnoughMemory);
  source.decode(frame, memory, tell);
}

void answer(const OpenRequest& request) {
  Teller teller;
  const DecodingProgress tell = std::ref(teller);
  const SourcePointer source =
      request.format == "TIFF" ? openTiffHere(request, tell) : openDicomHere(request, tell);
  if (!sendAnswer({{"header", headerToMessage(source->header())}})) return;
  const std::optional<Message> go = receiveMessage(kDecoderSocket);
  if (!go || source->header().isChoice) return;  // only the header was wanted
  fillMemory(dynamic_cast<DecodedSource&>(*source), go->at("frame").get<int>(), request.path, tell);
  sendAnswer({{"done", true}});
}

//! Points and triangles of a VTP file, one after the other.
void answerMesh(const std::string& path) {
  std::error_code ignored;
  sendMessage(kDecoderSocket,
              {{"part", 0}, {"file", path}, {"bytes", std::filesystem::file_size(path, ignored)}});
  const MeshFile file = readVtpHere(path);
  const std::size_t points = file.mesh.points.size() * sizeof(Vec3);
  const std::size_t triangles = file.mesh.triangles.size() * sizeof(Triangle);
  if (::ftruncate(kDecoderMemory, static_cast<off_t>(points + triangles + 1)) != 0)
    refuseInput(path, FindingKind::notEnoughMemory);
  void* memory =
      ::mmap(nullptr, points + triangles + 1, PROT_READ | PROT_WRITE, MAP_SHARED, kDecoderMemory, 0);
  if (memory == MAP_FAILED) refuseInput(path, FindingKind::notEnoughMemory);
  std::memcpy(memory, file.mesh.points.data(), points);
  std::memcpy(static_cast<char*>(memory) + points, file.mesh.triangles.data(), triangles);
  sendAnswer({{"points", file.mesh.points.size()},
              {"triangles", file.mesh.triangles.size()},
              {"ras", file.space == CoordinateSpace::ras}});
}

template <typename Error>
void tell(const char* kind, const Error& error) {
  Message message{{kind, error.what()}};
  if (const Finding finding = findingOf(error); finding.any()) message["finding"] = findingToMessage(finding);
  sendAnswer(message);
}

void tellRefusal(const std::string& path, const Finding& cause) {
  tell("input", Told<InputError>(Finding(FindingKind::fileRefused, {{"file", path}}, cause)));
}

}  // namespace

int runDicomDecoder() {
  // Never outlive the process that asked.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit nothing{0, 0};
  ::setrlimit(RLIMIT_CORE, &nothing);  // no core files of aborted decoders
  if (!sendMessage(kDecoderSocket, {{"ready", true}})) return 1;
  const std::optional<Message> message = receiveMessage(kDecoderSocket);
  if (!message) return 1;
  OpenRequest request;
  try {
    if (message->contains("mesh")) {
      request.path = message->at("mesh").get<std::string>();
      answerMesh(request.path);
      return 0;
    }
    request = requestFromMessage(*message);
    answer(request);
  } catch (const UsageError& error) {
    tell("usage", error);
  } catch (const InputError& error) {
    tell("input", error);
  } catch (const std::bad_alloc&) {
    tellRefusal(request.path, FindingKind::decodingMemory);
  } catch (const std::exception& error) {
    tellRefusal(request.path, {FindingKind::decodingFailed, {{"reason", std::string(error.what())}}});
  }
  return 0;
}

}  // namespace handlebody
