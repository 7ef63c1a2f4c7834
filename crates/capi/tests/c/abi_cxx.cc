// The same layouts as C has them.
#include "abi.c"
