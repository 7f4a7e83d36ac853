#pragma once
// Takes a picture of the window without a person at it.

#include <QImage>
#include <QObject>
#include <functional>

#include "app/window/options.h"
#include "core/geometry/vec.h"

namespace handlebody::ui {
class MainWindow;
}

namespace handlebody::app {

//! Opens what the options name, grows to their iteration, writes the picture and ends the program: exit code
//! 0; 3 if the file cannot be opened, 4 if the surface does not grow, 2 if the picture cannot be written or
//! there is no event whose stage was asked for.
class Screenshot : public QObject {
  Q_OBJECT

 public:
  Screenshot(const Options& options, ui::MainWindow& window);

  void start();

 private:
  void grow();
  void continueGrowing();
  void settle();
  void settleWhenPrepared();
  void measure();
  void tellSensitivity();
  void carry();
  void settleWhen(std::function<bool()> isDone);
  void showStage();
  void write(const QImage& picture);
  void take();
  void end(int code, const QString& sentence = {});

  Options options_;
  ui::MainWindow& window_;
  std::optional<Vec3> crosshair_;  //!< the session's; the alarm of a leak moves it
  bool growing_ = false;
  int stepped_ = -1;  //!< the iteration from which a step was asked for
  bool ended_ = false;
};

}  // namespace handlebody::app
