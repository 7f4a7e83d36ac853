#include "core/io/meshes/exported_object.h"

#include <algorithm>
#include <optional>

#include "core/io/meshes/object_name.h"
#include "core/io/utf8.h"

namespace handlebody {

namespace {

const Code kTissue{"85756007", "Tissue"};
const Code kStructure{"123037004", "Anatomical Structure"};
const Code kAltered{"49755003", "Morphologically Altered Structure"};

}  // namespace

const std::vector<Term>& terms() {
  static const std::vector<Term> all{
      {"tissue", kTissue, kTissue, {128, 174, 128}},
      {"organ", kTissue, {"113343008", "Organ"}, {221, 130, 101}},
      {"vessel", kTissue, {"59820001", "Blood vessel"}, {216, 101, 79}},
      {"artery", kTissue, {"51114001", "Artery"}, {216, 101, 79}},
      {"vein", kTissue, {"29092000", "Vein"}, {0, 151, 206}},
      {"bone", kTissue, {"272673000", "Bone"}, {241, 214, 145}},
      {"muscle", kTissue, {"71616004", "Muscle"}, {192, 104, 88}},
      {"aorta", kStructure, {"15825003", "Aorta"}, {224, 97, 76}},
      {"bladder", kStructure, {"89837001", "Bladder"}, {222, 154, 132}},
      {"brain", kStructure, {"12738006", "Brain"}, {250, 250, 225}},
      {"brain-ventricle", kStructure, {"35764002", "Brain ventricle"}, {88, 106, 215}},
      {"gallbladder", kStructure, {"28231008", "Gallbladder"}, {139, 150, 98}},
      {"heart", kStructure, {"80891009", "Heart"}, {206, 110, 84}},
      {"left-atrium", kStructure, {"82471001", "Left atrium"}, {203, 108, 81}},
      {"right-atrium", kStructure, {"73829009", "Right atrium"}, {210, 115, 89}},
      {"left-ventricle", kStructure, {"87878005", "Left ventricle"}, {152, 55, 13}},
      {"right-ventricle", kStructure, {"53085002", "Right ventricle"}, {181, 85, 57}},
      {"hippocampus", kStructure, {"5366008", "Hippocampus"}, {221, 130, 101}},
      {"kidney", kStructure, {"64033007", "Kidney"}, {185, 102, 83}},
      {"liver", kStructure, {"10200004", "Liver"}, {221, 130, 101}},
      {"lung", kStructure, {"39607008", "Lung"}, {197, 165, 145}},
      {"pancreas", kStructure, {"15776009", "Pancreas"}, {249, 180, 111}},
      {"prostate", kStructure, {"41216001", "Prostate"}, {230, 158, 140}},
      {"spinal-cord", kStructure, {"2748008", "Spinal cord"}, {244, 214, 49}},
      {"spleen", kStructure, {"78961009", "Spleen"}, {157, 108, 162}},
      {"stomach", kStructure, {"69695003", "Stomach"}, {216, 132, 105}},
      {"thyroid", kStructure, {"69748006", "Thyroid"}, {62, 162, 114}},
      {"trachea", kStructure, {"44567001", "Trachea"}, {182, 228, 255}},
      {"uterus", kStructure, {"35039007", "Uterus"}, {255, 181, 158}},
      {"vertebra", kStructure, {"51282000", "Vertebra"}, {241, 214, 145}},
      {"cyst", kAltered, {"367643001", "Cyst"}, {205, 205, 100}},
      {"hemorrhage", kAltered, {"50960005", "Hemorrhage"}, {188, 65, 28}},
      {"mass", kAltered, {"4147007", "Mass"}, {144, 238, 144}},
      {"tumor", kAltered, {"108369006", "Neoplasm"}, {144, 238, 144}},
  };
  return all;
}

const Term* termFromName(const std::string& name) {
  const auto& all = terms();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Term& t) { return t.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const Term& plainTerm() { return terms().front(); }

Terminology terminologyOf(const Term& term) {
  const auto coded = [](const Code& code) { return CodedTerm{code.value, kSnomed, code.meaning}; };
  return {coded(term.category), {coded(term.type), {}}, {}};
}

Terminology terminologyOf(const ObjectLabel& label) {
  if (label.source.terminology) return *label.source.terminology;
  const Term* term = termFromName(label.term);
  return terminologyOf(term ? *term : plainTerm());
}

const std::vector<Colour>& distinctColours() {
  static const std::vector<Colour> all{{230, 159, 0}, {86, 180, 233}, {0, 158, 115},  {240, 228, 66},
                                       {0, 114, 178}, {213, 94, 0},   {204, 121, 167}};
  return all;
}

int freeLabelValue(const std::vector<int>& taken) {
  int value = 1;
  while (std::find(taken.begin(), taken.end(), value) != taken.end()) ++value;
  return value;
}

std::optional<std::size_t> charactersOf(const std::string& text) {
  std::size_t characters = 0;
  for (std::size_t at = 0; at < text.size(); ++characters) {
    const std::size_t length = sequenceLength(text, at);
    if (length == 0) return std::nullopt;
    at += length;
  }
  return characters;
}

NameFault nameFaultOf(const std::string& name) {
  if (name.find_first_not_of(' ') == std::string::npos) return NameFault::empty;
  const std::optional<std::size_t> characters = charactersOf(name);
  if (!characters) return NameFault::notUtf8;
  if (*characters > kLongestName) return NameFault::tooLong;
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (std::any_of(name.begin(), name.end(), isControl)) return NameFault::controlCharacter;
  for (const char* noCharacter : {"\xef\xbf\xbe", "\xef\xbf\xbf"})  // U+FFFE and U+FFFF: not in XML
    if (name.find(noCharacter) != std::string::npos) return NameFault::controlCharacter;
  return name.find_first_of(kNameSeparators) == std::string::npos ? NameFault::none : NameFault::separator;
}

std::string objectNameFault(const std::string& name) {
  switch (nameFaultOf(name)) {
    case NameFault::none:
      return {};
    case NameFault::empty:
      return "is empty";
    case NameFault::notUtf8:
      return "is not UTF-8";
    case NameFault::tooLong:
      return "has more than " + std::to_string(kLongestName) + " characters";
    case NameFault::controlCharacter:
      return "holds a control character";
    case NameFault::separator:
      break;
  }
  return std::string("holds ") + name[name.find_first_of(kNameSeparators)] +
         ", which separates in some of the formats";
}

}  // namespace handlebody
