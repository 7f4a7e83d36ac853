#pragma once
// The tool that places points to measure, and what it shows besides rulers and angles: a centre line. All
// views share it, so that a ruler may begin in one of them and end in another.

#include <QObject>
#include <optional>
#include <vector>

#include "core/geometry/vec.h"
#include "core/measure/measurement.h"

namespace handlebody::ui {

class Measurements;

class MeasureTool : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  enum class Mode { off, ruler, angle, centreLine };

  Mode mode() const { return mode_; }
  bool isOn() const { return mode_ != Mode::off; }
  //! Points that were placed before are forgotten.
  void setMode(Mode mode);

  //! The next point, mm LPS. With the last of a ruler or an angle that is added to `measurements`, with that
  //! of a centre line lineAsked() tells; the tool is off then. Precondition: isOn().
  void place(const Vec3& point, Measurements& measurements);
  const std::vector<Vec3>& placed() const { return placed_; }
  //! Where the next point would be placed now; none: the mouse is nowhere.
  const std::optional<Vec3>& pointer() const { return pointer_; }
  void setPointer(const std::optional<Vec3>& point);
  //! The last point that was placed is taken back, or the tool is off if there is none.
  void stepBack();

  //! A line inside of an object, and a place on it that is pointed at with the circle of its section.
  struct Marker {
    Vec3 place{0, 0, 0}, direction{0, 0, 1};
    double radius = 0;  //!< mm
    bool operator==(const Marker&) const = default;
  };
  const std::vector<Vec3>& line() const { return line_; }
  void setLine(const std::vector<Vec3>& line);
  const std::optional<Marker>& marker() const { return marker_; }
  void setMarker(const std::optional<Marker>& marker);

  //! Off, with nothing placed or shown.
  void reset();

 Q_SIGNALS:
  void changed();  //!< anything
  void modeChanged();
  void lineAsked(const handlebody::Vec3& from, const handlebody::Vec3& to);

 private:
  Mode mode_ = Mode::off;
  std::vector<Vec3> placed_;
  std::optional<Vec3> pointer_;
  std::vector<Vec3> line_;
  std::optional<Marker> marker_;
};

}  // namespace handlebody::ui
