#include "core/io/report/terminology_json.h"

#include "core/io/report/json_field.h"

namespace handlebody {

namespace {

Json termToJson(const CodedTerm& term) {
  return {{"value", term.value}, {"scheme", term.scheme}, {"meaning", term.meaning}};
}

Json termToJson(const ModifiedTerm& term) {
  Json json = termToJson(term.term);
  for (const CodedTerm& modifier : term.modifiers) json["modifiers"].push_back(termToJson(modifier));
  return json;
}

CodedTerm codedFromJson(const JsonField& json) {
  return {json.at("value").text(), json.at("scheme").text(), json.at("meaning").text()};
}

ModifiedTerm modifiedFromJson(const JsonField& json) {
  ModifiedTerm term{codedFromJson(json), {}};
  if (json.has("modifiers"))
    for (const JsonField& modifier : json.at("modifiers").list())
      term.modifiers.push_back(codedFromJson(modifier));
  return term;
}

//! Files of others are read leniently, our own as they were written.
Terminology terminologyFromJson(const JsonField& json) {
  Terminology said{codedFromJson(json.at("category")), modifiedFromJson(json.at("type")), {}};
  if (json.has("region")) said.region = modifiedFromJson(json.at("region"));
  if (usable(said) != said) json.refuse(FindingKind::fieldBadCode);
  return said;
}

SegmentAlgorithm algorithmFromJson(const JsonField& json) {
  const std::string name = json.has("name") ? json.at("name").text() : std::string();
  const SegmentAlgorithm said =
      json.at("type").word([&](const std::string& type) { return algorithmSaid(type, name); });
  if (said.name != name) json.at("name").refuse(FindingKind::fieldNotWritable);
  return said;
}

}  // namespace

Json terminologyToJson(const Terminology& terminology) {
  Json json = {{"category", termToJson(terminology.category)}, {"type", termToJson(terminology.type)}};
  if (!terminology.region.term.value.empty()) json["region"] = termToJson(terminology.region);
  return json;
}

void addSource(Json& object, const SegmentSource& source) {
  if (source.terminology) object["terminology"] = terminologyToJson(*source.terminology);
  if (!source.algorithm) return;
  object["algorithm"] = {{"type", algorithmTypeName(source.algorithm->type)}};
  if (!source.algorithm->name.empty()) object["algorithm"]["name"] = source.algorithm->name;
}

SegmentSource sourceFromJson(const JsonField& object) {
  SegmentSource source;
  if (object.has("terminology")) source.terminology = terminologyFromJson(object.at("terminology"));
  if (object.has("algorithm")) source.algorithm = algorithmFromJson(object.at("algorithm"));
  return source;
}

}  // namespace handlebody
