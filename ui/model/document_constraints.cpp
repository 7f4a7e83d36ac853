// What the surface may not do: vetoes, and what is allowed again.

#include <algorithm>

#include "ui/model/document_private.h"

namespace handlebody::ui {

const Constraints& Document::constraints() const { return d_->active->edits().constraints; }

void Document::setConstraints(const Constraints& constraints, const QString& undoText, int gesture) {
  if (constraints == this->constraints()) return;
  Edits after = d_->active->edits();
  after.constraints = constraints;
  d_->push(undoText, std::move(after), gesture);
}

void Document::forbid(int index) {
  const Event& event = events().at(static_cast<std::size_t>(index));
  const bool isMeeting = event.kind == EventKind::handleInserted;
  Edits after = d_->active->edits();
  after.constraints.vetoes.push_back({event.iteration, event.location});
  if (!d_->mayChange()) return;
  goTo(event.iteration - 1);
  d_->push(isMeeting ? tr("Keep apart") : tr("Keep as it is"), std::move(after), -1);
}

void Document::wallAt(int index) {
  const FoundLeak found = leaks().at(static_cast<std::size_t>(index));
  Edits after = d_->active->edits();
  after.constraints.walls.discs.push_back(found.leak.disc);
  if (!d_->mayChange()) return;
  goTo(found.before);
  d_->push(tr("Wall here"), std::move(after), -1);
}

void Document::allow(const HeldPlace& held) {
  Edits after = d_->active->edits();
  std::vector<Veto>& vetoes = after.constraints.vetoes;
  const auto distance = [&](const Veto& v) {
    return v.iteration == held.iteration ? (v.place - held.place).norm() : 1e300;
  };
  const auto nearest = std::min_element(
      vetoes.begin(), vetoes.end(), [&](const Veto& a, const Veto& b) { return distance(a) < distance(b); });
  if (!held.isVetoed)
    after.constraints.topology.allowed.push_back(held.place);
  else if (nearest != vetoes.end())
    vetoes.erase(nearest);
  d_->push(tr("Let it happen"), std::move(after), -1);
}

}  // namespace handlebody::ui
