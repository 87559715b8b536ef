// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Bernstein_form.h"

namespace corral::exact {

std::vector<Integer> bernstein_weights(std::size_t n)
{
  std::vector<Integer> binomials(n + 1);
  Integer common = 1;
  for (std::size_t k = 0; k <= n; ++k) {
    mpz_bin_uiui(binomials[k].get_mpz_t(), n, k);
    common = lcm(common, binomials[k]);
  }
  for (Integer& b : binomials) b = common / b;
  return binomials;
}

} // namespace corral::exact
