#include "core/io/report/terminology_json.h"

#include "core/errors.h"

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

CodedTerm codedFromJson(const Json& json) {
  return {json.at("value").get<std::string>(), json.at("scheme").get<std::string>(),
          json.at("meaning").get<std::string>()};
}

ModifiedTerm modifiedFromJson(const Json& json) {
  ModifiedTerm term{codedFromJson(json), {}};
  if (json.contains("modifiers"))
    for (const Json& modifier : json.at("modifiers")) term.modifiers.push_back(codedFromJson(modifier));
  return term;
}

//! Files of others are read leniently, our own as they were written.
Terminology terminologyFromJson(const Json& json) {
  Terminology said{codedFromJson(json.at("category")), modifiedFromJson(json.at("type")), {}};
  if (json.contains("region")) said.region = modifiedFromJson(json.at("region"));
  if (usable(said) != said)
    throw UsageError("a code of the object's terminology is empty, too long, or holds what separates codes.");
  return said;
}

SegmentAlgorithm algorithmFromJson(const Json& json) {
  const auto type = json.at("type").get<std::string>(), name = json.value("name", std::string());
  const std::optional<SegmentAlgorithm> said = algorithmSaid(type, name);
  if (!said) throw UsageError("there is no type of algorithm '" + type + "'.");
  if (said->name != name) throw UsageError("the name of the object's algorithm cannot be written.");
  return *said;
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

SegmentSource sourceFromJson(const Json& object) {
  SegmentSource source;
  if (object.contains("terminology")) source.terminology = terminologyFromJson(object.at("terminology"));
  if (object.contains("algorithm")) source.algorithm = algorithmFromJson(object.at("algorithm"));
  return source;
}

}  // namespace handlebody
