#include "ui/window/objects/object_dialog.h"

#include <QColorDialog>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/model/document.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

QColor shown(const Colour& c) { return {c[0], c[1], c[2]}; }

QIcon filled(const Colour& colour) {
  QPixmap pixmap(48, 16);
  pixmap.fill(shown(colour));
  return pixmap;
}

}  // namespace

ObjectDialog::ObjectDialog(Document& document, QWidget* parent)
    : QDialog(parent), document_(document), object_(document.objectKey(document.activeObject())) {
  before_ = document_.objectInfo(document_.activeObject()).label;
  colour_ = before_.colour;
  setWindowTitle(tr("Properties of the object"));
  setAttribute(Qt::WA_DeleteOnClose);
  build();
  connect(name_, &QLineEdit::textChanged, this, &ObjectDialog::showFault);
  connect(value_, &QSpinBox::valueChanged, this, &ObjectDialog::showFault);
  connect(term_, &QComboBox::activated, this, &ObjectDialog::takeTerm);
  connect(colourButton_, &QToolButton::clicked, this, &ObjectDialog::chooseColour);
  connect(buttons_, &QDialogButtonBox::accepted, this, &ObjectDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &ObjectDialog::reject);
  connect(&document_, &Document::objectsChanged, this, &ObjectDialog::followList);
  connect(&document_, &Document::opened, this, &ObjectDialog::reject);
  showFault();
}

void ObjectDialog::build() {
  auto* layout = new QVBoxLayout(this);
  QFormLayout* form = panelForm();
  name_ = new QLineEdit(QString::fromStdString(before_.name), this);
  describe(name_, tr("Name"), tr("What the object is called in the list and in files that hold names"));
  name_->setMinimumWidth(260);
  name_->selectAll();
  form->addRow(tr("&Name"), name_);
  colourButton_ = new QToolButton(this);
  colourButton_->setIconSize(QSize(48, 16));
  colourButton_->setIcon(filled(colour_));
  describe(colourButton_, tr("Colour"), tr("Of its surface and outlines, and in files that hold colours"));
  form->addRow(tr("&Colour"), colourButton_);
  term_ = new QComboBox(this);
  offerTerms();
  describe(term_, tr("Term"), tr("What it is, as a code of SNOMED CT; gives the colour, too"));
  form->addRow(tr("&Term"), term_);
  value_ = new QSpinBox(this);
  value_->setRange(1, kLargestLabel);
  value_->setValue(before_.value);
  describe(value_, tr("Label value"), tr("Of its voxels in a label map"));
  form->addRow(tr("&Label value"), value_);
  layout->addLayout(form);
  fault_ = notice(tr("What is wrong"), this);
  QSizePolicy keeps = fault_->sizePolicy();
  keeps.setRetainSizeWhenHidden(true);  // nothing jumps
  fault_->setSizePolicy(keeps);
  layout->addWidget(fault_);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  layout->addWidget(buttons_);
}

//! What the object's file says of it comes first, without a name of our list.
void ObjectDialog::offerTerms() {
  const auto& said = before_.source.terminology;
  if (said) term_->addItem(QString::fromStdString(meaningOf(*said)), QString());
  for (const Term& term : terms())
    term_->addItem(QString::fromStdString(term.type.meaning), QString::fromStdString(term.name));
  term_->setCurrentIndex(said ? 0 : term_->findData(QString::fromStdString(before_.term)));
}

ObjectLabel ObjectDialog::label() const {
  ObjectLabel label = before_;
  label.name = name_->text().toStdString();
  label.colour = colour_;
  label.value = value_->value();
  if (const std::string term = term_->currentData().toString().toStdString(); !term.empty()) {
    label.term = term;
    label.source.terminology.reset();
  }
  return label;
}

//! A name that was made up gives way to what the object is.
void ObjectDialog::takeTerm() {
  const Term* term = termFromName(term_->currentData().toString().toStdString());
  colour_ = term ? term->colour : before_.colour;
  colourButton_->setIcon(filled(colour_));
  if (!term) return;  // what its file says is taken up again, and its name stays
  const bool isMadeUp = name_->text().startsWith(tr("Object"));
  if (isMadeUp || terminologyOf(before_).type.term.meaning == name_->text().toStdString())
    name_->setText(QString::fromStdString(term->type.meaning));
}

//! Waits for no answer: this dialog may be closed meanwhile.
void ObjectDialog::chooseColour() {
  auto* dialog = new QColorDialog(shown(colour_), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Colour of the object"));
  connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& chosen) {
    colour_ = {static_cast<std::uint8_t>(chosen.red()), static_cast<std::uint8_t>(chosen.green()),
               static_cast<std::uint8_t>(chosen.blue())};
    colourButton_->setIcon(filled(colour_));
  });
  dialog->open();
}

//! What takes its time changes the list while this is open.
void ObjectDialog::followList() { document_.indexOfObject(object_) < 0 ? reject() : showFault(); }

//! Precondition: the object is in the list.
void ObjectDialog::showFault() {
  const QString fault = document_.objectLabelFault(document_.indexOfObject(object_), label());
  fault_->setText(fault);
  fault_->setVisible(!fault.isEmpty());
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(fault.isEmpty());
  const int needed = layout()->totalHeightForWidth(width());
  if (needed > height()) resize(width(), needed);  // it stays so large: nothing jumps back
}

void ObjectDialog::accept() {
  const int index = document_.indexOfObject(object_);
  if (index < 0) return reject();
  if (document_.objectLabelFault(index, label()).isEmpty())
    document_.setObjectLabel(index, label(), tr("Change object"));
  QDialog::accept();
}

}  // namespace handlebody::ui
