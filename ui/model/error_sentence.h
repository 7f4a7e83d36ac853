#pragma once

#include <QString>

namespace handlebody::ui {

//! The exception that is being handled as a sentence for a person. Call it in a catch block.
QString errorSentence();

//! Does `job`: why it failed, as a sentence; empty: it did not.
template <typename Job>
QString whyNot(Job&& job) try {
  job();
  return {};
} catch (...) {
  return errorSentence();
}

}  // namespace handlebody::ui
