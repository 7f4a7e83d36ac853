#pragma once
// What tests of the window share: a window on the display, the sample in it, and waiting.

#include <QAbstractButton>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "ui/view/slice_view.h"
#include "ui/view/surface_view.h"
#include "ui/window/commands.h"
#include "ui/window/main_window.h"
#include "ui/window/open/file_work.h"
#include "ui/window/views/view_grid.h"
#include "ui/window/widgets/message_bar.h"

namespace handlebody::test {

//! The six pages of the panel at the left.
constexpr ui::Command kSteps[] = {ui::Command::stepOpen, ui::Command::stepSeed,    ui::Command::stepTune,
                                  ui::Command::stepGrow, ui::Command::stepCorrect, ui::Command::stepExport};

constexpr int kPatience = 120'000;  // ms; the machine may be busy

inline QString sample(const char* name) {
  return QStringLiteral(HANDLEBODY_SAMPLES "/") + QLatin1String(name);
}

//! A window as at the first start, apart from the notice.
inline std::unique_ptr<ui::MainWindow> shownWindow() {
  QSettings().clear();
  auto window = std::make_unique<ui::MainWindow>();
  window->resize(1280, 800);
  window->show();
  window->activateWindow();
  return QTest::qWaitForWindowExposed(window.get()) ? std::move(window) : nullptr;
}

//! Asks again until it is: without a window manager a request that comes before the server shows the window
//! is lost.
inline bool activate(QWidget& window) {
  return QTest::qWaitFor([&] {
    if (!window.isActiveWindow()) window.activateWindow();
    return window.isActiveWindow();
  });
}

inline bool open(ui::MainWindow& window, const QString& path) {
  QSignalSpy opened(&window.document(), &ui::Document::opened);
  window.files().open(path);
  return !opened.isEmpty() || opened.wait(kPatience);
}

inline bool waitFor(ui::MainWindow& window, ui::GrowthState state) {
  return QTest::qWaitFor([&] { return window.document().state() == state; }, kPatience);
}

//! The label or field that is read aloud under this name; null if none is shown.
inline QLabel* shownLabel(ui::MainWindow& window, const QString& name) {
  const auto labels = window.findChildren<QLabel*>();
  for (QLabel* label : labels)
    if (label->accessibleName() == name && label->isVisible()) return label;
  return nullptr;
}

inline QString shownText(ui::MainWindow& window, const char* name) {
  const QLabel* label = shownLabel(window, QString::fromLatin1(name));
  return label ? label->text() : QString();
}

inline QDoubleSpinBox* numberField(ui::MainWindow& window, const QString& name) {
  const auto fields = window.findChildren<QDoubleSpinBox*>();
  for (QDoubleSpinBox* field : fields)
    if (field->accessibleName() == name) return field;
  return nullptr;
}

//! One that is seen, if there is one.
inline QAbstractButton* buttonSaying(ui::MainWindow& window, const char* text) {
  QAbstractButton* hidden = nullptr;
  const auto buttons = window.findChildren<QAbstractButton*>();
  for (QAbstractButton* button : buttons) {
    if (!button->text().contains(QLatin1String(text))) continue;
    if (button->isVisible()) return button;
    if (!hidden) hidden = button;
  }
  return hidden;
}

inline int firstHandle(const ui::Document& document) {
  for (std::size_t i = 0; i < document.events().size(); ++i)
    if (document.events()[i].kind == EventKind::handleInserted) return static_cast<int>(i);
  return -1;
}

}  // namespace handlebody::test
