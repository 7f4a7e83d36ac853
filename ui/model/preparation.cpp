#include "ui/model/preparation.h"

#include <chrono>

#include "ui/model/error_sentence.h"

namespace handlebody::ui {

namespace {

Prepared prepare(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& parameters) try {
  const auto start = std::chrono::steady_clock::now();
  Prepared prepared;
  prepared.contour = std::make_shared<const ActiveContour>(volume, seeds, parameters);
  prepared.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return prepared;
} catch (...) {
  return {nullptr, errorSentence(), 0};
}

}  // namespace

void Preparation::request(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& parameters,
                          std::function<void(Prepared)> done) {
  background_.postInstead([=, done = std::move(done)] { done(prepare(volume, seeds, parameters)); });
}

}  // namespace handlebody::ui
