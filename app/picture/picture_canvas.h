#pragma once
// Internal: a picture in memory, what is drawn on it, and its PNG. Pixel (x, y) covers [x, x+1) × [y, y+1), y
// runs down.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace handlebody {

using Vec2 = Eigen::Vector2d;
//! Red, green, blue in [0, 1].
using Colour = Eigen::Array3f;

//! Pixels of a picture.
struct Rect {
  int x = 0, y = 0, width = 0, height = 0;
  int right() const { return x + width; }
  int bottom() const { return y + height; }
  Vec2 centre() const { return Vec2(x + width / 2.0, y + height / 2.0); }
  bool contains(int px, int py) const { return px >= x && py >= y && px < right() && py < bottom(); }
};

class Canvas {
 public:
  Canvas(int width, int height, const Colour& background);
  int width() const { return width_; }
  int height() const { return height_; }
  Rect area() const { return {0, 0, width_, height_}; }
  Colour& at(int x, int y) { return pixels_[index(x, y)]; }
  const Colour& at(int x, int y) const { return pixels_[index(x, y)]; }
  //! Mixes a colour in; `opacity` in [0, 1]. Pixels outside the canvas are ignored.
  void blend(int x, int y, const Colour& colour, double opacity);
  void fill(const Rect& rect, const Colour& colour, double opacity = 1);

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int width_, height_;
  std::vector<Colour> pixels_;
};

//! Smooth lines that are painted together, so that they do not darken each other where they meet.
class LineDrawing {
 public:
  //! Only pixels of `area` are painted; lines are `width` pixels thick.
  LineDrawing(const Rect& area, double width);
  void add(const Vec2& from, const Vec2& to);
  void paint(Canvas& canvas, const Colour& colour, double opacity = 1) const;

 private:
  Rect area_;
  double reach_;  // pixels from the line's centre to where it ends
  std::vector<float> coverage_;
};

enum class TextAlign { left, centre, right };

enum class TextWeight { normal, bold };

//! UTF-8 text, `size` pixels high, its middle at the height of `anchor`, with a dark rim that keeps it
//! readable on any ground.
void drawText(Canvas& canvas, const std::string& text, const Vec2& anchor, TextAlign align, int size,
              const Colour& colour, TextWeight weight = TextWeight::normal);

//! A bar of a round length at the lower right of `area`, with its length in mm.
void drawScaleBar(Canvas& canvas, const Rect& area, double mmPerPixel);

//! The bytes of a PNG file.
std::string pngBytes(const Canvas& canvas);

}  // namespace handlebody
