#include "ui/window/open/open_objects_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "core/io/meshes/mesh_io.h"
#include "ui/model/file_name.h"
#include "ui/window/open/label_choice.h"
#include "ui/window/widgets/decimal_field.h"
#include "ui/window/widgets/in_background.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kWidth = 520, kNameWidth = 400;             // pixels; lines of some 80 letters
constexpr double kUsualLength = 1, kLongestLength = 100;  // mm
constexpr int kMaxTunnels = 999;

}  // namespace

OpenObjectsDialog::OpenObjectsDialog(const QString& path, QWidget* parent)
    : QDialog(parent), path_(path), isMesh_(isMeshInputPath(fileName(path))) {
  setWindowTitle(tr("Open objects"));
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(kWidth);
  auto* layout = new QVBoxLayout(this);
  buildQuestion(layout);
  if (!isMesh_) {
    buildLabels(layout);
    buildShape(layout);
  }
  buildAnswers(layout);
  enableAnswers();
  (isMesh_ ? static_cast<QWidget*>(done_) : smoothing_)->setFocus();
  if (!isMesh_) readLabels();
}

void OpenObjectsDialog::buildQuestion(QVBoxLayout* all) {
  const QString name = QFileInfo(path_).fileName();
  QLabel* question = heading({}, this);
  question->setTextFormat(Qt::PlainText);
  question->setWordWrap(true);
  question->setText(tr("What are the surfaces of “%1”?")
                        .arg(question->fontMetrics().elidedText(name, Qt::ElideMiddle, kNameWidth)));
  question->setToolTip(QStringLiteral("<p>%1</p>").arg(name.toHtmlEscaped()));
  all->addWidget(question);
  all->addWidget(hint(tr("Objects that are done stay as they are: locked, written with the others, and walls "
                         "for objects that grow after them.\n\nOthers are where objects begin: they grow "
                         "from there onto the image, or give ground."),
                      this));
}

void OpenObjectsDialog::buildLabels(QVBoxLayout* all) {
  pages_ = new QStackedWidget(this);
  auto* reading = new QWidget(pages_);
  auto* column = new QVBoxLayout(reading);
  auto* text = new QLabel(tr("Reading the labels…"), reading);
  auto* bar = new QProgressBar(reading);
  bar->setRange(0, 0);  // how long it takes is not known
  bar->setAccessibleName(text->text());
  column->addStretch();
  column->addWidget(text);
  column->addWidget(bar);
  column->addStretch();
  pages_->addWidget(reading);
  labels_ = new LabelChoice(pages_);
  pages_->addWidget(labels_);
  all->addWidget(pages_, 1);
  overlap_ = notice(tr("Segments that overlap"), this);
  overlap_->setText(
      tr("Segments may overlap here: voxels that several of those that are opened hold are left "
         "to the smallest of them."));
  overlap_->hide();
  all->addWidget(overlap_);
  connect(labels_, &LabelChoice::changed, this, &OpenObjectsDialog::enableAnswers);
}

void OpenObjectsDialog::buildShape(QVBoxLayout* all) {
  all->addWidget(heading(tr("How the surfaces are made"), this));
  all->addLayout(smoothingRow());
  all->addLayout(tunnelsRow());
  largest_ = new QCheckBox(tr("Only the largest &part"), this);
  describe(largest_, tr("Only the largest part"),
           tr("Of each label only the part with the most voxels: those that share a side"));
  all->addWidget(largest_);
}

QHBoxLayout* OpenObjectsDialog::smoothingRow() {
  auto* row = new QHBoxLayout;
  auto* label = new QLabel(tr("&Smoothing"), this);
  smoothing_ = new QComboBox(this);
  smoothing_->addItems({tr("A voxel along each axis"), tr("A length"), tr("None")});
  describe(smoothing_, tr("Smoothing"),
           tr("How far the steps between the voxels are smoothed, as a standard deviation. None: the surface "
              "goes midway between the voxels, steps and all."));
  label->setBuddy(smoothing_);
  length_ = new DecimalField(this);
  length_->setRange(0, kLongestLength);
  length_->setDecimals(2);
  length_->setSingleStep(0.5);
  length_->setValue(kUsualLength);
  length_->setSuffix(tr(" mm"));
  length_->setEnabled(false);
  describe(length_, tr("Length of the smoothing"), tr("Standard deviation; 0: none, steps and all"));
  connect(smoothing_, &QComboBox::currentIndexChanged, length_,
          [this](int chosen) { length_->setEnabled(chosen == kByLength); });
  row->addWidget(label);
  row->addWidget(smoothing_, 1);
  row->addWidget(length_);
  return row;
}

QHBoxLayout* OpenObjectsDialog::tunnelsRow() {
  auto* row = new QHBoxLayout;
  limitsTunnels_ = new QCheckBox(tr("No more &tunnels than"), this);
  describe(limitsTunnels_, tr("No more tunnels than"),
           tr("In each surface, all of its parts together: tunnels are filled, or what goes around them is "
              "cut, whichever changes the fewest voxels"));
  tunnels_ = new QSpinBox(this);
  tunnels_->setRange(0, kMaxTunnels);
  tunnels_->setEnabled(false);
  describe(tunnels_, tr("Tunnels at most"), tr("Tunnels, as in a ring"));
  connect(limitsTunnels_, &QCheckBox::toggled, tunnels_, &QWidget::setEnabled);
  row->addWidget(limitsTunnels_);
  row->addWidget(tunnels_);
  row->addStretch();
  return row;
}

void OpenObjectsDialog::buildAnswers(QVBoxLayout* all) {
  auto* buttons = new QDialogButtonBox(this);
  done_ = answerButton(tr("&Done"), OpenAs::done);
  start_ = answerButton(tr("To &grow from"), OpenAs::start);
  buttons->addButton(done_, QDialogButtonBox::AcceptRole);
  buttons->addButton(start_, QDialogButtonBox::AcceptRole);
  buttons->addButton(QDialogButtonBox::Cancel);
  done_->setDefault(true);
  connect(buttons, &QDialogButtonBox::rejected, this, &OpenObjectsDialog::reject);
  all->addWidget(buttons);
}

QPushButton* OpenObjectsDialog::answerButton(const QString& text, OpenAs as) {
  auto* button = new QPushButton(text, this);
  connect(button, &QPushButton::clicked, this, [this, as] { answer(as); });
  return button;
}

void OpenObjectsDialog::readLabels() {
  inBackground(
      this, [path = path_, stop = cancelled_] { return labelsToOpen(path, *stop); },
      [this](const LabelsToOpen& found) {
        if (!*cancelled_) take(found);
      });
}

void OpenObjectsDialog::take(const LabelsToOpen& found) {
  if (!found.error.isEmpty()) {
    reject();
    Q_EMIT failed(found.error);
    return;
  }
  labels_->offer(found.labels);
  pages_->setCurrentWidget(labels_);
  overlap_->setVisible(found.mayOverlap);
  if (focusWidget() == smoothing_) labels_->setFocus();  // where it was left
  growToFit();
  enableAnswers();
}

void OpenObjectsDialog::enableAnswers() {
  const bool hasSome = isMesh_ || !labels_->checked().empty();
  done_->setEnabled(hasSome);
  start_->setEnabled(hasSome);
}

void OpenObjectsDialog::growToFit() {
  layout()->activate();
  const int needed = layout()->totalHeightForWidth(width());
  if (needed > height()) resize(width(), needed);
}

//! It is over before anybody hears of it, so that what they show does not lie below.
void OpenObjectsDialog::answer(OpenAs as) {
  const ObjectsToOpen asked{path_, as, isMesh_ ? std::vector<int>() : labels_->checked(), shape()};
  accept();
  Q_EMIT chosen(asked);
}

LabelShape OpenObjectsDialog::shape() const {
  LabelShape shape;
  if (isMesh_) return shape;
  if (smoothing_->currentIndex() == kByLength) shape.smoothing = length_->value();
  if (smoothing_->currentIndex() == kNone) shape.smoothing = 0;
  if (limitsTunnels_->isChecked()) shape.genus = tunnels_->value();
  shape.keepsLargest = largest_->isChecked();
  return shape;
}

//! Whatever is still read is not wanted any more.
void OpenObjectsDialog::done(int result) {
  *cancelled_ = true;
  QDialog::done(result);
}

}  // namespace handlebody::ui
