#pragma once
// Internal: what the brush does from where it is put down to where it is lifted, in slices and in 3D alike.

#include "core/geometry/vec.h"

namespace handlebody::ui {

class Brush;
class Document;

//! There is a surface of the active object that may be pinned: at rest, and the object is not locked.
bool mayBePinned(const Document& document);
//! And it bounds a body, so that it may be edited.
bool mayBeEdited(const Document& document);

class BrushHand {
 public:
  BrushHand(Document& document, Brush& brush) : document_(document), brush_(brush) {}

  //! What the brush is on for can be done now; false where it is off.
  bool isReady() const;
  bool isDown() const { return isDown_; }
  //! All places are mm LPS. `pointer`: where the mouse is, if that is not at the place: a pull keeps the
  //! distance. `sight`: across the slice, a unit vector; a cut lies along it. Precondition: isReady(); for a
  //! pull the place lies on the surface.
  void press(const Vec3& place, const Vec3& pointer, const Vec3& sight = Vec3::Zero());
  //! `joined`: with what lies between.
  void drawTo(const Vec3& pointer, bool joined = true);
  //! Only now is anything done: one entry of the undo list.
  void lift();
  //! Nothing is kept.
  void giveUp();

 private:
  void edit(const Vec3& place) const;
  void pull() const;
  void cut(const Vec3& from, const Vec3& to) const;

  Document& document_;
  Brush& brush_;
  bool isDown_ = false;
  Vec3 offset_{0, 0, 0};  // from the mouse to what it has hold of
  Vec3 sight_{0, 0, 0};
};

}  // namespace handlebody::ui
