#include "ui/window/measures/measures_panel.h"

#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include "ui/window/measures/centre_line_page.h"
#include "ui/window/measures/compare_page.h"
#include "ui/window/measures/object_measures_page.h"
#include "ui/window/measures/rulers_page.h"
#include "ui/window/measures/sensitivity_page.h"

namespace handlebody::ui {

MeasuresPanel::MeasuresPanel(Document& document, ViewState& state, const Commands& commands, QWidget* parent)
    : QWidget(parent),
      tabs_(new QTabWidget(this)),
      objects_(new ObjectMeasuresPage(document, state, tabs_)),
      rulers_(new RulersPage(document, state, commands, tabs_)),
      line_(new CentreLinePage(document, state, commands, tabs_)),
      compare_(new ComparePage(document, state, tabs_)),
      sensitivity_(new SensitivityPage(document, state, tabs_)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setAccessibleName(tr("What is measured"));
  tabs_->addTab(objects_, tr("Objects"));
  tabs_->addTab(rulers_, tr("Rulers and angles"));
  tabs_->addTab(line_, tr("Centre line"));
  tabs_->addTab(compare_, tr("Compare"));
  tabs_->addTab(sensitivity_, tr("Sensitivity"));
  layout->addWidget(tabs_);
  connect(objects_, &ObjectMeasuresPage::saveRequested, this,
          [this](const QString& title, const QString& extension, const std::string& text) {
            Q_EMIT saveRequested(title, QStringLiteral("measures"), extension, text);
          });
  connect(rulers_, &RulersPage::saveRequested, this,
          [this](const QString& title, const QString& extension, const std::string& text) {
            Q_EMIT saveRequested(title, QStringLiteral("rulers"), extension, text);
          });
  connect(line_, &CentreLinePage::saveRequested, this,
          [this](const QString& title, const QString& extension, const std::string& text) {
            Q_EMIT saveRequested(title, QStringLiteral("sections"), extension, text);
          });
  connect(compare_, &ComparePage::saveRequested, this,
          [this](const QString& title, const QString& extension, const std::string& text) {
            Q_EMIT saveRequested(title, QStringLiteral("comparison"), extension, text);
          });
  connect(compare_, &ComparePage::saveFileRequested, this,
          [this](const QString& title, const QString& extension, const FileWriter& write) {
            Q_EMIT saveFileRequested(title, QStringLiteral("distances"), extension, write);
          });
  connect(sensitivity_, &SensitivityPage::saveRequested, this,
          [this](const QString& title, const QString& extension, const std::string& text) {
            Q_EMIT saveRequested(title, QStringLiteral("sensitivity"), extension, text);
          });
  connect(line_, &CentreLinePage::lineAsked, this, [this] {
    show(Page::centreLine);
    Q_EMIT wanted();
  });
}

void MeasuresPanel::setAnonymous(bool anonymous) {
  objects_->setAnonymous(anonymous);
  line_->setAnonymous(anonymous);
  compare_->setAnonymous(anonymous);
}

void MeasuresPanel::show(Page page) { tabs_->setCurrentIndex(static_cast<int>(page)); }

}  // namespace handlebody::ui
