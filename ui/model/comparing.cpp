#include "ui/model/comparing.h"

#include <QFile>

#include "ui/model/cancellable.h"

namespace handlebody::ui {

CompareAnswer compareWith(const CompareQuestion& q) {
  auto pair = std::make_shared<ComparedPair>();
  pair->a = comparedMesh(q.surface.name.toStdString(), q.surface.mesh->get().mesh);
  giveUpIfCancelled();
  pair->b = readCompared(QFile::encodeName(q.path).toStdString(), q.label, pair->warnings);
  giveUpIfCancelled();
  compare(*pair, {});
  giveUpIfCancelled();
  CompareAnswer answer;
  const Solid& reference = pair->b.solid;
  if (!reference.empty()) {
    answer.isSigned = reference.isClosed();
    answer.distances = vertexDistances(pair->a.solid.surface, reference.surface, answer.isSigned, 1);
  }
  answer.pair = std::move(pair);
  return answer;
}

void Comparer::compare(CompareQuestion question, std::function<void(CompareAnswer)> done) {
  cancel();
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  thread_.postInstead([stop = cancelled_, question = std::move(question), done = std::move(done)] {
    answerWith<CompareAnswer>(*stop, done, [&] { return compareWith(question); });
  });
}

}  // namespace handlebody::ui
