#include "ui/window/open/series_list.h"

#include <algorithm>

#include "ui/model/finding_text.h"
#include "ui/window/widgets/numbers.h"

namespace handlebody::ui {

namespace {

constexpr int kPadding = 4;  // pixels above and below the lines of a series

QString titleOf(const SeriesInfo& series) {
  const QString modality = QString::fromStdString(series.modality);
  QString description = QString::fromStdString(series.description.empty() ? series.uid : series.description);
  const QString uid = QString::fromStdString(series.uid);  // which stack of several stands behind it
  const qsizetype stack = uid.indexOf(u'#');
  if (stack >= 0 && !series.description.empty())
    description += SeriesList::tr(", stack %1").arg(uid.mid(stack + 1));
  const bool said = modality.isEmpty() || description.startsWith(modality);
  return said ? description : modality + QLatin1Char(' ') + description;
}

QString volumeOf(const SeriesInfo& series) {
  if (series.note.any()) return SeriesList::tr("No volume: %1").arg(findingText(series.note));
  if (series.size[0] <= 0) return {};
  const Vec3 size(series.size[0], series.size[1], series.size[2]);
  return SeriesList::tr("%1, %2 mm").arg(times(size, 0), times(series.spacing, 2));
}

QString partsOf(const SeriesInfo& series) {
  QString text = series.slices > 0 ? SeriesList::tr("Slices: %1").arg(series.slices)
                                   : SeriesList::tr("Files: %1").arg(series.files);
  if (series.frames > 1) text += SeriesList::tr(" · time points: %1").arg(series.frames);
  return text;
}

}  // namespace

QStringList linesOf(const SeriesInfo& series) {
  QStringList lines{titleOf(series), volumeOf(series), partsOf(series)};
  lines.removeAll(QString());
  return lines;
}

SeriesList::SeriesList(QWidget* parent) : QListWidget(parent) {
  setAccessibleName(tr("Series in the folder"));
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // lines are shortened; the tooltip has them whole
  setAlternatingRowColors(true);
  setSpacing(2);
  // As high as it is: or the room below would stand around its heading.
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

// As high as what it lists, so that what is open stands below without scrolling; many are scrolled.
void SeriesList::fitHeight() {
  constexpr int kHighest = 230;
  int height = 2 * frameWidth();
  for (int row = 0; row < count(); ++row) height += sizeHintForRow(row) + 2 * spacing();
  setFixedHeight(std::min(height, kHighest));
}

void SeriesList::offer(const std::vector<SeriesInfo>& series) {
  clear();
  for (const SeriesInfo& s : series) {
    const QStringList lines = linesOf(s);
    auto* item = new QListWidgetItem(lines.join(QLatin1Char('\n')), this);
    const QFontMetrics metrics = fontMetrics();
    item->setSizeHint(QSize(0, static_cast<int>(lines.size()) * metrics.lineSpacing() + 2 * kPadding));
    item->setData(Qt::UserRole, QString::fromStdString(s.uid));
    QStringList whole = lines;
    whole << QString::fromStdString(s.uid);
    item->setToolTip(QStringLiteral("<p>%1</p>")
                         .arg(whole.join(QLatin1Char('\n'))
                                  .toHtmlEscaped()
                                  .replace(QLatin1Char('\n'), QLatin1String("<br>"))));
    const bool usable = !s.note.any();
    if (!usable) item->setFlags(Qt::NoItemFlags);
    if (usable && !currentItem()) setCurrentItem(item);
  }
  fitHeight();
}

std::optional<QString> SeriesList::chosen() const {
  const QListWidgetItem* item = currentItem();
  if (!item || !(item->flags() & Qt::ItemIsEnabled)) return std::nullopt;
  return item->data(Qt::UserRole).toString();
}

}  // namespace handlebody::ui
