#include "ui/window/measures/compare_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>
#include <numeric>

#include "core/io/meshes/mesh_io.h"
#include "core/io/report/compared_table.h"
#include "ui/model/document.h"
#include "ui/model/file_name.h"
#include "ui/model/finding_text.h"
#include "ui/model/translate.h"
#include "ui/view/distance_colours.h"
#include "ui/view/view_state.h"
#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kCompareTools = 290;  // pixels
constexpr int kLabelLetters = 10;   // at least; longer names are shortened

const QString kNotCompared = QStringLiteral("–");

QString volumeOf(const Solid& s) { return s.isClosed() ? fineNumber(s.volume() / 1000) : kNotCompared; }

//! Of a topology that is a body's.
QString countOf(const Solid& s, int count) { return s.isMisplaced() ? kNotCompared : QString::number(count); }

QString genusOf(const Solid& s) {
  const auto& g = s.certificate.genus;
  return countOf(s, std::accumulate(g.begin(), g.end(), 0));
}

struct Row {
  QString what, object, reference;
};

std::vector<Row> rowsOf(const ComparedPair& pair) {
  const Solid &a = pair.a.solid, &b = pair.b.solid;
  const auto count = [](const Solid& s) {
    return countOf(s, s.certificate.components - std::max(0, s.certificate.cavities));
  };
  const auto cavities = [](const Solid& s) { return countOf(s, std::max(0, s.certificate.cavities)); };
  const Comparison& f = pair.found;
  const auto share = [](const std::optional<double>& value) {
    return value ? number(*value, 3) : kNotCompared;
  };
  std::vector<Row> rows{{tr("Dice"), share(f.dice), {}}, {tr("IoU"), share(f.iou), {}}};
  if (f.distances)
    rows.insert(rows.end(),
                {{tr("Mean distance of the surfaces, ASSD (mm)"), fineNumber(f.distances->mean(), 3), {}},
                 {tr("95 % Hausdorff distance (mm)"), fineNumber(f.distances->percentile95(), 3), {}},
                 {tr("Hausdorff distance (mm)"), fineNumber(f.distances->hausdorff(), 3), {}}});
  rows.push_back({tr("Volume (ml)"), volumeOf(a), volumeOf(b)});
  if (a.isClosed() && b.isClosed() && b.volume() > 0) {
    const double more = a.volume() - b.volume();
    rows.push_back({tr("Volume, difference (ml)"), fineNumber(more / 1000),
                    tr("%1 %").arg(number(100 * more / b.volume(), 3))});
  }
  rows.push_back(
      {tr("Area (cm²)"), fineNumber(a.certificate.area / 100), fineNumber(b.certificate.area / 100)});
  rows.push_back({tr("Components"), count(a), count(b)});
  rows.push_back({tr("Tunnels"), genusOf(a), genusOf(b)});
  rows.push_back({tr("Cavities"), cavities(a), cavities(b)});
  return rows;
}

QString textOf(const NamedLabel& label) {
  const QString number = QString::number(label.value);
  return label.name.empty() ? number
                            : QStringLiteral("%1 – %2").arg(number, QString::fromStdString(label.name));
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
  connectTools();
  connect(&document_, &Document::opened, this, &ComparePage::forget);
  for (auto changed : {&Document::snapshotChanged, &Document::objectsChanged, &Document::stateChanged})
    connect(&document_, changed, this, &ComparePage::showState);
  forget();
}

void ComparePage::connectTools() {
  connect(choose_, &QPushButton::clicked, this, &ComparePage::choose);
  connect(again_, &QPushButton::clicked, this, &ComparePage::compareOrCancel);
  connect(label_, &QComboBox::activated, this, &ComparePage::start);
  connect(colours_, &QCheckBox::toggled, this, &ComparePage::colour);
  connect(csv_, &QPushButton::clicked, this, [this] {
    Q_EMIT saveRequested(tr("Save the comparison"), QStringLiteral(".csv"), comparisonCsv(*told()));
  });
  connect(json_, &QPushButton::clicked, this, [this] {
    Q_EMIT saveRequested(tr("Save the comparison"), QStringLiteral(".json"), comparisonJson(*told()));
  });
  connect(vtp_, &QPushButton::clicked, this, &ComparePage::saveDistances);
}

QPushButton* ComparePage::addButton(const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, this);
  button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard with the views
  describe(button, text, tip);
  return button;
}

QWidget* ComparePage::buildTools() {
  auto* tools = new QWidget(this);
  tools->setFixedWidth(kCompareTools);
  auto* grid = new QGridLayout(tools);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  choose_ = addButton(tr("Choose reference…"),
                      tr("A mesh, a label map or another object to compare the active object with"));
  again_ = addButton(tr("Compare"), tr("Compare the shown surface with the reference"));
  csv_ = addButton(tr("Save as CSV…"), tr("The same table as “handlebody-cli compare --csv” writes"));
  json_ = addButton(tr("Save as JSON…"), tr("The same as “handlebody-cli compare --report” writes"));
  vtp_ = addButton(tr("Save distances…"),
                   tr("The surface with its distance from the reference at every vertex, as "
                      "“handlebody-cli compare -o” writes it"));
  reference_ = value(tr("The reference"), tools);
  reference_->setTextFormat(Qt::PlainText);  // an object may be called "<1>"
  labelNote_ = value(tr("Why no labels are listed"), tools);
  note_ = value(tr("State of the comparison"), tools);
  colours_ = new QCheckBox(tr("Distances in colour on the surface"), tools);
  colours_->setFocusPolicy(Qt::TabFocus);
  colours_->setChecked(true);
  describe(colours_, colours_->text(), tr("Blue inside of the reference, red outside of it"));
  progress_ = new QProgressBar(tools);
  progress_->setRange(0, 0);  // how long it takes is not known
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("The objects are compared"));
  grid->addWidget(choose_, 0, 0);
  grid->addWidget(again_, 0, 1);
  grid->addWidget(reference_, 1, 0, 1, 2);
  grid->addWidget(buildLabelRow(tools), 2, 0, 1, 2);
  grid->addWidget(labelNote_, 3, 0, 1, 2);
  grid->addWidget(colours_, 4, 0, 1, 2);
  grid->addWidget(progress_, 5, 0, 1, 2);
  grid->addWidget(note_, 6, 0, 1, 2);
  grid->setRowStretch(7, 1);
  grid->addWidget(csv_, 8, 0);
  grid->addWidget(json_, 8, 1);
  grid->addWidget(vtp_, 9, 0, 1, 2);
  return tools;
}

QWidget* ComparePage::buildLabelRow(QWidget* tools) {
  labelRow_ = new QWidget(tools);
  auto* row = new QHBoxLayout(labelRow_);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Label"), labelRow_));
  label_ = new QComboBox(labelRow_);
  label_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  label_->setMinimumContentsLength(kLabelLetters);
  describe(label_, tr("Label of the reference"), tr("Which voxels of a label map are the reference"));
  ignoreWheelWithoutFocus(label_);
  row->addWidget(label_, 1);
  return labelRow_;
}

// --- the reference ---

//! A file at once where there is nothing else to choose.
void ComparePage::choose() {
  const std::vector<int> others = otherObjects();
  if (others.empty()) return chooseFile();
  auto* menu = new QMenu(choose_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  connect(menu->addAction(tr("From a file…")), &QAction::triggered, this, &ComparePage::chooseFile);
  menu->addSeparator();
  for (const int index : others) {
    const ObjectLabel label = document_.objectInfo(index).label;
    QString name = QString::fromStdString(label.name);
    name.replace(QLatin1Char('&'), QLatin1String("&&"));  // no letter to press
    connect(
        menu->addAction(swatch(label.colour), name), &QAction::triggered, this,
        [this, object = document_.objectKey(index)] { compareWithObject(document_.indexOfObject(object)); });
  }
  menu->popup(choose_->mapToGlobal(QPoint(0, choose_->height())));
}

void ComparePage::chooseFile() {
  const QString kinds = tr(
      "Meshes and label maps (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl "
      "*.gipl.gz *.dcm);;All files (*)");
  const QString path = QFileDialog::getOpenFileName(this, tr("Choose the reference"),
                                                    QSettings().value(QStringLiteral("folder")).toString(),
                                                    kinds, nullptr, QFileDialog::HideNameFilterDetails);
  if (!path.isEmpty()) compareWith(path);
}

void ComparePage::compareWith(const QString& path) {
  if (!surfaceOf(document_.activeObject())) return;
  refer(path, {});
  start();
}

void ComparePage::compareWithObject(int index) {
  if (index == document_.activeObject() || !surfaceOf(document_.activeObject()) || !surfaceOf(index)) return;
  refer({}, document_.objectKey(index));
  start();
}

void ComparePage::refer(const QString& path, const ObjectKey& object) {
  path_ = path;
  isLabelMap_ = !path.isEmpty() && !isMeshInputPath(fileName(path));
  object_ = object;
  objectName_.clear();
  knowsLabels_ = false;
  showLabels({});
}

std::optional<MeasuredSurface> ComparePage::surfaceOf(int index) const {
  if (!document_.hasVolume() || index < 0) return std::nullopt;
  auto mesh = document_.finishedMesh(index);
  if (!mesh) return std::nullopt;
  const std::string anonymousName = document_.anonymousNames().at(static_cast<std::size_t>(index));
  return MeasuredSurface{QString::fromStdString(document_.objectInfo(index).label.name), std::move(mesh),
                         QString::fromStdString(anonymousName)};
}

//! That have a surface.
std::vector<int> ComparePage::otherObjects() const {
  std::vector<int> others;
  for (int i = 0; i < document_.objectCount(); ++i)
    if (i != document_.activeObject() && surfaceOf(i)) others.push_back(i);
  return others;
}

// --- comparing ---

//! None: there is no surface, or no reference that could be compared with it now.
std::optional<CompareQuestion> ComparePage::question() const {
  auto surface = surfaceOf(document_.activeObject());
  if (!surface) return std::nullopt;
  CompareQuestion question{std::move(*surface), path_};
  if (const QVariant label = label_->currentData(); isLabelMap_ && label.isValid())
    question.label = label.toInt();
  if (!path_.isEmpty()) return question;
  const int index = document_.indexOfObject(object_);
  if (index != document_.activeObject()) question.object = surfaceOf(index);
  return question.object ? std::optional(std::move(question)) : std::nullopt;
}

void ComparePage::compareOrCancel() {
  if (!isComparing_) return start();
  comparer_.cancel();
  isComparing_ = false;
  showState();
}

void ComparePage::start() {
  std::optional<CompareQuestion> wanted = question();
  if (!wanted) return;
  clear();
  asked_ = *wanted;
  compared_ = document_.snapshot();
  isComparing_ = true;
  ++number_;
  comparer_.compare(std::move(*wanted), knowsLabels_ ? nullptr : onThisThread(&ComparePage::showLabels),
                    onThisThread(&ComparePage::showAnswer));
  showState();
}

//! Shows what the newest job finds, unless it was cancelled.
template <typename Result>
std::function<void(Result)> ComparePage::onThisThread(void (ComparePage::*take)(Result)) {
  return [this, take, number = number_](Result result) {
    QMetaObject::invokeMethod(
        this,
        [this, take, number, result = std::make_shared<Result>(std::move(result))] {
          if (number == number_ && isComparing_) (this->*take)(std::move(*result));
        },
        Qt::QueuedConnection);
  };
}

void ComparePage::showLabels(ReferenceLabels labels) {
  knowsLabels_ = !labels.all.empty();
  labelError_ = labels.error;
  label_->clear();
  label_->addItem(tr("all but 0"));
  for (const NamedLabel& l : labels.all)
    label_->addItem(l.colour ? swatch(*l.colour) : QIcon(), textOf(l), l.value);
  showState();
}

void ComparePage::showAnswer(CompareAnswer answer) {
  isComparing_ = false;
  answer_ = std::move(answer);
  showTable();
  colour();
  showState();
}

//! What was found, not what it was found of.
void ComparePage::clear() {
  comparer_.cancel();
  isComparing_ = false;
  answer_ = {};
  compared_.reset();
  colour();
  showTable();
}

void ComparePage::forget() {
  clear();
  refer({}, {});
}

// --- what is saved ---

std::shared_ptr<const ComparedPair> ComparePage::told() const {
  if (!isAnonymous_) return answer_.pair;
  auto pair = std::make_shared<ComparedPair>(anonymous(*answer_.pair));
  pair->a.path = asked_.surface.anonymousName.toStdString();
  if (asked_.object) pair->b.path = asked_.object->anonymousName.toStdString();
  return pair;
}

//! They name nobody.
void ComparePage::saveDistances() {
  Q_EMIT saveFileRequested(tr("Save the distances"), QStringLiteral(".vtp"),
                           [pair = answer_.pair, distances = answer_.distances](const std::string& path) {
                             writeDistances(*pair, distances, path);
                           });
}

// --- what is shown ---

void ComparePage::colour() {
  const bool any = colours_->isChecked() && compared_ && !answer_.distances.empty() &&
                   answer_.distances.size() == compared_->mesh.points.size();
  if (!any) return state_.setDistances(DistancesOf::comparison, nullptr);
  DistanceColours colours = distanceColours(compared_, answer_.distances, answer_.isSigned);
  state_.setDistances(DistancesOf::comparison, std::make_shared<const DistanceColours>(std::move(colours)));
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
  const bool any = surfaceOf(document_.activeObject()).has_value();
  choose_->setEnabled(any && !isComparing_);
  again_->setEnabled(isComparing_ || question());
  again_->setText(isComparing_ ? tr("Cancel") : tr("Compare"));
  again_->setAccessibleName(again_->text());
  progress_->setVisible(isComparing_);
  for (QPushButton* button : {csv_, json_}) button->setEnabled(answer_.pair != nullptr);
  vtp_->setEnabled(!answer_.distances.empty());
  showReference();
  const QString text = stateText();
  note_->setText(text);
  note_->setVisible(!text.isEmpty());
}

void ComparePage::showReference() {
  if (const int index = document_.indexOfObject(object_); index >= 0)
    objectName_ = QString::fromStdString(document_.objectInfo(index).label.name);
  const QString name = path_.isEmpty() ? objectName_ : QFileInfo(path_).fileName();
  reference_->setText(name.isEmpty()
                          ? tr("No reference is chosen.")
                          : QFontMetrics(font()).elidedText(name, Qt::ElideMiddle, kCompareTools - 10));
  reference_->setToolTip((path_.isEmpty() ? objectName_ : path_).toHtmlEscaped());
  labelRow_->setVisible(isLabelMap_);
  label_->setEnabled(label_->count() > 1);
  labelNote_->setText(labelError_);
  labelNote_->setVisible(!labelError_.isEmpty());
}

//! One of the two is another one now, or gone.
bool ComparePage::isEarlier() const {
  if (compared_ != document_.snapshot()) return true;
  if (!asked_.object) return false;
  const auto now = surfaceOf(document_.indexOfObject(object_));
  return !now || !now->mesh->isOf(*asked_.object->mesh->shown());
}

QString ComparePage::stateText() const {
  if (!surfaceOf(document_.activeObject())) return tr("There is no surface to compare yet: grow one first.");
  if (!answer_.error.isEmpty()) return answer_.error;
  if (isComparing_) return tr("Comparing…");
  if (!answer_.pair) return {};
  if (isEarlier()) return tr("These are figures of an earlier surface, or of another object.");
  return findingSentences(answer_.pair->warnings);
}

}  // namespace handlebody::ui
