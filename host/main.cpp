// The program `slipstick`.
#include <cstdio>

int main() { return 0; }
