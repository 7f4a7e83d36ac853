// Numbers with decimals as people type and paste them, in every language of the window.

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QTest>
#include <cmath>

#include "ui/window/open/spacing_entry.h"
#include "ui/window/tune/intensity_field.h"
#include "ui/window/widgets/decimal_field.h"
#include "ui/window/widgets/value_field.h"

using namespace handlebody;

namespace {

constexpr const char* kLocales[] = {"de", "fr", "es", "en", "zh_CN", "de_CH"};

class Typed {
 public:
  explicit Typed(QDoubleSpinBox& field) : field_(field) { field.setKeyboardTracking(false); }

  double operator()(const char* keys) {
    field_.selectAll();
    QTest::keyClicks(&field_, QString::fromUtf8(keys));
    QTest::keyClick(&field_, Qt::Key_Return);
    return field_.value();
  }

  double pasted(const char* text) {
    QApplication::clipboard()->setText(QString::fromUtf8(text));
    field_.selectAll();
    field_.findChild<QLineEdit*>()->paste();
    QTest::keyClick(&field_, Qt::Key_Return);
    return field_.value();
  }

 private:
  QDoubleSpinBox& field_;
};

//! As the radii and spacings are made, in millimetres.
void makeLength(ui::DecimalField& field, double low, double high, int decimals) {
  field.setDecimals(decimals);
  field.setRange(low, high);
  field.setSuffix(QStringLiteral(" mm"));
}

ui::ValueSpec lengthSpec() {
  ui::ValueSpec spec;
  spec.name = spec.tip = QStringLiteral("Length");
  spec.unit = QStringLiteral("mm");
  spec.high = 5000;
  spec.decimals = 3;
  return spec;
}

class DecimalFieldTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { QLocale::setDefault(QLocale::system()); }
  void bothPointsAreTheDecimalPoint_data() { addLocales(); }
  void bothPointsAreTheDecimalPoint();
  void groupsAreNeitherReadNorWritten_data() { addLocales(); }
  void groupsAreNeitherReadNorWritten();
  void fieldsOfParametersTakeBothPoints_data() { addLocales(); }
  void fieldsOfParametersTakeBothPoints();
  void spacingsTakeBothPoints_data() { addLocales(); }
  void spacingsTakeBothPoints();
  void openEndsOfARangeAreTyped_data() { addLocales(); }
  void openEndsOfARangeAreTyped();
  void theUnitKeepsItsPoints();

 private:
  static void addLocales();
};

void DecimalFieldTest::addLocales() {
  QTest::addColumn<QString>("locale");
  for (const char* code : kLocales) QTest::newRow(code) << QString::fromLatin1(code);
}

//! Makes that of the row the default one.
void useLocaleOfRow() {
  QFETCH(QString, locale);
  QLocale::setDefault(QLocale(locale));
}

void DecimalFieldTest::bothPointsAreTheDecimalPoint() {
  useLocaleOfRow();
  for (const double high : {100.0, 1e6}) {  // Qt treats groups apart below a thousand
    ui::DecimalField field;
    makeLength(field, -high, high, 4);
    Typed typed(field);
    QCOMPARE(typed("0.5"), 0.5);
    QCOMPARE(typed("0,625"), 0.625);
    QCOMPARE(typed("0.625"), 0.625);
    QCOMPARE(typed("12,5"), 12.5);
    QCOMPARE(typed("12.5 mm"), 12.5);
    QCOMPARE(typed("-1.234"), -1.234);
    QCOMPARE(typed("-1,234"), -1.234);
    QCOMPARE(typed(".5"), 0.5);
    QCOMPARE(typed("7"), 7.0);
    QCOMPARE(field.text(), QLocale().toString(7.0, 'f', 4) + QStringLiteral(" mm"));
    QCOMPARE(typed.pasted("0.625"), 0.625);
    QCOMPARE(typed.pasted("-2,75"), -2.75);
    QCOMPARE(typed.pasted("3.5 mm"), 3.5);
    QCOMPARE(typed.pasted("4,25mm"), 4.25);
  }
}

void DecimalFieldTest::groupsAreNeitherReadNorWritten() {
  useLocaleOfRow();
  ui::DecimalField field;
  makeLength(field, 0, 1e6, 2);
  Typed typed(field);
  QCOMPARE(typed("12345.5"), 12345.5);
  QVERIFY(field.text().startsWith(QStringLiteral("12345")));
  for (const char* groups : {"1.234,5", "1,234.5", "1 234,5", "1\u202f234,5", "1’234.5", "1'234.5"})
    QCOMPARE(typed.pasted(groups), 12345.5);  // not taken
  ui::IntensityField intensity;
  intensity.setKnown(true);
  intensity.setEnd(12345);
  QCOMPARE(intensity.text(), QStringLiteral("12345"));
}

void DecimalFieldTest::fieldsOfParametersTakeBothPoints() {
  useLocaleOfRow();
  ui::ValueField field(lengthSpec());
  auto* number = field.findChild<QDoubleSpinBox*>();
  field.show(std::nullopt);
  field.show(2.0);
  Typed typed(*number);
  QCOMPARE(typed("0.625"), 0.625);
  QCOMPARE(typed("0,5"), 0.5);
  ui::ValueSpec whole = lengthSpec();
  whole.decimals = 0;
  ui::ValueField count(whole);
  count.show(3.0);
  QCOMPARE(Typed(*count.findChild<QDoubleSpinBox*>()).pasted("1.5"), 3.0);
}

void DecimalFieldTest::spacingsTakeBothPoints() {
  useLocaleOfRow();
  ui::SpacingEntry entry;
  for (QDoubleSpinBox* field : entry.findChildren<QDoubleSpinBox*>()) {
    QCOMPARE(Typed(*field)("0.625"), 0.625);
    QCOMPARE(Typed(*field)("0,75"), 0.75);
  }
}

void DecimalFieldTest::openEndsOfARangeAreTyped() {
  useLocaleOfRow();
  ui::IntensityField field;
  field.setKnown(true);
  Typed typed(field);
  QCOMPARE(typed("-0.5"), -0.5);
  QCOMPARE(typed("12,25"), 12.25);
  typed("-inf");
  QVERIFY(std::isinf(field.end()) && field.end() < 0);
  QCOMPARE(typed("1500.5"), 1500.5);
  typed("inf");
  QVERIFY(std::isinf(field.end()) && field.end() > 0);
  field.setKnown(false);
  QTest::keyClick(&field, Qt::Key_Return);  // the dash is no number
  QVERIFY(std::isinf(field.end()));
}

void DecimalFieldTest::theUnitKeepsItsPoints() {
  QLocale::setDefault(QLocale(QStringLiteral("de")));
  ui::DecimalField field;
  field.setSuffix(QStringLiteral(" a.u."));
  field.setRange(0, 10);
  QCOMPARE(Typed(field)("2.5"), 2.5);
  QCOMPARE(field.text(), QStringLiteral("2,50 a.u."));
}

}  // namespace

QTEST_MAIN(DecimalFieldTest)
#include "decimal_field_test.moc"
