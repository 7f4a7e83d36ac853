#pragma once
// Name, colour, label value and term of an object.

#include <QDialog>
#include <memory>

#include "core/io/meshes/exported_object.h"

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QSpinBox;
class QToolButton;

namespace handlebody::ui {

class Document;

class ObjectDialog : public QDialog {
  Q_OBJECT

 public:
  //! Of the object that is active now, which is changed when the dialog is accepted, wherever it stands by
  //! then. Closes when it is gone, or another volume was opened.
  explicit ObjectDialog(Document& document, QWidget* parent = nullptr);

  void accept() override;

 private:
  void build();
  void offerTerms();
  void takeTerm();
  void chooseColour();
  void followList();
  void showFault();
  ObjectLabel label() const;

  Document& document_;
  const std::weak_ptr<const void> object_;  // its key
  ObjectLabel before_;
  Colour colour_;
  QLineEdit* name_;
  QToolButton* colourButton_;
  QComboBox* term_;
  QSpinBox* value_;
  QLabel* fault_;
  QDialogButtonBox* buttons_;
};

}  // namespace handlebody::ui
