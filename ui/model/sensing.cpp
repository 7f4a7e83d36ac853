#include "ui/model/sensing.h"

#include "ui/model/cancellable.h"
#include "ui/model/document.h"
#include "ui/model/time_series.h"

namespace handlebody::ui {

QString sensitivityFault(const Document& document) {
  if (!document.hasVolume() || !document.snapshot() || document.snapshot()->mesh.triangles.empty())
    return Document::tr("There is no surface yet: grow one first.");
  if (!document.time().showsGrownFrame() || document.correctedFrame())
    return Document::tr("It is told of the frame that the surface is grown in: go there first.");
  if (document.state() == GrowthState::running || document.state() == GrowthState::preparing)
    return Document::tr("The surface still grows: wait until it is at rest.");
  if (document.state() != GrowthState::finished || document.iteration() != document.lastIteration())
    return Document::tr("It is told of a surface that has come to rest: let it grow to its end first.");
  if (!document.grownFrom()) return Document::tr("There is no surface yet: grow one first.");
  try {
    requireRepeatable(document.grownFrom()->request.constraints);
  } catch (...) {
    return errorSentence();
  }
  return {};
}

SensitivityQuestion sensitivityQuestion(const Document& document, int runs) {
  return {document.finishedMesh(document.activeObject()), *document.grownFrom(), runs};
}

void Sensor::ask(SensitivityQuestion question, std::function<void(int)> progress,
                 std::function<void(SensitivityAnswer)> done) {
  cancel();
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  thread_.postInstead(
      [stop = cancelled_, q = std::move(question), progress = std::move(progress), done = std::move(done)] {
        answerWith<SensitivityAnswer>(*stop, done, [&] {
          SensitivityAnswer answer;
          answer.found =
              sensitivityOf(q.surface->get().mesh, q.from, q.runs, q.from.used.threads, [&](int ended) {
                if (!*stop) progress(ended);
              });
          return answer;
        });
      });
}

}  // namespace handlebody::ui
