#pragma once

#include <QString>

namespace handlebody::ui {

//! The exception that is being handled as a sentence for a person. Call it in a catch block.
QString errorSentence();

}  // namespace handlebody::ui
