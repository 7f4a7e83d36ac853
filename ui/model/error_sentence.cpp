#include "ui/model/error_sentence.h"

#include <QCoreApplication>
#include <new>

#include "core/errors.h"

namespace handlebody::ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("errors", text); }

QString closed(QString text) {
  text = text.simplified();
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text.endsWith(QLatin1Char('.')) ? text : text + QLatin1Char('.');
}

}  // namespace

QString errorSentence() try {
  throw;
} catch (const InputError& e) {  // these begin with the file's name: no capital letter
  return QString::fromUtf8(e.what()).simplified();
} catch (const OutputError& e) {
  return QString::fromUtf8(e.what()).simplified();
} catch (const std::bad_alloc&) {
  return tr("There is not enough memory for this.");
} catch (const std::exception& e) {
  return closed(QString::fromUtf8(e.what()));
} catch (...) {
  return tr("Something went wrong that has no name.");
}

}  // namespace handlebody::ui
