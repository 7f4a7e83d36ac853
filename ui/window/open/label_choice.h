#pragma once
// The labels of a map, to check those that are wanted.

#include <QWidget>
#include <vector>

#include "core/io/report/label_file.h"

class QHBoxLayout;
class QListWidget;

namespace handlebody::ui {

class LabelChoice : public QWidget {
  Q_OBJECT

 public:
  explicit LabelChoice(QWidget* parent = nullptr);

  //! All are checked.
  void offer(const std::vector<NamedLabel>& labels);
  //! The numbers of those that are checked, in their order.
  std::vector<int> checked() const;

 Q_SIGNALS:
  void changed();

 private:
  void addButton(QHBoxLayout* row, const QString& text, const QString& tip, Qt::CheckState state);
  void checkAll(Qt::CheckState state);

  QListWidget* list_;
};

}  // namespace handlebody::ui
