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

// Nothing of it stays, not even an entry to do it again.
void Document::Private::editRefused(const ObjectWork& object, const Request& asked, const QString& why) {
  const auto* last = dynamic_cast<const EditCommand*>(undo.command(undo.index() - 1));
  if (&object == &active() && last && last->after().request() == asked) {
    auto* command = const_cast<EditCommand*>(last);
    command->undo();
    command->setObsolete(true);
    undo.undo();  // takes one that is obsolete from the list, and does no more
  }
  Q_EMIT q.refused(why);
}

}  // namespace handlebody::ui
