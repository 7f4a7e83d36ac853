#include "core/io/formats/time_axis.h"

#include <cmath>

#include "core/io/formats/volume_source.h"
#include "core/phase.h"

namespace handlebody {

namespace {

constexpr double kSameStep = 1e-3;  // of a step: files write times with four digits or more

}  // namespace

TimeAxis checkedTimes(int frames, std::vector<double> milliseconds, const std::string& source) {
  if (frames < 2 || milliseconds.size() != static_cast<std::size_t>(frames)) return {};
  for (std::size_t i = 0; i < milliseconds.size(); ++i)
    if (!std::isfinite(milliseconds[i]) || (i > 0 && !(milliseconds[i] > milliseconds[i - 1]))) return {};
  return {std::move(milliseconds), source};
}

TimeAxis evenTimes(int frames, double step, const std::string& source) {
  if (!(step > 0) || !std::isfinite(step)) return {};
  std::vector<double> times;
  for (int i = 0; i < frames; ++i) times.push_back(i * step);
  return checkedTimes(frames, std::move(times), source);
}

double evenStep(const TimeAxis& times) {
  const std::vector<double>& t = times.milliseconds;
  if (t.size() < 2) return 0;
  const double mean = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
  for (std::size_t i = 1; i < t.size(); ++i)
    if (std::abs(t[i] - t[i - 1] - mean) > kSameStep * mean) return 0;
  return mean;
}

TimeAxis readTimeAxis(const std::string& path, const VolumeSelection& selection) {
  const Phase phase("reading");
  const SourcePointer source = openVolume({path, selection}, {});
  if (source->header().isChoice) refuseInput(path, FindingKind::severalToChoose);
  return source->header().times;
}

}  // namespace handlebody
