#include "ui/window/help/help_pages.h"

#include <QKeySequence>

#include "core/version.h"
#include "ui/model/translate.h"
#include "ui/window/commands.h"
#include "ui/window/help/help_window.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

// The first column is as wide in every section, so that the second stands in one line down the page.
QString row(const QString& left, const QString& right) {
  return QStringLiteral("<tr><td width='210'>%1</td><td>%2</td></tr>").arg(left, right);
}

QString keysOfPage(const CommandSpec& spec) {
  QStringList keys;
  const auto texts = QString::fromLatin1(spec.keys).split(QStringLiteral("; "), Qt::SkipEmptyParts);
  for (const QString& text : texts)
    keys << QKeySequence(text, QKeySequence::PortableText).toString(QKeySequence::NativeText).toHtmlEscaped();
  return keys.join(tr(" or "));
}

QString plain(const char* text) { return withoutKey(Commands::translated(text)).toHtmlEscaped(); }

QString section(const QString& title, const QString& rows) {
  return QStringLiteral("<h3>%1</h3><table cellpadding='3'>%2</table>").arg(title, rows);
}

QString mouseInSlices() {
  return section(
      tr("Mouse and keys in a slice"),
      row(tr("Left click"), tr("Crosshair")) +
          row(tr("Return; with Shift"), tr("Seed at the crosshair; click outside of the object")) +
          row(tr("Left drag on a seed, on its rim"), tr("Move it, change its radius")) +
          row(tr("Wheel; with Shift"), tr("Next slice; five slices")) +
          row(tr("Right drag, Ctrl+wheel"), tr("Zoom")) + row(tr("Middle drag, Shift+left drag"), tr("Pan")) +
          row(tr("Arrows; with Shift"), tr("Crosshair by one voxel; by five")) +
          row(tr("Page Up, Page Down"), tr("Next, previous slice")) +
          row(tr("B or E, then left drag; Ctrl+wheel"), tr("Paint or erase walls; radius of the brush")) +
          row(tr("R, A or C, then clicks"),
              tr("Ruler, angle, centre line: place points; Return: at the crosshair")) +
          row(tr("Left drag on the end of a ruler or an angle"), tr("Move it")) +
          row(tr("L or Shift+L, then left drag"), tr("Pin or unpin the surface under the brush")) +
          row(tr("M, then left click"), tr("Smooth the surface under the brush")) +
          row(tr("U, then left drag from the outline"), tr("Pull the surface by that point")) +
          row(tr("X, then left drag across the outline"), tr("Cut the surface along that line")) +
          row(tr("W, then left drag"), tr("Window (sideways) and level (up and down)")) +
          row(tr("Double click"), tr("This view alone, or all four")));
}

QString mouseIn3d() {
  return section(
      tr("Mouse in the 3D view"),
      row(tr("Left drag"), tr("Rotate")) +
          row(tr("L, Shift+L, M or U, then left on the surface"),
              tr("Pin, unpin, smooth, pull; beside it: rotate")) +
          row(tr("R, A or C, then clicks on the surface"), tr("Ruler, angle, centre line: place points")) +
          row(tr("Right drag, wheel"), tr("Zoom")) + row(tr("Middle drag, Shift+left drag"), tr("Pan")) +
          row(tr("Double click"), tr("This view alone, or all four")));
}

QString escape() {
  return section(
      tr("Messages"),
      row(QStringLiteral("<b>%1</b>").arg(QKeySequence(Qt::Key_Escape).toString(QKeySequence::NativeText)),
          tr("Close the message over the views; else give up a stroke or a point, put brush and ruler away, "
             "leave "
             "window and level")));
}

struct Library {
  const char* name;
  const char* licence;
  const char* use;
};

constexpr Library kLibraries[] = {
    {"Qt 6", "LGPL-3.0", QT_TRANSLATE_NOOP("handlebody::ui", "window")},
    {"VTK", "BSD-3-Clause", QT_TRANSLATE_NOOP("handlebody::ui", "3D view, mesh files, pictures")},
    {"ITK, GDCM", "Apache-2.0, BSD", QT_TRANSLATE_NOOP("handlebody::ui", "reading and writing volumes")},
    {"DCMTK (oflog)", "BSD-3-Clause (Apache-2.0)",
     QT_TRANSLATE_NOOP("handlebody::ui", "writing DICOM files")},
    {"Eigen", "MPL-2.0", QT_TRANSLATE_NOOP("handlebody::ui", "linear algebra")},
    {"OpenSSL", "Apache-2.0", QT_TRANSLATE_NOOP("handlebody::ui", "SHA-256 of volumes")},
    {"zlib", "Zlib", QT_TRANSLATE_NOOP("handlebody::ui", "compressed files")},
    {"libzip", "BSD-3-Clause", QT_TRANSLATE_NOOP("handlebody::ui", "3MF files")},
    {"Expat", "MIT", QT_TRANSLATE_NOOP("handlebody::ui", "3MF files")},
    {"nlohmann-json", "MIT", QT_TRANSLATE_NOOP("handlebody::ui", "sessions and reports")},
    {"CLI11", "BSD-3-Clause", QT_TRANSLATE_NOOP("handlebody::ui", "command line")},
};

}  // namespace

QString shortcutsPage() {
  QString page, rows;
  const char* menu = Commands::table().front().menu;
  for (const CommandSpec& spec : Commands::table()) {
    if (QLatin1String(spec.menu) != QLatin1String(menu)) {
      page += section(plain(menu), rows);
      rows.clear();
      menu = spec.menu;
    }
    if (*spec.keys)
      rows += row(QStringLiteral("<b>%1</b>").arg(keysOfPage(spec)),
                  Commands::translated(spec.tip).toHtmlEscaped());
  }
  page += section(plain(menu), rows);
  return QStringLiteral("<h2>%1</h2>").arg(tr("Keyboard and mouse")) + mouseInSlices() + mouseIn3d() + page +
         escape();
}

QString aboutPage() {
  QString libraries;
  for (const Library& library : kLibraries)
    libraries +=
        QStringLiteral(
            "<tr><td style='padding-right: 24px'>%1</td><td style='padding-right: 24px'>%2</td><td>%3"
            "</td></tr>")
            .arg(QString::fromLatin1(library.name), QString::fromLatin1(library.licence), tr(library.use));
  return QStringLiteral(
             "<p><img src=':/handlebody/icons/handlebody.svg'></p>"
             "<h2>Handlebody %1</h2><p>%2</p><p><b>%3</b></p><p>%4</p><h3>%5</h3><table "
             "cellpadding='3'>%6</table><p>%7</p>")
      .arg(QStringLiteral(HANDLEBODY_VERSION),
           tr("Grows a certified surface from a point in a medical volume; the surface may change its "
              "topology on the "
              "way."),
           purposeNotice().toHtmlEscaped(),
           tr("Apache License 2.0. The method is that of the paper “A Combinatorial Method for Topology "
              "Adaptations in "
              "3D Deformable Models”."),
           tr("Libraries"), libraries,
           tr("Qt is linked dynamically and can be replaced by another version of it."));
}

QString purposeNotice() {
  return tr(
      "For research use only. Handlebody is not a medical device; do not use it for diagnosis or treatment.");
}

}  // namespace handlebody::ui
