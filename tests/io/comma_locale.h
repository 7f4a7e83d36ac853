#pragma once
// A locale that writes 0,5 for a half, as hosts of the engine may have chosen one.

#include <locale.h>

#include <cstdlib>
#include <string>

#include "tests/io/io_test_support.h"

namespace handlebody::test {

//! The locale of the whole process while one of these lives: one that is installed, or is made for it.
class CommaLocale {
 public:
  CommaLocale() : before_(setlocale(LC_NUMERIC, nullptr)) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "fr_FR.utf8"})
      if (!isChosen_) choose(name);
    if (isChosen_) return;
    const std::string make = "localedef -i de_DE -f UTF-8 '" + (folder_ / "de_DE.UTF-8") + "' 2> /dev/null";
    if (std::system(make.c_str()) != 0) return;
    setenv("LOCPATH", folder_.path().c_str(), 1);
    choose("de_DE.UTF-8");
    unsetenv("LOCPATH");
  }
  ~CommaLocale() { setlocale(LC_NUMERIC, before_.c_str()); }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

  //! False, and told, where there is none.
  bool isChosen() const {
    if (!isChosen_) WARN("SKIPPED: no locale with a decimal comma here");
    return isChosen_;
  }

 private:
  void choose(const char* name) {
    isChosen_ = setlocale(LC_NUMERIC, name) != nullptr && *localeconv()->decimal_point == ',';
  }
  TemporaryFolder folder_;
  std::string before_;
  bool isChosen_ = false;
};

}  // namespace handlebody::test
