#include "ui/model/measurements.h"

#include <QLocale>
#include <QUndoStack>
#include <algorithm>

namespace handlebody::ui {

namespace {
constexpr int kMeasurements = 3;  // the kind of command that merges (undo_commands.cpp has the others)
}

//! The list before and after.
class MeasurementsCommand : public QUndoCommand {
 public:
  struct List {
    std::vector<Measurement> all;
    int selected = -1;
  };

  MeasurementsCommand(const QString& text, Measurements& target, List after, int gesture)
      : QUndoCommand(text),
        target_(target),
        before_{target.all_, target.selected_},
        after_(std::move(after)),
        gesture_(gesture) {}

  int id() const override { return gesture_ < 0 ? -1 : kMeasurements; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const MeasurementsCommand*>(other);  // the same id: the same class
    if (next->gesture_ != gesture_) return false;
    after_ = next->after_;
    return true;
  }
  void undo() override { target_.apply(before_.all, before_.selected); }
  void redo() override { target_.apply(after_.all, after_.selected); }

 private:
  Measurements& target_;
  List before_, after_;
  int gesture_;
};

QString Measurements::nameOf(int index) const {
  const bool isRuler = all_.at(static_cast<std::size_t>(index)).kind == MeasurementKind::ruler;
  return (isRuler ? tr("Ruler %1") : tr("Angle %1")).arg(index + 1);
}

void Measurements::select(int index) {
  if (index == selected_ || index >= static_cast<int>(all_.size())) return;
  selected_ = index;
  Q_EMIT changed();
}

void Measurements::add(const Measurement& measurement) {
  std::vector<Measurement> after = all_;
  after.push_back(measurement);
  const int index = static_cast<int>(after.size()) - 1;
  push(measurement.kind == MeasurementKind::ruler ? tr("Add ruler") : tr("Add angle"), std::move(after),
       index);
}

void Measurements::movePoint(int index, int point, const Vec3& place, int gesture) {
  std::vector<Measurement> after = all_;
  Measurement& moved = after.at(static_cast<std::size_t>(index));
  Vec3& old = moved.points.at(static_cast<std::size_t>(point));
  if (old == place) return;
  old = place;
  push(moved.kind == MeasurementKind::ruler ? tr("Move ruler") : tr("Move angle"), std::move(after), index,
       gesture);
}

void Measurements::remove(int index) {
  if (index < 0 || index >= static_cast<int>(all_.size())) return;
  std::vector<Measurement> after = all_;
  const bool isRuler = after[index].kind == MeasurementKind::ruler;
  after.erase(after.begin() + index);
  const int next = std::min(index, static_cast<int>(after.size()) - 1);
  push(isRuler ? tr("Delete ruler") : tr("Delete angle"), std::move(after), next);
}

void Measurements::startWith(const std::vector<Measurement>& measurements) { apply(measurements, -1); }

void Measurements::push(const QString& text, std::vector<Measurement> after, int selected, int gesture) {
  undo_.push(new MeasurementsCommand(text, *this, {std::move(after), selected}, gesture));
}

void Measurements::apply(const std::vector<Measurement>& measurements, int selected) {
  all_ = measurements;
  selected_ = selected;
  Q_EMIT changed();
}

QString measuredValue(const Measurement& measurement, int decimals) {
  const QLocale locale;
  const double value = valueOf(measurement);
  constexpr double kFine = 10;  // mm, below which there is a decimal more
  if (measurement.kind == MeasurementKind::angle) return locale.toString(value, 'f', 1) + QStringLiteral("°");
  return locale.toString(value, 'f', value < kFine ? decimals : decimals - 1) + QStringLiteral(" mm");
}

}  // namespace handlebody::ui
