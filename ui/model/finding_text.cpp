#include "ui/model/finding_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <iterator>

namespace handlebody::ui {

namespace {

using K = FindingKind;

struct Words {
  FindingKind kind;
  const char* text;
};

// Where the English words of the engine name an option, or are another's alone.
constexpr Words kWords[] = {
    {K::heldAtNeck,
     QT_TRANSLATE_NOOP("Findings",
                       "the surface is held at a neck of radius {radius_mm:3g} mm: behind it the same "
                       "intensities go on for at least {behind_ml:3g} ml, in front of it they fill "
                       "{in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set "
                       "the range in step 3, Tune, which holds nothing back")},
    {K::heldAtHole,
     QT_TRANSLATE_NOOP("Findings",
                       "the surface is held at a hole of radius {radius_mm:3g} mm in a thin wall: behind it "
                       "the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill "
                       "{in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set "
                       "the range in step 3, Tune, which holds nothing back")},
    {K::heldWhereItWidens,
     QT_TRANSLATE_NOOP("Findings",
                       "the surface is held where its structure grows wider than a radius of {radius_mm:3g} "
                       "mm: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of "
                       "it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there "
                       "too, or set the range in step 3, Tune, which holds nothing back")},
    {K::stuck, QT_TRANSLATE_NOOP("Findings",
                                 "the surface got stuck: no part of a step could be kept, again and again; "
                                 "another edge length may help")},
    {K::frozen, QT_TRANSLATE_NOOP("Findings",
                                  "the surface rests at places that would still move, because changes there "
                                  "failed or repeated again and again; another edge length or smoothing may "
                                  "help")},
    {K::hardlyGrown,
     QT_TRANSLATE_NOOP("Findings",
                       "the surface hardly grew beyond its seed: look at the kind of object and the range in "
                       "step 3, Tune")},
    {K::heldByCurvature,
     QT_TRANSLATE_NOOP("Findings",
                       "the surface hardly grew beyond its seed: the curvature weight holds every front of a "
                       "radius below {radius_mm:3g} mm, and the seed is smaller; give it a larger radius, or "
                       "lower the weight")},
    {K::closeChoice,
     QT_TRANSLATE_NOOP("Findings",
                       "the choice among {objects} objects is close (expected overlap with the one that is "
                       "meant: Dice {dice:2g}): the next candidate holds {next_ml:3m} ml where this one "
                       "holds {this_ml:3m} ml; another one can be chosen in step 2, Seed")},
    {K::fewerCandidates,
     QT_TRANSLATE_NOOP("Findings",
                       "the clicks may mean fewer objects than {asked:0f}, which is the one that was asked "
                       "for: number {taken:0f}, the last of them, was taken")},
    {K::noEffectOnGiven,
     QT_TRANSLATE_NOOP("Findings",
                       "has no effect on an object that was given: its surface stays as it is, and nothing "
                       "grows.")},
    {K::noEffectWithRange,
     QT_TRANSLATE_NOOP("Findings",
                       "has no effect with a range, by which the intensities alone say what the object is: "
                       "leave one of them out.")},
    {K::wallOverGiven,
     QT_TRANSLATE_NOOP("Findings",
                       "The wall at {place} mm lies over the surface that was given, or within it, and that "
                       "surface stays as it is.")},
    {K::leaked, QT_TRANSLATE_NOOP("Findings", "the surface leaked at iteration {iteration}: {cause}")},
    {K::leakWalled,
     QT_TRANSLATE_NOOP("Findings",
                       "the surface leaked at iteration {iteration}: {cause}; a wall was put there")},
    {K::leakStopped,
     QT_TRANSLATE_NOOP("Findings",
                       "the surface leaked at iteration {iteration}: {cause}; the mesh is that of iteration "
                       "{mesh_iteration}, before it came there")},
    {K::undecided,
     QT_TRANSLATE_NOOP("Findings",
                       "at iteration {iteration} a limit of the topology holds: {cause}; step 4, Grow, asks "
                       "whether it may happen")},
    {K::fillsView,
     QT_TRANSLATE_NOOP("Findings",
                       "The seed is not in an object with a boundary of its own: what grows from it fills "
                       "the field of view, up to the padding around the image. Where that is meant, say "
                       "whether it is dark or bright, or set the range in step 3, Tune.")},
    {K::seedOutside, QT_TRANSLATE_NOOP("Findings", "The seed at {place:1f} mm lies outside the volume.")},
    {K::clickOutside,
     QT_TRANSLATE_NOOP("Findings",
                       "The click outside of the object at {place:1f} mm lies outside the volume.")},
    {K::seedNotInRange,
     QT_TRANSLATE_NOOP("Findings",
                       "The seed at {place:1f} mm is not in the object: the smoothed intensity there is "
                       "{intensity:4g}, the object's range is {low:4g} to {high:4g}.")},
    {K::rangeWithoutVoxels,
     QT_TRANSLATE_NOOP("Findings",
                       "The range {low:4g} to {high:4g} holds no voxel of the volume, whose values run from "
                       "{least:4g} to {most:4g}.")},
    {K::frameUnreadable, QT_TRANSLATE_NOOP("Findings", "its voxels cannot be read: {cause}")},
    {K::frameNoObject, QT_TRANSLATE_NOOP("Findings", "no object can be grown here: {cause}")},
    {K::frameAtLimit, QT_TRANSLATE_NOOP("Findings", "the surface was still moving at the iteration limit")},
    {K::frameStuck, QT_TRANSLATE_NOOP("Findings", "the surface got stuck before it was at rest")},
    {K::frameFrozen,
     QT_TRANSLATE_NOOP("Findings", "the surface rests, but parts that could not be mended would still move")},
    {K::sessionWithoutVolume,
     QT_TRANSLATE_NOOP("Findings", "This session does not say where its volume is. Choose it.")},
    {K::sessionWithoutWalls,
     QT_TRANSLATE_NOOP("Findings",
                       "This session does not say where the label map of its walls is. Choose it.")},
    {K::sessionWithoutStart,
     QT_TRANSLATE_NOOP(
         "Findings",
         "This session does not say where the file of a surface is that an object begins with. Choose it.")},
    {K::cine,
     QT_TRANSLATE_NOOP("Findings",
                       "this is a cine (2D images over time: {frames:0f} frames), not a volume; if its "
                       "frames are slices in space, enter their spacing in step 1, Open")},
    {K::frameZeroUsed,
     QT_TRANSLATE_NOOP(
         "Findings", "There are {frames:0f} time points; frame 0 is used (step 1, Open, chooses another).")},
    {K::uncalibrated,
     QT_TRANSLATE_NOOP("Findings",
                       "The volume is uncalibrated: its file does not give the spacing, 1 mm is assumed "
                       "where it is missing, and lengths and volumes mean nothing until it is entered in "
                       "step 1, Open.")},
    {K::stackOf, QT_TRANSLATE_NOOP("Findings", "stack {stack:0f} ({slices:0f} slices)")},
    {K::severalToChoose,
     QT_TRANSLATE_NOOP("Findings", "it holds several series or stacks, choose one in step 1, Open")},
    {K::seriesToChoose,
     QT_TRANSLATE_NOOP("Findings",
                       "it holds {series:0f} series or stacks, choose one in step 1, Open: {choices}")},
    {K::startAndGiven,
     QT_TRANSLATE_NOOP("Findings", "an object begins with one surface or is one, not both.")},
    {K::noLatticePoint,
     QT_TRANSLATE_NOOP("Findings", "No point of the lattice lies in A or B: there is no Dice coefficient.")},
};

const char* sourceOf(FindingKind kind) {
  const auto at =
      std::find_if(std::begin(kWords), std::end(kWords), [kind](const Words& w) { return w.kind == kind; });
  return at == std::end(kWords) ? findingText(kind) : at->text;
}

QString number(double value, const std::string& format) {
  if (std::isnan(value)) return QStringLiteral("NaN");
  if (std::isinf(value)) return value < 0 ? QStringLiteral("−∞") : QStringLiteral("∞");
  const QLocale locale;
  if (std::abs(value) >= 1e15) return locale.toString(value, 'g', 6);
  const int digits = format.empty() || format.back() == 'm' ? (format.empty() ? 6 : 3) : std::stoi(format);
  if (!format.empty() && format.back() == 'f') return locale.toString(value, 'f', digits);
  const int magnitude = value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
  const double scale = std::pow(10.0, std::clamp(digits - 1 - magnitude, 0, digits));
  return locale.toString(std::round(value * scale) / scale, 'f', QLocale::FloatingPointShortest);
}

QString written(const FindingValue& value, std::string_view format) {
  if (const auto* text = std::get_if<std::string>(&value)) return QString::fromStdString(*text);
  if (const auto* x = std::get_if<double>(&value)) return number(*x, std::string(format));
  const auto& place = std::get<std::array<double, 3>>(value);
  const std::string each(format.substr(format.starts_with(' ') ? 1 : 0));
  QStringList parts;
  for (const double x : place) parts << number(x, each);
  // Where the comma parts the decimals it cannot part the numbers as well.
  return parts.join(QLocale().decimalPoint() == QLatin1String(",") ? QStringLiteral("; ")
                                                                   : QStringLiteral(", "));
}

}  // namespace

QString findingText(const Finding& finding) {
  if (!finding.any()) return {};
  const std::string source =
      finding.kind == K::polishLeaves || finding.kind == K::other
          ? std::string("{text}")
          : QCoreApplication::translate("Findings", sourceOf(finding.kind)).toStdString();
  return QString::fromStdString(filled(
      source, finding,
      [](std::string_view, const FindingValue& value, std::string_view format) {
        return written(value, format).toStdString();
      },
      [](const Finding& cause) { return findingText(cause).toStdString(); },
      &dashed));  // there is none in the words above
}

QString findingText(const std::vector<Finding>& findings) {
  QStringList all;
  for (const Finding& f : findings) all << findingText(f);
  return all.join(QStringLiteral("; "));
}

bool isTranslated(const Finding& finding) {
  return finding.kind != K::other && std::all_of(finding.causes.begin(), finding.causes.end(),
                                                 [](const Finding& f) { return isTranslated(f); });
}

QString findingSentence(const Finding& finding) {
  QString text = findingText(finding);
  if (text.isEmpty()) return text;
  // The name of a file or an object is as it is.
  const auto beginsWith = [&](const char* name) {
    const FindingValue* value = finding.find(name);
    return value && text.startsWith(written(*value, ""));
  };
  if (!beginsWith("file") && !beginsWith("object")) text[0] = text[0].toUpper();
  if (QStringLiteral(".?。？").contains(text.back())) return text;
  return QCoreApplication::translate("Findings", "%1.").arg(text);
}

QString findingSentences(const std::vector<Finding>& findings) {
  QStringList all;
  for (const Finding& f : findings) all << findingSentence(f);
  return all.join(QLatin1Char(' '));
}

}  // namespace handlebody::ui
