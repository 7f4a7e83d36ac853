#include "ui/window/timeline/event_inspector.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/model/document.h"
#include "ui/model/finding_text.h"
#include "ui/window/widgets/choice_row.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"
#include "ui/window/widgets/toggle_button.h"

namespace handlebody::ui {

namespace {

constexpr EventStage kStages[] = {EventStage::none,   EventStage::colliding, EventStage::opened,
                                  EventStage::handle, EventStage::closed,    EventStage::refined};

QString explanation(EventStage stage) {
  switch (stage) {
    case EventStage::colliding:
      return EventInspector::tr("Stage 1 of 4: the triangles that run into each other.");
    case EventStage::opened:
      return EventInspector::tr(
          "Stage 2 of 4: the mesh without them, and the polygons that bound the openings.");
    case EventStage::handle:
      return EventInspector::tr("Stage 3 of 4: the handle, or the caps, that close the openings.");
    case EventStage::closed:
      return EventInspector::tr("Stage 4 of 4: the mesh with the handle in place.");
    case EventStage::refined:
      return EventInspector::tr(
          "Before stage 2: the edges around them are halved, or the openings would not be bounded by simple "
          "polygons.");
    default:
      return {};
  }
}

bool isEmpty(const EventTrace& trace) {
  return trace.collidingFaces.empty() && trace.openedFaces.empty() && trace.closedFaces.empty();
}

bool has(const EventTrace& trace, EventStage stage) {
  return stage == EventStage::refined ? !trace.refinedFaces.empty() : !isEmpty(trace);
}

QString loopsText(const Event& event) {
  QStringList sizes;
  for (int size : event.loopSizes) sizes << QString::number(size);
  return sizes.join(QStringLiteral(", "));
}

}  // namespace

QString eventName(EventKind kind) {
  switch (kind) {
    case EventKind::handleInserted:
      return EventInspector::tr("Handle inserted");
    case EventKind::split:
      return EventInspector::tr("Split");
    case EventKind::enclosedPartCutOff:
      return EventInspector::tr("Enclosed part cut off");
    case EventKind::tunnelClosed:
      return EventInspector::tr("Tunnel closed");
    case EventKind::componentDeleted:
      return EventInspector::tr("Component deleted");
    case EventKind::handleCut:
      return EventInspector::tr("Handle cut");
    case EventKind::componentRemoved:
      return EventInspector::tr("Component removed");
    case EventKind::cavityFilled:
      return EventInspector::tr("Cavity filled");
    case EventKind::smoothed:
      return EventInspector::tr("Fold smoothed");
    case EventKind::planeCut:
      return EventInspector::tr("Cut by a plane");
    case EventKind::surfaceSmoothed:
      return EventInspector::tr("Smoothed by hand");
    case EventKind::surfacePulled:
      return EventInspector::tr("Pulled");
    case EventKind::rolledBack:
      return EventInspector::tr("Rolled back");
  }
  return {};
}

QString eventName(const Event& event) {
  return event.held ? EventInspector::tr("Held: %1").arg(eventName(*event.held)) : eventName(event.kind);
}

QString changeText(int before, int after) {
  return before == after ? QString::number(after) : QStringLiteral("%1 → %2").arg(before).arg(after);
}

EventInspector::EventInspector(Document& document, SurfaceView& surface, QWidget* parent)
    : QWidget(parent), document_(document), surface_(surface) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  title_ = heading(QString(), this);
  layout->addWidget(title_);
  text_ = value(tr("Event"), this);
  layout->addWidget(text_);
  stages_ = choiceRow(
      tr("Stage"), {tr("Off"), tr("Collide"), tr("Open"), tr("Handle"), tr("Close")},
      {tr("Show the whole surface"), explanation(EventStage::colliding), explanation(EventStage::opened),
       explanation(EventStage::handle), explanation(EventStage::closed)},
      stage_, this);
  layout->addWidget(stages_);
  refine_ = new ToggleButton(tr("Refine"), this);
  describe(refine_, tr("Stage") + QStringLiteral(": ") + refine_->text(), explanation(EventStage::refined));
  stage_->addButton(refine_, static_cast<int>(EventStage::refined));
  layout->addWidget(refine_);
  stageText_ = hint(QString(), this);
  layout->addWidget(stageText_);
  constrain_ = new QPushButton(tr("Keep it"), this);
  constrain_->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard with the views
  layout->addWidget(constrain_);
  connect(constrain_, &QPushButton::clicked, this, &EventInspector::constrain);
  connect(stage_, &QButtonGroup::idClicked, this, [this](int id) { showStage(kStages[id]); });
  connect(&document_, &Document::eventTraced, this, &EventInspector::receive);
  // Of another object: its events have the same numbers.
  connect(&document_, &Document::activeObjectChanged, this, [this] { setEvent(-1); });
  connect(&document_, &Document::snapshotChanged, this, &EventInspector::followIteration);
  connect(&document_, &Document::summariesChanged, this, &EventInspector::followIteration);
  connect(&document_, &Document::stateChanged, this, &EventInspector::followIteration);
  setEvent(-1);
}

void EventInspector::setEvent(int index) {
  if (index == index_ && index >= 0) return;
  index_ = index;
  trace_.reset();
  leaveStage();
  showText();
}

void EventInspector::leaveStage() {
  if (wanted_ != EventStage::none) surface_.clearStage();
  wanted_ = EventStage::none;
  stage_->button(0)->setChecked(true);
  explain();
}

// The event of the shown iteration; the first, unless another one of it was chosen.
void EventInspector::followIteration() {
  // Not while it grows: every event on the way would let the panel flicker.
  if (document_.state() == GrowthState::running) return setEvent(-1);
  const std::vector<Event>& events = document_.events();
  const auto isHere = [&](int i) {
    return i >= 0 && i < static_cast<int>(events.size()) && events[i].iteration == document_.iteration();
  };
  if (isHere(index_)) return offerConstraint();  // what is held there may have changed
  int first = -1;
  for (int i = 0; i < static_cast<int>(events.size()) && first < 0; ++i)
    if (isHere(i) && changesTopology(events[i].kind)) first = i;
  for (int i = 0; i < static_cast<int>(events.size()) && first < 0; ++i)
    if (isHere(i) && events[i].held) first = i;
  setEvent(first);
}

void EventInspector::showText() {
  const bool any = index_ >= 0;
  setVisible(any);
  if (!any) return;
  offerConstraint();
  const Event& event = document_.events()[index_];
  title_->setText(tr("Event: %1").arg(eventName(event)));
  stages_->setVisible(!event.edit);  // nothing collided
  QStringList lines{tr("at %1").arg(place(event.location, document_.volume().grid)),
                    tr("Genus %1, components %2")
                        .arg(changeText(event.before.genus, event.after.genus),
                             changeText(event.before.components, event.after.components))};
  if (event.edit) {
    lines << tr("Edit by hand: %1 → %2")
                 .arg(millilitres(event.edit->volumeBefore), millilitres(event.edit->volumeAfter));
    if (event.edit->loop > 0) lines << tr("Loop of %1").arg(millimetres(event.edit->loop));
  }
  if (event.fronts > 0) lines << tr("Fronts joined: %1").arg(event.fronts);
  if (!event.loopSizes.empty()) lines << tr("Boundary polygons of %1 vertices").arg(loopsText(event));
  if (!event.reasons.empty()) lines << findingText(event.reasons);
  text_->setText(lines.join(QLatin1Char('\n')));
}

//! What is held at the place of the shown event, if it is a change that was held; a repair is not.
std::optional<HeldPlace> EventInspector::heldHere() const {
  const Event& event = document_.events()[index_];
  const auto shown = document_.snapshot();
  if (!event.held || !shown || shown->held.empty()) return std::nullopt;
  const auto distance = [&](const HeldPlace& held) { return (held.place - event.location).norm(); };
  return *std::min_element(shown->held.begin(), shown->held.end(),
                           [&](const HeldPlace& a, const HeldPlace& b) { return distance(a) < distance(b); });
}

void EventInspector::offerConstraint() {
  const Event& event = document_.events()[index_];
  const bool isChange = changesTopology(event.kind);
  constrain_->setVisible(isChange || heldHere());
  const bool isMeeting = event.kind == EventKind::handleInserted;
  const QString name = !isChange    ? tr("Let it happen")
                       : event.edit ? tr("Leave out")
                       : isMeeting  ? tr("Keep apart here")
                                    : tr("Keep it");
  const QString tip = event.edit ? tr("Goes back to the step before this edit, and on without it")
                      : isChange
                          ? tr("Goes back to the step before; grown on from there, this does not happen")
                          : tr("From the shown step on, what is held here may happen");
  constrain_->setText(name);
  describe(constrain_, name, tip);
}

void EventInspector::constrain() {
  if (index_ < 0) return;
  if (const auto held = heldHere())
    document_.allow(*held);
  else
    document_.forbid(index_);
}

void EventInspector::showStage(EventStage stage) {
  if (index_ < 0) return;
  wanted_ = stage;
  stage_->button(static_cast<int>(stage))->setChecked(true);
  explain();
  if (stage == EventStage::none)
    surface_.clearStage();
  else if (trace_ && !has(*trace_, stage))
    surface_.clearStage();
  else if (trace_)
    surface_.showStage(*trace_, stage);
  else
    document_.requestTrace(index_);
}

void EventInspector::explain() {
  const bool waiting = wanted_ != EventStage::none && !trace_;
  const bool none = trace_ && isEmpty(*trace_) && wanted_ != EventStage::none;
  const bool unrefined = trace_ && !none && wanted_ == EventStage::refined && !has(*trace_, wanted_);
  stageText_->setText(waiting     ? tr("The step is worked out again…")
                      : none      ? tr("The mesh was not opened here: there are no stages to show.")
                      : unrefined ? tr("Nothing was refined here: the polygons were simple.")
                                  : explanation(wanted_));
  refine_->setVisible(trace_ && has(*trace_, EventStage::refined));
  stageText_->setVisible(!stageText_->text().isEmpty());
}

void EventInspector::receive(int index, const EventTrace& trace) {
  if (index != index_) return;
  trace_ = trace;
  if (wanted_ != EventStage::none) showStage(wanted_);
}

}  // namespace handlebody::ui
