#include "ui/window/measures/object_measures_page.h"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <numeric>

#include "ui/model/document.h"
#include "ui/model/finding_text.h"
#include "ui/model/measurements.h"
#include "ui/view/view_state.h"
#include "ui/window/measures/measure_texts.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kSettle = 300;        // ms from the last change to the measuring
constexpr int kDetails = 300;       // pixels
constexpr int kProgressWidth = 90;  // pixels

}  // namespace

ObjectMeasuresPage::ObjectMeasuresPage(Document& document, ViewState& state, QWidget* parent)
    : QWidget(parent), document_(document), state_(state) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 4);
  layout->setSpacing(4);
  auto* row = new QHBoxLayout;
  table_ = listTable(measureHeaders(), this);
  table_->setAccessibleName(tr("Measures of the objects"));
  row->addWidget(table_, 1);
  details_ = value(tr("More about the chosen object"), this);
  details_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(kDetails);
  scroll->setWidget(details_);
  scroll->setFocusPolicy(Qt::NoFocus);
  row->addWidget(scroll);
  layout->addLayout(row, 1);
  note_ = value(tr("State of the measures"), this);
  layout->addWidget(note_);
  layout->addWidget(buildBelow());
  settle_ = new QTimer(this);
  settle_->setSingleShot(true);
  settle_->setInterval(kSettle);
  connect(settle_, &QTimer::timeout, this, [this] {
    if (isVisible() && isStale() && !isGrowing() && !isMeasuring_) measure();
  });
  connect(table_, &QTableWidget::itemSelectionChanged, this, &ObjectMeasuresPage::showDetails);
  connect(table_, &QTableWidget::cellClicked, this, [this](int index) {
    if (shown_)
      state_.setCrosshair(shown_->objects.at(static_cast<std::size_t>(index)).measures.shape.centroid);
  });
  for (auto changed : {&Document::snapshotChanged, &Document::objectsChanged, &Document::stateChanged,
                       &Document::opened, &Document::activeObjectChanged})
    connect(&document_, changed, this, &ObjectMeasuresPage::follow);
  follow();
}

QPushButton* ObjectMeasuresPage::addButton(const QString& text, const QString& tip, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard with the views
  describe(button, text, tip);
  parent->layout()->addWidget(button);
  return button;
}

QWidget* ObjectMeasuresPage::buildBelow() {
  auto* part = new QWidget(this);
  auto* row = new QHBoxLayout(part);
  row->setContentsMargins(0, 0, 0, 0);
  walls_ = new QComboBox(part);
  describe(walls_, tr("Wall thickness"),
           tr("The distance of two surfaces over their area: of two objects, or of an object and its own "
              "cavities"));
  ignoreWheelWithoutFocus(walls_);
  walls_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  walls_->setMinimumContentsLength(20);
  row->addWidget(walls_);
  connect(walls_, &QComboBox::activated, this, [this] { measure(); });
  progress_ = new QProgressBar(part);
  progress_->setRange(0, 100);
  progress_->setFixedWidth(kProgressWidth);
  progress_->setAccessibleName(tr("How much is measured"));
  row->addStretch(1);
  row->addWidget(progress_);
  measure_ = addButton(tr("Measure"), tr("Measure the surfaces as they are shown"), part);
  copy_ = addButton(tr("Copy"), tr("Copy the table, to paste it into a spreadsheet"), part);
  csv_ = addButton(tr("Save as CSV…"), tr("The same table as “handlebody-cli measure --csv” writes"), part);
  json_ = addButton(tr("Save as JSON…"), tr("The same as “handlebody-cli measure --json” writes"), part);
  connect(measure_, &QPushButton::clicked, this, &ObjectMeasuresPage::measureOrCancel);
  connect(copy_, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(copyText()); });
  connect(csv_, &QPushButton::clicked, this,
          [this] { Q_EMIT saveRequested(tr("Save the measures"), QStringLiteral(".csv"), csv()); });
  connect(json_, &QPushButton::clicked, this,
          [this] { Q_EMIT saveRequested(tr("Save the measures"), QStringLiteral(".json"), json()); });
  return part;
}

// --- what is shown, and whether it is still so ---

bool ObjectMeasuresPage::isGrowing() const {
  for (int i = 0; i < document_.objectCount(); ++i) {
    const GrowthState state = document_.objectInfo(i).state;
    if (state == GrowthState::running || state == GrowthState::preparing) return true;
  }
  return false;
}

bool ObjectMeasuresPage::isStale() const { return shownSurfaces(document_) != measured_; }

void ObjectMeasuresPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  follow();
}

void ObjectMeasuresPage::follow() {
  const Surfaces now = shownSurfaces(document_);
  if (isMeasuring_ && now != asked_) {  // what is being measured is shown no more
    measurer_.cancel();
    isMeasuring_ = false;
  }
  if (now.empty()) {
    shown_.reset();
    measured_.clear();
    showTable();
  }
  if (now != asked_) declined_ = false;
  fillWalls();
  if (isVisible() && !declined_ && !isMeasuring_ && isStale() && !isGrowing()) settle_->start();
  showState();
}

void ObjectMeasuresPage::fillWalls() {
  const QSignalBlocker quiet(walls_);
  const QVariant chosen = walls_->currentData();
  walls_->clear();
  walls_->addItem(tr("No wall thickness"), QPoint(-1, -1));
  const Surfaces now = shownSurfaces(document_);
  const int n = static_cast<int>(now.size());
  for (int i = 0; i < n; ++i) {
    const QString& name = now[i].name;
    walls_->addItem(tr("Wall of “%1” around its cavities").arg(name), QPoint(i, -1));
    for (int j = i + 1; j < n; ++j)
      walls_->addItem(tr("Wall from “%1” to “%2”").arg(name, now[j].name), QPoint(i, j));
  }
  walls_->setCurrentIndex(std::max(0, walls_->findData(chosen)));
}

// --- measuring ---

MeasureQuestion ObjectMeasuresPage::question() const {
  MeasureQuestion q;
  q.surfaces = asked_;
  q.volume = document_.volume();
  q.path = document_.sessionPath().toStdString();
  q.volumePath = document_.path().toStdString();
  const QPoint wall = walls_->currentData().toPoint();
  if (wall.x() >= 0) q.wall = WantedWall{wall.x(), wall.y() >= 0 ? std::optional(wall.y()) : std::nullopt};
  return q;
}

void ObjectMeasuresPage::measureOrCancel() {
  if (!isMeasuring_) return measure();
  measurer_.cancel();
  isMeasuring_ = false;
  declined_ = true;
  showState();
}

void ObjectMeasuresPage::measure() {
  settle_->stop();
  asked_ = shownSurfaces(document_);
  if (asked_.empty()) return;
  isMeasuring_ = true;
  declined_ = false;
  error_.clear();
  progress_->setValue(0);
  const int number = ++number_;
  const auto onThisThread = [this, number](auto action) {
    QMetaObject::invokeMethod(
        this,
        [this, number, action = std::move(action)]() mutable {
          if (number == number_ && isMeasuring_) action();
        },
        Qt::QueuedConnection);
  };
  measurer_.measure(
      question(),
      [this, onThisThread](double part) {
        onThisThread([this, part] { progress_->setValue(static_cast<int>(100 * part)); });
      },
      [this, onThisThread](MeasureAnswer answer) {
        onThisThread([this, answer = std::make_shared<MeasureAnswer>(std::move(answer))] {
          showAnswer(std::move(*answer));
        });
      });
  showState();
}

void ObjectMeasuresPage::showAnswer(MeasureAnswer answer) {
  isMeasuring_ = false;
  error_ = answer.error;
  declined_ = !error_.isEmpty();
  if (error_.isEmpty()) {
    shown_ = std::move(answer.measured);
    measured_ = asked_;
    showTable();
  }
  follow();
}

void ObjectMeasuresPage::showTable() {
  const int row = table_->currentRow();
  table_->setRowCount(0);
  if (shown_)
    for (const MeasuredObject& object : shown_->objects) {
      const int at = table_->rowCount();
      table_->insertRow(at);
      const QStringList cells = measureCells(*shown_, object);
      for (int c = 0; c < cells.size(); ++c) {
        QTableWidgetItem* cell = listCell(cells[c]);
        if (c > 0) cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        table_->setItem(at, c, cell);
      }
    }
  if (table_->rowCount() > 0) table_->selectRow(std::clamp(row, 0, table_->rowCount() - 1));
  showDetails();
}

void ObjectMeasuresPage::showDetails() {
  const int row = table_->currentRow();
  const bool any = shown_ && row >= 0 && row < static_cast<int>(shown_->objects.size());
  details_->setText(any ? measureDetails(*shown_, shown_->objects[row], document_.volume().grid) : QString());
}

void ObjectMeasuresPage::showState() {
  const bool any = !shownSurfaces(document_).empty();
  measure_->setText(isMeasuring_ ? tr("Cancel") : tr("Measure"));
  measure_->setAccessibleName(measure_->text());
  measure_->setEnabled(any);
  walls_->setEnabled(any);
  progress_->setVisible(isMeasuring_);
  for (QPushButton* button : {copy_, csv_, json_}) button->setEnabled(shown_.has_value());
  QString text;
  if (!any)
    text = tr("There is no surface to measure yet: grow one first.");
  else if (!error_.isEmpty())
    text = error_;
  else if (isMeasuring_)
    text = shown_ ? tr("Measuring. What is shown is of earlier surfaces.") : tr("Measuring.");
  else if (isStale())
    text = shown_ ? tr("These are measures of earlier surfaces.") : tr("Nothing is measured yet.");
  else if (!shown_->warnings.empty())
    text = findingSentences(shown_->warnings);
  note_->setText(text);
  note_->setVisible(!text.isEmpty());
}

//! What leaves the page.
//! With the rulers and angles as they are now, as `measure` tells those of a session.
Measured ObjectMeasuresPage::told() const {
  Measured m = *shown_;
  m.placed = document_.measurements().all();
  return isAnonymous_ ? anonymous(std::move(m), anonymousNames(measured_)) : m;
}

std::string ObjectMeasuresPage::csv() const { return measuredCsv(told()); }
std::string ObjectMeasuresPage::json() const { return measuredJson(told()); }

QString ObjectMeasuresPage::copyText() const {
  return shown_ ? columnsForSpreadsheet(QString::fromStdString(measuredColumns(told(), '\t'))) : QString();
}

}  // namespace handlebody::ui
