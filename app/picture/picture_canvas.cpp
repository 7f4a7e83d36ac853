#include "app/picture/picture_canvas.h"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "core/indices.h"
#include "core/volume/anatomy.h"

namespace handlebody {

Canvas::Canvas(int width, int height, const Colour& background)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), background) {}

void Canvas::blend(int x, int y, const Colour& colour, double opacity) {
  if (!area().contains(x, y)) return;
  Colour& pixel = at(x, y);
  pixel += static_cast<float>(opacity) * (colour - pixel);
}

void Canvas::fill(const Rect& rect, const Colour& colour, double opacity) {
  for (int y = rect.y; y < rect.bottom(); ++y)
    for (int x = rect.x; x < rect.right(); ++x) blend(x, y, colour, opacity);
}

LineDrawing::LineDrawing(const Rect& area, double width)
    : area_(area),
      reach_(width / 2),
      coverage_(static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height), 0.0F) {}

void LineDrawing::add(const Vec2& from, const Vec2& to) {
  const double margin = reach_ + 1;
  const Vec2 low = from.cwiseMin(to).array() - margin, high = from.cwiseMax(to).array() + margin;
  // Clamped before they become integers: a line may end far outside.
  const auto pixel = [](double at, int first, int last) {
    return static_cast<int>(
        std::clamp(std::floor(at), static_cast<double>(first), static_cast<double>(last)));
  };
  const int x0 = pixel(low.x(), area_.x, area_.right()), x1 = pixel(high.x() + 1, area_.x, area_.right());
  const int y0 = pixel(low.y(), area_.y, area_.bottom()), y1 = pixel(high.y() + 1, area_.y, area_.bottom());
  const Vec2 along = to - from;
  const double length2 = along.squaredNorm();
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const Vec2 p = Vec2(x + 0.5, y + 0.5) - from;
      const double t = length2 > 0 ? std::clamp(p.dot(along) / length2, 0.0, 1.0) : 0.0;
      const double covered = std::clamp(reach_ + 0.5 - (p - t * along).norm(), 0.0, 1.0);
      float& most = coverage_[idx(y - area_.y) * idx(area_.width) + idx(x - area_.x)];
      most = std::max(most, static_cast<float>(covered));
    }
}

void LineDrawing::paint(Canvas& canvas, const Colour& colour, double opacity) const {
  auto covered = coverage_.begin();
  for (int y = area_.y; y < area_.bottom(); ++y)
    for (int x = area_.x; x < area_.right(); ++x, ++covered)
      if (*covered > 0) canvas.blend(x, y, colour, opacity * static_cast<double>(*covered));
}

namespace {

const Colour kRim(0.0F, 0.0F, 0.0F);
const Colour kBar(0.92F, 0.94F, 0.96F);

//! Calls f(x, y, opacity) for the pixels of the text, in canvas coordinates.
template <typename F>
void forEachTextPixel(vtkImageData* image, const Vec2& anchor, F&& f) {
  int extent[6];
  image->GetExtent(extent);
  const int ax = static_cast<int>(std::lround(anchor.x())), ay = static_cast<int>(std::lround(anchor.y()));
  for (int y = extent[2]; y <= extent[3]; ++y)
    for (int x = extent[0]; x <= extent[1]; ++x) {
      const auto* rgba = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
      if (rgba[3] > 0) f(ax + x, ay - y, rgba[3] / 255.0);
    }
}

}  // namespace

void drawText(Canvas& canvas, const std::string& text, const Vec2& anchor, TextAlign align, int size,
              const Colour& colour, TextWeight weight) {
  vtkNew<vtkTextProperty> style;
  style->SetFontFamilyToArial();  // comes with VTK: the same letters on every machine
  style->SetFontSize(size);
  style->SetBold(weight == TextWeight::bold ? 1 : 0);
  style->SetColor(1, 1, 1);
  style->SetVerticalJustificationToCentered();
  if (align == TextAlign::centre) style->SetJustificationToCentered();
  if (align == TextAlign::right) style->SetJustificationToRight();
  vtkNew<vtkImageData> image;
  constexpr int kDotsPerInch = 72;  // makes a point a pixel
  if (!vtkFreeTypeTools::GetInstance()->RenderString(style, text, kDotsPerInch, image))
    throw std::runtime_error("the text \"" + text + "\" could not be drawn.");
  forEachTextPixel(image, anchor, [&](int x, int y, double opacity) {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) canvas.blend(x + dx, y + dy, kRim, 0.55 * opacity);
  });
  forEachTextPixel(image, anchor, [&](int x, int y, double opacity) { canvas.blend(x, y, colour, opacity); });
}

void drawScaleBar(Canvas& canvas, const Rect& area, double mmPerPixel) {
  const double length = roundLength(0.25 * area.width * mmPerPixel);
  const int pixels = static_cast<int>(std::lround(length / mmPerPixel));
  constexpr int kInset = 16, kThickness = 3;
  const Rect bar{area.right() - kInset - pixels, area.bottom() - kInset - kThickness, pixels, kThickness};
  canvas.fill({bar.x - 1, bar.y - 1, bar.width + 2, bar.height + 2}, kRim, 0.7);
  canvas.fill(bar, kBar);
  char label[32];
  std::snprintf(label, sizeof label, "%g mm", length);
  drawText(canvas, label, Vec2(bar.x + pixels / 2.0, bar.y - 12), TextAlign::centre, 14, kBar);
}

std::string pngBytes(const Canvas& canvas) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(canvas.width(), canvas.height(), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < canvas.height(); ++y)
    for (int x = 0; x < canvas.width(); ++x) {
      // VTK's rows run up.
      auto* rgb = static_cast<unsigned char*>(image->GetScalarPointer(x, canvas.height() - 1 - y, 0));
      for (int c = 0; c < 3; ++c)
        rgb[c] = static_cast<unsigned char>(std::lround(std::clamp(canvas.at(x, y)[c], 0.0F, 1.0F) * 255));
    }
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(image);
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr || bytes->GetNumberOfValues() == 0) throw std::runtime_error("the PNG was not made.");
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

}  // namespace handlebody
