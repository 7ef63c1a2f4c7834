// The C++ layouts equal the C layouts.
#include "abi.c"
