#pragma once
// The shown growth again with everything a little different (core/sensitivity), on a thread of its own.

#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "core/sensitivity/sensitivity.h"
#include "ui/model/background.h"
#include "ui/model/finished_mesh.h"

namespace handlebody::ui {

class Document;

struct SensitivityQuestion {
  std::shared_ptr<const FinishedMesh> surface;
  GrownFrom from;
  int runs = 8;
};

struct SensitivityAnswer {
  std::optional<Sensitivity> found{};  //!< none: it failed
  QString error{};                     //!< why
};

//! Why it cannot be told of the shown surface of the active object, as a sentence; empty: it can.
QString sensitivityFault(const Document& document);
//! Precondition: there is no fault.
SensitivityQuestion sensitivityQuestion(const Document& document, int runs);

//! One job at a time: a new one takes the place of the one before. All functions given are called on other
//! threads, none of a job that was cancelled before its end.
class Sensor {
 public:
  ~Sensor() { cancel(); }
  //! `progress` gets the number of runs that have ended.
  void ask(SensitivityQuestion question, std::function<void(int)> progress,
           std::function<void(SensitivityAnswer)> done);
  void cancel() { *cancelled_ = true; }

 private:
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  Background thread_;
};

}  // namespace handlebody::ui
