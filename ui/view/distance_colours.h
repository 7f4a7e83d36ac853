#pragma once
// Distances of a surface from a reference, as colours of its faces.

#include <QColor>
#include <QPainter>
#include <QString>
#include <memory>
#include <vector>

#include "ui/model/document.h"

namespace handlebody::ui {

struct DistanceColours {
  std::shared_ptr<const MeshSnapshot> mesh;  //!< whose faces are coloured
  std::vector<double> ofFace;                //!< mm; negative inside of the reference
  bool isSigned = true;                      //!< false: the reference has no inside, all are positive
  double end = 1;                            //!< mm, of the scale: what is farther has its last colour
  QString title{};                           //!< over the scale; empty: none
};

//! From the distances of the mesh's points. The scale ends at a round number that 98 % of the faces are not
//! beyond.
DistanceColours distanceColours(std::shared_ptr<const MeshSnapshot> mesh, const std::vector<double>& ofPoint,
                                bool isSigned);

//! 256 colours: blue inside, white at the surface, red outside; without a sign from white to red.
const std::vector<QColor>& distancePalette(bool isSigned);
//! Index into the palette of every face.
std::vector<unsigned char> paletteEntries(const DistanceColours& colours);

//! The scale with its mm at the right edge of a view.
void paintDistanceScale(QPainter& painter, const QSizeF& size, const DistanceColours& colours);

}  // namespace handlebody::ui
