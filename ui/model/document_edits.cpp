// Edits of the mesh by hand, each a step of the growth (core/evolution/mesh_edit.h).

#include <algorithm>

#include "ui/model/document_private.h"

namespace handlebody::ui {

namespace {

QString nameOf(const MeshEdit& edit) {
  switch (edit.kind) {
    case MeshEditKind::removeComponent:
      return Document::tr("Remove component");
    case MeshEditKind::keepComponent:
      return Document::tr("Keep only one component");
    case MeshEditKind::fillCavity:
      return Document::tr("Fill cavity");
    case MeshEditKind::smooth:
      return Document::tr("Smooth here");
    case MeshEditKind::pull:
      return Document::tr("Pull here");
    case MeshEditKind::cut:
      return Document::tr("Cut here");
    default:
      return edit.cut == TunnelCut::handle   ? Document::tr("Cut handle")
             : edit.cut == TunnelCut::tunnel ? Document::tr("Fill tunnel")
                                             : Document::tr("Close tunnel");
  }
}

}  // namespace

void Document::editMesh(MeshEdit edit) {
  if (iteration() < 0 || state() == GrowthState::running || state() == GrowthState::preparing) return;
  edit.iteration = iteration() + 1;
  Edits after = d_->active().edits();
  // Those of later steps were of a surface that is not there any more.
  std::erase_if(after.constraints.edits, [&](const MeshEdit& e) { return e.iteration >= edit.iteration; });
  std::erase_if(after.constraints.vetoes, [&](const Veto& v) { return v.iteration == edit.iteration; });
  after.constraints.edits.push_back(edit);
  d_->push(nameOf(edit), std::move(after), -1);
}

void Document::leaveOutEdit(int iteration) {
  Edits after = d_->active().edits();
  const auto removed =
      std::erase_if(after.constraints.edits, [&](const MeshEdit& e) { return e.iteration == iteration; });
  if (removed == 0 || !d_->mayChange()) return;
  if (this->iteration() >= iteration) goTo(iteration - 1);
  d_->push(tr("Leave out an edit"), std::move(after), -1);
}

void Document::Private::edited(const ObjectWork& object) {
  journalNow();
  if (&object == &active()) Q_EMIT q.meshEdited();
}

void Document::Private::editRefused(ObjectWork& object, const MeshEdit& edit, const QString& why) {
  takeOut(object, edit);
  if (&object != &active()) object.beHidden();  // nothing is to be prepared for it now
  Q_EMIT q.refused(why);
}

//! Nothing of it stays, not even an entry to do it again; what was done meanwhile stays.
void Document::Private::takeOut(ObjectWork& object, const MeshEdit& edit) {
  Edits left = withoutEdit(object.edits(), edit);
  EditCommand* made = nullptr;
  for (int i = undo.count() - 1, later = 0; i >= 0 && !made; --i) {
    auto* command = const_cast<EditCommand*>(dynamic_cast<const EditCommand*>(undo.command(i)));
    if (!command || !command->isOf(object)) continue;
    if (i < undo.index() && holds(command->after(), edit) && !holds(command->before(), edit)) {
      made = command;
      if (later == 0) left = command->before();
      if (undo.cleanIndex() > i) undo.resetClean();  // it was saved
    } else {
      command->leaveOut(edit);
      ++later;
    }
  }
  ++edits;
  object.apply(left, EditCommand::Way::undo);
  if (made) made->setObsolete(true);
  dropObsolete();
}

//! What is left of edits that were refused: an entry that does nothing.
void Document::Private::dropObsolete() {
  while (undo.index() > 0 && undo.command(undo.index() - 1)->isObsolete())
    undo.undo();  // takes one that is obsolete from the list, and does no more
}

}  // namespace handlebody::ui
