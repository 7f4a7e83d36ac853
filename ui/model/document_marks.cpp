// What the timeline tells of changes on the way of a growth.

#include <algorithm>
#include <map>

#include "ui/model/document_private.h"

namespace handlebody::ui {

namespace {

//! What is another one, by name.
QStringList differences(const Constraints& a, const Constraints& b) {
  QStringList what;
  const auto add = [&](bool differs, const QString& name) {
    if (differs) what << name;
  };
  add(a.walls.balls != b.walls.balls || a.walls.map != b.walls.map, Document::tr("Walls"));
  add(a.walls.discs != b.walls.discs, Document::tr("Wall disc"));
  add(a.pins != b.pins, Document::tr("Pins"));
  add(a.vetoes != b.vetoes, Document::tr("Veto"));
  add(a.edits != b.edits, Document::tr("Edit by hand"));
  const TopologyLimits &was = a.topology, &is = b.topology;
  add(was.components != is.components || was.genus != is.genus || was.asks != is.asks,
      Document::tr("Limits of the topology"));
  add(was.allowed != is.allowed, Document::tr("Decided: let it happen"));
  add(was.kept != is.kept, Document::tr("Decided: hold it"));
  return what;
}

//! What was known from the start, some of it of a later iteration.
void addFirst(const Constraints& first, std::map<int, QStringList>& marks) {
  Constraints untimed;
  untimed.walls = first.walls;
  untimed.topology = first.topology;
  if (const QStringList what = differences({}, untimed); !what.isEmpty()) marks[0] << what;
  for (const Pin& pin : first.pins) marks[pin.iteration] << Document::tr("Pins");
  for (const Veto& veto : first.vetoes) marks[veto.iteration - 1] << Document::tr("Veto");
  for (const MeshEdit& edit : first.edits) marks[edit.iteration - 1] << Document::tr("Edit by hand");
}

}  // namespace

std::vector<ChangeMark> Document::changeMarks() const {
  const SurfaceGrowth& growth = d_->active().growth();
  if (!growth.exists()) return {};
  std::map<int, QStringList> marks;
  const Constraints* constraints = &growth.beginning().constraints();
  const Parameters* parameters = &growth.beginning().requested();
  addFirst(*constraints, marks);
  for (const ParameterChange& change : growth.changes()) {
    QStringList& what = marks[change.iteration];
    if (change.seeds) what << tr("Clicks");
    if (!(change.parameters == *parameters)) what << tr("Parameters");
    parameters = &change.parameters;
    if (!change.constraints) continue;
    what << differences(*constraints, *change.constraints);
    constraints = &*change.constraints;
  }
  std::vector<ChangeMark> all;
  for (auto& [iteration, what] : marks) {
    what.removeDuplicates();
    if (!what.isEmpty()) all.push_back({iteration, what});
  }
  return all;
}

}  // namespace handlebody::ui
