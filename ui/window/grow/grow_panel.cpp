#include "ui/window/grow/grow_panel.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/io/report/start_surface.h"
#include "ui/model/document.h"
#include "ui/model/finding_text.h"
#include "ui/window/commands.h"
#include "ui/window/grow/topology_section.h"
#include "ui/window/time/time_bar.h"
#include "ui/window/timeline/event_inspector.h"
#include "ui/window/widgets/action_button.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

const QString kNone = QStringLiteral("–");

QString genusText(const Certificate& certificate) {
  if (certificate.genus.empty()) return kNone;
  int total = 0;
  QStringList each;
  for (int genus : certificate.genus) {
    total += genus;
    each << QString::number(genus);
  }
  if (each.size() == 1 || each.size() > 8) return QString::number(total);
  return QStringLiteral("%1 (%2)").arg(QString::number(total), each.join(QStringLiteral(", ")));
}

QString faultsOf(const Certificate& c) {
  QStringList faults;
  if (!c.closed) faults << GrowPanel::tr("not closed");
  if (!c.manifold) faults << GrowPanel::tr("not manifold");
  if (!c.oriented) faults << GrowPanel::tr("not oriented");
  if (c.selfIntersections > 0) faults << GrowPanel::tr("self-intersections: %1").arg(c.selfIntersections);
  if (c.misplaced > 0) faults << GrowPanel::tr("parts that lie wrongly in each other: %1").arg(c.misplaced);
  if (c.selfIntersections < 0) faults << GrowPanel::tr("self-intersections not checked");
  return faults.join(QStringLiteral(", "));
}

QString finishedText(StopReason reason) {
  switch (reason) {
    case StopReason::converged:
      return GrowPanel::tr("Finished: the surface is at rest");
    case StopReason::maxIterations:
      return GrowPanel::tr("Stopped at the iteration limit");
    case StopReason::empty:
      return GrowPanel::tr("Finished: nothing is left of the surface");
    case StopReason::frozen:
      return GrowPanel::tr("At rest, but parts that could not be mended would still move");
    case StopReason::given:
      return GrowPanel::tr("As it was opened: nothing grows");
    case StopReason::stuck:
      return GrowPanel::tr("Stuck: no part of a step could be kept");
    default:
      return GrowPanel::tr("Finished");
  }
}

QString warningText(const Finding& warning) {
  return QStringLiteral("<p style='margin: 4px 0 0 0'>%1</p>").arg(findingSentence(warning).toHtmlEscaped());
}

//! Only what came to its end is judged: on the way much of a surface lies where there is no edge. What a
//! surface that was opened lacks is known from the beginning.
std::vector<Finding> warningsAbout(const Document& document) {
  const auto snapshot = document.snapshot();
  if (!snapshot) return {};
  std::vector<Finding> warnings;
  if (Finding shared = sharedVoxels(document.constraints()); shared.any())
    warnings.push_back(std::move(shared));
  if (const auto start = document.constraints().start)
    for (const Finding& w : start->warnings)
      if (!w.causes.empty() && w.causes[0].kind == FindingKind::volumeOffVoxels) warnings.push_back(w);
  if (document.state() == GrowthState::finished && document.iteration() == document.lastIteration())
    warnings.insert(warnings.end(), snapshot->warnings.begin(), snapshot->warnings.end());
  return warnings;
}

QString warningsOf(const Document& document) {
  const std::vector<Finding> warnings = warningsAbout(document);
  if (warnings.empty()) return {};
  QString text = QStringLiteral("<p style='margin: 0'><b>%1</b></p>").arg(GrowPanel::tr("⚠ Worth a look"));
  for (const Finding& warning : warnings) text += warningText(warning);
  return text;
}

}  // namespace

QString stateText(const Document& document, const QString& between) {
  const QString at =
      document.iteration() < 0
          ? QString()
          : between +
                GrowPanel::tr("iteration %1 of %2").arg(document.iteration()).arg(document.lastIteration());
  switch (document.state()) {
    case GrowthState::preparing:
      return GrowPanel::tr("Preparing the image…");
    case GrowthState::running:
      return GrowPanel::tr("Growing") + at;
    case GrowthState::paused:
      return GrowPanel::tr("Paused") + at;
    case GrowthState::finished:
      return finishedText(document.stopReason()) + at;
    default:
      if (!document.isSeeded()) return GrowPanel::tr("No seed yet");
      return document.growthError().isEmpty() ? GrowPanel::tr("Ready to grow")
                                              : GrowPanel::tr("Nothing grew");
  }
}

namespace {

//! What the clicks that were changed last have made of the shown surface; empty if none were.
QString correctionText(const Document& document) {
  const auto& all = document.corrections();
  const auto isShown = [&](const RecordedCorrection& c) { return c.iteration < document.iteration(); };
  const auto last = std::find_if(all.rbegin(), all.rend(), isShown);
  if (last == all.rend()) return {};
  const QString text = last->what.beganAnew
                           ? GrowPanel::tr("These clicks mean another object: begun anew at iteration %1")
                           : GrowPanel::tr("Clicks changed at iteration %1: gone on from there");
  return QLatin1Char('\n') + text.arg(last->iteration);
}

}  // namespace

GrowPanel::GrowPanel(Document& document, SurfaceView& surface, const Commands& commands, QWidget* parent)
    : QWidget(parent), document_(document) {
  auto* layout = panelLayout(this);
  hint_ = hint(tr("Start grows the surface from the seeds. You may pause, go back exactly, change a click or "
                  "a parameter "
                  "and go on from there at any time."),
               this);
  layout->addWidget(buildButtons(commands));
  layout->addWidget(hint_);
  state_ = value(tr("State of the growth"), this);
  layout->addWidget(state_);
  error_ = notice(tr("Why it did not grow"), this);
  layout->addWidget(error_);
  warnings_ = notice(tr("Doubts about the surface"), this);
  warnings_->setTextFormat(Qt::RichText);
  layout->addWidget(warnings_);
  layout->addWidget(buildNumbers());
  inspector_ = new EventInspector(document_, surface, this);
  layout->addWidget(inspector_);
  // As wide as with an event, so that the panel does not widen when one is chosen.
  layout->addItem(new QSpacerItem(inspector_->minimumSizeHint().width(), 0, QSizePolicy::Minimum,
                                  QSizePolicy::Expanding));
  for (auto changed : {&Document::stateChanged, &Document::snapshotChanged, &Document::summariesChanged,
                       &Document::seedsChanged})
    connect(&document_, changed, this, &GrowPanel::showState);
  connect(&document_, &Document::snapshotChanged, this, &GrowPanel::showNumbers);
  connect(&document_, &Document::stateChanged, this, &GrowPanel::showNumbers);
  showState();
  showNumbers();
}

QWidget* GrowPanel::buildButtons(const Commands& commands) {
  auto* part = new QWidget(this);
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* run = new ActionButton(commands[Command::run], part);
  run->setMinimumHeight(36);
  layout->addWidget(run);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  for (Command id : {Command::toStart, Command::previousEvent, Command::stepBack, Command::stepForward,
                     Command::nextEvent, Command::toEnd}) {
    QToolButton* button = smallButton(commands[id], part);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    row->addWidget(button);
  }
  layout->addLayout(row);
  auto* stepsRow = new QHBoxLayout;
  auto* label = new QLabel(tr("Steps per frame"), part);
  auto* steps = new QSpinBox(part);
  steps->setRange(1, 50);
  steps->setValue(document_.stepsPerFrame());
  describe(steps, tr("Steps per frame"),
           tr("How many iterations the surface goes on between two pictures of it"));
  ignoreWheelWithoutFocus(steps);
  label->setBuddy(steps);
  connect(steps, &QSpinBox::valueChanged, this, [this](int n) { document_.setStepsPerFrame(n); });
  stepsRow->addWidget(label);
  stepsRow->addWidget(steps, 1);
  layout->addLayout(stepsRow);
  auto* pauses = new QCheckBox(tr("Pause at a leak"), part);
  describe(
      pauses, tr("Pause at a leak"),
      tr("The growth pauses where the surface has come through a passage much narrower than what lies on "
         "both sides of it"));
  document_.setPausesAtLeaks(true);
  pauses->setChecked(true);
  connect(pauses, &QCheckBox::toggled, this, [this](bool on) { document_.setPausesAtLeaks(on); });
  layout->addWidget(pauses);
  topology_ = new TopologySection(document_, part);
  layout->addWidget(topology_);
  return part;
}

void GrowPanel::addNumber(QFormLayout* form, const QString& name, const QString& tip, QLabel*& field) {
  field = value(name, numbers_);
  auto* label = new QLabel(name, numbers_);
  for (QLabel* l : {label, field}) l->setToolTip(QStringLiteral("<p>%1</p>").arg(tip.toHtmlEscaped()));
  form->addRow(label, field);
}

QWidget* GrowPanel::buildNumbers() {
  numbers_ = new QWidget(this);
  auto* layout = new QVBoxLayout(numbers_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Surface now"), numbers_));
  badge_ = new QLabel(numbers_);
  badge_->setWordWrap(true);
  badge_->setMargin(6);
  badge_->setAutoFillBackground(true);
  badge_->setAccessibleName(tr("Certificate"));
  layout->addWidget(badge_);
  QFormLayout* form = panelForm();
  addNumber(form, tr("Volume"), tr("Volume enclosed by the surface"), volume_);
  addNumber(form, tr("Area"), tr("Area of the surface"), area_);
  addNumber(form, tr("Components"), tr("Connected parts of the surface"), components_);
  addNumber(form, tr("Genus"), tr("Holes as in a ring: in all, and of each component"), genus_);
  addNumber(form, tr("Euler number"), tr("Vertices minus edges plus faces"), euler_);
  addNumber(form, tr("Vertices"), tr("Vertices of the mesh"), vertices_);
  layout->addLayout(form);
  return numbers_;
}

void GrowPanel::showState() {
  state_->setText(stateText(document_, QStringLiteral("\n")) + correctionText(document_));
  error_->setText(document_.growthError());
  error_->setVisible(!document_.growthError().isEmpty());
  hint_->setVisible(document_.iteration() < 0);
  const QString warnings = warningsOf(document_);
  warnings_->setText(warnings);
  warnings_->setVisible(!warnings.isEmpty());
}

void GrowPanel::showNumbers() {
  const auto snapshot = document_.snapshot();
  numbers_->setVisible(snapshot != nullptr);
  if (!snapshot) return;
  const Certificate& c = snapshot->certificate;
  showCertificate();
  if (c.faces == 0 || document_.isShownOutOfDate()) {  // it shrank away, or is not what there is now
    for (QLabel* field : {components_, genus_, euler_, vertices_, area_, volume_}) field->setText(kNone);
    return;
  }
  components_->setText(QString::number(c.components));
  genus_->setText(genusText(c));
  euler_->setText(QString::number(c.euler));
  vertices_->setText(QLocale().toString(c.vertices));
  area_->setText(squareCentimetres(c.area));
  volume_->setText(millilitres(c.volume));
}

void GrowPanel::showCertificate() {
  const Certificate& c = document_.snapshot()->certificate;
  const bool empty = c.faces == 0;  // a surface that shrank away: nothing to certify, and nothing wrong
  const bool passes = c.boundsBody(), isOld = document_.isShownOutOfDate();
  badge_->setText(isOld    ? outOfDateText(document_)
                  : empty  ? tr("Nothing is left of the surface")
                  : passes ? tr("✓ Closed, manifold, free of self-intersections")
                           : tr("✗ %1").arg(faultsOf(c)));
  QPalette palette = badge_->palette();
  palette.setColor(QPalette::Window, isOld || empty ? QColor(0x6B, 0x6B, 0x6B)
                                     : passes       ? QColor(0x2E, 0x7D, 0x4F)
                                                    : QColor(0xB0, 0x3A, 0x2E));
  palette.setColor(QPalette::WindowText, Qt::white);
  badge_->setPalette(palette);
}

}  // namespace handlebody::ui
