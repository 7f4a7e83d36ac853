#include "core/sequence/volume_curve.h"

namespace handlebody {

VolumeCurve volumeCurve(std::vector<VolumePoint> points) {
  VolumeCurve curve;
  curve.points = std::move(points);
  std::optional<std::size_t> largest, smallest;
  std::size_t trusted = 0;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const VolumePoint& p = curve.points[i];
    if (!p.isTrusted || !p.volume) continue;
    ++trusted;
    if (!largest || *p.volume > *curve.points[*largest].volume) largest = i;
    if (!smallest || *p.volume < *curve.points[*smallest].volume) smallest = i;
  }
  if (trusted < 2) return curve;
  curve.endDiastole = largest;
  curve.endSystole = smallest;
  const double most = *curve.points[*largest].volume, least = *curve.points[*smallest].volume;
  curve.strokeVolume = most - least;
  curve.ejectionFraction = most > 0 ? curve.strokeVolume / most : 0;
  return curve;
}

}  // namespace handlebody
