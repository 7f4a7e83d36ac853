#include "ui/window/grow/topology_section.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <utility>

#include "ui/model/document.h"
#include "ui/model/finding_text.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kMaxCount = 999;
// What is meant by most who want a limit: one body without a tunnel.
constexpr int kComponents = 1, kGenus = 0;

}  // namespace

QString questionText(const HeldPlace& held) {
  return TopologySection::tr("Held at iteration %1: %2.")
      .arg(QString::number(held.iteration), findingText(findingOf(held)));
}

TopologySection::TopologySection(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  buildFields(layout);
  buildQuestion(layout);
  for (auto changed : {&Document::constraintsChanged, &Document::snapshotChanged, &Document::stateChanged,
                       &Document::opened, &Document::activeObjectChanged})
    connect(&document_, changed, this, &TopologySection::refresh);
  refresh();
}

QSpinBox* TopologySection::countField(const QString& name, const QString& tip, int least) {
  auto* field = new QSpinBox(counts_);
  field->setRange(least - 1, kMaxCount);
  field->setSpecialValueText(tr("any"));
  field->setKeyboardTracking(false);
  describe(field, name, tip);
  ignoreWheelWithoutFocus(field);
  connect(field, &QSpinBox::valueChanged, this, &TopologySection::setCounts);
  return field;
}

void TopologySection::buildFields(QVBoxLayout* all) {
  auto* row = new QHBoxLayout;
  auto* label = new QLabel(tr("Topology"), this);
  rule_ = new QComboBox(this);
  rule_->addItems({tr("Free"), tr("Never more than"), tr("Ask each time")});
  describe(rule_, tr("Topology"),
           tr("What happens where the surface would get more parts or tunnels than are chosen: it gets them, "
              "never does (what is held is listed in Correct), or the growth pauses and asks you"));
  rule_->setFocusPolicy(Qt::TabFocus);  // a choice by mouse leaves the keyboard with the views
  ignoreWheelWithoutFocus(rule_);
  label->setBuddy(rule_);
  row->addWidget(label);
  row->addWidget(rule_, 1);
  all->addLayout(row);
  counts_ = new QWidget(this);
  auto* form = new QHBoxLayout(counts_);
  form->setContentsMargins(0, 0, 0, 0);
  components_ =
      countField(tr("Components at most"), tr("Connected parts of the surface, cavities included"), 1);
  genus_ = countField(tr("Genus at most"), tr("Tunnels, as in a ring, of all parts together"), 0);
  for (const auto& [text, field] : {std::pair(tr("Parts"), components_), std::pair(tr("Genus"), genus_)}) {
    auto* name = new QLabel(text, counts_);
    name->setBuddy(field);
    form->addWidget(name);
    form->addWidget(field, 1);
  }
  all->addWidget(counts_);
  connect(rule_, &QComboBox::activated, this, &TopologySection::choose);
}

void TopologySection::buildQuestion(QVBoxLayout* all) {
  question_ = new QWidget(this);
  auto* layout = new QVBoxLayout(question_);
  layout->setContentsMargins(0, 0, 0, 0);
  text_ = notice(tr("To decide"), question_);
  layout->addWidget(text_);
  auto* row = new QHBoxLayout;
  const auto answer = [&](const QString& name, const QString& tip, bool allows) {
    auto* button = new QPushButton(name, question_);
    button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard with the views
    describe(button, name, tip);
    connect(button, &QPushButton::clicked, this, [this, allows] {
      const std::vector<HeldPlace> open = document_.openQuestions();
      if (!open.empty()) Q_EMIT answered(open.front(), allows);
    });
    row->addWidget(button);
  };
  answer(tr("Let it happen"), tr("It may break the limits here; the growth goes on"), true);
  answer(tr("Hold it"), tr("It stays held here, and you are not asked again; the growth goes on"), false);
  layout->addLayout(row);
  all->addWidget(question_);
}

TopologySection::Rule TopologySection::rule() const {
  const TopologyLimits& limits = document_.constraints().topology;
  if (!limits.components && !limits.genus) return kFree;
  return limits.asks ? kAsk : kNeverMore;
}

void TopologySection::choose(int chosen) {
  if (chosen == rule()) return;
  Constraints after = document_.constraints();
  TopologyLimits& limits = after.topology;
  if (chosen == kFree) {
    limits = {};
  } else {
    if (rule() == kFree) {
      limits.components = kComponents;
      limits.genus = kGenus;
    }
    limits.asks = chosen == kAsk;
  }
  document_.setConstraints(after, chosen == kFree  ? tr("Free topology")
                                  : chosen == kAsk ? tr("Ask about the topology")
                                                   : tr("Limit the topology"));
  refresh();  // of a locked object nothing has changed
}

void TopologySection::setCounts() {
  const auto countOf = [](const QSpinBox* field) {
    return field->value() == field->minimum() ? std::nullopt : std::optional(field->value());
  };
  Constraints after = document_.constraints();
  after.topology.components = countOf(components_);
  after.topology.genus = countOf(genus_);
  if (!after.topology.components && !after.topology.genus) after.topology = {};
  document_.setConstraints(after, tr("Limit the topology"));
  refresh();
}

void TopologySection::refresh() {
  const TopologyLimits& limits = document_.constraints().topology;
  const QSignalBlocker quiet1(rule_), quiet2(components_), quiet3(genus_);
  rule_->setCurrentIndex(rule());
  counts_->setVisible(rule() != kFree);
  components_->setValue(limits.components.value_or(components_->minimum()));
  genus_->setValue(limits.genus.value_or(genus_->minimum()));
  showQuestion();
}

//! While it grows nothing is asked: it has gone on without an answer.
void TopologySection::showQuestion() {
  const bool rests = document_.state() != GrowthState::running;
  const std::vector<HeldPlace> open = rests ? document_.openQuestions() : std::vector<HeldPlace>();
  question_->setVisible(!open.empty());
  if (open.empty()) return;
  QString text = questionText(open.front());
  if (open.size() > 1) text += QLatin1Char(' ') + tr("%1 more to decide.").arg(open.size() - 1);
  text_->setText(text);
}

}  // namespace handlebody::ui
