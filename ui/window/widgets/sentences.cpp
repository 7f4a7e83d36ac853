#include "ui/window/widgets/sentences.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/model/finding_text.h"

namespace handlebody::ui {

std::vector<Finding> warningsOfWindow(const VolumeInfo& info) {
  std::vector<Finding> warnings = info.warnings;
  std::erase_if(warnings, [](const Finding& w) { return w.kind == FindingKind::frameZeroUsed; });
  return warnings;
}

QString mainWarning(const VolumeInfo& info) {
  const std::vector<Finding> warnings = warningsOfWindow(info);
  if (warnings.empty()) return {};
  const auto scale = std::ranges::find(warnings, FindingKind::uncalibrated, &Finding::kind);
  const QString more = QCoreApplication::translate("Sentences", " More in the step Open.");
  return findingSentence(scale == warnings.end() ? warnings.front() : *scale) +
         (warnings.size() > 1 ? more : QString());
}

QString breakable(const QString& text) {
  constexpr int kLongWord = 28;  // characters that fit into the narrowest panel
  constexpr QChar kMayBreak(0x200b);
  QString result;
  int word = 0;
  for (const QChar c : text) {
    word = c.isSpace() ? 0 : word + 1;
    if (word > kLongWord) {
      result += kMayBreak;
      word = 1;
    }
    result += c;
  }
  return result;
}

}  // namespace handlebody::ui
