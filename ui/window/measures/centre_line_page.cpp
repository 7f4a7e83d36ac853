#include "ui/window/measures/centre_line_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/model/document.h"
#include "ui/view/view_state.h"
#include "ui/window/commands.h"
#include "ui/window/measures/measure_texts.h"
#include "ui/window/measures/section_plot.h"
#include "ui/window/widgets/panel_tools.h"
#include "ui/window/widgets/toggle_button.h"

namespace handlebody::ui {

namespace {
constexpr int kLineTools = 290;  // pixels
}  // namespace

CentreLinePage::CentreLinePage(Document& document, ViewState& state, const Commands& commands,
                               QWidget* parent)
    : QWidget(parent), document_(document), state_(state) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  buildTools(commands);
  plot_ = new SectionPlot(this);
  layout->addWidget(plot_, 1);
  connect(plot_, &SectionPlot::pointedAt, this, &CentreLinePage::markPoint);
  connect(plot_, &SectionPlot::chosen, this, [this](int index) {
    state_.setCrosshair(shown_->line.points.at(static_cast<std::size_t>(index)).place);
  });
  connect(&state_.measure(), &MeasureTool::lineAsked, this, [this](const Vec3& from, const Vec3& to) {
    Q_EMIT lineAsked();
    find(from, to);
  });
  connect(&state_.measure(), &MeasureTool::modeChanged, this, &CentreLinePage::showState);
  connect(&state_.measure(), &MeasureTool::changed, this, [this] {
    if (state_.measure().mode() == MeasureTool::Mode::centreLine) showState();
  });
  connect(&document_, &Document::opened, this, &CentreLinePage::forget);
  for (auto changed : {&Document::snapshotChanged, &Document::objectsChanged})
    connect(&document_, changed, this, [this] {
      showLine();
      showState();
    });
  showState();
}

void CentreLinePage::buildTools(const Commands& commands) {
  auto* tools = new QWidget(this);
  tools->setFixedWidth(kLineTools);
  auto* column = new QVBoxLayout(tools);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(toggleFor(commands[Command::centreLine], tools));
  text_ = value(tr("The centre line"), tools);
  column->addWidget(text_);
  column->addStretch(1);
  auto* files = new QHBoxLayout;
  csv_ = new QPushButton(tr("Save as CSV…"), tools);
  describe(csv_, tr("Save as CSV"), tr("The same table as “handlebody-cli measure --sections” writes"));
  json_ = new QPushButton(tr("Save as JSON…"), tools);
  describe(json_, tr("Save as JSON"), tr("The same as “handlebody-cli measure --json” writes of the line"));
  remove_ = new QPushButton(tools);
  for (QPushButton* button : {csv_, json_, remove_})
    button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard with the views
  for (QPushButton* button : {csv_, json_}) files->addWidget(button);
  column->addLayout(files);
  column->addWidget(remove_);
  layout()->addWidget(tools);
  connect(csv_, &QPushButton::clicked, this, [this] {
    Q_EMIT saveRequested(tr("Save the sections"), QStringLiteral(".csv"), sectionsCsv(shown_->line));
  });
  connect(json_, &QPushButton::clicked, this,
          [this] { Q_EMIT saveRequested(tr("Save the sections"), QStringLiteral(".json"), json()); });
  connect(remove_, &QPushButton::clicked, this, &CentreLinePage::forget);
}

std::string CentreLinePage::json() const {
  MeasuredLine told = *shown_;
  if (isAnonymous_) told.object = anonymousNames(made_).at(told.object);
  return centreLineJson(told);
}

void CentreLinePage::find(const Vec3& from, const Vec3& to) {
  forget();
  made_ = shownSurfaces(document_);
  const LineQuestion question{made_, from, to};
  isSearching_ = true;
  measurer_.findLine(question, [this, number = ++number_](LineAnswer answer) {
    QMetaObject::invokeMethod(
        this,
        [this, number, answer = std::make_shared<LineAnswer>(std::move(answer))] {
          if (number == number_ && isSearching_) showAnswer(std::move(*answer));
        },
        Qt::QueuedConnection);
  });
  showState();
}

void CentreLinePage::showAnswer(LineAnswer answer) {
  isSearching_ = false;
  error_ = answer.error;
  shown_ = std::move(answer.line);
  if (shown_) plot_->setLine(shown_->line);
  showLine();
  showState();
}

//! The surface that it was made in is shown still, whatever it is called now. Precondition: there is a line.
bool CentreLinePage::isCurrent() const {
  const auto isIts = [&](const MeasuredSurface& s) { return s.name.toStdString() == shown_->object; };
  const auto its = std::find_if(made_.begin(), made_.end(), isIts);
  const std::vector<MeasuredSurface> now = shownSurfaces(document_);
  return its != made_.end() &&
         std::any_of(now.begin(), now.end(), [&](const MeasuredSurface& s) { return s.mesh == its->mesh; });
}

//! The plot keeps what is drawn in the views no more.
void CentreLinePage::showLine() {
  std::vector<Vec3> places;
  if (shown_ && isCurrent())
    for (const CentreLinePoint& p : shown_->line.points) places.push_back(p.place);
  if (places != state_.measure().line()) state_.measure().setLine(places);
}

void CentreLinePage::forget() {
  measurer_.cancel();
  isSearching_ = false;
  shown_.reset();
  error_.clear();
  plot_->setLine({});
  showLine();
  showState();
}

void CentreLinePage::markPoint(int index) {
  if (!shown_ || index < 0 || !isCurrent()) {
    state_.measure().setMarker(std::nullopt);
  } else {
    const CentreLinePoint& p = shown_->line.points.at(static_cast<std::size_t>(index));
    state_.measure().setMarker(
        MeasureTool::Marker{p.place, p.direction, p.area ? p.equivalentDiameter() / 2 : p.radius});
  }
  showState();
}

//! What a click does now, or what there is.
void CentreLinePage::showState() {
  const MeasureTool& tool = state_.measure();
  QString text = tr("Between two places in an object, along its middle.");
  if (tool.mode() == MeasureTool::Mode::centreLine)
    text = tool.placed().empty()
               ? tr("Click in the object or on its surface where the line begins, or press Return for the "
                    "crosshair.")
               : tr("Click where it ends. Escape takes the beginning back.");
  else if (isSearching_)
    text = tr("Searching for the middle of the object…");
  else if (!error_.isEmpty())
    text = error_;
  else if (shown_) {
    text = lineSummary(*shown_);
    if (const int at = plot_->pointed(); at >= 0)
      text += QLatin1Char('\n') +
              tr("Pointed at: %1").arg(sectionText(shown_->line.points.at(static_cast<std::size_t>(at))));
    if (!isCurrent()) text += QLatin1Char('\n') + tr("It was made in an earlier surface.");
  }
  text_->setText(text);
  for (QPushButton* button : {csv_, json_}) button->setEnabled(shown_.has_value());
  remove_->setText(isSearching_ ? tr("Cancel") : tr("Remove"));
  describe(remove_, remove_->text(), isSearching_ ? tr("Search no longer") : tr("Draw the line no more"));
  remove_->setEnabled(isSearching_ || shown_ || !error_.isEmpty());
}

}  // namespace handlebody::ui
