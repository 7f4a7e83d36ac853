#include "ui/model/undo_commands.h"

namespace handlebody::ui {

namespace {
constexpr int kEdit = 1, kList = 2;  // the kinds of commands that merge
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
