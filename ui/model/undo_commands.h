#pragma once
// What can be undone: seeds, parameters and constraints, as they were before and after.

#include <QUndoCommand>
#include <functional>
#include <vector>

#include "core/evolution/parameters.h"

namespace handlebody::ui {

//! Everything that undo restores.
struct Edits {
  std::vector<Seed> seeds;
  Parameters parameters;
  Constraints constraints{};
  Request request() const { return {seeds, parameters, constraints}; }
  int selectedSeed = -1;
};

class EditCommand : public QUndoCommand {
 public:
  enum class Way { undo, redo };
  using Apply = std::function<void(const Edits&, Way)>;

  //! Calls of one gesture (>= 0) with the same text merge.
  EditCommand(const QString& text, Edits before, Edits after, int gesture, Apply apply);

  int id() const override;
  bool mergeWith(const QUndoCommand* other) override;
  void undo() override { apply_(before_, Way::undo); }
  void redo() override { apply_(after_, Way::redo); }

 private:
  Edits before_, after_;
  int gesture_;
  Apply apply_;
};

}  // namespace handlebody::ui
