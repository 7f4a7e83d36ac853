#pragma once

namespace handlebody::test {

//! All test cases that are linked, with Catch2's own options; its exit code. Catch2's own code is compiled
//! once, with this.
int runCatch(int argc, char** argv);

}  // namespace handlebody::test
