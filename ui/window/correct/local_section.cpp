#include "ui/window/correct/local_section.h"

#include <QAbstractButton>
#include <QAction>
#include <QButtonGroup>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "core/surgery/kept_side.h"
#include "ui/model/document.h"
#include "ui/view/brush_hand.h"
#include "ui/view/length_decimals.h"
#include "ui/view/slice_geometry.h"
#include "ui/window/commands.h"
#include "ui/window/widgets/action_button.h"
#include "ui/window/widgets/choice_row.h"
#include "ui/window/widgets/decimal_field.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr double kFirstRadius = 5, kMinRadius = 0.5;  // voxels

// As they are offered.
constexpr Plane kPlanes[] = {Plane::axial, Plane::coronal, Plane::sagittal};

//! Across the plane's slices as they are shown: to superior, posterior or left, along the world's axis.
Vec3 normalOf(const Grid& grid, Plane plane) {
  const Vec3 normal = SliceGeometry(grid, plane, {1, 1}).normal();
  return normal[static_cast<int>(plane)] < 0 ? Vec3(-normal) : normal;
}

//! So that the ball holds a vertex, however small it is. Precondition: there is one.
Vec3 nearestVertex(const TriangleSoup& mesh, const Vec3& place) {
  const auto distance = [&](const Vec3& p) { return (p - place).squaredNorm(); };
  return *std::min_element(mesh.points.begin(), mesh.points.end(),
                           [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
}

}  // namespace

LocalSection::LocalSection(Document& document, ViewState& state, const Commands& commands, QWidget* parent)
    : QWidget(parent), document_(document), state_(state), commands_(commands) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(buildRadius());
  layout->addWidget(buildCut());
  connect(commands_[Command::pinHere], &QAction::triggered, this, &LocalSection::pin);
  connect(commands_[Command::smoothHere], &QAction::triggered, this, &LocalSection::smooth);
  connect(commands_[Command::pullHere], &QAction::triggered, this, &LocalSection::pull);
  connect(commands_[Command::cutHere], &QAction::triggered, this, &LocalSection::cut);
  connect(&document_, &Document::opened, this, &LocalSection::startWithVolume);
  for (auto changed : {&Document::opened, &Document::stateChanged, &Document::snapshotChanged,
                       &Document::objectsChanged, &Document::activeObjectChanged})
    connect(&document_, changed, this, &LocalSection::updateCommands);
  updateCommands();
}

//! That it is done here stands over them all.
QWidget* LocalSection::button(Command id, const QString& text) {
  auto* made = new ActionButton(commands_[id], this);
  made->setOwnText(text);
  return made;
}

QWidget* LocalSection::buildRadius() {
  auto* part = new QWidget(this);
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  radius_ = new DecimalField(part);
  radius_->setDecimals(2);
  radius_->setRange(0.01, 1000);
  radius_->setValue(kFirstRadius);
  radius_->setSuffix(tr(" mm"));
  radius_->setKeyboardTracking(false);
  describe(radius_, tr("Radius at the crosshair"),
           tr("Of the ball in which the surface is pinned or smoothed, and how far along it a pull reaches"));
  ignoreWheelWithoutFocus(radius_);
  QFormLayout* form = panelForm();
  form->addRow(tr("Radius"), radius_);
  layout->addLayout(form);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(button(Command::pinHere, tr("Pin")));
  row->addWidget(button(Command::smoothHere, tr("Smooth")));
  row->addWidget(button(Command::pullHere, tr("Pull")));
  layout->addLayout(row);
  return part;
}

QWidget* LocalSection::buildCut() {
  auto* part = new QWidget(this);
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  QFormLayout* form = panelForm();
  form->addRow(tr("Plane"), choiceRow(tr("Plane"), {tr("Axial"), tr("Coronal"), tr("Sagittal")},
                                      {tr("Cut as the axial slices lie"), tr("Cut as the coronal slices lie"),
                                       tr("Cut as the sagittal slices lie")},
                                      plane_, part));
  form->addRow(tr("Keep"), choiceRow(tr("Keep"), {tr("Both"), tr("Superior"), tr("Inferior")},
                                     {tr("Both sides of the cut stay"), {}, {}}, kept_, part));
  layout->addLayout(form);
  layout->addWidget(button(Command::cutHere, tr("Cut")));
  plane_->button(0)->setChecked(true);
  kept_->button(0)->setChecked(true);
  connect(plane_, &QButtonGroup::idToggled, this, &LocalSection::showSides);
  showSides();
  return part;
}

//! The ids of the sides are KeptSide's.
void LocalSection::showSides() {
  const QString positive[] = {tr("Superior"), tr("Posterior"), tr("Left")};
  const QString negative[] = {tr("Inferior"), tr("Anterior"), tr("Right")};
  const int plane = plane_->checkedId();
  if (plane < 0) return;
  for (const auto& [side, name] :
       {std::pair(KeptSide::positive, positive[plane]), std::pair(KeptSide::negative, negative[plane])}) {
    QAbstractButton* button = kept_->button(static_cast<int>(side));
    button->setText(name);
    describe(button, tr("Keep: %1").arg(name), tr("Only what lies on this side of the plane stays"));
  }
}

void LocalSection::startWithVolume() {
  const Grid& grid = document_.volume().grid;
  const double voxel = grid.meanSpacing();
  const Vec3 size(grid.size[0], grid.size[1], grid.size[2]);
  radius_->setDecimals(lengthDecimals(grid));
  radius_->setRange(kMinRadius * voxel, size.cwiseProduct(grid.spacing).maxCoeff());
  radius_->setSingleStep(kMinRadius * voxel);
  radius_->setValue(kFirstRadius * voxel);
}

void LocalSection::updateCommands() {
  commands_[Command::pinHere]->setEnabled(mayBePinned(document_));
  for (Command id : {Command::smoothHere, Command::pullHere, Command::cutHere})
    commands_[id]->setEnabled(mayBeEdited(document_));
}

void LocalSection::pin() {
  if (document_.pin(state_.crosshair(), radius_->value())) Q_EMIT pinned();
}

void LocalSection::smooth() {
  MeshEdit edit;
  edit.kind = MeshEditKind::smooth;
  edit.place = nearestVertex(document_.snapshot()->mesh, state_.crosshair());
  edit.radius = radius_->value();
  document_.editMesh(edit);
}

void LocalSection::pull() {
  MeshEdit edit;
  edit.kind = MeshEditKind::pull;
  edit.place = nearestVertex(document_.snapshot()->mesh, state_.crosshair());
  edit.vector = state_.crosshair();
  edit.radius = radius_->value();
  document_.editMesh(edit);
}

void LocalSection::cut() {
  MeshEdit edit;
  edit.kind = MeshEditKind::cut;
  edit.place = state_.crosshair();
  edit.vector = normalOf(document_.volume().grid, kPlanes[plane_->checkedId()]);
  edit.keep = static_cast<KeptSide>(kept_->checkedId());
  document_.editMesh(edit);
}

}  // namespace handlebody::ui
