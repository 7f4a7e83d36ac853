#include "ui/window/widgets/label_face.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QLabel>
#include <QTextDocumentFragment>

namespace handlebody::ui {

namespace {

QString plainText(const QLabel& label) {
  QString text = label.text();
  if (Qt::mightBeRichText(text)) text = QTextDocumentFragment::fromHtml(text).toPlainText();
  return text.remove(QChar(0x200b));  // where a line may break
}

class LabelFace : public QAccessibleWidget {
 public:
  explicit LabelFace(QLabel* label) : QAccessibleWidget(label, QAccessible::StaticText) {}

  QString text(QAccessible::Text kind) const override {
    if (kind != QAccessible::Name) return QAccessibleWidget::text(kind);
    const QString name = widget()->accessibleName();
    const QString value = plainText(*static_cast<const QLabel*>(widget()));
    return value.isEmpty() || value == name ? name : name + QStringLiteral(": ") + value;
  }
};

// Qt asks for every class from the widget's own up to QWidget; a label without a name of its own is left to
// it.
QAccessibleInterface* makeFace(const QString& className, QObject* object) {
  auto* label = className == QLatin1String("QLabel") ? qobject_cast<QLabel*>(object) : nullptr;
  return label && !label->accessibleName().isEmpty() ? new LabelFace(label) : nullptr;
}

}  // namespace

void readLabelsWithTheirValues() { QAccessible::installFactory(makeFace); }

}  // namespace handlebody::ui
