#pragma once
// A spin box for one end of a range of intensities, which may be open.

#include "ui/window/widgets/decimal_field.h"

namespace handlebody::ui {

class IntensityField : public DecimalField {
  Q_OBJECT

 public:
  explicit IntensityField(QWidget* parent = nullptr);

  //! The end, infinite if it is open.
  double end() const;
  void setEnd(double end);
  //! For intensities of this width, from the least to the largest: decimals and steps that are fine in it.
  void setScale(double width);
  //! While it is not known, a dash is shown.
  void setKnown(bool known);

 protected:
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;

 private:
  bool known_ = false;
};

}  // namespace handlebody::ui
