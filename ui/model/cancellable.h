#pragma once
// Jobs of a background thread that somebody may no longer want.

#include <atomic>
#include <functional>

#include "core/cancellation.h"
#include "ui/model/error_sentence.h"

namespace handlebody::ui {

//! Calls `done` with what work() returns, or with an empty Answer whose `error` says why it failed; not at
//! all if it was cancelled.
template <typename Answer, typename Work>
void answerWith(const std::atomic<bool>& cancelled, const std::function<void(Answer)>& done, Work&& work) {
  Answer answer;
  try {
    const CancelScope scope(cancelled);
    giveUpIfCancelled();
    answer = work();
  } catch (const Cancelled&) {
    return;
  } catch (...) {
    answer = {};
    answer.error = errorSentence();
  }
  if (!cancelled) done(std::move(answer));
}

}  // namespace handlebody::ui
