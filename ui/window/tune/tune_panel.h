#pragma once
// Step 3: what belongs to the object, and the forces on the surface.

#include <QWidget>
#include <functional>

#include "core/evolution/parameters.h"

class QButtonGroup;
class QCheckBox;
class QFormLayout;
class QLabel;
class QTimer;
class QToolButton;

namespace handlebody::ui {

class Document;
class HistogramView;
class IntensityField;
struct Histogram;
class ValueField;
struct ValueSpec;
class ViewState;

class TunePanel : public QWidget {
  Q_OBJECT

 public:
  TunePanel(Document& document, ViewState& state, QWidget* parent = nullptr);

 private:
  using Change = std::function<void(Parameters&)>;
  QWidget* buildObject();
  QWidget* buildRange();
  QWidget* buildForces();
  QWidget* buildExpert();
  IntensityField* rangeEnd(const QString& name, bool low);
  ValueField* addField(QFormLayout* form, const ValueSpec& spec, const QString& undoText,
                       std::function<void(Parameters&, std::optional<double>)> set);
  void apply(const QString& undoText, int gesture, const Change& change);
  void setRange(const IntensityRange& range, int gesture);
  std::optional<IntensityRange> shownRange() const;
  void tintForAWhile();
  void updateTint();
  void boundLengths();
  void countIntensities();
  void showHistogram(const Histogram& histogram, double width);
  void show();
  void showRange();

  Document& document_;
  ViewState& state_;
  QLabel *hint_, *error_;
  QWidget* body_;
  HistogramView* histogram_;
  QButtonGroup *object_, *direction_, *resolution_, *broadPhase_;
  IntensityField *low_, *high_;
  QToolButton* automaticRange_;
  QCheckBox* keepTint_;
  QTimer* tintEnds_;
  int opened_ = 0;  //!< number of the volume whose intensities are counted
  ValueField *smoothing_, *edgeLength_, *balloon_, *curvature_, *maxIterations_;
};

}  // namespace handlebody::ui
