#include "app/picture/picture_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/indices.h"
#include "core/volume/anatomy.h"

namespace handlebody {
namespace {

constexpr int kSamples = 3;  // along x and y in each pixel, against steps at the edges

const Colour kTop(0.135F, 0.150F, 0.175F), kBottom(0.065F, 0.072F, 0.085F);
const Colour kMaterial(0.93F, 0.74F, 0.44F);
const Colour kText(0.85F, 0.87F, 0.90F);

//! Rows: right, up and towards the eye, in LPS.
Eigen::Matrix3d camera() {
  const Vec3 eye = obliqueSight();
  const Vec3 right = (-eye).cross(Vec3::UnitZ()).normalized();
  Eigen::Matrix3d rows;
  rows << right.transpose(), eye.cross(right).transpose(), eye.transpose();
  return rows;
}

//! Mean of the faces' normals by area, in camera coordinates.
std::vector<Vec3> vertexNormals(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  std::vector<Vec3> normals(points.size(), Vec3::Zero());
  for (const Triangle& t : triangles) {
    const Vec3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const Vec3 area = (b - a).cross(c - a);
    for (int v : t) normals[v] += area;
  }
  for (Vec3& n : normals) n.normalize();
  return normals;
}

//! Diffuse light from upper left and from the right, some from everywhere, and a soft highlight.
Colour shade(Vec3 normal, double nearness) {
  static const Vec3 kKey = Vec3(-0.45, 0.65, 0.7).normalized(), kFill = Vec3(0.85, -0.1, 0.4).normalized();
  static const Vec3 kHalf = (kKey + Vec3::UnitZ()).normalized();
  if (normal.z() < 0) normal = -normal;
  const double key = std::max(0.0, normal.dot(kKey)), fill = std::max(0.0, normal.dot(kFill));
  // What is farther away is darker: it tells folds that lie behind each other apart.
  const double diffuse = (0.20 + 0.68 * key + 0.24 * fill) * (0.72 + 0.28 * nearness);
  const double highlight = 0.14 * std::pow(std::max(0.0, normal.dot(kHalf)), 24);
  return kMaterial * static_cast<float>(diffuse) + static_cast<float>(highlight);
}

//! Samples of one panel; coordinates in samples, y down, z towards the eye.
struct Buffer {
  int width, height;
  std::vector<float> depth;
  std::vector<Colour> colour;

  Buffer(int w, int h)
      : width(w),
        height(h),
        depth(idx(w) * idx(h), -std::numeric_limits<float>::infinity()),
        colour(idx(w) * idx(h)) {}
};

struct Corner {
  Vec3 position;  // samples
  Vec3 normal;
};

//! How strong the edges are drawn: faint, and not at all where triangles are so small that they would merge.
double edgeStrength(const std::array<Corner, 3>& t) {
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c)
    sum += (t[(c + 1) % 3].position - t[c].position).head<2>().norm() / (3 * kSamples);
  return 0.30 * std::clamp((sum - 3) / 7, 0.0, 1.0);
}

void rasterizeTriangle(Buffer& buffer, const std::array<Corner, 3>& t, double depthRange) {
  const auto cross = [](const Vec3& a, const Vec3& b, double x, double y) {
    return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
  };
  const Vec3 &a = t[0].position, &b = t[1].position, &c = t[2].position;
  const double area = cross(a, b, c.x(), c.y());
  if (area == 0) return;  // seen from the side
  const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  const int x0 = std::max(0, static_cast<int>(low.x() - 0.5)),
            y0 = std::max(0, static_cast<int>(low.y() - 0.5));
  const int x1 = std::min(buffer.width - 1, static_cast<int>(high.x())),
            y1 = std::min(buffer.height - 1, static_cast<int>(high.y()));
  const Vec3 heights = std::abs(area) * Vec3(1 / (c - b).head<2>().norm(), 1 / (a - c).head<2>().norm(),
                                             1 / (b - a).head<2>().norm());
  const double strength = edgeStrength(t);
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const Vec3 w = Vec3(cross(b, c, px, py), cross(c, a, px, py), cross(a, b, px, py)) / area;
      if (w.minCoeff() < 0) continue;
      const double z = w[0] * a.z() + w[1] * b.z() + w[2] * c.z();
      const std::size_t i = idx(y) * idx(buffer.width) + idx(x);
      if (z <= buffer.depth[i]) continue;
      buffer.depth[i] = static_cast<float>(z);
      const Vec3 normal = w[0] * t[0].normal + w[1] * t[1].normal + w[2] * t[2].normal;
      const double toEdge = w.cwiseProduct(heights).minCoeff() / kSamples;  // pixels
      const double dark = strength * std::clamp(1 - toEdge, 0.0, 1.0);
      buffer.colour[i] = shade(normal.normalized(), z / depthRange) * static_cast<float>(1 - dark);
    }
}

void paintBackground(Canvas& canvas, const Rect& area) {
  for (int y = area.y; y < area.bottom(); ++y) {
    const float t = static_cast<float>(y - area.y) / static_cast<float>(area.height);
    canvas.fill({area.x, y, area.width, 1}, kTop + t * (kBottom - kTop));
  }
}

void paintBuffer(Canvas& canvas, const Rect& area, const Buffer& buffer) {
  for (int y = 0; y < area.height; ++y)
    for (int x = 0; x < area.width; ++x) {
      Colour sum = Colour::Zero();
      int hit = 0;
      for (int s = 0; s < kSamples * kSamples; ++s) {
        const std::size_t i =
            idx(y * kSamples + s / kSamples) * idx(buffer.width) + idx(x * kSamples + s % kSamples);
        if (std::isinf(buffer.depth[i])) continue;
        sum += buffer.colour[i];
        ++hit;
      }
      if (hit > 0)
        canvas.blend(area.x + x, area.y + y, sum / static_cast<float>(hit),
                     static_cast<double>(hit) / (kSamples * kSamples));
    }
}

//! Three small arrows that say where left, posterior and superior are.
void drawTriad(Canvas& canvas, const Rect& area, const Eigen::Matrix3d& view) {
  constexpr double kLength = 26, kLetterAt = 37;
  const Vec2 origin(area.x + 50, area.bottom() - 50);
  LineDrawing lines(area, 1.6);
  for (int w = 0; w < 3; ++w) {
    // Anterior rather than posterior: it points towards the eye.
    const double sign = w == 1 ? -1 : 1;
    const Vec2 direction(sign * view(0, w), -sign * view(1, w));
    lines.add(origin, origin + kLength * direction);
    drawText(canvas, std::string(1, "LAS"[w]), origin + kLetterAt * direction, TextAlign::centre, 14, kText);
  }
  lines.paint(canvas, kText, 0.8);
}

//! Points in camera coordinates, millimetres, and the box around them.
struct Seen {
  std::vector<Vec3> points;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
};

Seen lookAt(const TriangleSoup& mesh, const Eigen::Matrix3d& view) {
  Seen seen;
  seen.points.reserve(mesh.points.size());
  for (const Vec3& p : mesh.points) {
    seen.points.push_back(view * p);
    seen.low = seen.low.cwiseMin(seen.points.back());
    seen.high = seen.high.cwiseMax(seen.points.back());
  }
  return seen;
}

}  // namespace

double drawSurface(Canvas& canvas, const Rect& area, const TriangleSoup& mesh) {
  constexpr int kMargin = 44;  // for the triad and the scale bar
  paintBackground(canvas, area);
  const Eigen::Matrix3d view = camera();
  drawTriad(canvas, area, view);
  if (mesh.triangles.empty()) return 0;
  Seen seen = lookAt(mesh, view);
  const std::vector<Vec3> normals = vertexNormals(seen.points, mesh.triangles);
  const Vec3 extent = seen.high - seen.low, middle = (seen.low + seen.high) / 2;
  const double mmPerPixel =
      std::max({extent.x() / (area.width - 2 * kMargin), extent.y() / (area.height - 2 * kMargin), 1e-9});
  Buffer buffer(area.width * kSamples, area.height * kSamples);
  const double scale = kSamples / mmPerPixel;
  for (Vec3& p : seen.points)
    p = Vec3(buffer.width / 2.0 + scale * (p.x() - middle.x()),
             buffer.height / 2.0 - scale * (p.y() - middle.y()), scale * (p.z() - seen.low.z()));
  const double depthRange = std::max(scale * extent.z(), 1e-9);
  for (const Triangle& t : mesh.triangles) {
    std::array<Corner, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) corners[c] = {seen.points[t[c]], normals[t[c]]};
    rasterizeTriangle(buffer, corners, depthRange);
  }
  paintBuffer(canvas, area, buffer);
  return mmPerPixel;
}

}  // namespace handlebody
