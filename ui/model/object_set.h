#pragma once
// The objects of the open work, in their order, and which of them is active.

#include <memory>
#include <vector>

#include "core/io/meshes/exported_object.h"
#include "ui/model/object_work.h"

namespace handlebody::ui {

//! Shares its objects with the undo commands: those that are in no list any more live on in them. Owned by
//! the document; GUI thread. Tells nobody of a change: its owner does. Once it was filled (hold) it holds one
//! object at least, and the active one is among them.
class ObjectSet {
 public:
  using Object = std::shared_ptr<ObjectWork>;

  //! These and no others. Precondition: `active` is one of them.
  void hold(std::vector<Object> all, Object active);
  //! Behind the others.
  void add(Object object) { all_.push_back(std::move(object)); }
  //! Precondition: one of them.
  void activate(Object object) { active_ = std::move(object); }

  const std::vector<Object>& all() const { return all_; }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  std::size_t size() const { return all_.size(); }
  const Object& operator[](std::size_t index) const { return all_[index]; }
  //! Throws std::out_of_range.
  ObjectWork& at(int index) const { return *all_.at(static_cast<std::size_t>(index)); }
  const Object& active() const { return active_; }
  //! -1: it is not among them.
  int indexOf(const ObjectWork& object) const;
  //! Those after it; none if it is not among them.
  std::vector<Object> after(const ObjectWork& object) const;
  //! With what they are called, to be undone.
  ObjectList list() const;
  std::vector<ObjectLabel> labels() const;

  //! Something is grown, or is going to be.
  bool isGrown() const;
  //! One of them has a seed.
  bool isSeeded() const;
  bool isAsSaved() const;

  //! The surfaces of those before it: walls for it. Of one that is not among them: of all.
  std::vector<FinishedWall> wallsFor(const ObjectWork& object) const;
  //! True while one of those before it still grows.
  bool mustWait(const ObjectWork& object) const;
  //! The first of those before it whose surface was another one when it was grown, or that was not among
  //! them, or is no more; empty: its surface is made with those that there are.
  QString madeWithEarlier(const ObjectWork& object) const;

 private:
  std::vector<Object> all_;
  Object active_;
};

}  // namespace handlebody::ui
