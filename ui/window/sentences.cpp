#include "ui/window/sentences.h"

#include <QCoreApplication>

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
  return sentence;
}

bool asksForSpacing(const QString& sentence) { return sentence.contains(QLatin1String("give --spacing")); }

}  // namespace handlebody::ui
