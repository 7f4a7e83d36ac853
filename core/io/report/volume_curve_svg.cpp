// The volume–time curve as a plot.

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

#include "core/io/report/over_time_report.h"
#include "core/units.h"

namespace handlebody {

namespace {

// Pixels: the picture, and the box of the curve in it.
constexpr double kWidth = 640, kHeight = 400, kLeft = 64, kRight = 616, kTop = 56, kBottom = 344;

//! A step of 1, 2 or 5 times a power of ten that divides a range into about five.
double niceStep(double range) {
  const double raw = range / 5, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double part : {1.0, 2.0, 5.0})
    if (raw <= part * power) return part * power;
  return 10 * power;
}

class Plot {
 public:
  explicit Plot(const OverTimeReport& report) : report_(report) {
    out_.imbue(std::locale::classic());
    isTimed_ = true;
    for (const VolumePoint& p : points()) isTimed_ = isTimed_ && p.time.has_value();
    first_ = abscissa(points().front());
    last_ = std::max(abscissa(points().back()), first_ + 1e-9);
    for (const VolumePoint& p : points()) most_ = std::max(most_, p.volume.value_or(0) / kMillilitre);
    if (!(most_ > 0)) most_ = 1;
    most_ = niceStep(most_) * std::ceil(1.02 * most_ / niceStep(most_));
  }
  std::string text() {
    open();
    axes();
    curve();
    phases();
    out_ << "</svg>\n";
    return out_.str();
  }

 private:
  const std::vector<VolumePoint>& points() const { return report_.curve.points; }
  double abscissa(const VolumePoint& p) const { return isTimed_ ? *p.time : p.frame; }
  double x(double t) const { return kLeft + (t - first_) / (last_ - first_) * (kRight - kLeft); }
  double y(double ml) const { return kBottom - ml / most_ * (kBottom - kTop); }
  double x(const VolumePoint& p) const { return x(abscissa(p)); }
  double y(const VolumePoint& p) const { return y(*p.volume / kMillilitre); }

  void label(double px, double py, const char* anchor, const std::string& text) {
    out_ << "<text x=\"" << px << "\" y=\"" << py << "\" text-anchor=\"" << anchor << "\">" << text
         << "</text>\n";
  }
  std::string number(double value, int digits = 4) const {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::setprecision(digits) << value;
    return text.str();
  }
  void open();
  void axes();
  void curve();
  void phases();

  const OverTimeReport& report_;
  std::ostringstream out_;
  bool isTimed_ = false;
  double first_ = 0, last_ = 1, most_ = 0;  // ms or frames; ml
};

void Plot::open() {
  out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << kWidth << "\" height=\"" << kHeight
       << "\" viewBox=\"0 0 " << kWidth << ' ' << kHeight
       << "\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n"
       << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  const VolumeCurve& c = report_.curve;
  std::string title = "Volume over time";
  if (c.endDiastole)
    title += ": stroke volume " + number(c.strokeVolume / kMillilitre) + " ml, ejection fraction " +
             number(100 * c.ejectionFraction, 3) + " %";
  label(kWidth / 2, 28, "middle", title);
}

void Plot::axes() {
  out_ << "<g stroke=\"#ddd\">\n";
  for (double v = 0; v <= most_ * 1.001; v += niceStep(most_))
    out_ << "<line x1=\"" << kLeft << "\" x2=\"" << kRight << "\" y1=\"" << y(v) << "\" y2=\"" << y(v)
         << "\"/>\n";
  out_ << "</g>\n";
  for (double v = 0; v <= most_ * 1.001; v += niceStep(most_)) label(kLeft - 8, y(v) + 4, "end", number(v));
  const double step = isTimed_ ? niceStep(last_ - first_) : std::max(1.0, niceStep(last_ - first_));
  for (double t = std::ceil(first_ / step) * step; t <= last_ + 1e-6 * step; t += step)
    label(x(t), kBottom + 20, "middle", number(t, 6));
  label(kWidth / 2, kHeight - 12, "middle", isTimed_ ? "time, ms" : "frame");
  label(16, kTop - 16, "start", "ml");
}

void Plot::curve() {
  out_ << "<polyline fill=\"none\" stroke=\"#0072b2\" stroke-width=\"2\" points=\"";
  for (const VolumePoint& p : points())
    if (p.volume && p.isTrusted) out_ << x(p) << ',' << y(p) << ' ';
  out_ << "\"/>\n";
  for (const VolumePoint& p : points()) {
    if (!p.volume) continue;
    if (p.isTrusted)
      out_ << "<circle cx=\"" << x(p) << "\" cy=\"" << y(p) << "\" r=\"3\" fill=\"#0072b2\"/>\n";
    else  // a cross: told, but not part of the curve
      out_ << "<path stroke=\"#d55e00\" stroke-width=\"2\" d=\"M" << x(p) - 4 << ' ' << y(p) - 4
           << "l8 8m0 -8l-8 8\"/>\n";
  }
}

void Plot::phases() {
  const VolumeCurve& c = report_.curve;
  if (!c.endDiastole) return;
  const auto mark = [&](std::size_t i, const char* name, double down) {
    const VolumePoint& p = points()[i];
    const bool isLeft = x(p) < kWidth / 2;
    out_ << "<circle cx=\"" << x(p) << "\" cy=\"" << y(p) << "\" r=\"6\" fill=\"none\" stroke=\"#d55e00\" "
         << "stroke-width=\"2\"/>\n";
    label(
        x(p) + (isLeft ? 4 : -4), y(p) + down, isLeft ? "start" : "end",
        std::string(name) + ": " + number(*p.volume / kMillilitre) + " ml, frame " + std::to_string(p.frame));
  };
  mark(*c.endDiastole, "end-diastole", -12);
  mark(*c.endSystole, "end-systole", 22);
}

}  // namespace

std::string curveSvg(const OverTimeReport& report) {
  if (report.curve.points.empty()) return "<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n";
  return Plot(report).text();
}

}  // namespace handlebody
