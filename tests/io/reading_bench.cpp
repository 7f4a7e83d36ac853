// reading_bench FOLDER [SLICES]
//
// A CT of 512 x 512 x 600 voxels of 16 bits, written once into FOLDER in every format, opened by this program
// and by plain ITK in turn: the median of the ratios, and how long a cancelled opening takes to return.

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "core/cancellation.h"
#include "tests/io/dicom_test_support.h"

void registerItkFormats();
long readWithItk(const std::string& path);

namespace handlebody::test {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int kSide = 512;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

//! Of this process and the decoders that have ended.
double processorSeconds() {
  double sum = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& t : {usage.ru_utime, usage.ru_stime})
      sum += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  }
  return sum;
}

struct Cost {
  double seconds = 0, processor = 0;
};

template <typename F>
Cost timed(F&& f) {
  const auto start = Clock::now();
  const double before = processorSeconds();
  f();
  return {secondsSince(start), processorSeconds() - before};
}

//! Tissue, air around it, and noise of four bits.
Volume thorax(int slices) {
  Grid grid;
  grid.size = {kSide, kSide, slices};
  grid.spacing = Vec3(0.7, 0.7, 1);
  void* buffer = nullptr;
  Volume volume = makeVolume(grid, VoxelType::int16, &buffer);
  auto* to = static_cast<std::int16_t*>(buffer);
  std::uint32_t noise = 1;
  for (int k = 0; k < slices; ++k)
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        noise = noise * 1664525u + 1013904223u;
        const bool inside = std::hypot(x - 256, 1.4 * (y - 256)) < 230;
        *to++ = static_cast<std::int16_t>(inside ? 40 + static_cast<int>(noise >> 28) : -1000);
      }
  return volume;
}

void writeSlices(const Volume& volume, const std::string& folder) {
  const std::size_t pixels = std::size_t{kSide} * kSide;
  std::vector<Slice> slices;
  for (int k = 0; k < volume.grid.size[2]; ++k) {
    Slice s;
    s.columns = s.rows = kSide;
    s.spacing = "0.7\\0.7";
    s.position = Vec3(0, 0, k);
    s.number = k + 1;
    const auto* first = volume.data<std::int16_t>() + pixels * static_cast<std::size_t>(k);
    s.pixel = [first](int x, int y) { return int{first[y * kSide + x]}; };
    slices.push_back(s);
  }
  writeSeries(folder, slices);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

//! Seconds from setting the stop token, half way through, to the return.
double cancelTime(const std::string& path, double whole) {
  std::atomic<bool> cancelled = false;
  Clock::time_point asked;
  std::thread user([&] {
    std::this_thread::sleep_for(std::chrono::duration<double>(whole / 2));
    asked = Clock::now();
    cancelled = true;
  });
  const CancelScope scope(cancelled);
  bool read = false;
  try {
    loadVolume(path);
    read = true;
  } catch (const Cancelled&) {
  }
  const auto end = Clock::now();
  user.join();
  return read ? -1 : std::chrono::duration<double>(end - asked).count();
}

void compare(const std::string& name, const std::string& path) {
  std::vector<double> ours, theirs, ratios, processor;
  for (int round = 0; round < 5; ++round) {
    const Cost a = timed([&] { readVolume(path); }), b = timed([&] { readWithItk(path); });
    ours.push_back(a.seconds);
    theirs.push_back(b.seconds);
    ratios.push_back(a.seconds / b.seconds);
    processor.push_back(a.processor / b.processor);
  }
  std::printf(
      "%-14s ours %7.3f s  ITK %7.3f s  ratio %.2f (of processor time %.2f)  cancelled after %.3f s\n",
      name.c_str(), median(ours), median(theirs), median(ratios), median(processor),
      cancelTime(path, median(ours)));
  std::fflush(stdout);
}

}  // namespace

}  // namespace handlebody::test

int main(int argc, char** argv) {
  using namespace handlebody::test;
  if (argc < 2) return 2;
  const std::string folder = argv[1];
  const int slices = argc > 2 ? std::atoi(argv[2]) : 600;
  registerItkFormats();
  std::filesystem::create_directories(folder);
  {
    const handlebody::Volume volume = thorax(slices);
    for (const char* name : {"v.mha", "v.nii", "packed.nii.gz", "v.nrrd"})
      if (!std::filesystem::exists(folder + "/" + name)) handlebody::writeVolume(volume, folder + "/" + name);
    if (!std::filesystem::exists(folder + "/dicom")) writeSlices(volume, folder + "/dicom");
  }
  for (const char* name : {"v.nii", "packed.nii.gz", "v.nrrd", "v.mha", "dicom"})
    compare(name, folder + "/" + name);
}
