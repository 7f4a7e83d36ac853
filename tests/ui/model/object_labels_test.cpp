#include "ui/model/object_labels.h"

#include <set>

#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

std::vector<ObjectLabel> freshLabels(std::size_t count) {
  std::vector<ObjectLabel> labels;
  while (labels.size() < count) labels.push_back(freshLabel(labels));
  return labels;
}

}  // namespace

TEST_CASE("fresh labels differ in name and value, and none has a fault", "[objects]") {
  const std::vector<ObjectLabel> labels = freshLabels(30);
  std::set<std::string> names;
  std::set<int> values;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    names.insert(labels[i].name);
    values.insert(labels[i].value);
    CHECK(labelFault(i, labels[i], labels).isEmpty());
  }
  CHECK(names.size() == labels.size());
  CHECK(values.size() == labels.size());
}

TEST_CASE("an object from a file keeps name and value where they are free, and else gets others",
          "[objects]") {
  std::vector<ObjectLabel> known = freshLabels(2);
  ObjectLabel wanted = known[0];
  wanted.name = "Cyst";
  wanted.value = 77;
  const ObjectLabel taken = labelFor(wanted, known);
  CHECK(taken.name == "Cyst");
  CHECK(taken.value == 77);
  known.push_back(taken);
  const ObjectLabel again = labelFor(wanted, known);
  CHECK(again.name == "Cyst (2)");
  CHECK(again.value != 77);
  CHECK(labelFault(known.size(), again, known).isEmpty());
}

TEST_CASE("a label with the name or the value of another object is told as a fault", "[objects]") {
  const std::vector<ObjectLabel> known = freshLabels(2);
  ObjectLabel label = known[1];
  label.name = known[0].name;
  CHECK_FALSE(labelFault(1, label, known).isEmpty());
  label = known[1];
  label.value = known[0].value;
  CHECK_FALSE(labelFault(1, label, known).isEmpty());
  label = known[1];
  label.name.clear();
  CHECK_FALSE(labelFault(1, label, known).isEmpty());
}
