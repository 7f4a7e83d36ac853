#include "ui/model/undo_commands.h"

#include <algorithm>

namespace handlebody::ui {

namespace {
constexpr int kEdit = 1, kList = 2;  // the kinds of commands that merge
}

bool holds(const Edits& edits, const MeshEdit& edit) {
  const std::vector<MeshEdit>& all = edits.constraints.edits;
  return std::find(all.begin(), all.end(), edit) != all.end();
}

Edits withoutEdit(Edits edits, const MeshEdit& edit) {
  std::erase(edits.constraints.edits, edit);
  return edits;
}

EditCommand::EditCommand(const QString& text, std::shared_ptr<const ObjectWork> object, Edits before,
                         Edits after, int gesture, Apply apply)
    : QUndoCommand(text),
      object_(std::move(object)),
      before_(std::move(before)),
      after_(std::move(after)),
      gesture_(gesture),
      apply_(std::move(apply)) {}

int EditCommand::id() const { return gesture_ < 0 ? -1 : kEdit; }

bool EditCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const EditCommand*>(other);  // the same id: the same class
  if (next->object_ != object_ || next->gesture_ != gesture_ || next->text() != text()) return false;
  after_ = next->after_;
  return true;
}

void EditCommand::leaveOut(const MeshEdit& edit) {
  before_ = withoutEdit(std::move(before_), edit);
  after_ = withoutEdit(std::move(after_), edit);
}

ListCommand::ListCommand(const QString& text, ObjectList before, ObjectList after, int gesture, Apply apply)
    : QUndoCommand(text),
      before_(std::move(before)),
      after_(std::move(after)),
      gesture_(gesture),
      apply_(std::move(apply)) {}

int ListCommand::id() const { return gesture_ < 0 ? -1 : kList; }

bool ListCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const ListCommand*>(other);
  if (next->gesture_ != gesture_ || next->text() != text()) return false;
  after_ = next->after_;
  return true;
}

}  // namespace handlebody::ui
