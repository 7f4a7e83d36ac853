#pragma once
// What the four views share: crosshair, window and level, colour map, what is shown. One object, so that
// linked views cannot disagree.

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/evolution/parameters.h"
#include "core/geometry/vec.h"
#include "core/volume/anatomy.h"
#include "core/volume/volume.h"
#include "ui/view/brush.h"
#include "ui/view/measure_tool.h"

namespace handlebody::ui {

//! Slices run along the volume's own axes; each is named after the nearest anatomical plane.
using Plane = AnatomicalPlane;

enum class ColourMap { grey, inverted, hot, contrast };
enum class MeshColouring { plain, edges, state, support };

//! A closed loop on the surface that was pointed out, mm LPS.
struct MarkedLoop {
  //! Around a handle, or round a tunnel: each has a colour (loopColour, overlay.h).
  enum class Kind { handle, tunnel };
  Kind kind = Kind::handle;
  std::vector<Vec3> points;
  bool operator==(const MarkedLoop&) const = default;
};

//! Voxels of an object: as the surface is driven into it, smoothed, with its levels, necks and walls. As long
//! as that is not known, the voxels in a range of intensities.
struct Tint {
  std::shared_ptr<const ObjectImage> object;
  IntensityRange range{};
  bool operator==(const Tint&) const = default;
};

struct DistanceColours;
//! Who colours the surface by distances.
enum class DistancesOf { comparison, sensitivity };

class ViewState : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  const Vec3& crosshair() const { return crosshair_; }  //!< mm LPS
  void setCrosshair(const Vec3& world);
  double window() const { return window_; }  //!< intensity units, > 0
  double level() const { return level_; }
  //! Ignored where one is not finite, or the window not above zero; else brought within what a picture can be
  //! made with in single precision.
  void setWindowLevel(double window, double level);
  //! From the 0.1 to the 99.9 percentile of the volume; takes milliseconds for a volume of any size.
  void setAutomaticWindow(const Volume& volume);
  //! For a volume that was just opened: crosshair in its middle, automatic window, no tint, no brush. The
  //! views do not call it, so that a session may restore its own state.
  void startWith(const Volume& volume);
  //! While on, dragging with the left button in a slice changes window and level (key W in a slice).
  bool windowLevelTool() const { return windowLevelTool_; }
  void setWindowLevelTool(bool on);
  ColourMap colourMap() const { return colourMap_; }
  void setColourMap(ColourMap map);
  MeshColouring meshColouring() const { return meshColouring_; }
  void setMeshColouring(MeshColouring colouring);
  bool slicesIn3d() const { return slicesIn3d_; }
  void setSlicesIn3d(bool on);
  //! Walls and pins are drawn.
  bool showsConstraints() const { return showsConstraints_; }
  void setShowsConstraints(bool on);
  //! What is tinted on the slices; none: no tint.
  const std::optional<Tint>& tint() const { return tint_; }
  void setTint(std::optional<Tint> tint);

  Brush& brush() { return brush_; }
  const Brush& brush() const { return brush_; }
  MeasureTool& measure() { return measure_; }
  const MeasureTool& measure() const { return measure_; }

  //! Loops of the shown surface that are drawn over it; none at first.
  const std::vector<MarkedLoop>& markedLoops() const { return markedLoops_; }
  void markLoops(const std::vector<MarkedLoop>& loops);

  //! Drawn on the surface that they are of, in place of the colours of meshColouring(): what was set last and
  //! was not taken away; null: none.
  std::shared_ptr<const DistanceColours> distances() const;
  //! Null takes away what that one has set; what another one has set stays, or is seen again.
  void setDistances(DistancesOf whose, std::shared_ptr<const DistanceColours> colours);

  //! A number for Document::moveSeed() and its like that no other drag has.
  static int nextGesture();

 Q_SIGNALS:
  void crosshairChanged();
  void markedLoopsChanged();
  void distancesChanged();
  void changed();  //!< anything else

 private:
  template <typename T>
  void change(T& member, const T& value);

  Vec3 crosshair_{0, 0, 0};
  double window_ = 1;
  double level_ = 0;
  bool windowLevelTool_ = false;
  ColourMap colourMap_ = ColourMap::grey;
  MeshColouring meshColouring_ = MeshColouring::plain;
  bool slicesIn3d_ = true;
  bool showsConstraints_ = true;
  std::optional<Tint> tint_;
  std::vector<MarkedLoop> markedLoops_;
  std::vector<std::pair<DistancesOf, std::shared_ptr<const DistanceColours>>> distances_;  //!< the last: seen
  Brush brush_;
  MeasureTool measure_;
};

}  // namespace handlebody::ui
