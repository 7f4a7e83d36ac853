#pragma once
// Internal: triangles as VTK draws them, refilled without new objects when they change at every step.

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <QColor>
#include <array>
#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody::ui {

class TriangleActor {
 public:
  TriangleActor();

  //! `smooth`: shaded with normals at the points (means by area, outward as the triangles are wound); else
  //! every triangle has its own.
  void setMesh(const TriangleSoup& mesh, bool smooth);
  //! Separate triangles, shaded flat.
  void setFaces(const std::vector<std::array<Vec3, 3>>& faces);
  //! One colour for all triangles.
  void setColour(const QColor& colour);
  //! One colour per triangle.
  void setColours(const std::vector<QColor>& palette, const unsigned char* entries, std::size_t count);
  void setEdges(bool visible);
  //! Where triangles of several actors lie in one place these are seen.
  void setInFront();
  vtkActor* actor() const { return actor_; }

 private:
  void setNormals(const TriangleSoup& mesh);
  void setCells(const std::vector<Triangle>& triangles);

  vtkNew<vtkFloatArray> points_, normals_;
  vtkNew<vtkTypeInt32Array> corners_, offsets_;
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}  // namespace handlebody::ui
