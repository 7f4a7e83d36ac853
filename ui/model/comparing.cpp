#include "ui/model/comparing.h"

#include "core/io/meshes/mesh_io.h"
#include "ui/model/cancellable.h"
#include "ui/model/file_name.h"

namespace handlebody::ui {

namespace {

//! A label map may have too many to be listed, and be compared as a whole all the same.
ReferenceLabels labelsOf(LabelFile& file) {
  try {
    return {file.labels(), {}};
  } catch (const Cancelled&) {
    throw;
  } catch (...) {
    return {{}, errorSentence()};
  }
}

ComparedObject referenceOf(const CompareQuestion& q, std::vector<Finding>& warnings, const TellLabels& tell) {
  if (q.object) return comparedMesh(q.object->name.toStdString(), q.object->mesh->get().mesh);
  const std::string path = fileName(q.path);
  if (isMeshInputPath(path)) return readCompared(path, {}, warnings);
  LabelFile file(path);
  giveUpIfCancelled();
  if (tell) tell(labelsOf(file));
  giveUpIfCancelled();
  return comparedLabels(path, file, q.label, warnings);
}

}  // namespace

CompareAnswer compareWith(const CompareQuestion& q, const TellLabels& tell) {
  auto pair = std::make_shared<ComparedPair>();
  pair->a = comparedMesh(q.surface.name.toStdString(), q.surface.mesh->get().mesh);
  giveUpIfCancelled();
  pair->b = referenceOf(q, pair->warnings, tell);
  giveUpIfCancelled();
  compare(*pair, {});
  giveUpIfCancelled();
  CompareAnswer answer;
  if (!pair->b.solid.empty()) {
    answer.isSigned = pair->b.solid.isClosed();
    answer.distances = distancesFromReference(*pair, 1);
  }
  answer.pair = std::move(pair);
  return answer;
}

void Comparer::compare(CompareQuestion question, TellLabels tell, std::function<void(CompareAnswer)> done) {
  cancel();
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  thread_.postInstead(
      [stop = cancelled_, question = std::move(question), tell = std::move(tell), done = std::move(done)] {
        answerWith<CompareAnswer>(*stop, done, [&] { return compareWith(question, tell); });
      });
}

}  // namespace handlebody::ui
