#include "app/window/screenshot.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QTimer>
#include <iostream>

#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "ui/model/time_series.h"
#include "ui/view/surface_view.h"
#include "ui/window/main_window.h"
#include "ui/window/measures/measures_panel.h"
#include "ui/window/measures/object_measures_page.h"
#include "ui/window/measures/sensitivity_page.h"
#include "ui/window/timeline/event_inspector.h"
#include "ui/window/views/view_grid.h"

namespace handlebody::app {

namespace {

enum Code { kDone = 0, kOutput = 2, kInput = 3, kSeed = 4 };
constexpr ui::EventStage kStages[] = {ui::EventStage::colliding, ui::EventStage::opened,
                                      ui::EventStage::handle, ui::EventStage::closed,
                                      ui::EventStage::refined};
const QStringList kStageWords{QStringLiteral("collide"), QStringLiteral("open"), QStringLiteral("handle"),
                              QStringLiteral("close"), QStringLiteral("refine")};
constexpr int kSettle = 400;      // ms for layouts and the last drawing
constexpr int kPrepare = 60'000;  // ms at most
constexpr int kLayouts = 3;

}  // namespace

Screenshot::Screenshot(const Options& options, ui::MainWindow& window) : options_(options), window_(window) {
  ui::Document& document = window_.document();
  window_.views().surface().setFlightTime(0);
  connect(&document, &ui::Document::openFailed, this, [this](const QString& why) { end(kInput, why); });
  connect(&document, &ui::Document::seriesChoiceNeeded, this, [this] { take(); });
  connect(&document, &ui::Document::fileNeeded, this, [this] { take(); });
  connect(&document, &ui::Document::opened, this, &Screenshot::grow);
  connect(&document, &ui::Document::stateChanged, this, &Screenshot::continueGrowing);
  connect(&document, &ui::Document::snapshotChanged, this, &Screenshot::continueGrowing);
}

void Screenshot::start() {
  if (options_.file.isEmpty())
    take();
  else
    window_.document().open(options_.file);
}

void Screenshot::grow() {
  ui::Document& document = window_.document();
  if (!document.view().isEmpty()) crosshair_ = window_.viewState().crosshair();
  if (!options_.iteration) return take();
  if (!document.isSeeded()) return end(kSeed, tr("There is no seed to grow from: open a session."));
  growing_ = true;
  document.stepForward();  // the first one prepares the growth
}

// Step by step: a growth that runs is stopped some iterations too late, and the picture would tell how many.
void Screenshot::continueGrowing() {
  if (!growing_) return;
  ui::Document& document = window_.document();
  if (!document.growthError().isEmpty()) return end(kSeed, document.growthError());
  const bool finished = document.state() == ui::GrowthState::finished;
  if (!finished && document.state() != ui::GrowthState::paused) return;  // on the way
  const int wanted = *options_.iteration, now = document.iteration();
  if (now < wanted && !finished) {
    if (now != stepped_) document.stepForward();
    stepped_ = now;
    return;
  }
  if (now > wanted) return document.goTo(wanted);
  window_.views().surface().resetCamera();  // it followed the growth, as fast as it could
  take();
}

void Screenshot::take() {
  growing_ = false;
  if (crosshair_) window_.viewState().setCrosshair(*crosshair_);
  if (options_.step == QStringLiteral("measure")) return measure();
  if (options_.step == QStringLiteral("sensitivity")) return tellSensitivity();
  if (options_.step == QStringLiteral("time")) return carry();
  if (!options_.step.isEmpty()) {
    const QStringList steps{QStringLiteral("open"), QStringLiteral("seed"),    QStringLiteral("tune"),
                            QStringLiteral("grow"), QStringLiteral("correct"), QStringLiteral("export")};
    window_.showStep(
        static_cast<ui::Command>(int(ui::Command::stepOpen) + int(steps.indexOf(options_.step))));
  }
  if (options_.stage.isEmpty()) return settleWhenPrepared();
  if (window_.inspector().event() < 0)
    return end(
        kOutput,
        tr("There is no event at iteration %1, and so no stage of it.").arg(options_.iteration.value_or(0)));
  showStage();
}

//! With the automatic values, which are found in the background; not for ever, since another object may have
//! to grow before.
void Screenshot::settleWhenPrepared() {
  settleWhen([this, waited = QElapsedTimer()]() mutable {
    if (!waited.isValid()) waited.start();
    const ui::Document& document = window_.document();
    return !document.isSeeded() || document.iteration() >= 0 || document.resolved() ||
           !document.resolveError().isEmpty() || waited.hasExpired(kPrepare);
  });
}

//! The panel of measures, with its table if there is a surface.
void Screenshot::measure() {
  window_.showStep(ui::Command::stepExport);
  window_.commands()[ui::Command::showMeasures]->trigger();
  settleWhen([this] { return window_.document().iteration() < 0 || window_.measures().objects().shown(); });
}

void Screenshot::settleWhen(std::function<bool()> isDone) {
  constexpr int kLook = 50;  // ms
  auto* look = new QTimer(this);
  connect(look, &QTimer::timeout, this, [this, look, isDone = std::move(isDone)]() mutable {
    if (!isDone()) return;
    look->stop();
    settle();
  });
  look->start(kLook);
}

void Screenshot::tellSensitivity() {
  window_.showStep(ui::Command::stepExport);
  window_.commands()[ui::Command::sensitivity]->trigger();
  settleWhen([this] { return !window_.measures().sensitivity().isAsking(); });
}

//! The surface carried through the frames, if there are some; one in their middle is shown.
void Screenshot::carry() {
  window_.showStep(ui::Command::stepGrow);
  window_.commands()[ui::Command::carryOverTime]->trigger();
  window_.commands()[ui::Command::showOverTime]->trigger();
  ui::TimeSeries& time = window_.document().time();
  settleWhen([&time] {
    if (time.isCarrying()) return false;
    time.show(time.frameCount() / 3);
    return time.shownFrame() == time.wantedFrame();
  });
}

void Screenshot::showStage() {
  window_.goToEvent(window_.inspector().event());
  connect(&window_.document(), &ui::Document::eventTraced, this, &Screenshot::settle);
  window_.inspector().showStage(kStages[kStageWords.indexOf(options_.stage)]);
}

void Screenshot::settle() {
  QTimer::singleShot(kSettle, this, [this] {
    // On a busy machine layouts may still wait, and those that follow from them.
    for (int i = 0; i < kLayouts; ++i) QCoreApplication::sendPostedEvents();
    const QString& view = options_.view;
    const QImage picture = view == QStringLiteral("window") ? window_.grab().toImage()
                                                            : window_.views().picture(ui::cellFromWord(view));
    write(picture);
  });
}

//! Whole or not at all: what there was before stays.
void Screenshot::write(const QImage& picture) try {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!picture.save(&buffer, "png"))
    return end(kOutput, tr("%1 cannot be written.").arg(options_.screenshot));
  writeTextAtomically(QFile::encodeName(options_.screenshot).toStdString(), bytes.toStdString());
  end(kDone);
} catch (const OutputError& error) {
  end(kOutput, QString::fromStdString(error.what()));
}

void Screenshot::end(int code, const QString& sentence) {
  if (ended_) return;
  ended_ = true;
  growing_ = false;
  if (!sentence.isEmpty()) std::cerr << "handlebody: " << sentence.toStdString() << std::endl;
  QCoreApplication::exit(code);
}

}  // namespace handlebody::app
