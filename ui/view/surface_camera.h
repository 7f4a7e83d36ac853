#pragma once
// Internal: how the camera of the 3D view moves by itself: its flights, and that it follows the mesh.

#include <QObject>
#include <QVariantAnimation>
#include <optional>

#include "ui/view/surface_scene.h"

class QWidget;

namespace handlebody::ui {

class Document;

//! Before there is a scene only startVolume(), stand(), standing() and setFlightTime() may be called.
class SurfaceCamera : public QObject {
  Q_OBJECT

 public:
  //! `view` is what the pictures are for.
  explicit SurfaceCamera(const QWidget& view);

  //! Once.
  void setScene(SurfaceScene& scene) { scene_ = &scene; }
  //! Another volume was opened, or none (null): all of it, unless stand() has asked for something else.
  void startVolume(const Grid* grid);

  CameraPose pose() const { return scene_->pose(); }
  //! The pose, or where it flies to.
  CameraPose destination() const;
  void flyTo(const CameraPose& pose);
  //! Of flights, ms; 0: it jumps; below 0: the style's.
  void setFlightTime(int ms) { flightTime_ = ms; }
  //! A hand moves it: it does not follow the mesh any more.
  void takeInHand();
  //! Nearer by this factor.
  void zoom(double factor);
  //! Flies after the mesh if it leaves the view or is lost in it, unless a hand has moved the camera.
  void follow(const Document& document);
  //! Flies to where all of the mesh is seen, or of the volume; follows the mesh from now on.
  void seeAll(const Document& document);

  //! It may be asked for before there is a scene.
  void stand(const StandingCamera& camera);
  std::optional<StandingCamera> standing() const;
  bool follows() const { return follows_; }

  //! mm that a view is high in which a ball has this margin.
  double heightFor(const Sight& sight, double margin) const;

 Q_SIGNALS:
  void moved();
  //! A flight has ended.
  void arrived();

 private:
  bool isFlying() const { return flight_.state() == QAbstractAnimation::Running; }
  double aspect() const;

  const QWidget& view_;
  SurfaceScene* scene_ = nullptr;
  bool follows_ = true;
  std::optional<StandingCamera> wanted_;  // asked for before there was a scene
  QVariantAnimation flight_;
  CameraPose from_, to_;
  int flightTime_ = -1;
};

}  // namespace handlebody::ui
