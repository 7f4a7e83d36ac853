#include "ui/window/tune/tune_panel.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "core/evolution/parameter_limits.h"
#include "ui/model/document.h"
#include "ui/model/time_series.h"
#include "ui/view/view_state.h"
#include "ui/window/tune/histogram_view.h"
#include "ui/window/tune/intensity_field.h"
#include "ui/window/tune/tune_specs.h"
#include "ui/window/widgets/choice_row.h"
#include "ui/window/widgets/in_background.h"
#include "ui/window/widgets/panel_tools.h"
#include "ui/window/widgets/toggle_button.h"
#include "ui/window/widgets/value_field.h"

namespace handlebody::ui {

namespace {

constexpr std::array kResolutions{Resolution::automatic, Resolution::uniform, Resolution::adaptive};
constexpr int kTintStays = 2500;  // ms after the last change

}  // namespace

TunePanel::TunePanel(Document& document, ViewState& state, QWidget* parent)
    : QWidget(parent),
      document_(document),
      state_(state),
      body_(new QWidget(this)),
      tintEnds_(new QTimer(this)) {
  auto* layout = panelLayout(this);
  hint_ = hint(QString(), this);
  layout->addWidget(hint_);
  error_ = value(tr("What is wrong with the parameters"), this);
  layout->addWidget(error_);
  auto* column = new QVBoxLayout(body_);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(buildObject());
  column->addWidget(buildRange());
  column->addWidget(buildForces());
  column->addWidget(buildExpert());
  layout->addWidget(body_);
  layout->addStretch();

  tintEnds_->setSingleShot(true);
  tintEnds_->setInterval(kTintStays);
  connect(tintEnds_, &QTimer::timeout, this, &TunePanel::updateTint);
  connect(&document_, &Document::opened, this, &TunePanel::countIntensities);
  connect(&document_, &Document::opened, this, &TunePanel::boundLengths);
  connect(&document_, &Document::frameShown, this, &TunePanel::updateTint);
  connect(&document_, &Document::activeObjectChanged, histogram_, &HistogramView::endDrag);
  for (auto changed :
       {&Document::opened, &Document::parametersChanged, &Document::resolvedChanged, &Document::seedsChanged})
    connect(&document_, changed, this, &TunePanel::show);
  show();
}

QWidget* TunePanel::buildObject() {
  auto* part = new QWidget(body_);
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Object"), part));
  layout->addWidget(choiceRow(
      tr("Object"), {tr("Dark"), tr("Bright"), tr("Auto")},
      {tr("The object is darker than its surroundings"), tr("The object is brighter than its surroundings"),
       tr("Found out from the image around the seeds")},
      object_, part));
  connect(object_, &QButtonGroup::idClicked, this, [this](int id) {
    constexpr ObjectKind kinds[] = {ObjectKind::dark, ObjectKind::bright, ObjectKind::automatic};
    apply(tr("Change object"), -1, [&](Parameters& p) {
      p.object = kinds[id];
      p.range.reset();
    });
    tintForAWhile();
  });
  return part;
}

IntensityField* TunePanel::rangeEnd(const QString& name, bool low) {
  auto* field = new IntensityField(body_);
  field->setMinimumWidth(70);
  describe(field, name, tr("Intensities from the lower to the upper end belong to the object"));
  ignoreWheelWithoutFocus(field);
  connect(field, &QDoubleSpinBox::valueChanged, this, [this, low, field] {
    if (!shownRange()) return;
    IntensityRange range = *shownRange();
    (low ? range.low : range.high) = field->end();
    if (range.low <= range.high) setRange(range, gestureOf(low ? low_ : high_));
    showRange();
  });
  return field;
}

QWidget* TunePanel::buildRange() {
  auto* part = new QWidget(body_);
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Intensities of the object"), part));
  histogram_ = new HistogramView(part);
  layout->addWidget(histogram_);
  low_ = rangeEnd(tr("Lowest intensity of the object"), true);
  high_ = rangeEnd(tr("Highest intensity of the object"), false);
  automaticRange_ = new ToggleButton(tr("Auto"), part);
  describe(automaticRange_, tr("Range: automatic"), tr("Chosen from the image around the seeds"));
  auto* row = new QHBoxLayout;
  row->addWidget(low_, 1);
  row->addWidget(new QLabel(tr("to"), part));
  row->addWidget(high_, 1);
  row->addWidget(automaticRange_);
  layout->addLayout(row);
  keepTint_ = new QCheckBox(tr("Tint the object in the slices"), part);
  keepTint_->setToolTip(
      tr("The voxels that the surface is driven into: as smoothed, up to necks that are cut and to walls. "
         "They are tinted for a moment after every change; with this on, all the time"));
  keepTint_->setFocusPolicy(Qt::TabFocus);
  layout->addWidget(keepTint_);
  connect(histogram_, &HistogramView::rangeEdited, this, &TunePanel::setRange);
  connect(keepTint_, &QCheckBox::toggled, this, &TunePanel::updateTint);
  connect(automaticRange_, &QToolButton::clicked, this, [this](bool automatic) {
    const std::optional<IntensityRange> range = automatic ? std::nullopt : shownRange();
    apply(tr("Change range"), -1, [&](Parameters& p) { p.range = range; });
    showRange();
    tintForAWhile();
  });
  return part;
}

ValueField* TunePanel::addField(QFormLayout* form, const ValueSpec& spec, const QString& undoText,
                                std::function<void(Parameters&, std::optional<double>)> set) {
  auto* field = new ValueField(spec, body_);
  auto* label = new QLabel(spec.name, body_);
  label->setBuddy(field);
  label->setToolTip(QStringLiteral("<p>%1</p>").arg(spec.tip.toHtmlEscaped()));
  form->addRow(label, field);
  connect(field, &ValueField::edited, this,
          [this, undoText, set = std::move(set)](std::optional<double> value, int gesture) {
            apply(undoText, gesture, [&](Parameters& p) { set(p, value); });
          });
  return field;
}

QWidget* TunePanel::buildForces() {
  auto* part = new QWidget(body_);
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Surface"), part));
  QFormLayout* form = panelForm();
  smoothing_ = addField(form, smoothingSpec(), tr("Change smoothing"),
                        [](Parameters& p, std::optional<double> v) { p.smoothing = v; });
  edgeLength_ = addField(form, edgeLengthSpec(), tr("Change edge length"),
                         [](Parameters& p, std::optional<double> v) { p.edgeLength = v; });
  balloon_ = addField(form, balloonSpec(), tr("Change balloon"),
                      [](Parameters& p, std::optional<double> v) { p.balloon = *v; });
  curvature_ = addField(form, curvatureSpec(), tr("Change curvature"),
                        [](Parameters& p, std::optional<double> v) { p.curvature = *v; });
  maxIterations_ = addField(form, maxIterationsSpec(), tr("Change iteration limit"),
                            [](Parameters& p, std::optional<double> v) { p.maxIterations = int(*v); });
  form->addRow(tr("Direction"), choiceRow(tr("Direction"), {tr("Outward"), tr("Both")},
                                          {tr("The surface only grows"), tr("The surface may also shrink")},
                                          direction_, part));
  connect(direction_, &QButtonGroup::idClicked, this, [this](int id) {
    apply(tr("Change direction"), -1,
          [id](Parameters& p) { p.direction = id == 0 ? Direction::outward : Direction::both; });
  });
  layout->addLayout(form);
  return part;
}

QWidget* TunePanel::buildExpert() {
  auto* part = new QWidget(body_);
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Expert"), part));
  QFormLayout* form = panelForm();
  form->addRow(
      tr("Edges"),
      choiceRow(tr("Edges"), {tr("Auto"), tr("Uniform"), tr("Adaptive")},
                {tr("Adaptive where the object is wide for its edges, so that this saves iterations"),
                 tr("The target edge length is the same everywhere"),
                 tr("Edges and steps are up to four times as long where the image shows no boundary near by: "
                    "fewer iterations")},
                resolution_, part));
  connect(resolution_, &QButtonGroup::idClicked, this, [this](int id) {
    apply(tr("Change edges"), -1, [id](Parameters& p) { p.resolution = kResolutions[id]; });
  });
  form->addRow(
      tr("Collisions"),
      choiceRow(tr("Collisions"), {tr("Sorted"), tr("Hashing")},
                {tr("Near vertices are found in one sorted table. The surface does not depend on it"),
                 tr("Near vertices are found by the paper's eight hash functions: slower, the same "
                    "surface")},
                broadPhase_, part));
  connect(broadPhase_, &QButtonGroup::idClicked, this, [this](int id) {
    apply(tr("Change search for collisions"), -1,
          [id](Parameters& p) { p.broadPhase = id == 0 ? BroadPhase::sorted : BroadPhase::hashing; });
  });
  layout->addLayout(form);
  return part;
}

void TunePanel::apply(const QString& undoText, int gesture, const Change& change) {
  Parameters parameters = document_.parameters();
  change(parameters);
  document_.setParameters(parameters, undoText, gesture);
}

void TunePanel::setRange(const IntensityRange& range, int gesture) {
  apply(tr("Change range"), gesture, [&](Parameters& p) { p.range = range; });
  tintForAWhile();
}

std::optional<IntensityRange> TunePanel::shownRange() const {
  if (document_.parameters().range) return document_.parameters().range;
  if (document_.resolved()) return document_.resolved()->range;
  return std::nullopt;
}

void TunePanel::tintForAWhile() {
  tintEnds_->start();
  updateTint();
}

void TunePanel::updateTint() {
  // What is tinted is found in the frame that is worked in.
  const bool tinted = document_.time().showsWorkFrame() && (keepTint_->isChecked() || tintEnds_->isActive());
  const std::optional<IntensityRange> range = tinted ? shownRange() : std::nullopt;
  state_.setTint(range ? std::optional(Tint{document_.objectImage(), *range}) : std::nullopt);
}

void TunePanel::countIntensities() {
  keepTint_->setChecked(false);
  showHistogram({}, 0);
  inBackground(
      this, [volume = document_.volume()] { return histogramOf(volume); },
      [this, number = ++opened_](const Histogram& histogram) {
        if (number == opened_) showHistogram(histogram, histogram.high - histogram.low);
      });
}

//! `width`: of the intensities; 0: not known.
void TunePanel::showHistogram(const Histogram& histogram, double width) {
  histogram_->setHistogram(histogram);
  const QSignalBlocker quietLow(low_), quietHigh(high_);  // what is rounded is no entry
  for (IntensityField* field : {low_, high_}) field->setScale(width);
  showRange();
}

void TunePanel::boundLengths() {
  if (!document_.hasVolume()) return;
  const Grid& grid = document_.volume().grid;
  const ParameterLimits limits = limitsFor(grid);
  smoothing_->setLengths(grid, true, limits.smoothing);
  edgeLength_->setLengths(grid, false, limits.edgeLength);
}

void TunePanel::show() {
  const bool usable = document_.hasVolume();
  body_->setEnabled(usable);
  hint_->setVisible(!usable || !document_.isSeeded());
  hint_->setText(
      tr("%1 everything here is then chosen from the image. Change it only if the surface leaks or "
         "stops early.")
          .arg(usable ? tr("Place a seed:") : tr("Open a volume and place a seed:")));
  error_->setText(document_.resolveError());
  error_->setVisible(!document_.resolveError().isEmpty());
  const Parameters& p = document_.parameters();
  const std::optional<ResolvedParameters>& used = document_.resolved();
  object_->button(p.object == ObjectKind::dark ? 0 : (p.object == ObjectKind::bright ? 1 : 2))
      ->setChecked(true);
  object_->button(2)->setText(
      !used ? tr("Auto") : (used->object == ObjectKind::dark ? tr("Auto (dark)") : tr("Auto (bright)")));
  direction_->button(p.direction == Direction::outward ? 0 : 1)->setChecked(true);
  const auto resolution = std::find(kResolutions.begin(), kResolutions.end(), p.resolution);
  resolution_->button(static_cast<int>(resolution - kResolutions.begin()))->setChecked(true);
  broadPhase_->button(p.broadPhase == BroadPhase::sorted ? 0 : 1)->setChecked(true);
  smoothing_->show(p.smoothing, used ? std::optional(used->smoothing) : std::nullopt);
  edgeLength_->show(p.edgeLength, used ? std::optional(used->edgeLength) : std::nullopt);
  balloon_->show(p.balloon);
  curvature_->show(p.curvature);
  maxIterations_->show(p.maxIterations);
  showRange();
  updateTint();
}

void TunePanel::showRange() {
  const QSignalBlocker quietLow(low_), quietHigh(high_);
  const std::optional<IntensityRange> range = shownRange();
  const bool automatic = !document_.parameters().range;
  histogram_->setRange(range, automatic);
  automaticRange_->setChecked(automatic);
  for (IntensityField* field : {low_, high_}) {
    field->setEnabled(range.has_value());
    field->setKnown(range.has_value());
  }
  if (!range) return;
  low_->setEnd(range->low);
  high_->setEnd(range->high);
}

}  // namespace handlebody::ui
