#include "ui/model/object_labels.h"

#include <algorithm>
#include <set>

#include "core/io/meshes/object_name.h"
#include "ui/model/document.h"

namespace handlebody::ui {

namespace {

//! Why an object cannot be called so; empty if it can.
QString nameFaultInWords(const std::string& utf8) {
  const QString name = QString::fromStdString(utf8);
  switch (nameFaultOf(utf8)) {
    case NameFault::none:
      return {};
    case NameFault::empty:
      return Document::tr("The name is empty.");
    case NameFault::notUtf8:
      return Document::tr("The name “%1” is not UTF-8.").arg(name);
    case NameFault::tooLong:
      return Document::tr("The name “%1” has more than %2 characters.")
          .arg(name, QString::number(kLongestName));
    case NameFault::controlCharacter:
      return Document::tr("The name “%1” holds a control character.").arg(name);
    case NameFault::separator:
      break;
  }
  const char separator = utf8[utf8.find_first_of(kNameSeparators)];
  return Document::tr("The name “%1” holds %2, which separates in some of the formats.")
      .arg(name, QString(QLatin1Char(separator)));
}

}  // namespace

ObjectLabel freshLabel(const std::vector<ObjectLabel>& known) {
  std::set<std::string> names;
  std::vector<int> values;
  std::vector<Colour> colours;
  for (const ObjectLabel& other : known) {
    names.insert(other.name);
    values.push_back(other.value);
    colours.push_back(other.colour);
  }
  ObjectLabel label;
  int number = static_cast<int>(known.size()) + 1;
  do label.name = Document::tr("Object %1").arg(number++).toStdString();
  while (names.count(label.name) != 0);
  label.value = freeLabelValue(values);
  const std::vector<Colour>& all = distinctColours();
  const auto isFree = [&](const Colour& c) {
    return std::find(colours.begin(), colours.end(), c) == colours.end();
  };
  const auto free = std::find_if(all.begin(), all.end(), isFree);
  label.colour = free != all.end() ? *free : all[known.size() % all.size()];
  return label;
}

ObjectLabel labelFor(const ObjectLabel& wanted, const std::vector<ObjectLabel>& known) {
  const auto isTaken = [&](const std::string& name) {
    return std::any_of(known.begin(), known.end(), [&](const ObjectLabel& o) { return o.name == name; });
  };
  ObjectLabel label = freshLabel(known);
  if (std::none_of(known.begin(), known.end(),
                   [&](const ObjectLabel& o) { return o.value == wanted.value; }) &&
      wanted.value >= 1 && wanted.value <= kLargestLabel)
    label.value = wanted.value;
  for (int n = 1;; ++n) {
    const std::string name = n == 1 ? wanted.name : wanted.name + " (" + std::to_string(n) + ")";
    if (!objectNameFault(name).empty()) break;  // too long with a number
    if (isTaken(name)) continue;
    label.name = name;
    break;
  }
  return label;
}

QString labelFault(std::size_t index, const ObjectLabel& label, const std::vector<ObjectLabel>& known) {
  if (const QString fault = nameFaultInWords(label.name); !fault.isEmpty()) return fault;
  const QString name = QString::fromStdString(label.name);
  for (std::size_t i = 0; i < known.size(); ++i) {
    const ObjectLabel& other = known[i];
    if (i != index && other.name == label.name)
      return Document::tr("Another object is called “%1”.").arg(name);
    if (i != index && other.value == label.value)
      return Document::tr("“%1” has the label value %2.")
          .arg(QString::fromStdString(other.name), QString::number(label.value));
  }
  return {};
}

}  // namespace handlebody::ui
