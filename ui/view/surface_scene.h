#pragma once
// Internal: what the 3D view shows, as VTK actors, and its camera. Millimetres LPS throughout.

#include <QColor>
#include <QImage>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/evolution/image_warnings.h"
#include "core/evolution/parameters.h"
#include "core/surgery/event.h"
#include "core/volume/volume.h"
#include "ui/view/pinned_surface.h"
#include "ui/view/surface_view.h"

class vtkRenderer;

namespace handlebody::ui {

struct MeshSnapshot;

QColor plainMaterial();             //!< of a mesh without other colours
QColor faceStateColour(int state);  //!< of a FaceState
QColor faceSupportColour(FaceSupport support);

//! A ball about what is to be seen.
struct Sight {
  Vec3 centre{0, 0, 0};
  double radius = 1;
};
std::optional<Sight> sightOf(const std::vector<Vec3>& points);
//! Points of all parts of a trace that have to do with its place.
std::optional<Sight> sightOf(const EventTrace& trace);

//! Parallel projection: lengths across the view are the same at any depth, so that a scale bar is true.
struct CameraPose {
  Vec3 focus{0, 0, 0}, towardsEye{0, -1, 0}, up{0, 0, 1};  //!< the last two of length 1
  double height = 1;                                       //!< mm that the view is high
};
//! What a session keeps of the camera.
struct StandingCamera {
  CameraPose pose{};
  bool follows = true;  //!< the mesh: it was not moved by hand
};
//! Half way and so on from one pose to another, for a flight; share 0 … 1.
CameraPose between(const CameraPose& from, const CameraPose& to, double share);
//! From superior (axial), anterior (coronal) or left (sagittal), or from the other side.
CameraPose lookingFrom(const CameraPose& pose, Plane plane, bool opposite);
//! From the front, the left and above, as in the pictures of the command line.
CameraPose obliquePose();
//! The pose moved so that all of the volume is just in a view of this width per height.
CameraPose around(const Grid& grid, CameraPose pose, double aspect);
//! A direction from which fronts do not hide each other: across the line between the first two polygons.
Vec3 acrossFronts(const EventTrace& trace, const Vec3& towardsEye);

class SurfaceScene {
 public:
  explicit SurfaceScene(vtkRenderer* renderer);
  ~SurfaceScene();

  //! Null: no mesh. `material`: its colour where `colouring` gives none.
  void setMesh(const MeshSnapshot* mesh, MeshColouring colouring, const QColor& material = plainMaterial());
  //! Other colours for the faces of the mesh, as indices into a palette, until it is set anew.
  void colourFaces(const std::vector<QColor>& palette, const std::vector<unsigned char>& entries);
  //! Surfaces besides the mesh, each in one colour.
  struct Other {
    std::shared_ptr<const MeshSnapshot> mesh;
    QColor colour;
  };
  void setOthers(const std::vector<Other>& others);
  //! Balls, and crosses in place of those outside of the object; all with radii; empty: none are shown.
  void setSeeds(const std::vector<Seed>& seeds);
  //! Translucent; where it is empty there are none.
  void setWalls(const TriangleSoup& walls);
  //! Faces of the mesh that the pins hold, one entry per triangle of it; empty: none.
  void setPinned(const TriangleSoup& mesh, const std::vector<PinnedSurface::Part>& parts);
  //! Seen through the surface.
  void setLoops(const std::vector<MarkedLoop>& loops);
  //! The volume's edges; null: none.
  void setVolume(const Grid* grid);
  //! A picture whose corners (upper left, upper right, lower left) lie at world points.
  void setSlice(Plane plane, const QImage& picture, const std::array<Vec3, 3>& corners);
  void showSlices(bool on);
  //! Instead of mesh and seeds; EventStage::none: these again.
  void showStage(const EventTrace& trace, EventStage stage);

  //! Device pixels per logical one: lines and points keep their width.
  void setPixelRatio(double ratio);
  CameraPose pose() const;
  void setPose(const CameraPose& pose);
  //! Keeps all that is shown between the clipping planes; before every rendering.
  void fitDepth();

 private:
  struct Private;
  std::unique_ptr<Private> d_;
};

}  // namespace handlebody::ui
