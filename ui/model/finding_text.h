#pragma once
// Findings of the engine in the words of the window, translated, with numbers in the user's locale.

#include <QString>
#include <vector>

#include "core/finding.h"

namespace handlebody::ui {

//! The words alone: no capital letter and no full stop unless the finding is a whole sentence.
QString findingText(const Finding& finding);
//! With "; " between.
QString findingText(const std::vector<Finding>& findings);
//! False where a part of it is words that have no kind yet: they are English.
bool isTranslated(const Finding& finding);
//! As a sentence: with a capital letter and a full stop.
QString findingSentence(const Finding& finding);
//! One behind the other.
QString findingSentences(const std::vector<Finding>& findings);

}  // namespace handlebody::ui
