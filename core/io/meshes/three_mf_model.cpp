#include "core/io/meshes/three_mf_model.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "core/io/meshes/three_mf_values.h"
#include "core/io/meshes/xml_parser.h"
#include "core/io/meshes/zip_archive.h"
#include "core/io/refuse_input.h"
#include "core/io/shown.h"
#include "core/io/trimmed.h"

namespace handlebody {
namespace {

constexpr std::string_view kProduction = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
                           kPath = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06 path";
constexpr std::array<std::string_view, 4> kSupported{
    kThreeMfCore, kProduction, "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07"};

enum class ElementTag {
  none,
  other,  // and all that is in it
  model,
  metadata,
  resources,
  object,
  mesh,
  vertices,
  vertex,
  triangles,
  triangle,
  components,
  component,
  build,
  item
};

struct Rule {
  ElementTag within;
  std::string_view name;
  ElementTag tag;
};
// Those first that there are most of.
constexpr Rule kRules[] = {{ElementTag::vertices, "vertex", ElementTag::vertex},
                           {ElementTag::triangles, "triangle", ElementTag::triangle},
                           {ElementTag::components, "component", ElementTag::component},
                           {ElementTag::build, "item", ElementTag::item},
                           {ElementTag::resources, "object", ElementTag::object},
                           {ElementTag::object, "mesh", ElementTag::mesh},
                           {ElementTag::object, "components", ElementTag::components},
                           {ElementTag::mesh, "vertices", ElementTag::vertices},
                           {ElementTag::mesh, "triangles", ElementTag::triangles},
                           {ElementTag::model, "metadata", ElementTag::metadata},
                           {ElementTag::model, "resources", ElementTag::resources},
                           {ElementTag::model, "build", ElementTag::build},
                           {ElementTag::none, "model", ElementTag::model}};

//! What stands in a place where the core specification has no such element, or is of another namespace, is
//! ignored with all that is in it, as the specification wants.
ElementTag tagOf(ElementTag within, std::string_view name) {
  const std::string_view core = kThreeMfCore;
  if (!name.starts_with(core) || name.size() <= core.size() + 1) return ElementTag::other;
  name.remove_prefix(core.size() + 1);
  for (const Rule& rule : kRules)
    if (rule.within == within && rule.name == name) return rule.tag;
  return ElementTag::other;
}

//! The core specification knows five types, of meshes alone (an object of components has those of its
//! components). "model" (the default) is a body and "surface" one that need not be closed, which the
//! certificate tells; "support" and "solidsupport" hold things while they are printed and may be ignored;
//! "other" is never built.
bool isBody(const char* type) {
  const std::string_view name = type ? type : "model";
  return name != "support" && name != "solidsupport" && name != "other";
}

class ModelReader : public XmlHandler {
 public:
  ModelReader(std::string path, ThreeMfCount& count) : path_(std::move(path)), count_(count) {}

  void declare(std::string_view prefix, std::string_view space) override {
    if (tags_.empty()) spaces_[std::string(prefix)] = space;  // of the root: names in texts use no others
  }

  void start(std::string_view name, const XmlAttributes& attributes) override {
    const ElementTag tag = tagOf(tags_.empty() ? ElementTag::none : tags_.back(), name);
    if (tags_.empty() && tag != ElementTag::model)
      refuseInput(path_, {FindingKind::notOfFormat, {{"format", std::string(kThreeMf)}}});
    tags_.push_back(tag);
    if (tag == ElementTag::vertex) return readVertex(attributes);
    if (tag == ElementTag::triangle) return readTriangle(attributes);
    if (tag == ElementTag::component) return readPlacement(attributes, object_->components);
    if (tag == ElementTag::item) return readPlacement(attributes, model.items);
    if (tag == ElementTag::object) return readObject(attributes);
    if (tag == ElementTag::model) return readModel(attributes);
    if (tag == ElementTag::metadata) {
      isSpace_ = isOurs(attributes.find("name"));
      text_.clear();
    }
  }

  void end() override {
    if (tags_.back() == ElementTag::metadata && isSpace_) {
      if (trimmed(text_) == "RAS") model.space = CoordinateSpace::ras;
      isSpace_ = false;
    }
    tags_.pop_back();
  }

  void text(std::string_view piece) override {
    constexpr std::size_t kLongestValue = 64;
    if (isSpace_ && text_.size() < kLongestValue) text_ += piece.substr(0, kLongestValue);
  }

  ThreeMfModel model{};

 private:
  //! "PREFIX:Space", by the namespace of the prefix.
  bool isOurs(const char* name) const {
    const std::string all = name ? name : "";
    const std::size_t colon = all.find(':');
    if (colon == std::string::npos || all.substr(colon + 1) != "Space") return false;
    const auto found = spaces_.find(all.substr(0, colon));
    return found != spaces_.end() && found->second == kThreeMfOurs;
  }

  void readModel(const XmlAttributes& attributes) {
    if (const char* unit = attributes.find("unit")) {
      const std::optional<double> known = three_mf::unitCalled(std::string(trimmed(unit)));
      if (!known) refuseThreeMf(path_, {FindingKind::unitUnknown, {{"unit", shown(unit)}}});
      unit_ = *known;
    }
    const char* required = attributes.find("requiredextensions");
    for (std::string_view left = required ? required : ""; !trimmed(left).empty();)
      requireSupported(std::string(three_mf::nextWord(left)));
  }

  //! What a file says that it cannot be read without. Colours and groups of triangles change no surface.
  void requireSupported(const std::string& prefix) const {
    const auto found = spaces_.find(prefix);
    const std::string space = found == spaces_.end() ? prefix : found->second;
    if (std::find(kSupported.begin(), kSupported.end(), space) != kSupported.end()) return;
    // Of the address that a namespace is the end tells people something.
    const std::string consortium = "http://schemas.microsoft.com/3dmanufacturing/";
    const std::string name = space.starts_with(consortium) ? space.substr(consortium.size()) : space;
    refuseInput(path_, {FindingKind::extensionNotSupported,
                        {{"format", std::string(kThreeMf)}, {"extension", shown(name)}}});
  }

  void readObject(const XmlAttributes& attributes) {
    count_.add(0, 0, 1);
    const std::optional<int> id = three_mf::index(attributes.find("id"));
    if (!id) refuseThreeMf(path_, FindingKind::objectWithoutNumber);
    const auto [at, isNew] = model.objects.try_emplace(*id);
    if (!isNew) refuseThreeMf(path_, {FindingKind::objectTwice, {{"object", *id}}});
    object_ = &at->second;
    object_->isBody = isBody(attributes.find("type"));
  }

  void readVertex(const XmlAttributes& attributes) {
    count_.add(1, 0);
    Vec3 p;
    for (int a = 0; a < 3; ++a) {
      const std::optional<float> value =
          three_mf::coordinate(attributes.find(std::string_view("xyz").substr(a, 1)));
      if (!value) refuseInput(path_, FindingKind::vertexDamaged);
      p[a] = unit_ * double{*value};
    }
    object_->mesh.points.push_back(p);
  }

  void readTriangle(const XmlAttributes& attributes) {
    count_.add(0, 1);
    constexpr std::array<std::string_view, 3> kCorners{"v1", "v2", "v3"};
    Triangle t{};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::optional<int> corner = three_mf::index(attributes.find(kCorners[c]));
      if (!corner) refuseInput(path_, FindingKind::faceDamaged);
      // The specification has the vertices first.
      if (static_cast<std::size_t>(*corner) >= object_->mesh.points.size())
        refuseInput(path_, FindingKind::faceVertexMissing);
      t[c] = *corner;
    }
    object_->mesh.triangles.push_back(t);
  }

  void readPlacement(const XmlAttributes& attributes, std::vector<ThreeMfPlacement>& to) {
    count_.add(0, 0, 1);
    ThreeMfPlacement placement;
    const std::optional<int> id = three_mf::index(attributes.find("objectid"));
    if (!id) refuseThreeMf(path_, FindingKind::itemWithoutObject);
    placement.object = *id;
    if (const char* part = attributes.find(kPath)) placement.part = trimmed(part, "/ \t\r\n");
    if (const char* text = attributes.find("transform")) {
      const std::optional<Eigen::Affine3d> read = three_mf::transform(text, unit_);
      if (!read) refuseThreeMf(path_, FindingKind::badTransform);
      placement.transform = *read;
    }
    to.push_back(std::move(placement));
  }

  std::string path_, text_{};
  ThreeMfCount& count_;
  std::vector<ElementTag> tags_{};  // that are open
  std::map<std::string, std::string> spaces_{};
  ThreeMfObject* object_ = nullptr;  // in which we are: unordered_map moves none
  double unit_ = 1;
  bool isSpace_ = false;
};

}  // namespace

void refuseThreeMf(const std::string& path, const Finding& cause) {
  refuseInput(path, {FindingKind::damagedBecause, {{"format", std::string(kThreeMf)}}, cause});
}

void ThreeMfCount::add(std::size_t points, std::size_t triangles, std::size_t entries) {
  constexpr std::size_t kMax = 100'000'000;  // 4 GB of them; a body of so many has as many points by half
  constexpr std::size_t kMaxEntries = 1'000'000;
  points_ += points;
  triangles_ += triangles;
  entries_ += entries;
  if (points_ > kMax || triangles_ > kMax)
    refuseInput(path_, {FindingKind::surfaceTooLarge, {{"most", kMax}}});
  if (entries_ > kMaxEntries) refuseThreeMf(path_, {FindingKind::objectsTooMany, {{"most", kMaxEntries}}});
}

ThreeMfModel readThreeMfModel(ZipReader& archive, std::uint64_t entry, const std::string& name,
                              const std::string& path, ThreeMfCount& count) {
  ModelReader reader(path, count);
  XmlParser parser(reader, path, kThreeMf, name);
  archive.read(entry, [&](std::string_view piece) { parser.take(piece); });
  parser.finish();
  return std::move(reader.model);
}

}  // namespace handlebody
