#pragma once
// What is in the middle while nothing is open: how to begin.

#include <QWidget>

class QVBoxLayout;

namespace handlebody::ui {

class Commands;

class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(const Commands& commands, QWidget* parent = nullptr);

  void setRecent(const QStringList& paths);

 Q_SIGNALS:
  void openRequested(const QString& path);
  void sampleRequested();

 private:
  QWidget* recent_;
  QVBoxLayout* recentLayout_;
};

}  // namespace handlebody::ui
