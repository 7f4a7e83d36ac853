#include "ui/window/seed/seed_panel.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/evolution/parameter_limits.h"
#include "ui/model/document.h"
#include "ui/view/view_state.h"
#include "ui/window/commands.h"
#include "ui/window/seed/object_choice.h"
#include "ui/window/widgets/action_button.h"
#include "ui/window/widgets/key_guard.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"
#include "ui/window/widgets/value_field.h"

namespace handlebody::ui {

namespace {

constexpr int kSeedTableHeight = 150;

ValueSpec radiusSpec() {
  ValueSpec spec;
  spec.name = SeedPanel::tr("Radius");
  spec.unit = SeedPanel::tr("mm");
  spec.tip = SeedPanel::tr(
      "Radius of the selected seed. Automatic: the largest ball that fits into the object; outside "
      "of it, as the image allows");
  spec.low = 0.01;
  spec.high = 10'000;
  spec.step = 0.5;
  return spec;
}

QTableWidgetItem* cell(const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  return item;
}

QString radiusText(const Document& document, int index) {
  const double radius = document.shownRadius(index);
  const bool automatic = !document.seeds()[index].radius;
  const QString text = fineNumber(radius, 3);
  return automatic ? SeedPanel::tr("%1 (auto)").arg(text) : text;
}

//! Why there is no object to choose.
QString unknownObject(const Document& document) {
  if (!document.isSeeded()) return SeedPanel::tr("None yet: it takes a seed inside.");
  if (document.parameters().range) return SeedPanel::tr("Given by the range in step 3, Tune.");
  const bool searching = !document.resolved() && document.resolveError().isEmpty();
  return searching ? SeedPanel::tr("Looking for it…") : QStringLiteral("–");
}

}  // namespace

SeedPanel::SeedPanel(Document& document, ViewState& state, const Commands& commands, QWidget* parent)
    : QWidget(parent), document_(document), state_(state) {
  auto* layout = panelLayout(this);
  hint_ = hint(
      tr("Click into the structure in any slice, then press Return: a ball is placed there, from which the "
         "surface grows. One seed is often enough. Shift+Return marks a place outside. Drag a seed to "
         "move it, its rim to resize it."),
      this);
  layout->addWidget(hint_);
  auto* row = new QHBoxLayout;
  row->addWidget(new ActionButton(commands[Command::addSeed], this), 1);
  row->addWidget(smallButton(commands[Command::deleteSeed], this));
  layout->addLayout(row);
  layout->addWidget(new ActionButton(commands[Command::addOutside], this));
  buildTable();
  layout->addWidget(table_);

  details_ = new QWidget(this);
  QFormLayout* form = panelForm();
  form->setContentsMargins(0, 0, 0, 0);
  details_->setLayout(form);
  radius_ = new ValueField(radiusSpec(), details_);
  form->addRow(tr("Radius"), radius_);
  layout->addWidget(details_);
  object_ = new ObjectChoice(commands, this);
  layout->addWidget(object_);
  error_ = notice(tr("What is wrong with the seeds"), this);
  layout->addWidget(error_);
  layout->addStretch();
  layout->addWidget(new ActionButton(commands[Command::run], this));
  connect(radius_, &ValueField::edited, this, [this](std::optional<double> radius, int gesture) {
    if (document_.selectedSeed() >= 0) document_.setSeedRadius(document_.selectedSeed(), radius, gesture);
  });
  connect(&document_, &Document::opened, this, &SeedPanel::boundRadius);
  for (auto changed : {&Document::seedsChanged, &Document::resolvedChanged, &Document::opened})
    connect(&document_, changed, this, &SeedPanel::showSeeds);
  connect(&document_, &Document::selectedSeedChanged, this, &SeedPanel::showSelected);
  for (auto changed :
       {&Document::seedsChanged, &Document::parametersChanged, &Document::resolvedChanged, &Document::opened})
    connect(&document_, changed, this, &SeedPanel::showChoice);
  showSeeds();
  showChoice();
}

void SeedPanel::buildTable() {
  table_ = new QTableWidget(0, 3, this);
  table_->setHorizontalHeaderLabels({tr("Centre (mm LPS)"), tr("Radius (mm)"), tr("Object")});
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (int column : {1, 2})
    table_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setTabKeyNavigation(false);
  table_->setAccessibleName(tr("Seeds"));
  table_->setFixedHeight(kSeedTableHeight);
  KeyGuard::leaveDeletion(*table_);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) { select(row); });
}

void SeedPanel::select(int row) {
  if (row < 0 || row >= static_cast<int>(document_.seeds().size())) return;
  document_.selectSeed(row);
  state_.setCrosshair(document_.seeds()[row].centre);
}

void SeedPanel::boundRadius() {
  if (!document_.hasVolume()) return;
  const Grid& grid = document_.volume().grid;
  radius_->setLengths(grid, false, limitsFor(grid).longestSide);
}

void SeedPanel::showSeeds() {
  const QSignalBlocker quiet(table_);
  const int count = static_cast<int>(document_.seeds().size());
  table_->setRowCount(count);
  for (int i = 0; i < count; ++i) {
    const Seed& seed = document_.seeds()[i];
    table_->setItem(i, 0, cell(place(seed.centre, document_.volume().grid).chopped(3)));
    table_->setItem(i, 1, cell(radiusText(document_, i)));
    table_->setItem(i, 2, cell(seed.background ? tr("outside") : tr("inside")));
  }
  error_->setText(document_.resolveError());
  error_->setVisible(!document_.resolveError().isEmpty());
  showSelected();
}

void SeedPanel::showChoice() { object_->showChoice(document_.candidateChoice(), unknownObject(document_)); }

void SeedPanel::showSelected() {
  const QSignalBlocker quiet(table_);
  const int index = document_.selectedSeed();
  const bool valid = index >= 0 && index < static_cast<int>(document_.seeds().size());
  details_->setEnabled(valid);
  if (!valid) {
    table_->clearSelection();
    radius_->show(std::nullopt);
    return;
  }
  table_->selectRow(index);
  radius_->show(document_.seeds()[index].radius, document_.shownRadius(index));
}

}  // namespace handlebody::ui
