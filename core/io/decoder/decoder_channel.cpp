#include "core/io/decoder/decoder_channel.h"

#include <sys/socket.h>

#include <cerrno>

#include "core/finding_words.h"

namespace handlebody {
namespace {

constexpr std::uint32_t kLongest = 64u << 20;

bool sendBytes(int socket, const void* bytes, std::size_t n) {
  const char* at = static_cast<const char*>(bytes);
  while (n > 0) {
    const ssize_t sent = ::send(socket, at, n, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    at += sent;
    n -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receiveBytes(int socket, void* bytes, std::size_t n) {
  char* at = static_cast<char*>(bytes);
  while (n > 0) {
    const ssize_t got = ::recv(socket, at, n, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    n -= static_cast<std::size_t>(got);
  }
  return true;
}

Message valueMessage(const FindingValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* x = std::get_if<double>(&value)) return *x;
  return std::get<std::array<double, 3>>(value);
}

FindingValue valueFrom(const Message& m) {
  if (m.is_string()) return m.get<std::string>();
  if (m.is_array()) return m.get<std::array<double, 3>>();
  return m.get<double>();
}

//! The names of the values are those in the words: literals, as a finding needs them.
Finding findingFrom(const Message& m, int depth) {
  constexpr int kDeepest = 3;  // of causes; none of ours is deeper
  Finding f = findingKindOf(m.at("kind").get<std::string>());
  const Message& values = m.at("values");
  const std::string_view text = findingText(f.kind);
  for (auto open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
    const std::string_view name = text.substr(open + 1, text.find_first_of(":}", open) - open - 1);
    if (const auto at = values.find(std::string(name)); at != values.end() && !f.find(name))
      f.values.emplace_back(name, valueFrom(*at));
  }
  if (depth < kDeepest)
    for (const Message& cause : m.at("causes")) f.causes.push_back(findingFrom(cause, depth + 1));
  return f;
}

Message findingsMessage(const std::vector<Finding>& findings) {
  Message list = Message::array();
  for (const Finding& f : findings) list.push_back(findingToMessage(f));
  return list;
}

Message vectorMessage(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 vectorFrom(const Message& m) {
  return {m.at(0).get<double>(), m.at(1).get<double>(), m.at(2).get<double>()};
}

Message gridMessage(const Grid& g) {
  return {{"size", g.size},
          {"spacing", vectorMessage(g.spacing)},
          {"origin", vectorMessage(g.origin)},
          {"x", vectorMessage(g.direction.col(0))},
          {"y", vectorMessage(g.direction.col(1))},
          {"z", vectorMessage(g.direction.col(2))}};
}

Grid gridFrom(const Message& m) {
  Grid g;
  g.size = m.at("size").get<std::array<int, 3>>();
  g.spacing = vectorFrom(m.at("spacing"));
  g.origin = vectorFrom(m.at("origin"));
  g.direction.col(0) = vectorFrom(m.at("x"));
  g.direction.col(1) = vectorFrom(m.at("y"));
  g.direction.col(2) = vectorFrom(m.at("z"));
  return g;
}

Message seriesMessage(const SeriesInfo& s) {
  return {{"uid", s.uid},
          {"description", s.description},
          {"files", s.files},
          {"modality", s.modality},
          {"size", s.size},
          {"slices", s.slices},
          {"frames", s.frames},
          {"spacing", vectorMessage(s.spacing)},
          {"note", findingToMessage(s.note)}};
}

SeriesInfo seriesFrom(const Message& m) {
  SeriesInfo s;
  s.uid = m.at("uid").get<std::string>();
  s.description = m.at("description").get<std::string>();
  s.files = m.at("files").get<int>();
  s.modality = m.at("modality").get<std::string>();
  s.size = m.at("size").get<std::array<int, 3>>();
  s.slices = m.at("slices").get<int>();
  s.frames = m.at("frames").get<int>();
  s.spacing = vectorFrom(m.at("spacing"));
  s.note = findingFromMessage(m.at("note"));
  return s;
}

Message originMessage(const DicomOrigin& o) {
  Message values = Message::array(), images = Message::array();
  for (const DicomValue& v : o.values) values.push_back({v.group, v.element, v.value});
  for (const DicomImage& i : o.images) images.push_back({i.sopClass, i.instance, i.frame});
  return {{"values", values},
          {"images", images},
          {"straight", o.straight},
          {"displaced", findingName(o.displaced)},
          {"uids", {o.studyUid, o.seriesUid, o.frameOfReference}}};
}

std::shared_ptr<DicomOrigin> originFrom(const Message& m) {
  auto o = std::make_shared<DicomOrigin>();
  for (const Message& v : m.at("values"))
    o->values.push_back(
        {v.at(0).get<std::uint16_t>(), v.at(1).get<std::uint16_t>(), v.at(2).get<std::string>()});
  for (const Message& i : m.at("images"))
    o->images.push_back({i.at(0).get<std::string>(), i.at(1).get<std::string>(), i.at(2).get<int>()});
  o->straight = m.at("straight").get<bool>();
  o->displaced = findingKindOf(m.at("displaced").get<std::string>());
  const auto uids = m.at("uids").get<std::array<std::string, 3>>();
  o->studyUid = uids[0];
  o->seriesUid = uids[1];
  o->frameOfReference = uids[2];
  return o;
}

}  // namespace

bool sendMessage(int socket, const Message& message) {
  const std::vector<std::uint8_t> bytes = Message::to_cbor(message);
  const auto length = static_cast<std::uint32_t>(bytes.size());
  return sendBytes(socket, &length, sizeof length) && sendBytes(socket, bytes.data(), bytes.size());
}

std::optional<Message> receiveMessage(int socket) {
  std::uint32_t length = 0;
  if (!receiveBytes(socket, &length, sizeof length) || length > kLongest) return std::nullopt;
  std::vector<std::uint8_t> bytes(length);
  if (!receiveBytes(socket, bytes.data(), length)) return std::nullopt;
  Message message = Message::from_cbor(bytes, true, false);
  if (message.is_discarded()) return std::nullopt;
  return message;
}

Message findingToMessage(const Finding& finding) {
  Message m{{"kind", findingName(finding.kind)},
            {"values", Message::object()},
            {"causes", findingsMessage(finding.causes)}};
  for (const auto& [name, value] : finding.values) m["values"][std::string(name)] = valueMessage(value);
  return m;
}

Finding findingFromMessage(const Message& m) { return findingFrom(m, 0); }

Message requestToMessage(const OpenRequest& r) {
  Message m = {
      {"path", r.path}, {"format", r.format}, {"refuse", r.selection.uneven == UnevenSlices::refuse}};
  if (r.selection.series) m["series"] = *r.selection.series;
  if (r.selection.spacing) m["spacing"] = vectorMessage(*r.selection.spacing);
  return m;
}

OpenRequest requestFromMessage(const Message& m) {
  OpenRequest r;
  r.path = m.at("path").get<std::string>();
  r.format = m.at("format").get<std::string>();
  r.selection.uneven = m.at("refuse").get<bool>() ? UnevenSlices::refuse : UnevenSlices::resample;
  if (m.contains("series")) r.selection.series = m.at("series").get<std::string>();
  if (m.contains("spacing")) r.selection.spacing = vectorFrom(m.at("spacing"));
  return r;
}

Message headerToMessage(const VolumeHeader& h) {
  Message series = Message::array();
  for (const SeriesInfo& s : h.series) series.push_back(seriesMessage(s));
  const GeometrySources& s = h.sources;
  return {{"format", h.format},
          {"dicom", h.dicom ? originMessage(*h.dicom) : Message()},
          {"series", series},
          {"grid", gridMessage(h.grid)},
          {"component", static_cast<int>(h.component)},
          {"components", h.components},
          {"frames", h.frames},
          {"layers", h.hasLayers},
          {"several", h.isChoice},
          {"times", h.times.milliseconds},
          {"time_source", h.times.source},
          {"calibrated", h.calibrated},
          {"sources", {s.size, s.spacing[0], s.spacing[1], s.spacing[2], s.origin, s.direction}},
          {"warnings", findingsMessage(h.warnings)}};
}

VolumeHeader headerFromMessage(const Message& m) {
  VolumeHeader h;
  h.format = m.at("format").get<std::string>();
  for (const Message& s : m.at("series")) h.series.push_back(seriesFrom(s));
  if (!m.at("dicom").is_null()) h.dicom = originFrom(m.at("dicom"));
  h.grid = gridFrom(m.at("grid"));
  const int component = m.at("component").get<int>();
  if (component < 0 || component > static_cast<int>(Component::float64)) m.at("no such component");
  h.component = static_cast<Component>(component);
  h.components = m.at("components").get<int>();
  const bool colour = h.component == Component::uint8 || h.component == Component::uint16;
  if (h.components != 1 && !(colour && (h.components == 3 || h.components == 4))) m.at("no such voxels");
  h.frames = m.at("frames").get<int>();
  h.hasLayers = m.at("layers").get<bool>();
  h.isChoice = m.at("several").get<bool>();
  h.times = {m.at("times").get<std::vector<double>>(), m.at("time_source").get<std::string>()};
  h.calibrated = m.at("calibrated").get<bool>();
  const auto s = m.at("sources").get<std::array<std::string, 6>>();
  h.sources = {s[0], {s[1], s[2], s[3]}, s[4], s[5]};
  for (const Message& warning : m.at("warnings")) h.warnings.push_back(findingFromMessage(warning));
  return h;
}

}  // namespace handlebody
