#pragma once
// Internal: the outlines of the objects that are not active in a slice, and how the active one is drawn among
// them.

#include <QColor>
#include <QPainter>
#include <array>
#include <memory>
#include <vector>

#include "ui/view/slice_geometry.h"

namespace handlebody::ui {

class Document;
struct MeshSnapshot;

QColor colourOf(const Document& document, int object);
//! Of the active object's outline and surface; `alone` where there is no other and it has the colour that an
//! object has at first. Pale where what is shown is out of date.
QColor activeColour(const Document& document, const QColor& alone);
bool isActiveVisible(const Document& document);
//! A line over a darker and wider one, seen on any ground.
void paintSegments(QPainter& painter, const QVector<QLineF>& lines, const QColor& colour, double width);

//! Cuts a mesh only where it or the slice has changed.
class OtherOutlines {
 public:
  void paint(QPainter& painter, const Document& document, const SliceGeometry& geometry);

 private:
  struct Cut {
    std::shared_ptr<const MeshSnapshot> mesh;
    int slice = -1;
    std::vector<std::array<Vec3, 2>> section;  // mm
  };
  std::vector<Cut> cuts_;  // one per object
};

//! The height over the origin, along the normal, of the slice that is shown; mm.
double offsetOf(const SliceGeometry& geometry);

}  // namespace handlebody::ui
