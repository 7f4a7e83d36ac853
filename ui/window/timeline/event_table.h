#pragma once
// The changes of topology as a table.

#include <QAbstractTableModel>
#include <vector>

namespace handlebody::ui {

class Document;

class EventTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit EventTable(Document& document, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  //! Row ↔ index into Document::events(); -1 where there is none. Repairs of the mesh (folds smoothed, parts
  //! rolled back) are shown on request.
  int eventOf(int row) const;
  int rowOf(int event) const;
  void showRepairs(bool on);

 private:
  std::vector<int> shownEvents() const;
  void refresh();
  void reset();
  QString text(int row, int column) const;

  Document& document_;
  std::vector<int> rows_;
  bool repairs_ = false;
};

}  // namespace handlebody::ui
