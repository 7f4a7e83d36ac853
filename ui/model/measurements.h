#pragma once
// The rulers and angles of the open work.

#include <QObject>
#include <vector>

#include "core/measure/measurement.h"

class QUndoStack;

namespace handlebody::ui {

class Measurements : public QObject {
  Q_OBJECT

 public:
  //! `undo` outlives it.
  explicit Measurements(QUndoStack& undo) : undo_(undo) {}

  const std::vector<Measurement>& all() const { return all_; }
  //! "Ruler 1", "Angle 3": by the place in the list.
  QString nameOf(int index) const;
  //! -1: none
  int selected() const { return selected_; }
  void select(int index);

  //! Selected then. Precondition: it has all its points.
  void add(const Measurement& measurement);
  //! Calls with the same `gesture` (one mouse drag) merge into one undo entry; -1 never merges.
  void movePoint(int index, int point, const Vec3& place, int gesture = -1);
  void remove(int index);
  //! As of a volume or session that was just opened: no undo entry.
  void startWith(const std::vector<Measurement>& measurements);

 Q_SIGNALS:
  void changed();  //!< the list, or what is selected

 private:
  friend class MeasurementsCommand;
  void push(const QString& text, std::vector<Measurement> after, int selected, int gesture = -1);
  void apply(const std::vector<Measurement>& measurements, int selected);

  QUndoStack& undo_;
  std::vector<Measurement> all_;
  int selected_ = -1;
};

//! "12.3 mm" or "45.6°" in the user's locale. `decimals`: of a length below 10 mm; of a longer one it is one
//! less.
QString measuredValue(const Measurement& measurement, int decimals = 2);

}  // namespace handlebody::ui
