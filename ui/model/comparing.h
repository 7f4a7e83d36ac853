#pragma once
// The surface of an object against a reference, a file or another object, on a thread of its own.

#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/io/report/compared.h"
#include "core/io/report/label_file.h"
#include "ui/model/background.h"
#include "ui/model/measuring.h"

namespace handlebody::ui {

struct CompareQuestion {
  MeasuredSurface surface;
  QString path;                             //!< of the reference: a mesh or a label map
  std::optional<int> label{};               //!< of the object in a label map; none: all that is not 0
  std::optional<MeasuredSurface> object{};  //!< the reference in place of a file
};

//! Of a label map.
struct ReferenceLabels {
  std::vector<NamedLabel> all{};
  QString error{};  //!< why they are not known; empty: they are
};
using TellLabels = std::function<void(ReferenceLabels)>;

struct CompareAnswer {
  std::shared_ptr<const ComparedPair> pair{};  //!< null: there is none
  std::vector<double> distances{};  //!< mm, of the surface's points; none if the reference is empty
  bool isSigned = false;            //!< negative inside of the reference
  QString error{};                  //!< why there is nothing; empty: all went well
};

//! Throws Cancelled, and as readCompared. `tell`, if there is one, is told of the labels of a label map
//! before that is compared, whether or not it can be.
CompareAnswer compareWith(const CompareQuestion& question, const TellLabels& tell = {});

//! One job at a time: a new one takes the place of the one before.
class Comparer {
 public:
  ~Comparer() { cancel(); }
  //! `tell` and `done` are called on the comparer's thread, unless it was cancelled.
  void compare(CompareQuestion question, TellLabels tell, std::function<void(CompareAnswer)> done);
  void cancel() { *cancelled_ = true; }

 private:
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  Background thread_;
};

}  // namespace handlebody::ui
