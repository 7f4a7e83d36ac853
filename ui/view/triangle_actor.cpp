#include "ui/view/triangle_actor.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <Eigen/Geometry>

namespace handlebody::ui {
namespace {

vtkIdType countOf(std::size_t n) { return static_cast<vtkIdType>(n); }

}  // namespace

TriangleActor::TriangleActor() {
  points_->SetNumberOfComponents(3);
  normals_->SetNumberOfComponents(3);
  colours_->SetNumberOfComponents(3);
  vtkNew<vtkPoints> points;
  points->SetData(points_);
  data_->SetPoints(points);
  data_->SetPolys(vtkNew<vtkCellArray>());
  mapper_->SetInputData(data_);
  mapper_->ScalarVisibilityOff();
  mapper_->SetScalarModeToUseCellData();
  mapper_->SetColorModeToDirectScalars();
  actor_->SetMapper(mapper_);
  vtkProperty* property = actor_->GetProperty();
  property->SetAmbient(0.18);
  property->SetDiffuse(0.82);
  property->SetSpecular(0.16);
  property->SetSpecularPower(24);
  property->SetEdgeColor(0.34, 0.29, 0.22);
  property->SetLineWidth(1);
}

void TriangleActor::setMesh(const TriangleSoup& mesh, bool smooth) {
  points_->SetNumberOfTuples(countOf(mesh.points.size()));
  float* out = points_->GetPointer(0);
  for (const Vec3& p : mesh.points)
    for (int a = 0; a < 3; ++a) *out++ = static_cast<float>(p[a]);
  setCells(mesh.triangles);
  if (smooth)
    setNormals(mesh);
  else
    data_->GetPointData()->SetNormals(nullptr);
  points_->Modified();
  data_->GetPoints()->Modified();
  data_->Modified();
}

void TriangleActor::setNormals(const TriangleSoup& mesh) {
  std::vector<Vec3> sums(mesh.points.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.points[t[0]];
    const Vec3 area = (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a);
    for (int v : t) sums[v] += area;
  }
  normals_->SetNumberOfTuples(countOf(sums.size()));
  float* out = normals_->GetPointer(0);
  for (const Vec3& sum : sums) {
    const Vec3 normal = sum.normalized();
    for (int a = 0; a < 3; ++a) *out++ = static_cast<float>(normal[a]);
  }
  normals_->Modified();
  data_->GetPointData()->SetNormals(normals_);
}

void TriangleActor::setCells(const std::vector<Triangle>& triangles) {
  corners_->SetNumberOfValues(countOf(3 * triangles.size()));
  offsets_->SetNumberOfValues(countOf(triangles.size() + 1));
  vtkTypeInt32 *corner = corners_->GetPointer(0), *offset = offsets_->GetPointer(0);
  *offset++ = 0;
  for (const Triangle& t : triangles) {
    for (int v : t) *corner++ = v;
    *offset = offset[-1] + 3;
    ++offset;
  }
  corners_->Modified();
  offsets_->Modified();
  data_->GetPolys()->SetData(offsets_, corners_);
  data_->GetPolys()->Modified();
}

void TriangleActor::setFaces(const std::vector<std::array<Vec3, 3>>& faces) {
  TriangleSoup soup;
  for (const auto& face : faces) {
    const int first = static_cast<int>(soup.points.size());
    soup.points.insert(soup.points.end(), face.begin(), face.end());
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  setMesh(soup, false);
}

void TriangleActor::setColour(const QColor& colour) {
  mapper_->ScalarVisibilityOff();
  actor_->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

void TriangleActor::setColours(const std::vector<QColor>& palette, const unsigned char* entries,
                               std::size_t count) {
  colours_->SetNumberOfTuples(countOf(count));
  unsigned char* out = colours_->GetPointer(0);
  for (std::size_t i = 0; i < count; ++i) {
    const QColor& colour = palette[entries[i]];
    for (int channel : {colour.red(), colour.green(), colour.blue()})
      *out++ = static_cast<unsigned char>(channel);
  }
  colours_->Modified();
  data_->GetCellData()->SetScalars(colours_);
  data_->Modified();
  mapper_->ScalarVisibilityOn();
}

void TriangleActor::setEdges(bool visible) { actor_->GetProperty()->SetEdgeVisibility(visible ? 1 : 0); }

void TriangleActor::setInFront() {
  mapper_->SetResolveCoincidentTopologyToPolygonOffset();
  mapper_->SetRelativeCoincidentTopologyPolygonOffsetParameters(-1, -2);
}

}  // namespace handlebody::ui
