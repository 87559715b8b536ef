// SPDX-License-Identifier: LGPL-3.0-or-later
#include <number/Prime_field.h>

#include <gtest/gtest.h>

namespace {

using namespace corral;

TEST(Large_primes, are_all_primes_below_2_to_the_62_from_the_top)
{
  exact::Large_primes primes;
  std::uint64_t last = std::uint64_t{1} << 62;
  for (int i = 0; i < 110; ++i) { // beyond the table
    const std::uint64_t prime = primes.next();
    Integer expected = last;
    do --expected;
    while (mpz_probab_prime_p(expected.get_mpz_t(), 30) == 0);
    ASSERT_EQ(prime, expected.get_ui());
    last = prime;
  }
}

TEST(Prime_field, agrees_with_exact_integers)
{
  const std::uint64_t prime = exact::Large_primes().next();
  const exact::Prime_field field(prime);
  const Integer modulus = prime;
  Integer a = 3;
  for (int i = 0; i < 200; ++i) {
    a = (a * a + 12345) % modulus;
    const Integer b = a * 7919 % modulus;
    EXPECT_EQ(Integer(field.residue(field.multiply(field.from(a), field.from(b)))), Integer(a * b % modulus));
    EXPECT_EQ(field.residue(field.multiply(field.inverse(field.from(a)), field.from(a))), 1U);
    EXPECT_EQ(field.subtract(field.add(field.from(a), field.from(b)), field.from(b)), field.from(a));
  }
}

} // namespace
