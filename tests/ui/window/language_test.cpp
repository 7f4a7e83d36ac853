// The window in other languages: every text is translated, nothing is cut off, numbers are the user's; files
// are the same in all of them.

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QProcess>
#include <QRegularExpression>
#include <QTabBar>
#include <QTextBrowser>
#include <QTimer>
#include <QXmlStreamReader>
#include <algorithm>
#include <atomic>

#include "core/io/report/session.h"
#include "tests/ui/window/layout_support.h"
#include "tests/ui/window/window_support.h"
#include "ui/model/error_sentence.h"
#include "ui/model/finding_text.h"
#include "ui/model/opening.h"
#include "ui/window/help/help_window.h"
#include "ui/window/open/open_panel.h"
#include "ui/window/timeline/event_inspector.h"
#include "ui/window/widgets/language.h"

using namespace handlebody;
using namespace handlebody::test;
using ui::GrowthState;

namespace {

//! One entry of a .ts file.
struct Entry {
  QString source;
  QStringList translations;  //!< several for the forms of a number
  bool isFinished = false;
};

QString sourcesOf(const char* path) { return QStringLiteral(HANDLEBODY_SOURCE "/") + QLatin1String(path); }

QString translationFile(const QString& code) {
  return sourcesOf("resources/translations/handlebody_") + code + QStringLiteral(".ts");
}

Entry readEntry(QXmlStreamReader& xml) {
  Entry entry;
  while (xml.readNextStartElement()) {
    if (xml.name() == QLatin1String("source")) {
      entry.source = xml.readElementText();
    } else if (xml.name() == QLatin1String("translation")) {
      entry.isFinished = !xml.attributes().hasAttribute(QLatin1String("type"));
      const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
      entry.translations << text;
    } else {
      xml.skipCurrentElement();
    }
  }
  return entry;
}

QList<Entry> entriesOf(const QString& code) {
  QFile file(translationFile(code));
  if (!file.open(QIODevice::ReadOnly)) return {};
  QXmlStreamReader xml(&file);
  QList<Entry> entries;
  while (!xml.atEnd())
    if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QLatin1String("message"))
      entries << readEntry(xml);
  return entries;
}

QStringList translatedLanguages() {
  QStringList codes;
  for (const ui::Language& l : ui::languages())
    if (l.code != QLatin1String("en")) codes << l.code;
  return codes;
}

//! %1, %n and {name:format}, in alphabetical order.
QStringList holesOf(const QString& text) {
  static const QRegularExpression hole(QStringLiteral("%L?[0-9n]|\\{[^}]*\\}"));
  QStringList found;
  for (auto m = hole.globalMatch(text); m.hasNext();) found << m.next().captured();
  found.sort();
  return found;
}

QString bare(QString text) {
  static const QRegularExpression mark(QStringLiteral("\\(&.\\)"));
  return text.remove(mark).remove(QLatin1Char('&')).trimmed();
}

//! Everything that can be read in the window: texts, tips, names, menus.
QStringList textsOf(const QWidget& window) {
  QStringList texts;
  const auto widgets = window.findChildren<QWidget*>();
  for (const QWidget* w : widgets) {
    texts << w->toolTip() << w->accessibleName() << w->windowTitle();
    if (const auto* button = qobject_cast<const QAbstractButton*>(w)) texts << button->text();
    if (const auto* label = qobject_cast<const QLabel*>(w)) texts << label->text();
    if (const auto* box = qobject_cast<const QComboBox*>(w))
      for (int i = 0; i < box->count(); ++i) texts << box->itemText(i);
    if (const auto* tabs = qobject_cast<const QTabBar*>(w))
      for (int i = 0; i < tabs->count(); ++i) texts << tabs->tabText(i);
  }
  const auto actions = window.findChildren<QAction*>();
  for (const QAction* action : actions) texts << action->text() << action->statusTip();
  return texts;
}

//! The sample grown up to its first change of topology, which is inspected.
std::unique_ptr<ui::MainWindow> windowWithResult() {
  auto window = shownWindow();
  if (!window || !open(*window, sample("cyst_session.json"))) return nullptr;
  const ui::Document& document = window->document();
  if (!QTest::qWaitFor([&] { return document.resolved().has_value(); }, kPatience)) return nullptr;
  window->commands()[ui::Command::nextEvent]->trigger();
  if (!QTest::qWaitFor([&] { return firstHandle(document) >= 0; }, kPatience)) return nullptr;
  if (!waitFor(*window, GrowthState::paused)) return nullptr;
  window->goToEvent(firstHandle(document));
  return window;
}

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

//! What the texts of findings say between their values, where this language says it otherwise.
QStringList englishParts(const QString& code) {
  static const QRegularExpression hole(QStringLiteral("\\{[^}]*\\}"));
  QStringList parts;
  for (const Entry& e : entriesOf(code))
    if (e.source != e.translations.value(0))
      for (const QString& part : e.source.split(hole))
        if (part.size() > 12) parts << part;
  return parts;
}

//! Why it cannot be opened; empty if it can.
QString whyNot(const QString& path) {
  const std::atomic<bool> cancelled{false};
  const ui::OpeningResult result = ui::openWork(
      {path, {}, {}}, [](double) {}, cancelled);
  const auto* failed = std::get_if<ui::OpeningFailed>(&result);
  return failed ? failed->sentence : QString();
}

//! What the step Open says of the volume.
QString warningsIn(const ui::MainWindow& window) {
  const auto labels = window.findChild<ui::OpenPanel*>()->findChildren<QLabel*>();
  for (const QLabel* label : labels)
    if (label->text().contains(QChar(0x26a0))) return label->text();
  return {};
}

//! Files that cannot be opened, each for another reason; the first is not there.
QStringList brokenFiles(const QTemporaryDir& folder) {
  QStringList files{folder.filePath(QStringLiteral("missing.nii"))};
  const auto write = [&](const char* name, const QByteArray& bytes) {
    files << folder.filePath(QLatin1String(name));
    QFile file(files.back());
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) files.clear();
  };
  const QByteArray cyst = contentOf(sample("cyst.nii.gz"));
  const QByteArray nrrd = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: ";
  const QByteArray session = R"({"version": "0.1.0", "input": {"path": "cyst.nii.gz", "sha256": null},)";
  write("empty.nrrd", {});
  write("letter.nii", "This is a letter, not a volume.");
  write("cut.nii.gz", cyst.left(cyst.size() / 2));
  write("short.nrrd", nrrd + "raw\n\nabc");
  write("packed.nrrd", nrrd + "bzip2\n\nabcdefgh");
  write("flat.mha",
        "ObjectType = Image\nNDims = 2\nDimSize = 2 2\nElementType = MET_UCHAR\n"
        "ElementDataFile = LOCAL\nabcd");
  write("slice.dcm", QByteArray(128, '\0') + "DICM");
  write("letter.json", "This is a letter, not a session.");
  write("unseeded.json", session + R"("requested": {"seeds": []}})");
  files << folder.filePath(QStringLiteral("images"));
  QDir().mkdir(files.back());
  return files;
}

//! Without what the clock has written.
QByteArray withoutTimes(const QByteArray& json) {
  QJsonObject object = QJsonDocument::fromJson(json).object();
  object.remove(QStringLiteral("seconds"));
  return QJsonDocument(object).toJson();
}

}  // namespace

class LanguageTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { ui::useLanguage(QStringLiteral("en")); }
  void everyTextIsTranslated();
  void placeholdersAreTheSameInEveryLanguage();
  void theTranslationsHaveAllTextsOfTheSources();
  void theGuideHasTheSamePartsInEveryLanguage();
  void whatTheWindowShowsIsInItsLanguage();
  void nothingIsCutOffInAnyLanguage();
  void numbersAndFindingsAreWrittenAsTheLanguageDoes();
  void everyFindingIsToldInEveryLanguage();
  void whatIsWrongWithAFileIsToldInEveryLanguage();
  void whatIsWrongWithASessionIsToldInEveryLanguage();
  void whyATableIsNotWrittenIsToldInEveryLanguage();
  void whatIsToBeKnownOfAFileIsToldInEveryLanguage();
  void filesAreTheSameInEveryLanguage();
  void theLanguageIsChosenByOptionEnvironmentSettingAndSystem();
};

void LanguageTest::everyTextIsTranslated() {
  for (const QString& code : translatedLanguages()) {
    const QList<Entry> entries = entriesOf(code);
    QVERIFY2(entries.size() > 1000, qPrintable(code));
    for (const Entry& e : entries) {
      QVERIFY2(e.isFinished, qPrintable(code + ": " + e.source));
      for (const QString& t : e.translations)
        QVERIFY2(!t.isEmpty() && (t.trimmed().isEmpty() == e.source.trimmed().isEmpty()),
                 qPrintable(code + ": " + e.source));
    }
  }
}

void LanguageTest::placeholdersAreTheSameInEveryLanguage() {
  for (const QString& code : translatedLanguages())
    for (const Entry& e : entriesOf(code))
      for (const QString& t : e.translations) {
        QVERIFY2(holesOf(t) == holesOf(e.source), qPrintable(code + ": " + e.source + " / " + t));
        // A key in a menu or a button; Chinese has none where it would have to be shown in brackets.
        const bool hasKey = e.source.contains(QLatin1Char('&'));
        if (code != QLatin1String("zh_CN") || !hasKey)
          QVERIFY2(t.contains(QLatin1Char('&')) == hasKey, qPrintable(code + ": " + t));
      }
}

// As the target update_translations does it, on copies.
void LanguageTest::theTranslationsHaveAllTextsOfTheSources() {
  const QTemporaryDir folder;
  QStringList arguments = QString::fromUtf8(HANDLEBODY_LUPDATE_OPTIONS).split(QLatin1Char(' '));
  arguments << "ui"
            << "app/window"
            << "core/finding_words.cpp"
            << "core/finding_file_words.cpp"
            << "core/finding_dicom_words.cpp"
            << "core/finding_warning_words.cpp"
            << "-ts";
  for (const QString& code : translatedLanguages()) {
    const QString copy = folder.filePath("handlebody_" + code + ".ts");
    QVERIFY(QFile::copy(translationFile(code), copy));
    arguments << copy;
  }
  QProcess lupdate;
  lupdate.setWorkingDirectory(sourcesOf(""));
  lupdate.start(QStringLiteral(HANDLEBODY_LUPDATE), arguments);
  QVERIFY(lupdate.waitForFinished(60'000));
  const QString said = QString::fromUtf8(lupdate.readAllStandardOutput());
  QCOMPARE(said.count(QStringLiteral("(0 new and ")), translatedLanguages().size());
  QVERIFY2(!said.contains(QStringLiteral("Removed")), qPrintable(said));
}

void LanguageTest::theGuideHasTheSamePartsInEveryLanguage() {
  static const QRegularExpression part(
      QStringLiteral("<a name=\"[a-z]+\"|<h[1-3]>|<img src=\"[^\"]*\"|<a href=\"#[a-z]+\"|<li>|<tr>"));
  const auto partsOf = [](const QString& html) {
    QStringList parts;
    for (auto m = part.globalMatch(html); m.hasNext();) parts << m.next().captured();
    return parts;
  };
  const QStringList english = partsOf(QString::fromUtf8(contentOf(sourcesOf("resources/guide/guide.html"))));
  QVERIFY(english.size() > 50);
  for (const QString& code : translatedLanguages()) {
    ui::useLanguage(code);
    QCOMPARE(partsOf(QString::fromUtf8(contentOf(":" + ui::guideFile()))), english);
    QVERIFY(ui::guideFile().contains(code));
  }
}

void LanguageTest::whatTheWindowShowsIsInItsLanguage() {
  for (const QString& code : translatedLanguages()) {
    ui::useLanguage(code);
    QSet<QString> english;  // what has another wording in this language
    for (const Entry& e : entriesOf(code))
      if (bare(e.source) != bare(e.translations.value(0))) english << bare(e.source);
    for (const Entry& e : entriesOf(code)) english.remove(bare(e.translations.value(0)));
    auto window = windowWithResult();
    QVERIFY(window);
    const ui::HelpWindow help;
    for (const QString& text : textsOf(*window) + textsOf(help))
      QVERIFY2(!english.contains(bare(text)), qPrintable(code + ": " + text));
  }
}

void LanguageTest::nothingIsCutOffInAnyLanguage() {
  for (const QString& code : translatedLanguages()) {
    ui::useLanguage(code);
    QStringList faults;
    auto window = windowWithResult();
    QVERIFY(window);
    for (const ui::Command step : kSteps) {
      window->showStep(step);
      window->resize(1280, 800);
      for (const QString& fault : lastingLayoutFaults(*window))
        faults << window->commands()[step]->text() + ": " + fault;
    }
    ui::HelpWindow help;
    help.show(ui::HelpWindow::Page::shortcuts);
    QVERIFY(QTest::qWaitForWindowExposed(&help));
    faults += lastingLayoutFaults(help);
    QVERIFY2(faults.isEmpty(), qPrintable(code + ":\n" + faults.join(QLatin1Char('\n'))));
  }
}

void LanguageTest::numbersAndFindingsAreWrittenAsTheLanguageDoes() {
  const Finding neck(FindingKind::heldAtPassages, {{"radius_mm", 2.5}});
  const Finding seed(FindingKind::seedOutside,
                     {{"place", std::array{1.5, -2.0, 3.0}}, {"voxel", std::array{0., 0., 0.}}});
  QVERIFY(ui::findingSentence(neck).contains("2.5 mm"));
  QCOMPARE(ui::findingSentence(seed),
           QStringLiteral("The seed at 1.5, -2.0, 3.0 mm lies outside the volume."));
  ui::useLanguage(QStringLiteral("de"));
  QVERIFY(ui::findingSentence(neck).contains(QStringLiteral("2,5 mm Radius")));
  QVERIFY(ui::findingSentence(neck).endsWith(QLatin1Char('.')));
  QCOMPARE(ui::findingSentence(seed),
           QStringLiteral("Der Startpunkt bei 1,5; -2,0; 3,0 mm liegt außerhalb des Bildvolumens."));
  QVERIFY(sentence(neck).find("2.5 mm") != std::string::npos);  // reports are English
  auto window = windowWithResult();
  QVERIFY(window);
  QVERIFY(shownText(*window, "Volumen").contains(QLatin1Char(',')));
  ui::useLanguage(QStringLiteral("zh_CN"));
  QVERIFY(ui::findingSentence(neck).contains(QStringLiteral("2.5 mm")));
}

void LanguageTest::everyFindingIsToldInEveryLanguage() {
  static const QRegularExpression hole(QStringLiteral("\\{[^}]*\\}|[.: ]"));
  for (int k = 0; k < kFindingKinds; ++k) {
    const auto kind = static_cast<FindingKind>(k);
    ui::useLanguage(QStringLiteral("en"));
    const QString english = ui::findingText(kind);
    if (QString(english).remove(hole).isEmpty()) continue;  // the words of another finding alone
    for (const QString& code : translatedLanguages()) {
      ui::useLanguage(code);
      QVERIFY2(ui::findingText(kind) != english, qPrintable(code + ": " + english));
    }
  }
}

void LanguageTest::whatIsWrongWithAFileIsToldInEveryLanguage() {
  const QTemporaryDir folder;
  const QStringList files = brokenFiles(folder);
  for (const QString& code : translatedLanguages()) {
    ui::useLanguage(code);
    const QStringList english = englishParts(code);
    for (const QString& file : files) {
      const QString said = whyNot(file);
      QVERIFY2(said.contains(QFileInfo(file).fileName()), qPrintable(file + ": " + said));
      for (const QString& part : english)
        QVERIFY2(!said.contains(part), qPrintable(code + ": " + said + "\nhas: " + part));
    }
  }
  auto window = shownWindow();
  QVERIFY(window);
  ui::useLanguage(QStringLiteral("de"));
  QSignalSpy failed(&window->document(), &ui::Document::openFailed);
  window->document().open(files.front(), {});
  QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
  QCOMPARE(failed.front().front().toString(),
           files.front() + QStringLiteral(": es gibt keine solche Datei und keinen solchen Ordner."));
}

void LanguageTest::whatIsWrongWithASessionIsToldInEveryLanguage() {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("s.json"));
  QFile file(path);
  QVERIFY(file.open(QFile::WriteOnly));
  file.write(R"({"version": "1", "input": {"path": "v.mha", "sha256": null},
                 "requested": {"seeds": [{"centre": [1, 2]}]}})");
  file.close();
  const auto told = [&path] {
    try {
      readSessions(path.toStdString());
    } catch (const std::exception&) {
      return ui::errorSentence();
    }
    return QString();
  };
  ui::useLanguage(QStringLiteral("en"));
  QVERIFY(told().contains(QStringLiteral("its field 'requested.seeds[0].centre' must have 3 entries")));
  for (const QString& code : translatedLanguages()) {
    ui::useLanguage(code);
    const QString said = told();
    QVERIFY2(said.contains(path) && said.contains(QStringLiteral("requested.seeds[0].centre")),
             qPrintable(said));
    QVERIFY2(!said.contains(QStringLiteral("field '")) && !said.contains(QStringLiteral("session nor")),
             qPrintable(said));
  }
}

void LanguageTest::whyATableIsNotWrittenIsToldInEveryLanguage() {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("missing/measures.csv"));
  QTimer timer;
  connect(&timer, &QTimer::timeout, this, [&path] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (!dialog) return;
    if (auto* edit = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))) edit->setText(path);
    dialog->accept();
  });
  timer.start(200);
  for (const QString& code : translatedLanguages()) {
    ui::useLanguage(code);
    auto window = shownWindow();
    QVERIFY(window);
    window->files().saveText(QStringLiteral("-"), QStringLiteral("measures"), QStringLiteral(".csv"), "1,2");
    const QString said = window->messages().text();
    QVERIFY2(said.contains(path), qPrintable(said));
    for (const QString& part : englishParts(code))
      QVERIFY2(!said.contains(part), qPrintable(code + ": " + said + "\nhas: " + part));
  }
}

void LanguageTest::whatIsToBeKnownOfAFileIsToldInEveryLanguage() {
  const QTemporaryDir folder;
  QFile file(folder.filePath(QStringLiteral("nowhere.nrrd")));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("NRRD0004\ntype: uint8\ndimension: 3\nsizes: 8 8 8\nencoding: raw\n\n");
  for (int i = 0; i < 512; ++i) file.putChar(static_cast<char>(i % 100));
  file.close();
  for (const QString& code : translatedLanguages()) {
    ui::useLanguage(code);
    auto window = shownWindow();
    QVERIFY(window && open(*window, file.fileName()));
    window->showStep(ui::Command::stepOpen);
    const QString said = warningsIn(*window);
    QCOMPARE(said.count(QChar(0x26a0)), 2);
    for (const QString& part : englishParts(code))
      QVERIFY2(!said.contains(part), qPrintable(code + ": " + said + "\nhas: " + part));
    if (code != QLatin1String("de")) continue;
    QCOMPARE(shownText(*window, "Warnungen"), said);
    QVERIFY2(said.contains(QStringLiteral("Der Header sagt nicht, wie das Bildvolumen im Raum liegt; seine "
                                          "Achsen werden als LPS verstanden.")),
             qPrintable(said));
    QVERIFY2(said.contains(QStringLiteral("Das Bildvolumen ist nicht kalibriert: ")), qPrintable(said));
  }
}

void LanguageTest::filesAreTheSameInEveryLanguage() {
  const QTemporaryDir folder;
  for (const QString& code : {QStringLiteral("en"), QStringLiteral("de")}) {
    ui::useLanguage(code);
    auto window = windowWithResult();
    QVERIFY(window);
    ui::Document& document = window->document();
    QSignalSpy saved(&document, &ui::Document::sessionSaved), exported(&document, &ui::Document::exported);
    document.saveSession(folder.filePath(code + "_session.json"));
    QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
    document.exportReport(folder.filePath(code + "_report.json"));
    QTRY_COMPARE_WITH_TIMEOUT(exported.size(), 1, kPatience);
  }
  QCOMPARE(contentOf(folder.filePath("de_session.json")), contentOf(folder.filePath("en_session.json")));
  const QByteArray report = withoutTimes(contentOf(folder.filePath("de_report.json")));
  QVERIFY(report.size() > 1000);
  QCOMPARE(report, withoutTimes(contentOf(folder.filePath("en_report.json"))));
}

void LanguageTest::theLanguageIsChosenByOptionEnvironmentSettingAndSystem() {
  QSettings().clear();
  QCOMPARE(ui::languageToUse({}), QStringLiteral("en"));  // the tests' system has no language of its own
  ui::chooseLanguage(QStringLiteral("fr"));
  QCOMPARE(ui::languageToUse({}), QStringLiteral("fr"));
  qputenv("HANDLEBODY_LANGUAGE", "es");
  QCOMPARE(ui::languageToUse({}), QStringLiteral("es"));
  QCOMPARE(ui::languageToUse(QStringLiteral("de")), QStringLiteral("de"));
  QCOMPARE(ui::languageToUse(QStringLiteral("system")), QStringLiteral("en"));
  qputenv("HANDLEBODY_LANGUAGE", "klingon");
  QCOMPARE(ui::languageToUse({}), QStringLiteral("fr"));
  qunsetenv("HANDLEBODY_LANGUAGE");
  QSettings().clear();
}

QTEST_MAIN(LanguageTest)
#include "language_test.moc"
