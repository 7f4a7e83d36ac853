#pragma once
// The built-in guide, the page of keys and mouse buttons, and the licences.

#include <QWidget>

class QTabWidget;
class QTextBrowser;

namespace handlebody::ui {

//! What the program is for and what it is not.
QString purposeNotice();

class HelpWindow : public QWidget {
  Q_OBJECT

 public:
  enum class Page { guide, shortcuts, about };

  explicit HelpWindow(QWidget* parent = nullptr);

  void show(Page page);

 private:
  QTextBrowser* addPage(const QString& title);

  QTabWidget* tabs_;
  QTextBrowser* guide_;
};

}  // namespace handlebody::ui
