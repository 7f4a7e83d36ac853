#pragma once
// The series of a folder, to choose one.

#include <QListWidget>
#include <optional>
#include <vector>

#include "core/io/formats/volume_io.h"

namespace handlebody::ui {

//! What is known of a series, one line each: what it shows; size and spacing, or why it is no volume; slices
//! and time points.
QStringList linesOf(const SeriesInfo& series);

class SeriesList : public QListWidget {
  Q_OBJECT

 public:
  explicit SeriesList(QWidget* parent = nullptr);

  //! The first that can be opened is current. What cannot is shown, but cannot be chosen.
  void offer(const std::vector<SeriesInfo>& series);
  //! SeriesInstanceUID of the current series, which a file may lack (empty); none if none can be chosen.
  std::optional<QString> chosen() const;

 private:
  void fitHeight();
};

}  // namespace handlebody::ui
