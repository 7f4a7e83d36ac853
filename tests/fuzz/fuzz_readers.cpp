// fuzz_readers COUNT [--seed N] [--decoder CLI] [--files FOLDER --cli CLI] [--commands --cli CLI]
// fuzz_readers --corpus FOLDER
//
// Damaged files through the readers: they read or throw InputError or UsageError, within ten seconds each.
// Without --files: the project's own samples, in this process; with --decoder those that a child process
// reads. With --commands: label maps, segmentations, 3MF and meshes of these through whole runs of `mesh`,
// `edit` and `compare` of CLI, which write a result or say one sentence. With --corpus the samples are
// written for the libFuzzer targets. With --files: the real files of a folder, whole `info` and `segment`
// runs of CLI. A file that breaks something stays behind, and its path is printed.

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "core/errors.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/label_file.h"
#include "core/io/report/session.h"
#include "core/io/report/start_surface.h"
#include "tests/fuzz/corpus.h"
#include "tests/fuzz/mutate.h"
#include "tests/fuzz/run_program.h"
#include "tests/io/zip_test_support.h"

namespace handlebody::test {

namespace {

namespace fs = std::filesystem;
constexpr double kLongest = 10;  // seconds

struct Options {
  std::size_t count = 1000, first = 0;
  std::uint64_t seed = 1;
  std::string decoder, files, cli, corpus;
  bool commands = false;
};

struct Tally {
  std::size_t read = 0, refused = 0, broken = 0;
  double longest = 0;
  long memory = 0;  // kB, of child programs
};

std::string bytesOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void writeFile(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

//! True if it was read, false if it was refused as it should be.
bool readAny(const std::string& path, const DecoderSettings& decoder) try {
  labelIn(path, 1);
  if (path.ends_with(".json"))
    readSession(path);
  else if (isMeshInputPath(path))
    readMesh(path, decoder);
  else if (path.find(".seg.") != std::string::npos)
    LabelFile(path, decoder).labels();
  else
    readVolume(path, {.decoder = decoder});
  return true;
} catch (const InputError&) {
  return false;
} catch (const UsageError&) {
  return false;
}

//! The exit code of `info` and of `segment`; false where one is none of the contract's.
bool runAll(const std::string& cli, const std::string& path, const std::string& folder, Tally& tally) {
  const auto fine = [](const ProgramEnd& end) { return end.code == 0 || (end.code >= 2 && end.code <= 5); };
  const ProgramEnd info = runProgram({cli, "info", path}, 2 * kLongest);
  const ProgramEnd segment = runProgram({cli, "segment", path, "--seed-ijk", "5,5,5,2", "--range", "-inf,inf",
                                         "--max-iterations", "2", "-o", folder + "/out.stl", "--quiet"},
                                        2 * kLongest);
  tally.memory = std::max({tally.memory, info.memory, segment.memory});
  (info.code == 0 ? tally.read : tally.refused) += 1;
  return fine(info) && fine(segment);
}

//! An error is one line that begins with the program's name, ends with a point, and is not its own fault.
bool isOneSentence(const std::string& errors) {
  constexpr std::size_t kLongestSentence = 700;
  const std::string kName = "handlebody-cli: ";
  std::ifstream in(errors);
  std::vector<std::string> said;
  for (std::string line; std::getline(in, line);)
    if (line.rfind(kName + "warning: ", 0) != 0) said.push_back(line);
  return said.size() == 1 && said[0].rfind(kName, 0) == 0 && said[0].ends_with('.') &&
         said[0].size() < kLongestSentence && said[0].find("internal error") == std::string::npos;
}

bool runCommands(const std::string& cli, const std::string& path, const std::string& folder, Tally& tally) {
  const std::string out = folder + "/out.stl", errors = folder + "/errors", whole = folder + "/whole.mha";
  std::vector<std::vector<std::string>> commands{
      {cli, "compare", path, whole, "--sampling", "1"},
      {cli, "compare", whole, path, "--label-b", "1", "--sampling", "1"}};
  if (isMeshPath(path) || path.ends_with(".3mf"))
    commands.push_back({cli, "edit", path, "--keep-largest", "--polish", "all", "-o", out});
  if (!isMeshPath(path)) commands.push_back({cli, "mesh", path, "-o", out});
  if (path.find(".layers.") != std::string::npos)
    commands.push_back({cli, "mesh", path, "--label", "some", "-o", out});
  bool isFine = true;
  for (const std::vector<std::string>& words : commands) {
    const ProgramEnd end = runProgram(words, kLongest, errors);
    tally.memory = std::max(tally.memory, end.memory);
    (end.code == 0 ? tally.read : tally.refused) += 1;
    const bool isExpected = end.code == 0 || ((end.code == 2 || end.code == 3) && isOneSentence(errors));
    if (!isExpected) std::cerr << words[1] << " ended with " << end.code << ": " << bytesOf(errors);
    isFine = isFine && isExpected;
  }
  return isFine;
}

//! What they are for; and a whole label map to compare with. The STL within DICOM is m.stl's.
std::vector<Sample> samplesOfCommands(std::vector<Sample> all, const std::string& folder) {
  std::erase_if(all, [](const Sample& s) {
    return !s.name.starts_with("s.seg.") && s.name != "s.mha" && s.name != "p.3mf" && !isMeshPath(s.name);
  });
  for (const Sample& s : all)
    if (s.name == "s.mha") writeFile(folder + "/whole.mha", s.bytes);
  return all;
}

std::vector<Sample> realFiles(const std::string& folder) {
  std::vector<Sample> samples;
  constexpr std::uintmax_t kLargest = 3u << 20;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.file_size() < kLargest && entry.path().extension() != ".txt")
      samples.push_back({entry.path().filename().string(), bytesOf(entry.path())});
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.name < b.name; });
  return samples;
}

bool feed(const Options& o, const std::string& path, const std::string& folder, Tally& tally) try {
  if (o.commands) return runCommands(o.cli, path, folder, tally);
  if (!o.files.empty()) return runAll(o.cli, path, folder, tally);
  (readAny(path, {o.decoder}) ? tally.read : tally.refused) += 1;
  return true;
} catch (const std::exception& error) {
  std::cerr << "unexpected: " << error.what() << "\n";
  return false;
}

void one(const Options& o, const std::vector<Sample>& samples, std::size_t i, const std::string& folder,
         Tally& tally) {
  std::mt19937_64 random(o.seed * 1000003 + i);
  const Sample& sample = samples[random() % samples.size()];
  const std::string path = folder + "/" + sample.name;
  const std::string damaged = mutated(sample.bytes, random);
  writeFile(path, sample.isModel ? archiveOfModel(damaged) : damaged);
  const auto start = std::chrono::steady_clock::now();
  const bool good = feed(o, path, folder, tally);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  tally.longest = std::max(tally.longest, seconds);
  if (good && seconds < (o.commands ? 3 * kLongest : o.files.empty() ? kLongest : 2 * kLongest)) {
    fs::remove(path);
    return;
  }
  ++tally.broken;
  const std::string kept =
      folder + "/broken-" + std::to_string(o.seed) + "-" + std::to_string(i) + "-" + sample.name;
  fs::rename(path, kept);
  std::cerr << "broken after " << seconds << " s: " << kept << std::endl;
}

//! What only a child process reads.
bool needsDecoder(const std::string& name) {
  return name.ends_with(".vtp") || (name.ends_with(".dcm") && !isMeshInputPath(name));
}

//! Which libFuzzer target reads it; none for what only a child process does.
std::string targetOf(const std::string& name) {
  if (name.ends_with(".json")) return "sessions";
  if (name.ends_with(".vtp")) return {};
  if (isMeshInputPath(name)) return "meshes";
  return name.ends_with(".dcm") ? "dicom" : "volumes";
}

int writeCorpus(const std::string& folder) {
  const std::string work = folder + "/work";
  fs::create_directories(work);
  const std::vector<Sample> samples = fuzzCorpus(work);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::string target = targetOf(samples[i].name);
    if (target.empty()) continue;
    fs::create_directories(folder + "/" + target);
    writeFile(folder + "/" + target + "/" + std::to_string(i) + "-" + samples[i].name, samples[i].bytes);
  }
  fs::remove_all(work);
  return 0;
}

int fuzz(const Options& o) {
  std::string folder = (fs::temp_directory_path() / "handlebody-fuzz-XXXXXX").string();
  if (!mkdtemp(folder.data())) return 2;
  std::vector<Sample> samples = o.files.empty() ? fuzzCorpus(folder) : realFiles(o.files);
  if (o.commands)
    samples = samplesOfCommands(std::move(samples), folder);
  else if (o.files.empty())
    std::erase_if(samples, [&](const Sample& s) { return needsDecoder(s.name) == o.decoder.empty(); });
  Tally tally;
  for (std::size_t i = o.first; i < o.first + o.count; ++i) {
    one(o, samples, i, folder, tally);
    if (o.count >= 10000 && i % 1000 == 999)
      std::cerr << i + 1 << " done, " << tally.broken << " broken" << std::endl;
  }
  std::printf("%zu damaged files of %zu samples: %zu read, %zu refused, %zu broken; longest %.2f s", o.count,
              samples.size(), tally.read, tally.refused, tally.broken, tally.longest);
  std::printf(tally.memory ? ", largest program %ld MB\n" : "\n", tally.memory / 1024);
  if (tally.broken == 0) fs::remove_all(folder);
  return tally.broken == 0 ? 0 : 1;
}

}  // namespace
}  // namespace handlebody::test

int main(int argc, char** argv) {
  handlebody::test::Options o;
  CLI::App app("Damaged files through the readers", "fuzz_readers");
  app.add_option("COUNT", o.count, "How many");
  app.add_option("--first", o.first, "Number of the first, to repeat one");
  app.add_option("--seed", o.seed, "Of the random numbers");
  app.add_option("--decoder", o.decoder, "handlebody-cli, whose child processes decode DICOM and VTP");
  app.add_option("--files", o.files, "Folder of real files, for whole runs of --cli");
  app.add_option("--cli", o.cli, "handlebody-cli");
  app.add_flag("--commands", o.commands, "Whole runs of mesh, edit and compare of --cli");
  app.add_option("--corpus", o.corpus, "Folder to write the samples into");
  CLI11_PARSE(app, argc, argv);
  if (!o.corpus.empty()) return handlebody::test::writeCorpus(o.corpus);
  return handlebody::test::fuzz(o);
}
