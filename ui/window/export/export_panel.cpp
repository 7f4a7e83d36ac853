#include "ui/window/export/export_panel.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpressionValidator>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/io/meshes/three_mf.h"
#include "core/io/tetrahedra/tetrahedra.h"
#include "ui/model/document.h"
#include "ui/window/commands.h"
#include "ui/window/widgets/action_button.h"
#include "ui/window/widgets/choice_row.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

const QString kCreator = QStringLiteral("creator");

QString writing(const QString& path) {
  return ExportPanel::tr("Writing %1…").arg(QFileInfo(path).fileName());
}

}  // namespace

ExportPanel::ExportPanel(Document& document, const Commands& commands, QWidget* parent)
    : QWidget(parent), document_(document) {
  panelLayout(this);
  buildResult(commands);
  buildRest(commands);
  static_cast<QVBoxLayout*>(layout())->addStretch();
  connect(&document_, &Document::snapshotChanged, this, &ExportPanel::showWhatIsWritten);
  connect(&document_, &Document::stateChanged, this, &ExportPanel::showWhatIsWritten);
  for (auto changed : {&Document::objectsChanged, &Document::opened})
    connect(&document_, changed, this, &ExportPanel::showWhatIsWritten);
  for (QComboBox* field : {objects_, format_})
    connect(field, &QComboBox::currentIndexChanged, this, [this] {
      failed_.clear();
      showWhatIsWritten();
    });
  connect(objects_, &QComboBox::currentIndexChanged, this, &ExportPanel::whichChanged);
  connectProgress();
  showWhatIsWritten();
}

void ExportPanel::buildResult(const Commands& commands) {
  layout()->addWidget(heading(tr("Surface or label map"), this));
  hint_ = hint(tr("Nothing has grown yet. Place a seed and start the growth first."), this);
  layout()->addWidget(hint_);
  form_ = panelForm();
  objects_ = new QComboBox(this);
  objects_->addItem(tr("All objects in one file"), QVariant::fromValue(Objects::together));
  objects_->addItem(tr("Each object in a file of its own"), QVariant::fromValue(Objects::each));
  objects_->addItem(tr("The active object"), QVariant::fromValue(Objects::active));
  describe(objects_, tr("Objects"),
           tr("What a file holds: names and colours stay apart where it can; to the name of a file of one "
              "object its name is added"));
  ignoreWheelWithoutFocus(objects_);
  form_->addRow(tr("Objects"), objects_);
  format_ = new QComboBox(this);
  addFormats();
  describe(format_, tr("Format"), tr("A surface keeps all detail; a label map has the voxels of the volume"));
  ignoreWheelWithoutFocus(format_);
  form_->addRow(tr("Format"), format_);
  spaceRow_ = choiceRow(tr("Coordinates"), {tr("LPS"), tr("RAS")},
                        {tr("x to the patient's left, y to the back, as in DICOM and ITK"),
                         tr("x to the patient's right, y to the front, as in NIfTI and 3D Slicer")},
                        space_, this);
  space_->button(0)->setChecked(true);
  form_->addRow(tr("Coordinates"), spaceRow_);
  addContent();
  static_cast<QVBoxLayout*>(layout())->addLayout(form_);
  addPolish();
  addAnonymous();
  fault_ = notice(tr("Why nothing is written"), this);
  layout()->addWidget(fault_);
  numbers_ = value(tr("What is written"), this);
  layout()->addWidget(numbers_);
  layout()->addWidget(new ActionButton(commands[Command::exportResult], this));
  progress_ = buildProgress();
  layout()->addWidget(progress_);
  polished_ = value(tr("What was bettered"), this);
  polished_->hide();
  layout()->addWidget(polished_);
  layout()->addWidget(new ActionButton(commands[Command::showMeasures], this));
}

void ExportPanel::addFormats() {
  const auto add = [this](const QString& text, const char* ending) {
    format_->addItem(text, QString::fromLatin1(ending));
  };
  add(tr("STL surface, binary"), ".stl");
  add(tr("VTP surface (VTK)"), ".vtp");
  add(tr("PLY surface, binary"), ".ply");
  add(tr("OBJ surface"), ".obj");
  add(tr("3MF surface, to print"), ".3mf");
  add(tr("glTF scene, to view"), ".gltf");
  format_->insertSeparator(format_->count());
  add(tr("NIfTI label map"), ".nii.gz");
  add(tr("NRRD label map"), ".nrrd");
  add(tr("MetaImage label map"), ".mha");
  add(tr("3D Slicer segmentation"), ".seg.nrrd");
  add(tr("ITK-SNAP label description"), ".label");
  format_->insertSeparator(format_->count());
  add(tr("DICOM segmentation"), ".seg.dcm");
  add(tr("DICOM with STL surface"), ".stl.dcm");
  format_->insertSeparator(format_->count());
  add(tr("Gmsh tetrahedra"), ".msh");
  add(tr("VTK tetrahedra"), ".vtu");
  add(tr("Abaqus tetrahedra"), ".inp");
}

//! What no image knows. The creator is the same for every file until it is changed; nobody is named at first.
void ExportPanel::addContent() {
  constexpr int kLongest = 64;  // characters of a DICOM field, which has no backslash, either
  const auto add = [this](const QString& label, const QString& tip) {
    auto* field = new QLineEdit(this);
    field->setMaxLength(kLongest);
    field->setValidator(
        new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[^\\\\]*")), field));
    describe(field, label, tip);
    form_->addRow(label, field);
    return field;
  };
  creator_ = add(tr("Creator"), tr("Who made it, as DICOM writes names: Family^Given. May stay empty"));
  description_ = add(tr("Description"), tr("What it is for. May stay empty"));
  creator_->setText(QSettings().value(kCreator).toString());
  connect(creator_, &QLineEdit::editingFinished, this,
          [this] { QSettings().setValue(kCreator, creator_->text().trimmed()); });
}

//! On at first: a surface that a solver takes is a better surface for all others, too, and the same one that
//! the command line writes.
void ExportPanel::addPolish() {
  polish_ = new QCheckBox(tr("Better thin triangles"), this);
  polish_->setFocusPolicy(Qt::TabFocus);
  describe(
      polish_, tr("Better thin triangles"),
      tr("Triangles with an angle under 15° and edges sharper than 20°, which a solver cannot use, are made "
         "better in what is written; the surface goes no farther than a tenth of a voxel. The session "
         "keeps this choice."));
  layout()->addWidget(polish_);
  connect(polish_, &QCheckBox::clicked, &document_, &Document::setPolishes);
  for (auto changed : {&Document::polishesChanged, &Document::opened})
    connect(&document_, changed, this, &ExportPanel::showManner);
  showManner();
}

void ExportPanel::showManner() {
  polish_->setChecked(document_.polishes());
  space_->button(document_.space() == CoordinateSpace::ras ? 1 : 0)->setChecked(true);
}

void ExportPanel::addAnonymous() {
  anonymous_ = new QCheckBox(tr("Without what names the patient"), this);
  anonymous_->setFocusPolicy(Qt::TabFocus);
  describe(
      anonymous_, tr("Without what names the patient"),
      tr("DICOM files, report and measures are written without patient, study, dates and names of files, "
         "and the names that are suggested do not tell the volume's. In place of saving the session one "
         "is exported that does not say where its volume is: it asks for it when it is opened."));
  layout()->addWidget(anonymous_);
  connect(anonymous_, &QCheckBox::toggled, this, &ExportPanel::anonymousChanged);
}

//! Shown while a file is written.
QWidget* ExportPanel::buildProgress() {
  auto* part = new QWidget(this);
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  writing_ = value(tr("What is being written"), part);
  column->addWidget(writing_);
  auto* row = new QHBoxLayout;
  auto* bar = new QProgressBar(part);
  bar->setRange(0, 0);  // how long it takes is not known
  bar->setTextVisible(false);
  bar->setAccessibleName(tr("A file is being written"));
  row->addWidget(bar, 1);
  auto* cancel = new QPushButton(tr("Cancel"), part);
  cancel->setFocusPolicy(Qt::TabFocus);
  describe(cancel, tr("Cancel writing"), tr("Nothing is left of the file, nor of those that wait"));
  row->addWidget(cancel);
  column->addLayout(row);
  connect(cancel, &QPushButton::clicked, &document_, &Document::cancelExport);
  part->hide();
  return part;
}

void ExportPanel::connectProgress() {
  connect(&document_, &Document::exporting, this, &ExportPanel::begin);
  connect(&document_, &Document::exportPolishes, this, [this](const QString& object) {
    showWork(document_.objectCount() > 1 ? tr("Bettering the triangles of “%1”…").arg(object)
                                         : tr("Bettering the triangles…"));
  });
  connect(&document_, &Document::polished, this, [this](const QString& text) {
    polished_->setText(text);
    polished_->show();
  });
  connect(&document_, &Document::opened, this, [this] {  // both were of what was open
    polished_->hide();
    failed_.clear();
    showFault();
  });
  const auto fail = [this](const QString& why) {
    failed_ = why;
    end();
  };
  connect(&document_, &Document::exported, this, &ExportPanel::end);
  connect(&document_, &Document::exportCancelled, this,
          [fail] { fail(tr("It was cancelled: nothing was written.")); });
  connect(&document_, &Document::exportFailed, this, fail);
  connect(&document_, &Document::exportRefused, this, [this](const QString& why) {
    failed_ = why;  // what is being written goes on
    showFault();
  });
}

//! What went wrong with those before it is read as long as one of them is under way.
void ExportPanel::begin(const QString& path) {
  if (underWay_.isEmpty()) {
    failed_.clear();
    polished_->hide();
  }
  underWay_ << path;
  showWork(underWay_.size() > 1 ? work_ : writing(path));
  showFault();
}

//! They are written in the order in which they began: it is the first that has ended.
void ExportPanel::end() {
  if (!underWay_.isEmpty()) underWay_.removeFirst();
  showWork(underWay_.isEmpty() ? QString() : writing(underWay_.front()));
  showFault();
}

//! Of the first of the files; how many come after it is said, too.
void ExportPanel::showWork(const QString& work) {
  work_ = work;
  const auto waiting = underWay_.size() - 1;
  writing_->setText(waiting > 0 ? work + QLatin1Char(' ') + tr("Waiting: %1.").arg(waiting) : work);
  progress_->setVisible(waiting >= 0);
}

//! What speaks against the format, or what went wrong.
void ExportPanel::showFault() {
  const QString why = document_.exportFault(extension());
  const QString text = why.isEmpty() ? failed_ : why;
  fault_->setText(text);
  fault_->setVisible(!text.isEmpty());
}

void ExportPanel::buildRest(const Commands& commands) {
  layout()->addWidget(heading(tr("Picture"), this));
  picture_ = new QComboBox(this);
  picture_->addItem(tr("All four views"), -1);
  for (Cell cell : kCells) picture_->addItem(tr("%1 view").arg(cellName(cell)), static_cast<int>(cell));
  describe(picture_, tr("Picture of"), tr("Which view is written as PNG"));
  ignoreWheelWithoutFocus(picture_);
  layout()->addWidget(picture_);
  layout()->addWidget(new ActionButton(commands[Command::exportPicture], this));
  layout()->addWidget(heading(tr("Report and session"), this));
  layout()->addWidget(
      hint(tr("The report holds every parameter, number and event. A session opens here again, and "
              "“handlebody-cli replay” makes the same mesh of it."),
           this));
  layout()->addWidget(new ActionButton(commands[Command::exportReport], this));
  addSession(commands);
}

//! One that is saved has to say where its volume is: where nothing is to name the patient the other is
//! offered.
void ExportPanel::addSession(const Commands& commands) {
  auto* save = new ActionButton(commands[Command::saveSession], this);
  auto* anonymous = new ActionButton(commands[Command::exportAnonymousSession], this);
  anonymous->hide();
  for (QWidget* button : {save, anonymous}) layout()->addWidget(button);
  connect(anonymous_, &QCheckBox::toggled, save, &QWidget::setHidden);
  connect(anonymous_, &QCheckBox::toggled, anonymous, &QWidget::setVisible);
}

QString ExportPanel::extension() const { return format_->currentData().toString(); }

CoordinateSpace ExportPanel::space() const {
  return space_->checkedId() == 1 ? CoordinateSpace::ras : CoordinateSpace::lps;
}

bool ExportPanel::isAnonymous() const { return anonymous_->isChecked(); }

DicomContent ExportPanel::content() const {
  return {creator_->text().trimmed().toStdString(), description_->text().trimmed().toStdString(),
          isAnonymous()};
}

ExportPanel::Objects ExportPanel::which() const {
  return document_.objectCount() > 1 ? objects_->currentData().value<Objects>() : Objects::active;
}

std::optional<Cell> ExportPanel::pictureOf() const {
  const int cell = picture_->currentData().toInt();
  return cell < 0 ? std::nullopt : std::optional(static_cast<Cell>(cell));
}

//! How many there are, what they hold together, and what stands in the way.
void ExportPanel::showAllObjects() {
  int count = 0;
  double volume = 0;
  QStringList without, old;
  for (int i = 0; i < document_.objectCount(); ++i) {
    const ObjectInfo info = document_.objectInfo(i);
    const QString name = QString::fromStdString(info.label.name);
    if (!info.snapshot || info.snapshot->mesh.triangles.empty()) {
      without << name;
      continue;
    }
    ++count;
    volume += info.snapshot->certificate.volume;
    if (!info.madeWithEarlier.isEmpty()) old << name;
  }
  hint_->setVisible(count == 0);
  numbers_->setVisible(count > 0);
  QString text = tr("Objects: %1; %2 together.").arg(QString::number(count), millilitres(volume));
  if (!without.isEmpty()) text += QLatin1Char(' ') + tr("Without a surface: %1.").arg(without.join(tr(", ")));
  if (!old.isEmpty())
    text +=
        QLatin1Char(' ') +
        tr("Made with earlier surfaces: %1. Nothing is written if any of them meet.").arg(old.join(tr(", ")));
  if (const QString grows = document_.allFault(); !grows.isEmpty()) text += QLatin1Char(' ') + grows;
  numbers_->setText(text);
}

void ExportPanel::showWhatIsWritten() {
  const std::string example = QStringLiteral("x").append(extension()).toStdString();
  spaceRow_->setEnabled(isMeshPath(example) || isThreeMfPath(example) || isTetrahedraPath(example));
  const bool isDicom = isDicomSegmentationPath(example) || isDicomStlPath(example);
  form_->setRowVisible(description_, isDicom);
  // An Encapsulated STL has no place for it.
  form_->setRowVisible(creator_, isDicomSegmentationPath(example));
  showFault();
  form_->setRowVisible(objects_, document_.objectCount() > 1);
  if (which() != Objects::active) return showAllObjects();
  const auto snapshot = document_.snapshot();
  hint_->setVisible(!snapshot);
  numbers_->setVisible(snapshot != nullptr);
  if (!snapshot) return;
  if (snapshot->mesh.triangles.empty())
    return numbers_->setText(tr("Nothing is left of the surface at this iteration."));
  numbers_->setText(tr("Iteration %1: %2, %3")
                        .arg(QString::number(snapshot->iteration), millilitres(snapshot->certificate.volume),
                             squareCentimetres(snapshot->certificate.area)));
}

}  // namespace handlebody::ui
