#include "app/cli/case_folder.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include "app/picture/picture.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/formats/sequence_writer.h"
#include "core/io/formats/sha256.h"
#include "core/io/formats/volume_io.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/frame_files.h"
#include "core/io/report/json.h"
#include "core/version.h"

namespace handlebody::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRecord = "case.json";
//! Relative to the batch's.
std::string failureRecordOf(const StudyCase& c) { return "failed/" + c.name + ".json"; }

constexpr const char* kTemporary = ".tmp-";  // in front of a case's name

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw OutputError(path + ": cannot be written: " + why + ".");
}

void makeFolder(const std::string& path) {
  std::error_code failed;
  fs::create_directories(path, failed);
  if (!fs::is_directory(path)) refuse(path, failed ? failed.message() : "it is not a folder");
}

//! Onto the disk: files are renamed there by what is written in the folder.
void flushFolder(const std::string& path) {
  const int folder = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) refuse(path, std::strerror(errno));
  ::fsync(folder);  // not all file systems can
  ::close(folder);
}

//! Nothing if it cannot be read or is no JSON.
Json readJson(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return Json::parse(file, nullptr, false);
}

//! The UID of a series leads to its patient: an anonymous case keeps its hash, which tells another series
//! apart as well.
std::vector<std::string> writtenOptions(const StudyCase& c) {
  std::vector<std::string> options = c.options;
  const std::string series = "--series=";
  for (std::string& option : options)
    if (c.isAnonymous && option.rfind(series, 0) == 0)
      option = series + "sha256:" + sha256OfText(option.substr(series.size()));
  return options;
}

//! What decides on the result, but for the voxels themselves.
Json requestOf(const StudyCase& c) {
  return {{"version", HANDLEBODY_VERSION}, {"options", writtenOptions(c)}, {"outputs", c.outputs}};
}

Json hashesOf(const StudyCase& c) {
  Json hashes = {{"volume", sha256OfPath(c.volumePath)}};
  for (const StudyInput& input : c.inputs) hashes[input.option] = sha256OfPath(input.path);
  return hashes;
}

//! The hashes that the case found itself: a volume may be changed while a batch runs.
Json hashesIn(const Json& report, const StudyCase& c) {
  Json hashes = {{"volume", report.at("input").at("sha256")}};
  for (const StudyInput& input : c.inputs)
    hashes[input.option] = report.at("requested")
                               .at("constraints")
                               .at(input.option == "walls" ? "wall_map" : "start")
                               .at("sha256");
  return hashes;
}

//! Frames that have a surface. Throws what the JSON library throws.
std::vector<int> framesOf(const Json& report) {
  std::vector<int> frames;
  for (const Json& result : report.at("over_time").at("results"))
    if (!result.at("volume_mm3").is_null()) frames.push_back(result.at("frame").get<int>());
  return frames;
}

std::vector<std::string> filesOf(const StudyCase& c, const std::string& folder) {
  std::vector<std::string> files = BatchFolder::resultsOf(c, folder);
  files.insert(files.end(), {"report.json", "session.json", "picture.png", "thumbnail.png"});
  return files;
}

Json sizesOf(const StudyCase& c, const std::string& folder) {
  Json sizes = Json::object();
  for (const std::string& file : filesOf(c, folder)) {
    std::error_code failed;
    const auto size = fs::file_size(folder + "/" + file, failed);
    if (failed) throw InputError(file + ": it was not written.");
    sizes[file] = size;
  }
  return sizes;
}

bool isEmptyFolder(const std::string& path) {
  std::error_code failed;
  return !fs::exists(path, failed) || (fs::is_directory(path, failed) && fs::is_empty(path, failed));
}

//! Before the first batch works in a folder: what it would replace is not there yet. Later ones find its
//! lock.
void requireOwnOrNew(const std::string& folder) {
  if (fs::exists(folder + "/.lock")) return;
  const auto refuseFor = [&](const std::string& name) {
    throw UsageError(folder + ": '" + name +
                     "' is there already and of no batch; it would be replaced. Choose another folder.");
  };
  for (const char* table : BatchFolder::kTables)
    if (fs::exists(folder + "/" + table)) refuseFor(table);
  for (const char* part : {"cases", "failed"})
    if (!isEmptyFolder(folder + "/" + part)) refuseFor(part);
}

//! What somebody has put beside the results of a case, which are made anew, is copied there. Where the record
//! is damaged that may be old results, too.
void keepForeignFiles(const std::string& from, const std::string& to) {
  const Json record = readJson(from + "/" + kRecord);
  const Json files = record.is_object() ? record.value("files", Json::object()) : Json::object();
  for (const auto& entry : fs::directory_iterator(from)) {
    const std::string name = entry.path().filename().string();
    if (name == kRecord || name == "log.txt" || files.contains(name) || fs::exists(to + "/" + name)) continue;
    std::error_code failed;
    fs::copy(entry.path(), to + "/" + name, fs::copy_options::recursive | fs::copy_options::copy_symlinks,
             failed);
    if (failed) refuse(to + "/" + name, failed.message());
  }
}

//! As the system finds it, whether it is there or not: `..` behind a link is not the folder that the link is
//! in.
std::string realPath(const std::string& path) {
  std::error_code failed;
  const fs::path whole = fs::absolute(path), real = fs::weakly_canonical(whole, failed);
  std::string text = failed ? whole.string() : real.string();  // making it will say why
  if (text.size() > 1 && text.back() == '/') text.pop_back();
  return text;
}

bool liesIn(const std::string& path, const std::string& folder) {
  const fs::path inner = fs::weakly_canonical(path), outer = fs::weakly_canonical(folder);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

//! All files of a folder of DICOM images belong to the volume: with the batch's among them it would be
//! another one each time, and never done.
void requireInputApart(const std::string& folder, const std::string& input) {
  if (input.empty()) return;
  for (const char* part : {"/cases", "/failed"})
    if (liesIn(input, folder + part))
      throw UsageError(input + ": an input must not lie in " + folder + part + ", where the batch writes.");
  if (realPath(input) == folder)
    throw UsageError(input + ": an input must not be the folder where the batch writes. Choose another one.");
}

//! In one step where the file system can swap names; else what was there is away for a moment. It is then
//! under a name in the folder of `to` that no case has.
void putInPlace(const std::string& from, const std::string& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return;
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE) == 0) return;
  const fs::path target(to);
  const std::string hidden = std::string(kTemporary).append("~").append(target.filename().string());
  const std::string aside = (target.parent_path() / hidden).string();
  std::error_code ignored;
  fs::remove_all(aside, ignored);
  fs::rename(target, aside, ignored);
  if (::rename(from.c_str(), to.c_str()) != 0) refuse(to, std::strerror(errno));
  fs::remove_all(aside, ignored);
}

//! -1: somebody else has it. Throws OutputError.
int lockedFile(const std::string& path, int how) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) refuse(path, std::strerror(errno));
  while (::flock(file, how | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    const int cause = errno;
    ::close(file);
    if (cause != EWOULDBLOCK)
      refuse(path, std::string("its file system has no locks (") + std::strerror(cause) + ")");
    return -1;
  }
  return file;
}

}  // namespace

std::vector<std::string> BatchFolder::resultsOf(const StudyCase& c, const std::string& folder) {
  if (!c.isOverTime()) return c.outputs;
  std::vector<std::string> files{"curve.csv", "curve.svg"};
  std::vector<int> frames;
  try {
    frames = framesOf(readJson(folder + "/report.json"));
  } catch (const Json::exception&) {
    throw InputError("report.json: it was not written.");
  }
  for (const std::string& file : c.outputs) {
    if (!isMeshPath(file)) {
      files.push_back(file);
      continue;
    }
    if (hasCollection(file)) files.push_back(collectionPath(file));
    for (const int frame : frames) files.push_back(numberedPath(file, frame));
  }
  return files;
}

CaseHold::CaseHold(const std::string& path) : file_(lockedFile(path, LOCK_EX)) {}
CaseHold::~CaseHold() {
  if (file_ >= 0) ::close(file_);
}

BatchFolder::BatchFolder(const std::string& path, FolderUse use) : path_(realPath(path)) {
  requireOwnOrNew(path_);
  for (const char* part : {"cases", "failed", ".holds"}) makeFolder(absolute(part));
  const bool isShared = use == FolderUse::shared;
  const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while ((lock_ = lockedFile(absolute(".lock"), isShared ? LOCK_SH : LOCK_EX)) < 0) {
    if (!isShared || std::chrono::steady_clock::now() > patience)
      throw UsageError(path_ + ": another batch is at work in this folder.");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  if (isShared) return;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(absolute("cases")))
    if (entry.path().filename().string().rfind(kTemporary, 0) == 0) fs::remove_all(entry.path(), ignored);
}

BatchFolder::~BatchFolder() { ::close(lock_); }

void BatchFolder::requireApart(const std::string& path, const std::string& study,
                               const std::vector<StudyCase>& cases) {
  const std::string folder = realPath(path);
  for (const char* table : kTables)
    if (realPath(study) == realPath(folder + "/" + table))
      throw UsageError(study + ": a batch in " + folder + " would replace it. Choose another folder.");
  for (const StudyCase& c : cases) {
    requireInputApart(folder, c.volumePath);
    for (const StudyInput& input : c.inputs) requireInputApart(folder, input.path);
  }
}

void BatchFolder::requireOwn(const std::vector<StudyCase>& cases) const {
  for (const StudyCase& c : cases) {
    const std::string folder = absolute(folderOf(c));
    if (c.fault.empty() && !isEmptyFolder(folder) && !hasResults(c))
      throw UsageError(
          folder +
          ": it is there already and of no batch; it would be replaced. Choose another name or folder.");
  }
}

bool BatchFolder::hasResults(const StudyCase& c) const {
  return fs::exists(absolute(folderOf(c)) + "/" + kRecord);
}

bool BatchFolder::isDone(const StudyCase& c) const {
  const std::string folder = absolute(folderOf(c));
  if (!hasResults(c)) return false;
  const Json record = readJson(folder + "/" + kRecord);
  if (!record.is_object() || record.value("request", Json()) != requestOf(c)) return false;
  try {
    return record.value("files", Json()) == sizesOf(c, folder) &&
           record.value("sha256", Json()) == hashesOf(c);
  } catch (const InputError&) {  // gone meanwhile: running it will say so
    return false;
  }
}

std::string BatchFolder::begin(const StudyCase& c) const {
  abandon(c);
  makeFolder(temporary(c));
  return temporary(c);
}

void BatchFolder::writeRecord(const StudyCase& c, const CaseEnd& end, const std::string& folder) const {
  const Json report = readJson(folder + "/report.json");
  if (!report.is_object()) throw InputError("report.json: it was not written.");
  const Json record = {{"case", c.name},
                       {"volume", c.volume},
                       {"request", requestOf(c)},
                       {"sha256", hashesIn(report, c)},
                       {"files", sizesOf(c, folder)},
                       {"exit_code", end.exitCode},
                       {"seconds", end.seconds},
                       {"cpu_seconds", end.cpuSeconds},
                       {"peak_memory_mb", end.peakMegabytes}};
  writeTextAtomically(folder + "/" + kRecord, jsonText(record));
}

void BatchFolder::finish(const StudyCase& c, const CaseEnd& end) const {
  const std::string folder = temporary(c), target = absolute(folderOf(c));
  writeTextAtomically(folder + "/thumbnail.png", thumbnailOf(folder + "/picture.png"));
  writeRecord(c, end, folder);
  std::error_code ignored;
  if (c.isAnonymous) fs::remove(logOfWork(c), ignored);  // warnings name files
  if (hasResults(c)) keepForeignFiles(target, folder);
  flushFolder(folder);
  putInPlace(folder, target);
  flushFolder(absolute("cases"));
  fs::remove_all(folder, ignored);  // what was there before
  forgetFailure(c);
}

void BatchFolder::fail(const StudyCase& c, const std::string& why) const {
  std::error_code failed, ignored;
  if (!c.isAnonymous) fs::rename(logOfWork(c), absolute(logOf(c)), failed);
  // Of a run that was not anonymous, or an earlier one.
  if (c.isAnonymous || failed) fs::remove(absolute(logOf(c)), ignored);
  abandon(c);
  const Json record = {{"case", c.name}, {"volume", c.volume}, {"request", requestOf(c)}, {"message", why}};
  try {
    writeTextAtomically(absolute(failureRecordOf(c)), jsonText(record));
  } catch (const OutputError&) {  // a full disk, say: who runs it has the sentence
  }
}

void BatchFolder::forgetFailure(const StudyCase& c) const {
  std::error_code ignored;
  fs::remove(absolute(logOf(c)), ignored);
  fs::remove(absolute(failureRecordOf(c)), ignored);
}

bool BatchFolder::hasLogOfFailure(const StudyCase& c) const {
  std::error_code failed;
  return fs::exists(absolute(logOf(c)), failed);
}

std::string BatchFolder::failureOf(const StudyCase& c) const {
  const Json record = readJson(absolute(failureRecordOf(c)));
  if (!record.is_object() || record.value("request", Json()) != requestOf(c)) return {};
  const Json message = record.value("message", Json());
  return message.is_string() ? message.get<std::string>() : "";
}

bool BatchFolder::isBegun(const StudyCase& c) const { return fs::exists(temporary(c)); }

std::unique_ptr<CaseHold> BatchFolder::hold(const StudyCase& c) const {
  return std::make_unique<CaseHold>(absolute(".holds/" + c.name));
}

std::string BatchFolder::temporary(const StudyCase& c) const {
  return absolute("cases/" + (kTemporary + c.name));
}

void BatchFolder::abandon(const StudyCase& c) const {
  std::error_code ignored;
  fs::remove_all(temporary(c), ignored);
}

}  // namespace handlebody::cli
