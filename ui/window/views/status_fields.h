#pragma once
// The status bar: where the mouse is, what the growth does, how far the reading is.

#include <QObject>

#include "core/geometry/vec.h"

class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace handlebody::ui {

class Document;

class StatusFields : public QObject {
  Q_OBJECT

 public:
  StatusFields(QStatusBar* bar, Document& document);

  void showCursor(const Vec3& world, const Vec3& index, double intensity);
  void clearCursor();

 private:
  void showState();
  void say(const QString& state);
  void showProgress(const QString& path, double progress);
  void endProgress();

  Document& document_;
  QLabel *position_, *voxel_, *intensity_, *uncalibrated_, *state_;
  QProgressBar* progress_;
  QToolButton* cancel_;
};

}  // namespace handlebody::ui
