#pragma once
// The language of the window: its texts, Qt's own, and how numbers are written. Files know none.

#include <QString>
#include <vector>

namespace handlebody::ui {

struct Language {
  QString code;  //!< "de", "zh_CN"; as in the names of the translations
  QString name;  //!< in that language itself
};

//! English, then those that there are translations for.
const std::vector<Language>& languages();

//! The one to begin with: `asked` if that is one of them or "system", else what the environment's
//! HANDLEBODY_LANGUAGE says, else what was chosen in the window, else that of the system if there are texts
//! in it, else English.
QString languageToUse(const QString& asked);

//! For all windows that are made from now on. Where the system's language is another one, numbers are written
//! as is usual in `code`, else as the system says. Precondition: there is a QCoreApplication.
void useLanguage(const QString& code);
//! What useLanguage was called with; "en" if it was not.
QString languageInUse();

//! What was chosen in the window: a code, or "system". Kept between starts.
QString chosenLanguage();
void chooseLanguage(const QString& code);

//! The file of that name in the language in use, or the English one: "guide" gives
//! ":/handlebody/guide/guide_de.html".
QString guideFile();

}  // namespace handlebody::ui
