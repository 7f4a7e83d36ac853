// What the window keeps: layout between starts, and the view in a session.

#include <QDockWidget>
#include <QFileInfo>
#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMessageBox>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/model/time_series.h"
#include "ui/view/surface_scene.h"
#include "ui/view/surface_view.h"
#include "ui/window/help/help_window.h"
#include "ui/window/main_window.h"
#include "ui/window/open/file_work.h"
#include "ui/window/views/view_grid.h"
#include "ui/window/widgets/message_bar.h"
#include "ui/window/widgets/sentences.h"

namespace handlebody::ui {

namespace {

constexpr int kLayoutVersion = 1;
const QSize kUsualSize(1440, 900);
const QSize kFrame(12, 44);  // pixels that a frame takes, of which nothing is known until it is there
const QString kNoticeShown = QStringLiteral("noticeShown"), kGeometry = QStringLiteral("geometry"),
              kDocks = QStringLiteral("docks"), kViews = QStringLiteral("views"),
              kAppearance = QStringLiteral("appearance");

QJsonArray toJson(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

QJsonObject toJson(const StandingCamera& camera) {
  return {{QStringLiteral("focus"), toJson(camera.pose.focus)},
          {QStringLiteral("towardsEye"), toJson(camera.pose.towardsEye)},
          {QStringLiteral("up"), toJson(camera.pose.up)},
          {QStringLiteral("height"), camera.pose.height},
          {QStringLiteral("follows"), camera.follows}};
}

//! Precondition: there is one.
int firstInside(const std::vector<Seed>& seeds) {
  return static_cast<int>(
      std::find_if(seeds.begin(), seeds.end(), [](const Seed& s) { return !s.background; }) - seeds.begin());
}

bool isPoint(const QJsonArray& array) {
  return array.size() == 3 && array[0].isDouble() && array[1].isDouble() && array[2].isDouble();
}

std::optional<Vec3> pointIn(const QJsonObject& object, const QString& key) {
  const QJsonArray p = object[key].toArray();
  if (!isPoint(p)) return std::nullopt;
  return Vec3(p[0].toDouble(), p[1].toDouble(), p[2].toDouble());
}

//! None if it looks nowhere.
std::optional<StandingCamera> cameraIn(const QJsonObject& camera) {
  constexpr double kSquare = 1e-3;  // the two directions, of length 1, are at right angles
  const auto focus = pointIn(camera, QStringLiteral("focus")),
             towardsEye = pointIn(camera, QStringLiteral("towardsEye")),
             up = pointIn(camera, QStringLiteral("up"));
  const double height = camera[QStringLiteral("height")].toDouble();
  if (!focus || !towardsEye || !up || !(height > 0)) return std::nullopt;
  const bool isSquare = std::abs(towardsEye->norm() - 1) < kSquare && std::abs(up->norm() - 1) < kSquare &&
                        std::abs(towardsEye->dot(*up)) < kSquare;
  if (!isSquare) return std::nullopt;
  return StandingCamera{{*focus, *towardsEye, *up, height}, camera[QStringLiteral("follows")].toBool(true)};
}

}  // namespace

void MainWindow::restoreSettings() {
  const QSettings settings;
  const QSize screen = QGuiApplication::primaryScreen()->availableSize();
  resize(kUsualSize.boundedTo(screen - kFrame));
  restoreGeometry(settings.value(kGeometry).toByteArray());
  if (!restoreState(settings.value(kDocks).toByteArray(), kLayoutVersion))
    resizeDocks({timelineDock_}, {170}, Qt::Vertical);
  views_->restoreLayout(settings.value(kViews).toByteArray());
  const int appearance = settings.value(kAppearance, 0).toInt();
  setAppearance(appearance == 1 ? Appearance::light
                                : (appearance == 2 ? Appearance::dark : Appearance::system));
}

void MainWindow::saveSettings() {
  QSettings settings;
  settings.setValue(kGeometry, saveGeometry());
  settings.setValue(kDocks, saveState(kLayoutVersion));
  settings.setValue(kViews, views_->saveLayout());
  settings.setValue(kAppearance, static_cast<int>(appearance_));
}

void MainWindow::greet() {
  files_->offerRecovery();
  QSettings settings;
  if (settings.value(kNoticeShown).toBool()) return;
  auto* notice =
      new QMessageBox(QMessageBox::Information, tr("Handlebody"), purposeNotice(), QMessageBox::Ok, this);
  notice->setAttribute(Qt::WA_DeleteOnClose);
  connect(notice, &QMessageBox::finished, this, [] { QSettings().setValue(kNoticeShown, true); });
  notice->open();
}

void MainWindow::showOpened() {
  centre_->setCurrentWidget(views_);
  state_.startWith(document_.volume());
  justOpened_ = true;
  restoreView();
  showStep(document_.isSeeded() ? Command::stepGrow : Command::stepSeed);
  if (document_.isSeeded()) {
    const int first = firstInside(document_.seeds());
    if (document_.selectedSeed() < 0) document_.selectSeed(first);
    if (document_.view().isEmpty()) state_.setCrosshair(document_.seeds()[first].centre);
  }
  updateTitle();
  messages_->dismiss();
  QStringList warnings{mainWarning(document_.info()), std::exchange(dropNote_, {})};
  warnings.removeAll(QString());
  if (!warnings.isEmpty()) messages_->show(MessageBar::Kind::warning, warnings.join(QLatin1Char(' ')));
}

void MainWindow::keepView() {
  QJsonObject view;
  view[QStringLiteral("crosshair")] = toJson(state_.crosshair());
  view[QStringLiteral("window")] = state_.window();
  view[QStringLiteral("level")] = state_.level();
  view[QStringLiteral("colourMap")] = static_cast<int>(state_.colourMap());
  view[QStringLiteral("surface")] = static_cast<int>(state_.meshColouring());
  view[QStringLiteral("slicesIn3d")] = state_.slicesIn3d();
  if (const auto camera = views_->surface().camera()) view[QStringLiteral("camera")] = toJson(*camera);
  view[QStringLiteral("views")] = QString::fromLatin1(views_->saveLayout().toBase64());
  if (const TimeSeries& time = document_.time(); time.hasTime() && !time.showsGrownFrame())
    view[QStringLiteral("frame")] = time.shownFrame();
  document_.setView(QJsonDocument(view).toJson(QJsonDocument::Compact));
}

// A session may come from anywhere: what makes no sense is left as it is.
void MainWindow::restoreView() {
  const QJsonObject view = QJsonDocument::fromJson(document_.view()).object();
  if (const auto point = pointIn(view, QStringLiteral("crosshair"))) state_.setCrosshair(*point);
  const double window = view[QStringLiteral("window")].toDouble();
  if (window > 0) state_.setWindowLevel(window, view[QStringLiteral("level")].toDouble());
  const int map = view[QStringLiteral("colourMap")].toInt(-1);
  if (map >= 0 && map <= static_cast<int>(ColourMap::contrast))
    state_.setColourMap(static_cast<ColourMap>(map));
  const int surface = view[QStringLiteral("surface")].toInt(-1);
  if (surface >= 0 && surface <= static_cast<int>(MeshColouring::support))
    state_.setMeshColouring(static_cast<MeshColouring>(surface));
  if (const int frame = view[QStringLiteral("frame")].toInt(-1); frame >= 0) document_.time().show(frame);
  if (const QByteArray layout = view[QStringLiteral("views")].toString().toLatin1(); !layout.isEmpty())
    views_->restoreLayout(QByteArray::fromBase64(layout));
  if (const auto camera = cameraIn(view[QStringLiteral("camera")].toObject()))
    views_->surface().setCamera(*camera);
  state_.setSlicesIn3d(view[QStringLiteral("slicesIn3d")].toBool(state_.slicesIn3d()));
}

void MainWindow::updateTitle() {
  setWindowModified(document_.hasVolume() && document_.isModified());
  setWindowTitle(document_.hasVolume() ? tr("%1[*] – Handlebody").arg(QFileInfo(document_.path()).fileName())
                                       : tr("Handlebody[*]"));
}

}  // namespace handlebody::ui
