// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/number/Rational.h>

int main() { return corral::parse_rational("1/2") == 0 ? 1 : 0; }
