#pragma once
// Measures of the objects' surfaces and centre lines in them, worked out on a thread of their own.

#include <QString>
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/io/report/measured.h"
#include "ui/model/background.h"
#include "ui/model/finished_mesh.h"

namespace handlebody::ui {

//! An object to be measured, as it is written.
struct MeasuredSurface {
  QString name;
  std::shared_ptr<const FinishedMesh> mesh;
  QString anonymousName{};  //!< where nothing is to name the patient
  bool operator==(const MeasuredSurface&) const = default;
};

//! Of all objects that have one, in their order.
std::vector<MeasuredSurface> shownSurfaces(const Document& document);
//! Their anonymous names by their names.
std::map<std::string, std::string> anonymousNames(const std::vector<MeasuredSurface>& surfaces);

//! Whose wall is measured: between two of the surfaces, or one and its own cavities.
struct WantedWall {
  int first = 0;
  std::optional<int> second{};  //!< none: the first one's cavities
};

//! The two surfaces of a wall that an object is in itself, as files name them in every language.
inline constexpr const char *kOuterSurface = "the outer surface", *kCavities = "the cavities";

struct MeasureQuestion {
  std::vector<MeasuredSurface> surfaces;
  Volume volume;
  std::string path;        //!< of the work, for JSON
  std::string volumePath;  //!< the same
  std::optional<WantedWall> wall{};
};

struct MeasureAnswer {
  Measured measured;
  QString error{};  //!< why there is nothing; empty: all went well
};

//! Two places in one of the objects, mm LPS.
struct LineQuestion {
  std::vector<MeasuredSurface> surfaces;
  Vec3 from{0, 0, 0}, to{0, 0, 0};
};

struct LineAnswer {
  std::optional<MeasuredLine> line;  //!< in the object that holds both places
  QString error{};                   //!< why there is none
};

//! Throws Cancelled and what the parts throw. `progress` is called with 0 … 1.
Measured measureAll(const MeasureQuestion& question, const std::function<void(double)>& progress);
//! Throws Cancelled.
LineAnswer lineOf(const LineQuestion& question);

//! One job at a time: a new one takes the place of the one before. All functions given are called on its
//! thread, none of a job that was cancelled before its end.
class Measurer {
 public:
  ~Measurer() { cancel(); }
  void measure(MeasureQuestion question, std::function<void(double)> progress,
               std::function<void(MeasureAnswer)> done);
  void findLine(LineQuestion question, std::function<void(LineAnswer)> done);
  void cancel();

 private:
  std::shared_ptr<std::atomic<bool>> startAnew();

  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  Background thread_;
};

}  // namespace handlebody::ui
