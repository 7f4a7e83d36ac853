#include "tests/support/run_catch.h"

int main(int argc, char** argv) { return handlebody::test::runCatch(argc, argv); }
