#include "ui/window/sentences.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>

namespace handlebody::ui {

namespace {

struct Wording {
  const char* option;
  const char* field;
};

constexpr Wording kWordings[] = {
    {"give --range", QT_TRANSLATE_NOOP("Sentences", "set the range in step 3, Tune")},
    {"until --spacing gives it", QT_TRANSLATE_NOOP("Sentences", "until it is entered in step 1, Open")},
    {"give --spacing X,Y,Z", QT_TRANSLATE_NOOP("Sentences", "enter their spacing in step 1, Open")},
};

}  // namespace

QString inWordsOfWindow(QString sentence) {
  for (const Wording& w : kWordings)
    sentence.replace(QLatin1String(w.option), QCoreApplication::translate("Sentences", w.field));
  static const QRegularExpression stack(QStringLiteral("\\b[0-9.]+#([0-9]+)"));
  return sentence.replace(stack,
                          QCoreApplication::translate("Sentences", "stack %1").arg(QStringLiteral("\\1")));
}

std::vector<std::string> warningsOfWindow(const VolumeInfo& info) {
  std::vector<std::string> warnings = info.warnings;
  std::erase_if(warnings,
                [](const std::string& w) { return w.find("--frame chooses") != std::string::npos; });
  return warnings;
}

QString mainWarning(const VolumeInfo& info) {
  const std::vector<std::string> warnings = warningsOfWindow(info);
  if (warnings.empty()) return {};
  const auto namesScale = [&](const std::string& warning) {
    return !info.calibrated && warning.find("uncalibrated") != std::string::npos;
  };
  const auto first = std::find_if(warnings.begin(), warnings.end(), namesScale);
  const std::string& warning = first == warnings.end() ? warnings.front() : *first;
  const QString more = QCoreApplication::translate("Sentences", " More in the step Open.");
  return inWordsOfWindow(QString::fromStdString(warning)) + (warnings.size() > 1 ? more : QString());
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
