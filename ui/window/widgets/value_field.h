#pragma once
// One number of the panels: with its unit, the automatic value if there is one, and a way back to it.

#include <QString>
#include <QWidget>
#include <optional>

#include "core/volume/volume.h"
#include "ui/window/widgets/decimal_field.h"

class QToolButton;

namespace handlebody::ui {

//! What a ValueField asks for.
struct ValueSpec {
  QString name;  //!< as the label beside it says, for screen readers
  QString unit;  //!< behind the number; may be empty
  QString tip;
  double low = 0, high = 1, step = 0.1;
  int decimals = 2;
  std::optional<double> fallback{};  //!< what reset goes back to; none: the value may be automatic
};

//! A number that shows a dash while it is not known.
class NumberField : public DecimalField {
  Q_OBJECT

 public:
  using DecimalField::DecimalField;

  //! `unit` is written behind the number, not behind the dash.
  void setKnown(bool known, const QString& unit);
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;

 private:
  bool known_ = false;
};

class ValueField : public QWidget {
  Q_OBJECT

 public:
  explicit ValueField(const ValueSpec& spec, QWidget* parent = nullptr);

  //! Of a length: with as many decimals as the voxels need, up to `high` mm; from nothing, or from the least
  //! that shows.
  void setLengths(const Grid& grid, bool fromZero, double high);
  //! Shows the value asked for, or where it is left open the one that was worked out; a dash where neither is
  //! known.
  void show(std::optional<double> value, std::optional<double> automatic = std::nullopt);

 Q_SIGNALS:
  //! The user wants another value; none: the automatic one. Changes that follow each other within a second
  //! carry the same gesture, so that they are undone together.
  void edited(std::optional<double> value, int gesture);

 private:
  void edit(std::optional<double> value);

  ValueSpec spec_;
  NumberField* number_;
  QToolButton* reset_;
};

//! A number for one gesture of the user: the same as that of the last call for `owner` if it was less than a
//! second ago.
int gestureOf(const QObject* owner);
//! The next call begins another one.
void endGesture();

}  // namespace handlebody::ui
