#pragma once
// Numbers in files have a point, whatever the locale of the program that we are part of.

#include <locale.h>  // POSIX: of <clocale> nothing is said about these

namespace handlebody {

//! While one of these lives, C functions that this thread calls write and read numbers with a point:
//! libraries below use them, and a host (Python, Qt) may have chosen a locale with a comma. Other threads
//! keep theirs.
class DecimalPoint {
 public:
  DecimalPoint() {
    const locale_t copy = ::duplocale(::uselocale(nullptr));
    own_ = copy ? ::newlocale(LC_NUMERIC_MASK, "C", copy) : nullptr;
    if (own_)
      before_ = ::uselocale(own_);
    else if (copy)
      ::freelocale(copy);
  }
  ~DecimalPoint() {
    if (!own_) return;
    ::uselocale(before_);
    ::freelocale(own_);
  }
  DecimalPoint(const DecimalPoint&) = delete;
  DecimalPoint& operator=(const DecimalPoint&) = delete;

 private:
  locale_t own_ = nullptr, before_ = nullptr;  // no locale is made: what there was stays
};

}  // namespace handlebody
