#include "ui/window/seed/object_choice.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/window/commands.h"
#include "ui/window/widgets/action_button.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

//! Counted in voxels: no more digits than that is worth.
QString volumeText(const CandidateChoice& choice, int candidate) {
  return millilitres(volumeOf(choice, candidate), 3);
}

QString sentence(const CandidateChoice& choice) {
  const QString volume = volumeText(choice, choice.chosen);
  const std::size_t count = choice.candidates.size();
  if (count == 1) return ObjectChoice::tr("The only one: %1").arg(volume);
  const QString which =
      ObjectChoice::tr("%1 of %2 by size: %3").arg(placeBySize(choice)).arg(count).arg(volume);
  return choice.chosen == 1 ? ObjectChoice::tr("%1 (likeliest)").arg(which) : which;
}

//! "Smaller: 3.1 ml"
QString withVolume(const QString& text, const CandidateChoice& choice, SizeStep step) {
  const std::optional<int> next = neighbour(choice, step);
  return next ? ObjectChoice::tr("%1: %2").arg(text, volumeText(choice, *next)) : text;
}

}  // namespace

ObjectChoice::ObjectChoice(const Commands& commands, QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Object"), this));
  chosen_ = value(tr("Which object is taken"), this);
  layout->addWidget(chosen_);
  smaller_ = new ActionButton(commands[Command::smallerObject], this);
  larger_ = new ActionButton(commands[Command::largerObject], this);
  auto* row = new QHBoxLayout;
  row->addWidget(smaller_, 1);
  row->addWidget(larger_, 1);
  layout->addLayout(row);
  close_ = notice(tr("Whether the choice is sure"), this);
  close_->setText(tr("A close choice: look at the others, too."));
  QSizePolicy keeps = close_->sizePolicy();
  keeps.setRetainSizeWhenHidden(true);  // nothing jumps
  close_->setSizePolicy(keeps);
  layout->addWidget(close_);
  showChoice({}, QString());
}

void ObjectChoice::showChoice(const CandidateChoice& choice, const QString& unknown) {
  chosen_->setText(choice.candidates.empty() ? unknown : sentence(choice));
  close_->setVisible(choice.isClose && choice.candidates.size() > 1);
  smaller_->setOwnText(withVolume(tr("Smaller"), choice, SizeStep::smaller));
  larger_->setOwnText(withVolume(tr("Larger"), choice, SizeStep::larger));
}

}  // namespace handlebody::ui
