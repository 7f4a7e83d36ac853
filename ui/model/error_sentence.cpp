#include "ui/model/error_sentence.h"

#include <new>

#include "core/told_error.h"
#include "ui/model/finding_text.h"
#include "ui/model/translate.h"

namespace handlebody::ui {

namespace {

//! What carries no finding, or one that is not translated: what another program says (a mesher, DCMTK, the
//! system). In another language than English a headline stands before that.
QString headed(const char* headline, const std::exception& error) {
  const QString detail = QString::fromUtf8(error.what()).simplified(), own = tr(headline);
  return own == QLatin1String(headline) ? detail : own + QLatin1Char(' ') + detail;
}

QString closed(QString text) {
  text = text.simplified();
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text.endsWith(QLatin1Char('.')) ? text : text + QLatin1Char('.');
}

}  // namespace

QString errorSentence() try {
  try {
    throw;
  } catch (const CarriesFinding& e) {
    if (isTranslated(e.finding())) return findingSentence(e.finding());
    throw;
  }
} catch (const InputError& e) {  // these begin with the file's name: no capital letter
  return headed(QT_TR_NOOP("The file cannot be read."), e);
} catch (const OutputError& e) {
  return headed(QT_TR_NOOP("The file cannot be written."), e);
} catch (const std::bad_alloc&) {
  return tr("There is not enough memory for this.");
} catch (const std::exception& e) {
  return closed(QString::fromUtf8(e.what()));
} catch (...) {
  return tr("Something went wrong that has no name.");
}

}  // namespace handlebody::ui
