#include "ui/window/measures/compare_page.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>
#include <numeric>

#include "core/io/meshes/mesh_io.h"
#include "core/io/report/compared_table.h"
#include "ui/model/document.h"
#include "ui/model/finding_text.h"
#include "ui/model/translate.h"
#include "ui/view/distance_colours.h"
#include "ui/view/view_state.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kTools = 290;     // pixels
constexpr int kAllLabels = -1;  // shown as a word
constexpr int kLargest = 65535;

const QString kNone = QStringLiteral("–");

QString volumeOf(const Solid& s) { return s.isClosed() ? number(s.volume() / 1000) : kNone; }

QString genusOf(const Solid& s) {
  const auto& g = s.certificate.genus;
  return QString::number(std::accumulate(g.begin(), g.end(), 0));
}

struct Row {
  QString what, object, reference;
};

std::vector<Row> rowsOf(const ComparedPair& pair) {
  const Solid &a = pair.a.solid, &b = pair.b.solid;
  const auto count = [](const Solid& s) {
    return QString::number(s.certificate.components - std::max(0, s.certificate.cavities));
  };
  const auto cavities = [](const Solid& s) { return QString::number(std::max(0, s.certificate.cavities)); };
  const Comparison& f = pair.found;
  const auto share = [](const std::optional<double>& value) { return value ? number(*value, 3) : kNone; };
  std::vector<Row> rows{{tr("Dice"), share(f.dice), {}}, {tr("IoU"), share(f.iou), {}}};
  if (f.distances)
    rows.insert(rows.end(),
                {{tr("Mean distance of the surfaces, ASSD (mm)"), number(f.distances->mean(), 3), {}},
                 {tr("95 % Hausdorff distance (mm)"), number(f.distances->percentile95(), 3), {}},
                 {tr("Hausdorff distance (mm)"), number(f.distances->hausdorff(), 3), {}}});
  rows.push_back({tr("Volume (ml)"), volumeOf(a), volumeOf(b)});
  if (a.isClosed() && b.isClosed() && b.volume() > 0) {
    const double more = a.volume() - b.volume();
    rows.push_back({tr("Volume, difference (ml)"), number(more / 1000),
                    tr("%1 %").arg(number(100 * more / b.volume(), 3))});
  }
  rows.push_back({tr("Area (cm²)"), number(a.certificate.area / 100), number(b.certificate.area / 100)});
  rows.push_back({tr("Components"), count(a), count(b)});
  rows.push_back({tr("Tunnels"), genusOf(a), genusOf(b)});
  rows.push_back({tr("Cavities"), cavities(a), cavities(b)});
  return rows;
}

}  // namespace

ComparePage::ComparePage(Document& document, ViewState& state, QWidget* parent)
    : QWidget(parent), document_(document), state_(state) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(buildTools());
  table_ = listTable({tr("Figure"), tr("Object"), tr("Reference")}, this);
  table_->setAccessibleName(tr("The object beside the reference"));
  layout->addWidget(table_, 1);
  connect(choose_, &QPushButton::clicked, this, &ComparePage::choose);
  connect(again_, &QPushButton::clicked, this, &ComparePage::compareOrCancel);
  connect(colours_, &QCheckBox::toggled, this, &ComparePage::colour);
  connect(csv_, &QPushButton::clicked, this, [this] {
    Q_EMIT saveRequested(tr("Save the comparison"), QStringLiteral(".csv"), comparisonCsv(*told()));
  });
  connect(json_, &QPushButton::clicked, this, [this] {
    Q_EMIT saveRequested(tr("Save the comparison"), QStringLiteral(".json"), comparisonJson(*told()));
  });
  connect(&document_, &Document::opened, this, &ComparePage::forget);
  for (auto changed : {&Document::snapshotChanged, &Document::objectsChanged, &Document::stateChanged})
    connect(&document_, changed, this, &ComparePage::showState);
  showState();
}

QPushButton* ComparePage::addButton(const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, this);
  button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard with the views
  describe(button, text, tip);
  return button;
}

QWidget* ComparePage::buildTools() {
  auto* tools = new QWidget(this);
  tools->setFixedWidth(kTools);
  auto* grid = new QGridLayout(tools);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  choose_ = addButton(tr("Choose reference…"), tr("A mesh or a label map to compare the active object with"));
  again_ = addButton(tr("Compare"), tr("Compare the shown surface with the reference"));
  csv_ = addButton(tr("Save as CSV…"), tr("The same table as “handlebody-cli compare --csv” writes"));
  json_ = addButton(tr("Save as JSON…"), tr("The same as “handlebody-cli compare --report” writes"));
  reference_ = value(tr("The reference"), tools);
  note_ = value(tr("State of the comparison"), tools);
  label_ = new QSpinBox(tools);
  label_->setRange(kAllLabels, kLargest);
  label_->setSpecialValueText(tr("all but 0"));
  label_->setValue(kAllLabels);
  describe(label_, tr("Label value of the reference"), tr("Which voxels of a label map are the reference"));
  ignoreWheelWithoutFocus(label_);
  colours_ = new QCheckBox(tr("Distances in colour on the surface"), tools);
  colours_->setFocusPolicy(Qt::TabFocus);
  colours_->setChecked(true);
  describe(colours_, colours_->text(), tr("Blue inside of the reference, red outside of it"));
  progress_ = new QProgressBar(tools);
  progress_->setRange(0, 0);  // how long it takes is not known
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("The objects are compared"));
  auto* name = new QLabel(tr("Label value"), tools);
  grid->addWidget(choose_, 0, 0);
  grid->addWidget(again_, 0, 1);
  grid->addWidget(reference_, 1, 0, 1, 2);
  grid->addWidget(name, 2, 0);
  grid->addWidget(label_, 2, 1);
  grid->addWidget(colours_, 3, 0, 1, 2);
  grid->addWidget(progress_, 4, 0, 1, 2);
  grid->addWidget(note_, 5, 0, 1, 2);
  grid->setRowStretch(6, 1);
  grid->addWidget(csv_, 7, 0);
  grid->addWidget(json_, 7, 1);
  return tools;
}

void ComparePage::choose() {
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Choose the reference"), QSettings().value(QStringLiteral("folder")).toString(),
      tr("Meshes and label maps (*.stl *.vtp *.ply *.obj *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl "
         "*.gipl.gz *.dcm);;All files "
         "(*)"),
      nullptr, QFileDialog::HideNameFilterDetails);
  if (!path.isEmpty()) compareWith(path);
}

void ComparePage::compareOrCancel() {
  if (!isComparing_) return compareWith(path_);
  comparer_.cancel();
  isComparing_ = false;
  showState();
}

void ComparePage::compareWith(const QString& path) {
  const auto mesh = document_.hasVolume() ? document_.finishedMesh(document_.activeObject()) : nullptr;
  if (!mesh) return;
  forget();
  path_ = path;
  CompareQuestion question;
  const ObjectInfo info = document_.objectInfo(document_.activeObject());
  const auto active = static_cast<std::size_t>(document_.activeObject());
  anonymousName_ = QString::fromStdString(document_.anonymousNames().at(active));
  question.surface = {QString::fromStdString(info.label.name), mesh, anonymousName_};
  question.path = path;
  if (label_->value() != kAllLabels && !isMeshInputPath(path.toStdString())) question.label = label_->value();
  compared_ = info.snapshot;
  isComparing_ = true;
  comparer_.compare(std::move(question), [this, number = ++number_](CompareAnswer answer) {
    QMetaObject::invokeMethod(
        this,
        [this, number, answer = std::make_shared<CompareAnswer>(std::move(answer))] {
          if (number == number_ && isComparing_) showAnswer(std::move(*answer));
        },
        Qt::QueuedConnection);
  });
  showState();
}

void ComparePage::showAnswer(CompareAnswer answer) {
  isComparing_ = false;
  answer_ = std::move(answer);
  showTable();
  colour();
  showState();
}

//! What is saved.
std::shared_ptr<const ComparedPair> ComparePage::told() const {
  if (!isAnonymous_) return answer_.pair;
  auto pair = std::make_shared<ComparedPair>(anonymous(*answer_.pair));
  pair->a.path = anonymousName_.toStdString();
  return pair;
}

void ComparePage::forget() {
  comparer_.cancel();
  isComparing_ = false;
  answer_ = {};
  compared_.reset();
  path_.clear();
  state_.setDistances(nullptr);
  showTable();
  showState();
}

void ComparePage::colour() {
  const bool any = colours_->isChecked() && compared_ && !answer_.distances.empty() &&
                   answer_.distances.size() == compared_->mesh.points.size();
  state_.setDistances(any ? std::make_shared<const DistanceColours>(
                                distanceColours(compared_, answer_.distances, answer_.isSigned))
                          : nullptr);
}

void ComparePage::showTable() {
  table_->setRowCount(0);
  if (!answer_.pair) return;
  for (const Row& row : rowsOf(*answer_.pair)) {
    const int at = table_->rowCount();
    table_->insertRow(at);
    const QStringList cells{row.what, row.object, row.reference};
    for (int c = 0; c < cells.size(); ++c) {
      table_->setItem(at, c, listCell(cells[c]));
      if (c > 0) table_->item(at, c)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
  }
}

void ComparePage::showState() {
  const bool any = document_.hasVolume() && document_.finishedMesh(document_.activeObject());
  choose_->setEnabled(any && !isComparing_);
  again_->setEnabled(isComparing_ || (any && !path_.isEmpty()));
  again_->setText(isComparing_ ? tr("Cancel") : tr("Compare"));
  again_->setAccessibleName(again_->text());
  progress_->setVisible(isComparing_);
  for (QPushButton* button : {csv_, json_}) button->setEnabled(answer_.pair != nullptr);
  label_->setEnabled(!isComparing_ && !isMeshInputPath(path_.toStdString()));
  reference_->setText(path_.isEmpty() ? tr("No reference is chosen.")
                                      : QFontMetrics(font()).elidedText(QFileInfo(path_).fileName(),
                                                                        Qt::ElideMiddle, kTools - 10));
  reference_->setToolTip(path_.toHtmlEscaped());
  QString text;
  if (!any)
    text = tr("There is no surface to compare yet: grow one first.");
  else if (!answer_.error.isEmpty())
    text = answer_.error;
  else if (isComparing_)
    text = tr("Comparing…");
  else if (answer_.pair && compared_ != document_.snapshot())
    text = tr("These are figures of an earlier surface, or of another object.");
  else if (answer_.pair)
    text = findingSentences(answer_.pair->warnings);
  note_->setText(text);
  note_->setVisible(!text.isEmpty());
}

}  // namespace handlebody::ui
