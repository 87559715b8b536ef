// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/number/Outward_interval.h>

int main()
{
  const corral::Arithmetic_scope<corral::Outward_interval> scope;
  return corral::strict_sign(corral::Outward_interval(1) * 0.5) - 1;
}
