#include "ui/window/correct/tunnels_list.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/model/document.h"
#include "ui/view/length_decimals.h"
#include "ui/view/overlay.h"
#include "ui/view/view_state.h"
#include "ui/window/widgets/numbers.h"
#include "ui/window/widgets/panel_tools.h"

namespace handlebody::ui {

namespace {

constexpr int kHighestTable = 190;  // pixels
enum Column { kWhat, kSize };

QIcon square(const QColor& colour) {
  QPixmap picture(12, 12);
  picture.fill(colour);
  return picture;
}

//! An edit as it stands in the list.
QString nameOf(const MeshEdit& edit) {
  switch (edit.kind) {
    case MeshEditKind::removeComponent:
      return TunnelsList::tr("Component removed");
    case MeshEditKind::keepComponent:
      return TunnelsList::tr("One component kept");
    case MeshEditKind::fillCavity:
      return TunnelsList::tr("Cavity filled");
    case MeshEditKind::smooth:
      return TunnelsList::tr("Smoothed");
    case MeshEditKind::pull:
      return TunnelsList::tr("Pulled");
    case MeshEditKind::cut:
      return TunnelsList::tr("Cut by a plane");
    default:
      return edit.cut == TunnelCut::handle   ? TunnelsList::tr("Handle cut")
             : edit.cut == TunnelCut::tunnel ? TunnelsList::tr("Tunnel filled")
                                             : TunnelsList::tr("Tunnel closed");
  }
}

}  // namespace

TunnelsList::TunnelsList(Document& document, ViewState& state, QWidget* parent)
    : QWidget(parent), document_(document), state_(state) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  find_ = new QPushButton(this);
  find_->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard with the views
  layout->addWidget(find_);
  summary_ = value(tr("What the surface holds"), this);
  layout->addWidget(summary_);
  buildTable();
  layout->addWidget(table_);
  detail_ = value(tr("The chosen row"), this);
  layout->addWidget(detail_);
  actionRow_ = buildActions();
  layout->addWidget(actionRow_);
  connect(find_, &QPushButton::clicked, this, &TunnelsList::look);
  connect(&document_, &Document::snapshotChanged, this, &TunnelsList::follow);
  connect(&document_, &Document::stateChanged, this, &TunnelsList::showState);
  for (auto changed : {&Document::opened, &Document::activeObjectChanged})
    connect(&document_, changed, this, &TunnelsList::forget);
  connect(&document_, &Document::constraintsChanged, this, &TunnelsList::showRows);
  connect(&document_, &Document::meshEdited, this, [this] {
    if (std::exchange(looksAgain_, false) && canLook()) look();
  });
  showRows();
}

void TunnelsList::buildTable() {
  table_ = listTable({tr("What"), tr("Size")}, this);
  table_->setAccessibleName(tr("Tunnels, components and cavities, each with its size"));
  connect(table_, &QTableWidget::itemSelectionChanged, this, &TunnelsList::showChosen);
  connect(table_, &QTableWidget::cellClicked, this, &TunnelsList::showChosen);  // again, too
}

void TunnelsList::addAction(const QString& text, const QString& tip,
                            std::function<std::optional<MeshEdit>()> edit) {
  auto* button = new QPushButton(text, this);
  button->setFocusPolicy(Qt::TabFocus);
  describe(button, text, tip);
  connect(button, &QPushButton::clicked, this, [this, edit] {
    const std::optional<MeshEdit> wanted = chosen() ? edit() : std::nullopt;
    if (!wanted) return;
    looksAgain_ = true;
    document_.editMesh(*wanted);
  });
  actions_.push_back({button, std::move(edit)});
}

QWidget* TunnelsList::buildActions() {
  using Wanted = std::optional<MeshEdit>;
  const auto closing = [this](TunnelCut cut) -> Wanted {
    const FoundTunnel* t = chosen()->tunnel;
    if (!t || !(cut == TunnelCut::handle ? t->canCutHandle : t->canFillTunnel)) return std::nullopt;
    return MeshEdit{0, MeshEditKind::closeTunnel, t->place, cut};
  };
  const auto onPiece = [this](MeshEditKind kind) -> Wanted {
    const FoundPiece* p = chosen()->piece;
    if (!p || p->piece.isCavity != (kind == MeshEditKind::fillCavity)) return std::nullopt;
    if (!p->piece.isCavity && bodies() < 2) return std::nullopt;  // nothing would be left, or nothing goes
    return MeshEdit{0, kind, p->place};
  };
  addAction(tr("Cut handle"), tr("Cuts along the loop around the handle, which goes; both ends get a cap"),
            [closing] { return closing(TunnelCut::handle); });
  addAction(tr("Fill tunnel"), tr("Cuts along the loop round the tunnel: a membrane closes it on both sides"),
            [closing] { return closing(TunnelCut::tunnel); });
  addAction(tr("Remove"), tr("Removes this component with all that lies in it"),
            [onPiece] { return onPiece(MeshEditKind::removeComponent); });
  addAction(tr("Keep only this"), tr("Removes everything but this component and its cavities"),
            [onPiece] { return onPiece(MeshEditKind::keepComponent); });
  addAction(tr("Fill"), tr("Fills this cavity, with all that lies in it"),
            [onPiece] { return onPiece(MeshEditKind::fillCavity); });
  actions_[0].button->setIcon(square(loopColour(MarkedLoop::Kind::handle)));
  actions_[1].button->setIcon(square(loopColour(MarkedLoop::Kind::tunnel)));
  leaveOut_ = new QPushButton(tr("Leave out"), this);
  leaveOut_->setFocusPolicy(Qt::TabFocus);
  describe(leaveOut_, tr("Leave out"), tr("Goes back to the step before this edit, and on without it"));
  connect(leaveOut_, &QPushButton::clicked, this, [this] {
    if (const Row* row = chosen(); row && row->edit) document_.leaveOutEdit(row->edit->iteration);
  });
  auto* part = new QWidget(this);
  auto* layout = new QHBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  for (const Action& action : actions_) layout->addWidget(action.button);
  layout->addWidget(leaveOut_);
  return part;
}

// --- looking ---

bool TunnelsList::canLook() const {
  const auto shown = document_.snapshot();
  const GrowthState now = document_.state();
  return shown && !shown->mesh.triangles.empty() && shown->certificate.boundsBody() &&
         (now == GrowthState::paused || now == GrowthState::finished);
}

void TunnelsList::look() {
  if (std::exchange(isLooking_, false)) {  // the button said "Cancel"
    finder_.cancel();
    showState();
    return;
  }
  if (!canLook()) return;
  isLooking_ = true;
  finder_.find(document_.snapshot(), [this](MeshContents found) {
    QMetaObject::invokeMethod(
        this, [this, found = std::move(found)]() mutable { take(std::move(found)); }, Qt::QueuedConnection);
  });
  showState();
}

void TunnelsList::take(MeshContents found) {
  if (!isLooking_ || found.mesh != document_.snapshot()) return;  // another surface is shown
  isLooking_ = false;
  found_ = std::move(found);
  showRows();
}

//! What was found is of another iteration now.
void TunnelsList::follow() {
  const auto shown = document_.snapshot();
  const bool isSame = found_ && shown && found_->mesh->iteration == shown->iteration &&
                      found_->mesh->mesh.points == shown->mesh.points;
  if (isSame)
    found_->mesh = shown;
  else
    forget();
}

void TunnelsList::forget() {
  finder_.cancel();
  isLooking_ = false;
  found_.reset();
  showRows();
}

// --- rows ---

int TunnelsList::bodies() const {
  return static_cast<int>(std::count_if(found_->pieces.begin(), found_->pieces.end(),
                                        [](const FoundPiece& p) { return !p.piece.isCavity; }));
}

void TunnelsList::addTunnels(std::vector<Row>& rows) const {
  for (const FoundTunnel& t : found_->tunnels) {
    Row row;
    row.tunnel = &t;
    row.what = tr("Tunnel");
    row.size = QStringLiteral("%1 / %2").arg(fineNumber(t.handleLength, 3), millimetres(t.tunnelLength));
    row.detail = tr("%1 around its handle, %2 round the tunnel")
                     .arg(millimetres(t.handleLength), millimetres(t.tunnelLength));
    if (!t.canCutHandle || !t.canFillTunnel) row.detail += tr("; knotted");
    rows.push_back(std::move(row));
  }
}

void TunnelsList::addPieces(std::vector<Row>& rows, bool cavities) const {
  for (const FoundPiece& p : found_->pieces) {
    if (p.piece.isCavity != cavities) continue;
    Row row;
    row.piece = &p;
    row.what = cavities ? tr("Cavity") : tr("Component");
    row.size = millilitres(p.piece.volume, 3);
    row.detail = tr("%1 mm, genus %2")
                     .arg(times(p.piece.size, placeDecimals(document_.volume().grid)))
                     .arg(p.piece.genus);
    rows.push_back(std::move(row));
  }
}

void TunnelsList::addEdits(std::vector<Row>& rows) const {
  for (const MeshEdit& e : document_.constraints().edits) {
    Row row;
    row.edit = e;
    row.what = nameOf(e);
    row.size = tr("step %1").arg(e.iteration);
    row.detail = tr("At %1").arg(place(e.place, document_.volume().grid));
    rows.push_back(std::move(row));
  }
}

std::vector<TunnelsList::Row> TunnelsList::rowsNow() const {
  std::vector<Row> rows;
  if (found_) {
    addTunnels(rows);
    addPieces(rows, false);
    addPieces(rows, true);
  }
  addEdits(rows);
  return rows;
}

void TunnelsList::showRows() {
  std::vector<Row> now = rowsNow();
  const auto looksAlike = [](const Row& a, const Row& b) {
    return a.what == b.what && a.size == b.size && a.detail == b.detail;
  };
  const bool same = std::equal(now.begin(), now.end(), rows_.begin(), rows_.end(), looksAlike);
  rows_ = std::move(now);
  if (!same) {
    const QSignalBlocker quiet(table_);
    table_->clearSelection();
    table_->setCurrentCell(-1, -1);
    table_->setRowCount(static_cast<int>(rows_.size()));
    for (int i = 0; i < table_->rowCount(); ++i) {
      table_->setItem(i, kWhat, listCell(rows_[i].what));
      table_->setItem(i, kSize, listCell(rows_[i].size));
    }
  }
  fitTable();
  table_->setVisible(!rows_.empty());
  mark();
  showState();
}

//! As high as what it lists, so that its buttons stand near it; many rows are scrolled.
void TunnelsList::fitTable() {
  int height = 2 * table_->frameWidth() + table_->horizontalHeader()->sizeHint().height();
  for (int row = 0; row < table_->rowCount() && height < kHighestTable; ++row)
    height += table_->rowHeight(row);
  table_->setFixedHeight(std::min(height, kHighestTable));
}

//! The panel may be longer than the window: what can be done with the chosen row is not to be searched for.
void TunnelsList::scrollToActions() {
  for (QWidget* around = parentWidget(); around; around = around->parentWidget())
    if (auto* area = qobject_cast<QScrollArea*>(around)) {
      layout()->activate();
      QMetaObject::invokeMethod(
          area, [this, area] { area->ensureWidgetVisible(actionRow_, 0, 8); }, Qt::QueuedConnection);
      return;
    }
}

QString TunnelsList::summary() const {
  if (isLooking_) return tr("Looking…");
  if (!found_) return {};
  if (!found_->error.isEmpty()) return found_->error;
  const auto count = static_cast<int>(found_->pieces.size());
  QStringList parts{tr("Tunnels: %1").arg(found_->tunnels.size()), tr("components: %1").arg(bodies()),
                    tr("cavities: %1").arg(count - bodies())};
  if (found_->unlisted > 0) parts << tr("tunnels without loops: %1").arg(found_->unlisted);
  return parts.join(QStringLiteral(" · "));
}

void TunnelsList::showState() {
  const QString name = isLooking_ ? tr("Cancel") : tr("Find tunnels and pieces");
  find_->setText(name);
  describe(find_, name, tr("Lists the tunnels, components and cavities of the shown surface"));
  find_->setEnabled(isLooking_ || canLook());
  summary_->setText(summary());
  summary_->setVisible(!summary_->text().isEmpty());
  showActions();
}

const TunnelsList::Row* TunnelsList::chosen() const {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  const auto row = rows.isEmpty() ? rows_.size() : static_cast<std::size_t>(rows.front().row());
  return row < rows_.size() ? &rows_[row] : nullptr;
}

void TunnelsList::showActions() {
  const Row* row = chosen();
  detail_->setText(row ? row->detail : QString());
  detail_->setVisible(row != nullptr);
  for (const Action& action : actions_) {
    action.button->setVisible(row && action.edit());
    action.button->setEnabled(canLook());
  }
  leaveOut_->setVisible(row && row->edit);
}

//! The loops of the chosen tunnel are seen in the views while this list is.
void TunnelsList::mark() {
  const Row* row = isVisible() ? chosen() : nullptr;
  if (row && row->tunnel)
    state_.markLoops(
        {{MarkedLoop::Kind::handle, row->tunnel->handle}, {MarkedLoop::Kind::tunnel, row->tunnel->tunnel}});
  else
    state_.markLoops({});
}

void TunnelsList::showChosen() {
  showActions();
  mark();
  const Row* row = chosen();
  if (!row) return;
  scrollToActions();
  state_.setCrosshair(row->tunnel ? row->tunnel->place : row->piece ? row->piece->place : row->edit->place);
}

void TunnelsList::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  mark();
}

void TunnelsList::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  mark();
}

}  // namespace handlebody::ui
