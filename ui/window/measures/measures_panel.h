#pragma once
// What is measured: the objects as a table, rulers and angles, a centre line, the distance to a reference.

#include <QWidget>
#include <string>

#include "ui/window/widgets/file_writer.h"

class QTabWidget;

namespace handlebody::ui {

class CentreLinePage;
class Commands;
class ComparePage;
class Document;
class ObjectMeasuresPage;
class RulersPage;
class SensitivityPage;
class ViewState;

class MeasuresPanel : public QWidget {
  Q_OBJECT

 public:
  enum class Page { objects, rulers, centreLine, compare, sensitivity };

  MeasuresPanel(Document& document, ViewState& state, const Commands& commands, QWidget* parent = nullptr);

  void show(Page page);
  using QWidget::show;
  //! Nothing that names the patient is to stand in what is saved.
  void setAnonymous(bool anonymous);
  ObjectMeasuresPage& objects() { return *objects_; }
  CentreLinePage& centreLine() { return *line_; }
  ComparePage& compare() { return *compare_; }
  SensitivityPage& sensitivity() { return *sensitivity_; }

 Q_SIGNALS:
  //! `what`: what the file's name says of it, "measures".
  void saveRequested(const QString& title, const QString& what, const QString& extension,
                     const std::string& text);
  //! The same of a file that `write` makes, on any thread; it may throw.
  void saveFileRequested(const QString& title, const QString& what, const QString& extension,
                         const handlebody::ui::FileWriter& write);
  void wanted();  //!< something is to be seen here

 private:
  QTabWidget* tabs_;
  ObjectMeasuresPage* objects_;
  RulersPage* rulers_;
  CentreLinePage* line_;
  ComparePage* compare_;
  SensitivityPage* sensitivity_;
};

}  // namespace handlebody::ui
