#include "ui/window/help/help_window.h"

#include <QImage>
#include <QShortcut>
#include <QTabWidget>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "ui/window/help/help_pages.h"
#include "ui/window/widgets/icons.h"
#include "ui/window/widgets/language.h"

namespace handlebody::ui {

namespace {
const QSize kHelpSize(820, 640);
constexpr int kPicture = 720, kHelpIcon = 72;  // widths; pictures fit into the window as it opens
}  // namespace

namespace {

// Pictures are scaled here: those that the text scales itself are jagged.
class HelpBrowser : public QTextBrowser {
 public:
  using QTextBrowser::QTextBrowser;

  QVariant loadResource(int type, const QUrl& name) override {
    if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
    const double ratio = devicePixelRatioF();
    if (name.path().endsWith(QLatin1String(".svg")))
      return programIcon().pixmap(QSize(kHelpIcon, kHelpIcon), ratio);
    const QString file = QLatin1Char(':') + (name.isRelative() ? source().resolved(name) : name).path();
    QImage picture(file);
    picture = picture.scaledToWidth(static_cast<int>(kPicture * ratio), Qt::SmoothTransformation);
    picture.setDevicePixelRatio(ratio);
    return picture;
  }
};

}  // namespace

HelpWindow::HelpWindow(QWidget* parent) : QWidget(parent, Qt::Window), tabs_(new QTabWidget(this)) {
  setWindowTitle(tr("Handlebody: help"));
  setWindowIcon(programIcon());
  resize(kHelpSize);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(tabs_);
  guide_ = addPage(tr("Guide"));
  addPage(tr("Keyboard and mouse"))->setHtml(shortcutsPage());
  addPage(tr("About"))->setHtml(aboutPage());
  guide_->setSource(QUrl(QStringLiteral("qrc:") + guideFile()));
  for (const char* keys : {"Esc", "Ctrl+W"})
    connect(new QShortcut(QKeySequence(QString::fromLatin1(keys)), this), &QShortcut::activated, this,
            &QWidget::close);
}

QTextBrowser* HelpWindow::addPage(const QString& title) {
  auto* browser = new HelpBrowser(tabs_);
  browser->setFrameShape(QFrame::NoFrame);
  browser->setOpenExternalLinks(true);
  browser->document()->setDocumentMargin(16);
  browser->setAccessibleName(title);
  tabs_->addTab(browser, title);
  return browser;
}

void HelpWindow::show(Page page) {
  tabs_->setCurrentIndex(static_cast<int>(page));
  QWidget::show();
  raise();
  activateWindow();
  tabs_->currentWidget()->setFocus();  // keys scroll the text at once
}

}  // namespace handlebody::ui
