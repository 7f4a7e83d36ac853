#pragma once
// The spin box of all numbers with decimals.

#include <QDoubleSpinBox>

namespace handlebody::ui {

//! Takes "." and "," as the decimal point, whatever the locale: its own is written in their place. Qt would
//! take the other one as a group separator, and "0.5" for 5 where it is ",". Groups are neither shown nor
//! read.
class DecimalField : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;

  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;

 private:
  QString withOwnPoint(const QString& text) const;
  bool isNumber(const QString& text) const;
};

}  // namespace handlebody::ui
