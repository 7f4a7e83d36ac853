#include "ui/window/widgets/language.h"

#include <QCoreApplication>
#include <QFile>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <algorithm>
#include <memory>

#include "ui/window/widgets/icons.h"

// Outside every namespace, as Q_INIT_RESOURCE asks for.
static void registerTranslations() { Q_INIT_RESOURCE(translations); }

namespace handlebody::ui {

namespace {

const QString kEnglish = QStringLiteral("en"), kSystem = QStringLiteral("system"),
              kSetting = QStringLiteral("language");

bool isKnown(const QString& code) {
  return std::any_of(languages().begin(), languages().end(),
                     [&](const Language& l) { return l.code == code; });
}

//! "de_CH" is German; Chinese has one script here.
QString knownOf(const QLocale& locale) {
  for (const Language& l : languages())
    if (QLocale(l.code).language() == locale.language()) return l.code;
  return kEnglish;
}

//! What is in use, installed in the application.
struct InUse {
  QString code = kEnglish;
  QTranslator texts, qt;
};

InUse& inUse() {
  static auto* const one = new InUse;  // as long as the application, which may end later
  return *one;
}

}  // namespace

const std::vector<Language>& languages() {
  static const std::vector<Language> all{{kEnglish, QStringLiteral("English")},
                                         {QStringLiteral("de"), QStringLiteral("Deutsch")},
                                         {QStringLiteral("fr"), QStringLiteral("Français")},
                                         {QStringLiteral("es"), QStringLiteral("Español")},
                                         {QStringLiteral("zh_CN"), QStringLiteral("简体中文")}};
  return all;
}

QString languageToUse(const QString& asked) {
  for (const QString& code : {asked, qEnvironmentVariable("HANDLEBODY_LANGUAGE"), chosenLanguage()}) {
    if (isKnown(code)) return code;
    if (code == kSystem) break;
  }
  return knownOf(QLocale::system());
}

void useLanguage(const QString& code) {
  registerTranslations();
  InUse& now = inUse();
  QCoreApplication::removeTranslator(&now.texts);
  QCoreApplication::removeTranslator(&now.qt);
  now.code = code;
  const bool isSystems = QLocale(code).language() == QLocale::system().language();
  QLocale::setDefault(isSystems || code == kEnglish ? QLocale::system() : QLocale(code));
  if (code == kEnglish) return;
  if (now.qt.load(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&now.qt);
  if (now.texts.load(QStringLiteral(":/handlebody/translations/handlebody_") + code))
    QCoreApplication::installTranslator(&now.texts);
}

QString languageInUse() { return inUse().code; }

QString chosenLanguage() { return QSettings().value(kSetting, kSystem).toString(); }

void chooseLanguage(const QString& code) { QSettings().setValue(kSetting, code); }

QString guideFile() {
  icon(QStringLiteral("help"));  // registers the resources that the guide lies in
  const QString own = QStringLiteral("/handlebody/guide/guide_%1.html").arg(languageInUse());
  return QFile::exists(QLatin1Char(':') + own) ? own : QStringLiteral("/handlebody/guide/guide.html");
}

}  // namespace handlebody::ui
