// Compares pictures of the program with those in tests/ui/pictures:
//   sh tests/ui/with_display.sh picture_tests PROGRAM SAMPLES BASELINES [OUT]
// Each picture is made by `handlebody --screenshot`, reduced to a quarter by averaging 4 × 4 pixels, which
// levels out the rims of letters, and compared pixel by pixel. Tolerance: at most 2 of 1000 pixels may differ
// by more than 40 of 255 levels in a channel. An outline moved by three pixels, a surface or a panel that is
// gone change several times as many. What differs is written to OUT. `--renew` in the place of OUT writes the
// baselines anew: look at them before they are committed.

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>

namespace {

constexpr int kReduction = 4;
constexpr int kLevels = 40;       // of 255
constexpr double kShare = 0.002;  // of the pixels

struct Case {
  const char* name;
  const char* file;  // in the folder of samples; empty: none
  const char* options;
};

constexpr Case kCases[] = {
    {"start_light", "", "--appearance light"},
    {"seed_dark", "cyst.nii.gz", "--appearance dark --step seed"},
    {"tune_light", "cyst_session.json", "--appearance light --iteration 20 --step tune"},
    {"handle_dark", "cyst_session.json", "--appearance dark --iteration 36 --stage handle --step grow"},
    {"export_light", "cyst_session.json", "--appearance light --iteration 500 --step export"},
    {"axial", "cyst_session.json", "--iteration 36 --view axial"},
    {"ring_3d", "cyst_session.json", "--iteration 500 --view 3d"},
};

QImage reduced(const QImage& picture) {
  const QImage in = picture.convertToFormat(QImage::Format_RGB32);
  QImage out(in.width() / kReduction, in.height() / kReduction, QImage::Format_RGB32);
  for (int y = 0; y < out.height(); ++y)
    for (int x = 0; x < out.width(); ++x) {
      int sum[3] = {0, 0, 0};
      for (int j = 0; j < kReduction; ++j)
        for (int i = 0; i < kReduction; ++i) {
          const QRgb p = in.pixel(kReduction * x + i, kReduction * y + j);
          sum[0] += qRed(p);
          sum[1] += qGreen(p);
          sum[2] += qBlue(p);
        }
      constexpr int kPixels = kReduction * kReduction;
      out.setPixel(x, y, qRgb(sum[0] / kPixels, sum[1] / kPixels, sum[2] / kPixels));
    }
  return out;
}

int difference(QRgb a, QRgb b) {
  return std::max(
      {std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

//! Share of the pixels that differ; 1 where the sizes do.
double shareOfDifferent(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return 1;
  int different = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) different += difference(a.pixel(x, y), b.pixel(x, y)) > kLevels;
  return double(different) / (double(a.width()) * a.height());
}

QImage shoot(const QString& program, const QString& samples, const Case& c, const QString& path) {
  QStringList arguments = QString::fromLatin1(c.options).split(QLatin1Char(' '), Qt::SkipEmptyParts);
  if (*c.file) arguments << QDir(samples).filePath(QString::fromLatin1(c.file));
  arguments << "--size"
            << "1280x800"
            << "--screenshot" << path;
  if (QProcess::execute(program, arguments) != 0) return {};
  return QImage(path);
}

//! The comparison itself must see three pixels.
bool seesAShift(const QImage& picture, const QImage& small) {
  return shareOfDifferent(reduced(picture.copy(3, 0, picture.width(), picture.height())), small) > kShare;
}

bool passes(const QImage& picture, const Case& c, const QString& baselines, const QString& out) {
  const QString name = QString::fromLatin1(c.name) + QStringLiteral(".png");
  const QImage small = reduced(picture);
  const double share = shareOfDifferent(small, QImage(QDir(baselines).filePath(name)));
  const bool good = share <= kShare && seesAShift(picture, small);
  std::printf("%-14s %.3f %% of the pixels differ%s\n", c.name, 100 * share, good ? "" : ": FAILED");
  if (!good && !out.isEmpty()) {
    QDir().mkpath(out);
    small.save(QDir(out).filePath(name));
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  if (argc < 4) return 2;
  const QString program = argv[1], samples = argv[2], baselines = argv[3], out = argc > 4 ? argv[4] : "";
  const bool renew = out == QLatin1String("--renew");
  const QTemporaryDir folder;
  int failed = 0;
  for (const Case& c : kCases) {
    const QImage picture = shoot(program, samples, c, folder.filePath("picture.png"));
    if (picture.isNull()) {
      std::printf("%-14s no picture: FAILED\n", c.name);
      ++failed;
    } else if (renew) {
      failed += !reduced(picture).save(QDir(baselines).filePath(QString::fromLatin1(c.name) + ".png"));
    } else {
      failed += !passes(picture, c, baselines, out);
    }
  }
  return failed ? 1 : 0;
}
