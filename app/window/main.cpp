// The window: `handlebody [FILE]`.

#include <QApplication>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

#include "app/window/options.h"
#include "app/window/screenshot.h"
#include "core/version.h"
#include "ui/window/main_window.h"
#include "ui/window/open/file_work.h"
#include "ui/window/widgets/language.h"

namespace handlebody::app {

namespace {

constexpr int kNoDisplay = 1;

bool isStarting = true;  // Qt is looking for a display, the only thing that can be fatal then

// Not by std::cerr, whose buffer what writes a volume may have exchanged on another thread.
void say(const std::string& text) { std::fprintf(stderr, "handlebody: %s\n", text.c_str()); }

// Qt ends the program with an abort if it gets no display; a sentence and an exit code serve better.
void endOnFatal(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  if (type == QtDebugMsg || type == QtInfoMsg) return;
  if (type != QtFatalMsg) {
    const bool isOfPlatform = QByteArrayView(context.category).startsWith("qt.qpa");
    if (!isOfPlatform) say(text.toStdString());
    return;
  }
  say(isStarting ? "there is no display to open the window on; handlebody-cli does the same work without one."
                 : text.toStdString());
  std::_Exit(kNoDisplay);
}

ui::Appearance appearanceFrom(const QString& word) {
  if (word == QStringLiteral("light")) return ui::Appearance::light;
  return word == QStringLiteral("dark") ? ui::Appearance::dark : ui::Appearance::system;
}

int showWindow(const Options& options) {
  ui::MainWindow window;
  if (!options.appearance.isEmpty()) window.setAppearance(appearanceFrom(options.appearance));
  const bool picture = !options.screenshot.isEmpty();
  if (picture) window.resize(options.size);
  // It ends the program once its picture is taken, so there is none unless a picture is asked for.
  std::optional<Screenshot> screenshot;
  if (picture) screenshot.emplace(options, window);
  window.show();
  if (screenshot) {
    screenshot->start();
  } else {
    if (!options.file.isEmpty()) window.files().open(options.file);
    window.greet();
  }
  return QApplication::exec();
}

}  // namespace

}  // namespace handlebody::app

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes is an error of writing, told with the file's name
  std::signal(SIGCHLD, SIG_DFL);  // ignored, as some parents hand it down, no end of a process is ever told
  handlebody::app::Options options;
  if (const auto code = handlebody::app::readOptions(argc, argv, options)) return *code;
  qInstallMessageHandler(handlebody::app::endOnFatal);
  int qtArguments = 1;  // ours are read
  QApplication application(qtArguments, argv);
  handlebody::app::isStarting = false;
  QApplication::setOrganizationName(QStringLiteral("Handlebody"));
  QApplication::setApplicationName(QStringLiteral("handlebody"));
  QApplication::setApplicationVersion(QStringLiteral(HANDLEBODY_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("org.handlebody.Handlebody"));
  // QApplication has set the C library to the user's locale; what is written to files has a point in its
  // numbers in every language.
  std::setlocale(LC_NUMERIC, "C");
  handlebody::ui::useLanguage(handlebody::ui::languageToUse(options.language));
  return handlebody::app::showWindow(options);
}
