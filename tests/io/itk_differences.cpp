// itk_differences FILE...
//
// What ITK's own readers make of volumes, beside what this program makes of them: one line per file, the
// evidence of docs/formats.md. ITK reads in a process of its own, with 3 GB and ten seconds of the processor.

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkTIFFImageIO.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "core/errors.h"
#include "core/io/formats/volume_io.h"

namespace handlebody::test {

namespace {

//! The first time point as one of the two sees it.
struct Seen {
  bool isRead = false;
  std::array<int, 3> size{1, 1, 1};
  int frames = 1;
  std::array<double, 3> spacing{}, origin{};
  std::array<double, 9> direction{};  // by rows
  std::uint64_t hash = 0;
  char why[200] = "";  // it was refused
};

std::size_t voxelCount(const Seen& seen) {
  std::size_t n = 1;
  for (int s : seen.size) n *= static_cast<std::size_t>(s);
  return n;
}

template <typename Value>
void hashVoxels(Seen& seen, const Value& value) {
  seen.hash = 1469598103934665603u;
  for (std::size_t i = 0, n = voxelCount(seen); i < n; ++i) {
    const float v = std::isnan(value(i)) ? -12345.0F : static_cast<float>(value(i)) + 0.0F;
    std::uint32_t bits;
    std::memcpy(&bits, &v, sizeof bits);
    seen.hash = (seen.hash ^ bits) * 1099511628211u;
  }
}

void say(Seen& seen, const std::string& why) { std::snprintf(seen.why, sizeof seen.why, "%s", why.c_str()); }

itk::ImageIOBase::Pointer readerOf(const std::string& path) {
  std::string start(4, '\0');
  std::ifstream(path, std::ios::binary).read(start.data(), 4);
  const auto is = [&](int size) { return start[0] == static_cast<char>(size) && start[1] == size >> 8; };
  if (start == "NRRD") return itk::NrrdImageIO::New().GetPointer();
  if (start.starts_with("II*") || start.starts_with("MM")) return itk::TIFFImageIO::New().GetPointer();
  const bool isText = path.ends_with(".mha") || path.ends_with(".mhd");
  if (start.starts_with("\x1f\x8b") || is(348) || is(540) || !isText)
    return itk::NiftiImageIO::New().GetPointer();
  return itk::MetaImageIO::New().GetPointer();
}

template <typename T>
void hashComponents(Seen& seen, const char* bytes, std::size_t components) {
  const auto* in = reinterpret_cast<const T*>(bytes);
  if (components < 3)
    hashVoxels(seen, [&](std::size_t i) { return static_cast<double>(in[components * i]); });
  else
    hashVoxels(seen, [&](std::size_t i) {
      const T* c = in + components * i;
      return static_cast<double>(std::lround(0.2125 * static_cast<double>(c[0]) +
                                             0.7154 * static_cast<double>(c[1]) +
                                             0.0721 * static_cast<double>(c[2])));
    });
}

void hashItk(Seen& seen, const itk::ImageIOBase& io, const char* bytes) {
  using E = itk::IOComponentEnum;
  const std::size_t n = io.GetNumberOfComponents();
  switch (io.GetComponentType()) {
    case E::UCHAR:
      return hashComponents<std::uint8_t>(seen, bytes, n);
    case E::CHAR:
      return hashComponents<std::int8_t>(seen, bytes, n);
    case E::USHORT:
      return hashComponents<std::uint16_t>(seen, bytes, n);
    case E::SHORT:
      return hashComponents<std::int16_t>(seen, bytes, n);
    case E::UINT:
      return hashComponents<std::uint32_t>(seen, bytes, n);
    case E::INT:
      return hashComponents<std::int32_t>(seen, bytes, n);
    case E::ULONG:
    case E::ULONGLONG:
      return hashComponents<std::uint64_t>(seen, bytes, n);
    case E::LONG:
    case E::LONGLONG:
      return hashComponents<std::int64_t>(seen, bytes, n);
    case E::FLOAT:
      return hashComponents<float>(seen, bytes, n);
    default:
      return hashComponents<double>(seen, bytes, n);
  }
}

void readWithItk(const std::string& path, Seen& seen) {
  const itk::ImageIOBase::Pointer io = readerOf(path);
  io->SetFileName(path);
  io->ReadImageInformation();
  const unsigned dimensions = io->GetNumberOfDimensions();
  itk::ImageIORegion region(dimensions);
  for (unsigned a = 0; a < dimensions; ++a) region.SetSize(a, io->GetDimensions(a));
  io->SetIORegion(region);
  for (unsigned a = 0; a < std::min(3u, dimensions); ++a) {
    seen.size[a] = static_cast<int>(io->GetDimensions(a));
    seen.spacing[a] = io->GetSpacing(a);
    seen.origin[a] = io->GetOrigin(a);
    for (unsigned r = 0; r < std::min(3u, dimensions); ++r)
      seen.direction[3 * r + a] = io->GetDirection(a)[r];
  }
  if (dimensions > 3) seen.frames = static_cast<int>(io->GetDimensions(3));
  // What is never written shows.
  std::vector<char> bytes(io->GetImageSizeInBytes(), '\xa5');
  io->Read(bytes.data());
  hashItk(seen, *io, bytes.data());
  seen.isRead = true;
}

//! In a process of its own, which may die of it.
Seen itkSees(const std::string& path) {
  void* shared = ::mmap(nullptr, sizeof(Seen), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  Seen& seen = *new (shared) Seen;
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit memory{3u << 30, 3u << 30}, time{10, 12}, core{0, 0};
    ::setrlimit(RLIMIT_AS, &memory);
    ::setrlimit(RLIMIT_CORE, &core);
    ::setrlimit(RLIMIT_CPU, &time);
    itk::Object::GlobalWarningDisplayOff();
    if (!std::freopen("/dev/null", "w", stderr)) ::_exit(1);
    try {
      readWithItk(path, seen);
    } catch (const itk::ExceptionObject& error) {
      say(seen, std::string("refuses: ") + error.GetDescription());
    } catch (const std::exception& error) {
      say(seen, std::string("refuses: ") + error.what());
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    say(seen, WTERMSIG(status) == SIGXCPU ? "HANGS" : std::string("CRASHES: ") + strsignal(WTERMSIG(status)));
  const Seen result = seen;
  ::munmap(shared, sizeof(Seen));
  return result;
}

Seen weSee(const std::string& path) {
  Seen seen;
  try {
    const LoadedVolume loaded = loadVolume(path);
    const Grid& grid = loaded.volume.grid;
    seen.size = grid.size;
    seen.frames = loaded.info.frames;
    for (int a = 0; a < 3; ++a) {
      const auto i = static_cast<std::size_t>(a);
      seen.spacing[i] = grid.spacing[a];
      seen.origin[i] = grid.origin[a];
      for (int r = 0; r < 3; ++r) seen.direction[3 * static_cast<std::size_t>(r) + i] = grid.direction(r, a);
    }
    const bool hasNone =
        std::any_of(loaded.info.warnings.begin(), loaded.info.warnings.end(),
                    [](const Finding& w) { return w.kind == FindingKind::voxelsNotNumbers; });
    visitVoxels(loaded.volume, [&](const auto* in) {
      const auto none = *std::min_element(in, in + grid.voxelCount());  // what is not a number lies below all
      hashVoxels(seen, [&](std::size_t i) {
        return hasNone && in[i] == none ? std::nan("") : static_cast<double>(in[i]);
      });
    });
    seen.isRead = true;
  } catch (const InputError& error) {
    say(seen, "refuses: " + std::string(error.what()).substr(path.size() + 2));
  }
  return seen;
}

template <std::size_t N>
bool isNear(const std::array<double, N>& a, const std::array<double, N>& b) {
  for (std::size_t i = 0; i < N; ++i)
    if (!(std::abs(a[i] - b[i]) <= 1e-4 * (1 + std::abs(a[i])))) return false;
  return true;
}

std::string verdict(const Seen& ours, const Seen& theirs) {
  if (!ours.isRead && !theirs.isRead) return std::string("ours and ITK refuse; ITK ") + theirs.why;
  if (!theirs.isRead) return std::string("only ours reads; ITK ") + theirs.why;
  if (!ours.isRead) return std::string("only ITK reads; ours ") + ours.why;
  std::string differs;
  if (ours.size != theirs.size) differs += " size";
  if (ours.frames != theirs.frames) differs += " frames";
  if (ours.hash != theirs.hash) differs += " VOXELS";
  if (!isNear(ours.spacing, theirs.spacing)) differs += " spacing";
  if (!isNear(ours.origin, theirs.origin)) differs += " origin";
  if (!isNear(ours.direction, theirs.direction)) differs += " direction";
  return differs.empty() ? "same" : "differ:" + differs;
}

}  // namespace

}  // namespace handlebody::test

int main(int argc, char** argv) {
  using namespace handlebody::test;
  for (int i = 1; i < argc; ++i) {
    std::string line = verdict(weSee(argv[i]), itkSees(argv[i]));
    std::replace(line.begin(), line.end(), '\n', ' ');
    std::printf("%s\t%s\n", argv[i], line.c_str());
    std::fflush(stdout);
  }
}
