#include "core/io/report/sensitivity_table.h"

#include <iomanip>
#include <locale>
#include <sstream>

#include "core/io/report/csv_line.h"
#include "core/units.h"

namespace handlebody {

namespace {

std::string written(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(10) << value;
  return out.str();
}

}  // namespace

std::string sensitivityCsv(const Sensitivity& s) {
  std::string table = csvLine({"run", "volume_ml", "components", "genus", "mean_distance_mm", "failure"});
  int number = 0;
  for (const PerturbedRun& r : s.runs) {
    const std::string run = std::to_string(++number);
    table += r.failure.empty() ? csvLine({run, written(r.volume / kMillilitre), std::to_string(r.components),
                                          std::to_string(r.genus), written(r.distance), ""})
                               : csvLine({run, "", "", "", "", r.failure});
  }
  return table;
}

}  // namespace handlebody
