#include "core/io/report/session.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/io/atomic_file.h"
#include "core/io/report/json.h"
#include "core/io/report/json_field.h"
#include "core/io/report/measures_json.h"
#include "core/io/report/over_time_json.h"
#include "core/io/report/session_files.h"
#include "core/io/report/unnamed_files.h"
#include "core/told_error.h"

namespace handlebody {

namespace fs = std::filesystem;

namespace {

using K = FindingKind;

std::string readText(const std::string& path) {
  if (fs::is_directory(path)) throw Told<InputError>(Finding(K::sessionIsFolder, {{"file", path}}));
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Told<InputError>(Finding(K::sessionNotOpened, {{"file", path}}, systemFinding(errno)));
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw Told<InputError>(Finding(K::sessionNotRead, {{"file", path}}));
  return text;
}

// A relative path survives a move of the folder that holds volume and session; across different drives or
// roots there is none, and the absolute path stays.
std::string storedPath(const std::string& volume, const std::string& session) {
  const fs::path target(inRealFolder(volume));
  const fs::path folder = fs::weakly_canonical(fs::absolute(session)).parent_path();
  const fs::path relative = target.lexically_relative(folder);
  return relative.empty() ? target.string() : relative.string();
}

//! Beside the session, beside a link to it, or in the current folder. Empty where none is stored.
std::string openablePath(const std::string& stored, const std::string& session) {
  if (stored.empty() || fs::path(stored).is_absolute()) return stored;
  const fs::path beside = fs::path(session).parent_path() / stored;
  const fs::path besideTarget = fs::weakly_canonical(fs::absolute(session)).parent_path() / stored;
  for (const fs::path& path : {besideTarget, beside, fs::path(stored)})
    if (fs::exists(path)) return path.string();
  return beside.string();
}

//! Where the session says.
void locate(Session& session, const std::string& path) {
  forEachStart(session, [&](StartSurface& s) { s.path = openablePath(s.path, path); });
  forEachWallMap(session, [&](WallMap& map) { map.path = openablePath(map.path, path); });
}

//! What all objects have in common.
Session headFromJson(const JsonField& json, const std::string& path, const std::string& volume) {
  Session session;
  session.version = json.at("version").text();
  const JsonField input = json.at("input"), stored = input.at("path"), hash = input.at("sha256");
  session.volume.path = volume;
  if (volume.empty() && !stored.isNull()) session.volume.path = openablePath(stored.text(), path);
  if (!hash.isNull()) {
    session.volume.sha256 = hash.text();
    if (session.volume.sha256.empty()) hash.refuse(K::fieldEmpty);
  }
  readSelection(input, session.volume.selection);
  if (input.has("voxels_sha256")) session.volume.voxels = input.at("voxels_sha256").text();
  return session;
}

//! Where each of the objects stands.
std::vector<JsonField> objectsOf(const JsonField& json) {
  if (!json.has("objects")) return {json};
  std::vector<JsonField> objects = json.at("objects").list();
  if (objects.empty()) throw Told<UsageError>(K::sessionWithoutObjects);
  return objects;
}

std::vector<Session> sessionsFromJson(const JsonField& json, const std::string& path,
                                      const InputPaths& inputs) {
  const Session head = headFromJson(json, path, inputs.volume);
  std::vector<Session> sessions;
  for (const JsonField& object : objectsOf(json)) {
    sessions.push_back(head);
    readRequest(object.at("requested"), sessions.back());
  }
  if (std::none_of(sessions.begin(), sessions.end(), isSeeded))
    throw Told<UsageError>(K::sessionWithoutSeeds);
  if (json.has("over_time")) {
    if (sessions.size() > 1) throw Told<UsageError>(K::overTimeOfSeveral);
    sessions[0].overTime = overTimeFromJson(json.at("over_time"));
  }
  for (Session& session : sessions) locate(session, path);
  if (json.has("view")) sessions[0].view = json.at("view").json().dump();
  if (json.has("measurements"))  // of each, since the first may be left out where it has no seed
    for (Session& session : sessions) session.measurements = measurementsFromJson(json.at("measurements"));
  return sessions;
}

//! `path`: of the session or report.
std::vector<Session> parsed(const std::string& text, const std::string& path, const InputPaths& inputs) {
  try {
    const Json json = Json::parse(text);
    return sessionsFromJson(JsonField(json), path, inputs);
  } catch (const Json::parse_error&) {
    throw Told<InputError>(Finding(K::notJson, {{"file", path}}));
  } catch (const Json::out_of_range&) {  // of the parser: no double is as large
    throw Told<InputError>(Finding(K::notASession, {{"file", path}}, K::jsonNumberTooLarge));
  } catch (const std::exception& error) {
    throw Told<InputError>(Finding(K::notASession, {{"file", path}}, saidBy(error)));
  }
}

}  // namespace

namespace {

Json headToJson(const Session& session, const std::string& path) {
  Json json = {{"version", session.version}, {"notice", kNotice}};
  Json input = referenceToJson(session.volume);
  if (!session.volume.path.empty()) input["path"] = storedPath(session.volume.path, path);
  if (session.volume.sha256.empty()) input["sha256"] = nullptr;
  json["input"] = std::move(input);
  return json;
}

//! `path`: of the session.
Session withStoredPaths(Session session, const std::string& path) {
  forEachWallMap(session, [&](WallMap& map) {
    if (!map.path.empty()) map.path = storedPath(map.path, path);
  });
  forEachStart(session, [&](StartSurface& s) {
    if (!s.path.empty()) s.path = storedPath(s.path, path);
  });
  return session;
}

void addObject(Json& json, const Session& session, const std::string& path) {
  json["requested"] = requestToJson(withStoredPaths(session, path));
  if (!session.resolved) return;
  json["parameters"] = resolvedToJson(*session.resolved);
  json["seeds"] = seedsToJson(seedsOfSide(session.resolved->seeds, false));
}

void addWhatAWindowKeeps(Json& json, const Session& session) {
  if (!session.measurements.empty()) json["measurements"] = measurementsToJson(session.measurements);
  if (!session.view.empty()) json["view"] = Json::parse(session.view);
}

}  // namespace

void writeSession(const Session& session, const std::string& path) {
  Json json = headToJson(session, path);
  addObject(json, session, path);
  if (session.overTime) json["over_time"] = overTimeToJson(*withStoredPaths(session, path).overTime);
  addWhatAWindowKeeps(json, session);
  writeTextAtomically(path, jsonText(json));
}

void writeSessions(const std::vector<Session>& objects, const std::string& path) {
  if (objects.size() == 1) return writeSession(objects.front(), path);
  Json json = headToJson(objects.front(), path);
  for (const Session& object : objects) addObject(json["objects"].emplace_back(Json::object()), object, path);
  addWhatAWindowKeeps(json, objects.front());
  writeTextAtomically(path, jsonText(json));
}

bool isSeeded(const Session& session) {
  return session.constraints.start || !seedsOfSide(session.seeds, false).empty();
}

std::vector<std::string> inputsOf(const Session& session) {
  std::vector<std::string> inputs{session.volume.path};
  const auto add = [&inputs](const auto& file) { inputs.push_back(file.path); };
  forEachWallMap(session, add);
  forEachStart(session, add);
  return inputs;
}

Session anonymous(Session session) {
  session.volume.path.clear();
  if (!session.volume.selection.series) session.volume.voxels.clear();
  session.volume.selection.series.reset();
  session.view.clear();
  session.label.source = withoutSite(std::move(session.label.source));
  forEachWallMap(session, [](WallMap& map) { map.path.clear(); });
  forEachStart(session, [](StartSurface& s) { s.path.clear(); });
  return session;
}

Session readSession(const std::string& path, const InputPaths& inputs) {
  std::vector<Session> sessions = readSessions(path, inputs);
  if (sessions.size() > 1)
    throw Told<InputError>(Finding(K::severalObjects, {{"file", path}, {"objects", sessions.size()}}));
  return std::move(sessions[0]);
}

std::vector<Session> readSessions(const std::string& path, const InputPaths& inputs) {
  std::vector<Session> sessions = parsed(readText(path), path, inputs);
  placeFiles(sessions, K::sessionWithoutWalls, inputs.walls);
  placeFiles(sessions, K::sessionWithoutStart, inputs.starts);
  if (inputs.mayBeUnnamed) return sessions;
  if (const auto file = unnamedFile(sessions))
    throw Told<InputError>(Finding(K::fileRefusedWith, {{"file", path}}, file->missing));
  return sessions;
}

}  // namespace handlebody
