#include "core/io/report/json_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/io/shown.h"
#include "core/told_error.h"

namespace handlebody {

using K = FindingKind;

void JsonField::refuse(FindingKind kind, Finding::Values more) const {
  more.insert(more.begin(), {"field", place_});
  throw Told<UsageError>(Finding(kind, std::move(more)));
}

// As it stands in the file, not as a number: that is what is to be found there.
void JsonField::refuseValue(FindingKind kind, Finding::Values more) const {
  more.insert(more.begin(), {"value", shown(json_->dump(-1, ' ', false, Json::error_handler_t::replace))});
  refuse(kind, std::move(more));
}

void JsonField::refuseWord() const { refuse(K::fieldUnknownWord, {{"value", shown(text())}}); }

JsonField JsonField::at(const char* key) const {
  if (!has(key)) JsonField(*json_, placeOf(key)).refuse(K::fieldMissing);
  return {json_->at(key), placeOf(key)};
}

std::optional<JsonField> JsonField::given(const char* key) const {
  if (!has(key) || json_->at(key).is_null()) return std::nullopt;
  return at(key);
}

void JsonField::requireKeys(const std::vector<std::string>& known) const {
  if (!json_->is_object()) refuse(K::fieldNotObject);
  for (const auto& [key, value] : json_->items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      JsonField(value, placeOf(shown(key))).refuse(K::fieldUnknown);
}

std::vector<JsonField> JsonField::list() const {
  if (isNull()) return {};
  if (!json_->is_array()) refuse(K::fieldNotList);
  std::vector<JsonField> entries;
  for (const Json& entry : *json_)
    entries.push_back({entry, place_ + "[" + std::to_string(entries.size()) + "]"});
  return entries;
}

std::vector<JsonField> JsonField::list(std::size_t entries) const {
  std::vector<JsonField> all = list();
  if (all.size() != entries) refuse(K::fieldEntries, {{"needed", entries}, {"count", all.size()}});
  return all;
}

double JsonField::number() const {
  if (!json_->is_number()) refuseValue(K::fieldNotNumber);
  return json_->get<double>();
}

double JsonField::numberAtLeast(double least) const {
  const double value = number();
  if (!(value >= least)) refuseValue(K::fieldBelow, {{"least", least}});
  return value;
}

double JsonField::numberAbove(double least) const {
  const double value = number();
  if (!(value > least)) refuseValue(K::fieldNotAbove, {{"least", least}});
  return value;
}

Vec3 JsonField::point() const {
  const std::vector<JsonField> parts = list(3);
  return {parts[0].number(), parts[1].number(), parts[2].number()};
}

Vec3 JsonField::direction() const {
  Vec3 vector = point();
  if (!(vector.norm() > 0)) refuse(K::fieldNoDirection);
  return vector;
}

int JsonField::whole() const {
  if (!json_->is_number_integer() || std::abs(json_->get<double>()) > std::numeric_limits<int>::max())
    refuseValue(K::fieldNotWhole);
  return json_->get<int>();
}

int JsonField::wholeAtLeast(int least) const {
  const int value = whole();
  if (value < least) refuseValue(K::fieldBelow, {{"least", least}});
  return value;
}

int JsonField::wholeWithin(int least, int most) const {
  const int value = whole();
  if (value < least || value > most) refuseValue(K::fieldOutside, {{"least", least}, {"most", most}});
  return value;
}

bool JsonField::flag() const {
  if (!json_->is_boolean()) refuseValue(K::fieldNotFlag);
  return json_->get<bool>();
}

std::string JsonField::text() const {
  if (!json_->is_string()) refuse(K::fieldNotText);
  return json_->get<std::string>();
}

}  // namespace handlebody
