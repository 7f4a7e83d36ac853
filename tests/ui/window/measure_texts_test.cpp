// Measures as the window writes them, in the user's locale and language.

#include <QApplication>
#include <QTest>
#include <QTranslator>

#include "ui/model/measuring.h"
#include "ui/window/measures/measure_texts.h"

using namespace handlebody;

namespace {

//! Puts every text in brackets.
class Brackets : public QTranslator {
 public:
  bool isEmpty() const override { return false; }
  QString translate(const char*, const char* text, const char*, int) const override {
    return QStringLiteral("[%1]").arg(QString::fromUtf8(text));
  }
};

class MeasureTextsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { QLocale::setDefault(QLocale::system()); }
  void copiedNumbersHaveThePointOfTheLocale();
  void theSurfacesOfAWallAreTranslated();
  void whyARunLeftNoSurfaceIsTranslated();
};

void MeasureTextsTest::copiedNumbersHaveThePointOfTheLocale() {
  const QString columns = QStringLiteral(
      "object\tvolume_mm3\tgenus\tnearest_object\tdistance_mm\twall_first\twall_from_first_mean_mm\n"
      "1.5\t12.625\t3\t2.5\t-1.25e-05\t1.5\t\n");
  QLocale::setDefault(QLocale(QStringLiteral("de")));
  QCOMPARE(ui::columnsForSpreadsheet(columns),
           QStringLiteral(
               "object\tvolume_mm3\tgenus\tnearest_object\tdistance_mm\twall_first\twall_from_first_mean_mm\n"
               "1.5\t12,625\t3\t2.5\t-1,25e-05\t1.5\t\n"));
  QLocale::setDefault(QLocale(QStringLiteral("en")));
  QCOMPARE(ui::columnsForSpreadsheet(columns), columns);
  QVERIFY(ui::columnsForSpreadsheet(QString()).isEmpty());
}

void MeasureTextsTest::theSurfacesOfAWallAreTranslated() {
  Measured measured;
  measured.wall = MeasuredWall{ui::kOuterSurface, ui::kCavities, {}};
  MeasuredObject object;
  Brackets brackets;
  QCoreApplication::installTranslator(&brackets);
  const QString own = ui::measureDetails(measured, object, Grid());
  measured.wall->second = "Lesion";
  const QString others = ui::measureDetails(measured, object, Grid());
  QCoreApplication::removeTranslator(&brackets);
  QVERIFY2(
      own.contains(QStringLiteral("[the outer surface]")) && own.contains(QStringLiteral("[the cavities]")),
      qPrintable(own));
  QVERIFY2(others.contains(QStringLiteral("Lesion")) && !others.contains(QStringLiteral("[Lesion]")),
           qPrintable(others));
}

void MeasureTextsTest::whyARunLeftNoSurfaceIsTranslated() {
  PerturbedRun run;
  run.failure = sentence(FindingKind::sensitivityVanished);
  Brackets brackets;
  QCoreApplication::installTranslator(&brackets);
  const QString words = ui::failureText(run);
  run.why = FindingKind::sensitivityVanished;
  const QString finding = ui::failureText(run);
  QCoreApplication::removeTranslator(&brackets);
  QCOMPARE(words, QStringLiteral("The surface vanished."));
  QCOMPARE(finding, QStringLiteral("[The surface vanished.]"));
}

}  // namespace

QTEST_MAIN(MeasureTextsTest)
#include "measure_texts_test.moc"
