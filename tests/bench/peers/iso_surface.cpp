#include "tests/bench/peers/iso_surface.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace handlebody::bench {

namespace {

//! With one layer of positive values around, so that the surface is closed.
void fillPadded(vtkImageData& image, const std::vector<float>& field, const std::array<int, 3>& n) {
  image.SetDimensions(n[0] + 2, n[1] + 2, n[2] + 2);
  image.AllocateScalars(VTK_FLOAT, 1);
  auto* out = static_cast<float*>(image.GetScalarPointer());
  const float* in = field.data();
  for (int k = -1; k <= n[2]; ++k)
    for (int j = -1; j <= n[1]; ++j)
      for (int i = -1; i <= n[0]; ++i) {
        const bool inside = i >= 0 && j >= 0 && k >= 0 && i < n[0] && j < n[1] && k < n[2];
        *out++ = inside ? *in++ : 0.5f;
      }
}

}  // namespace

TriangleSoup isoSurface(const std::vector<float>& field, const Grid& grid) {
  vtkNew<vtkImageData> image;
  fillPadded(*image, field, grid.size);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0.0);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  vtkPolyData* surface = edges->GetOutput();
  TriangleSoup soup;
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p) {
    const double* x = surface->GetPoint(p);
    soup.points.push_back(grid.toWorld(Vec3(x[0] - 1, x[1] - 1, x[2] - 1)));
  }
  const auto it = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(count, ids);
    soup.triangles.push_back({static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2])});
  }
  return soup;
}

}  // namespace handlebody::bench
