#pragma once
// What can be undone: seeds, parameters and constraints of an object, as they were before and after; and
// which objects there are, in which order, and how they are called.

#include <QUndoCommand>
#include <functional>
#include <memory>
#include <vector>

#include "core/evolution/parameters.h"
#include "core/io/meshes/exported_object.h"

namespace handlebody::ui {

//! Everything that undo restores.
struct Edits {
  std::vector<Seed> seeds;
  Parameters parameters;
  Constraints constraints{};
  Request request() const { return {seeds, parameters, constraints}; }
  int selectedSeed = -1;
};

bool holds(const Edits& edits, const MeshEdit& edit);
Edits withoutEdit(Edits edits, const MeshEdit& edit);

class ObjectWork;

class EditCommand : public QUndoCommand {
 public:
  enum class Way { undo, redo };
  using Apply = std::function<void(const Edits&, Way)>;

  //! Calls of one gesture (>= 0) with the same text merge if they change the same `object`.
  EditCommand(const QString& text, std::shared_ptr<const ObjectWork> object, Edits before, Edits after,
              int gesture, Apply apply);

  int id() const override;
  bool mergeWith(const QUndoCommand* other) override;
  void undo() override { apply_(before_, Way::undo); }
  void redo() override { apply_(after_, Way::redo); }
  const Edits& after() const { return after_; }
  const Edits& before() const { return before_; }
  bool isOf(const ObjectWork& object) const { return object_.get() == &object; }
  //! What it holds is without that edit from now on.
  void leaveOut(const MeshEdit& edit);

 private:
  std::shared_ptr<const ObjectWork> object_;
  Edits before_, after_;
  int gesture_;
  Apply apply_;
};

//! How an object is called, and how it is treated.
struct ObjectTraits {
  ObjectLabel label;
  bool visible = true;
  bool locked = false;
  friend bool operator==(const ObjectTraits&, const ObjectTraits&) = default;
};

//! The objects in their order. Those that are in no list any more live on in the commands that took them out.
struct ObjectList {
  struct Entry {
    std::shared_ptr<ObjectWork> object;
    ObjectTraits traits;
    bool operator==(const Entry&) const = default;
  };
  std::vector<Entry> entries;
  std::shared_ptr<ObjectWork> active;
};

class ListCommand : public QUndoCommand {
 public:
  using Apply = std::function<void(const ObjectList&)>;

  ListCommand(const QString& text, ObjectList before, ObjectList after, int gesture, Apply apply);

  int id() const override;
  bool mergeWith(const QUndoCommand* other) override;
  void undo() override { apply_(before_); }
  void redo() override { apply_(after_); }

 private:
  ObjectList before_, after_;
  int gesture_;
  Apply apply_;
};

}  // namespace handlebody::ui
