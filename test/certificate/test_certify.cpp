// SPDX-License-Identifier: LGPL-3.0-or-later
#include "certificate_cases.h"

#include <localization/paper_polynomials.h>

#include <corral/decision/ideal_system.h>
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/print.h>
#include <corral/polynomial/square_free.h>
#include <corral_check/check.h>

#include "stopping_run.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <random>

namespace {

using namespace certificate_test;
using corral_check::Counts;

Counts check(const std::string& bytes) { return corral_check::check(bytes).counts; }

/// The message of the rejection, or the empty string.
std::string rejection(const std::string& bytes)
{
  try {
    (void)check(bytes);
  } catch (const corral_check::Rejected& error) {
    return error.what();
  }
  return {};
}

/// The message with which the checker stops, or the empty string.
std::string stop(const std::string& bytes)
{
  try {
    (void)check(bytes);
  } catch (const corral_check::Stopped& error) {
    return error.what();
  }
  return {};
}

template <std::size_t D, class Decider>
std::uint64_t count_hits(Decider decider, std::uint32_t cells)
{
  std::uint64_t hits = 0;
  Cell<D> cell{};
  for (std::size_t axis = 0; axis < D;) {
    hits += decider.decide(cell).verdict == Verdict::hit ? 1 : 0;
    for (axis = 0; axis < D && ++cell[axis] == cells; ++axis) cell[axis] = 0;
    if (axis < D) axis = 0;
  }
  return hits;
}

template <std::size_t D>
std::uint64_t exact_hits(const Case& c)
{
  const auto grid = cube<D>(c.lower, c.upper, c.cells);
  const auto system = system_of<D>(c);
  if constexpr (D > 1)
    if (system.size() > 1) return count_hits<D>(System_decider<D>(system, grid), c.cells);
  return count_hits<D>(Cell_decider<D>(system.front(), grid), c.cells);
}

TEST(Certify, writes_what_the_checker_accepts)
{
  for (const Case& c : cases) {
    SCOPED_TRACE(c.polynomial);
    const std::string text = make_text(c);
    const Counts counts = check(text);
    EXPECT_EQ(counts.unknown, 0U);
    const auto hits = c.dimension == 1 ? exact_hits<1>(c) : c.dimension == 2 ? exact_hits<2>(c) : exact_hits<3>(c);
    EXPECT_EQ(counts.hit, hits);
    if (c.hits != 0) {
      EXPECT_EQ(counts.hit, c.hits);
    }
    EXPECT_EQ(counts.empty + counts.hit, std::uint64_t(std::pow(c.cells, double(c.dimension)) + 0.5));
    const std::string packed = gzip(text);
    EXPECT_EQ(check(packed).hit, counts.hit);
  }
}

/// Random polynomials of one kind or another; full mantissas, so that nothing is small by chance.
template <std::size_t D>
class Random_problems
{
public:
  explicit Random_problems(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  Rational coefficient()
  {
    Rational value(static_cast<long>(random_() % 2000001) - 1000000, static_cast<unsigned long>(1 + below(1000000)));
    value.canonicalize();
    return value;
  }

  Polynomial<Rational, D> dense(unsigned degree)
  {
    std::vector<typename Polynomial<Rational, D>::Term> terms;
    Exponents<D> exponents{};
    for (std::size_t axis = 0; axis < D;) {
      if (std::accumulate(exponents.begin(), exponents.end(), 0U) <= degree)
        terms.push_back({exponents, coefficient()});
      for (axis = 0; axis < D && ++exponents[axis] > degree; ++axis) exponents[axis] = 0;
      if (axis < D) axis = 0;
    }
    return collect<Rational, D>(std::move(terms));
  }

  /// A polynomial that is nowhere zero and comes near to it all along a curve or surface.
  Polynomial<Rational, D> near_miss(unsigned degree)
  {
    const auto p = dense(std::max(1U, degree / 2));
    Rational distance(1, 1);
    distance /= Rational(Integer(1) << (20 + 4 * below(20)));
    if (below(3) != 0 || degree < 4) return p * p + constant<Rational, D>(distance);
    const auto q = dense(1);
    const auto r = dense(degree / 2 - 1);
    return (q * r) * (q * r) + constant<Rational, D>(distance) * (constant<Rational, D>(1) + q * q);
  }

  Grid<D> grid(std::uint32_t cells)
  {
    Rational_box<D> box;
    Resolution<D> resolution;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Rational lower = -static_cast<long>(1 + below(5)) / Rational(static_cast<long>(2 + below(3)));
      box[axis] = Rational_interval(lower, lower + static_cast<long>(1 + below(9)) / Rational(3));
      resolution[axis] = static_cast<std::uint32_t>(1 + below(cells));
    }
    return Grid<D>(box, resolution);
  }

  std::vector<Polynomial<Rational, D>> system()
  {
    constexpr std::array<unsigned, 3> highest = {12, 6, 4};
    const unsigned degree = 1 + static_cast<unsigned>(below(highest[D - 1]));
    switch (below(D == 1 ? 4 : 5)) {
    case 0:
      return {dense(degree)};
    case 1:
      return {near_miss(std::max(2U, degree))};
    case 2: { // with multiple factors
      const auto p = dense(1);
      return {p * p * dense((degree + 1) / 2)};
    }
    case 3: { // few terms of high degree
      Exponents<D> exponents{};
      for (auto& exponent : exponents) exponent = static_cast<std::uint16_t>(below(D == 1 ? 300 : D == 2 ? 60 : 12));
      return {Polynomial<Rational, D>({{exponents, coefficient() + 2000001}}) + dense(1)};
    }
    default:
      return {dense((degree + 1) / 2), dense(1 + static_cast<unsigned>(below(2)))};
    }
  }

private:
  std::mt19937 random_;
};

template <std::size_t D>
void expect_random_certificates_accepted(unsigned seed, std::size_t count)
{
  Random_problems<D> problems(seed);
  for (std::size_t k = 0; k < count; ++k) {
    const auto system = problems.system();
    const auto grid = problems.grid(D == 1 ? 40 : D == 2 ? 9 : 4);
    const auto certificate = certify(system, grid);
    const std::string text = to_json(certificate, names<D>());
    SCOPED_TRACE(to_string(system.front(), names<D>()));
    Counts counts;
    ASSERT_NO_THROW(counts = check(text));
    EXPECT_EQ(counts.unknown, certificate.unknown);
  }
}

std::size_t rounds(std::size_t count)
{
  const char* multiplier = std::getenv("CORRAL_TEST_MULTIPLIER");
  return static_cast<std::size_t>(static_cast<double>(count) * (multiplier != nullptr ? std::atof(multiplier) : 1));
}

/// Whatever is written is accepted, and within the limits of work and memory.
TEST(Certify, writes_nothing_else_than_the_checker_accepts)
{
  expect_random_certificates_accepted<1>(301, rounds(40));
  expect_random_certificates_accepted<2>(302, rounds(25));
  expect_random_certificates_accepted<3>(303, rounds(8));
}

TEST(Certify, keeps_to_the_limits_at_high_degrees)
{
  const auto line = certify(parse_polynomial<1>("x^800 + x - 1", names<1>()), cube<1>("0", "1", 4));
  EXPECT_EQ(check(to_json(line, names<1>())).unknown, 0U);
  const auto plane = certify(parse_polynomial<2>("x^200*y^200 + x + y - 1", names<2>()), cube<2>("0", "1", 4));
  EXPECT_EQ(check(to_json(plane, names<2>())).unknown, 0U);
}

TEST(Certify, leaves_no_near_miss_of_the_plane_unknown)
{
  Random_problems<2> problems(304);
  for (std::size_t k = 0; k < rounds(22); ++k) {
    const auto f = problems.near_miss(2 + static_cast<unsigned>(k % 11));
    SCOPED_TRACE(to_string(f, names<2>()));
    const auto certificate = certify(f, problems.grid(9));
    EXPECT_EQ(certificate.empty, static_cast<std::uint64_t>(certificate.grid.cell_count()));
    EXPECT_EQ(check(to_json(certificate, names<2>())).empty, certificate.empty);
  }
}

/// The size that certificates of the paper's curves may have.
TEST(Certify, is_small_on_the_paper_s_curves)
{
  for (const auto& curve : corral::test::paper_curves) {
    SCOPED_TRACE(curve.text);
    const auto f = parse_polynomial<2>(curve.text, names<2>());
    const auto certificate = certify(f, cube<2>("0", "1", 256));
    const std::string packed = gzip(to_json(certificate, names<2>()));
    const Counts counts = check(packed);
    EXPECT_EQ(counts.unknown, 0U);
    EXPECT_LE(counts.hit, curve.maa_cells);
    EXPECT_LE(packed.size(), 60 * certificate.plotted());
  }
}

TEST(Certify, keeps_what_it_has_proved_when_stopped)
{
  const auto certificate =
      certify(parse_polynomial<2>("x^2 + y^2 - 1", names<2>()), cube<2>("-2", "2", 16), test::stopping_at(30));
  EXPECT_GT(certificate.unknown, 0U);
  EXPECT_GT(certificate.empty + certificate.hit, 0U);
  EXPECT_EQ(certificate.reasons, std::vector<std::string>{"stopped before it was decided"});
  EXPECT_EQ(check(to_json(certificate, names<2>())).unknown, certificate.unknown);
}

// The points of x = y where x^30 = 1/2 need a resultant of degree 3600: no one waits for that.
TEST(Certify, keeps_what_it_has_proved_when_a_long_step_is_left)
{
  const auto f = parse_polynomial<2>("(x^30 + y^30 - 1)^2 + (x - y)^60", names<2>());
  const test::Stopping_run run(400);
  const auto certificate = certify(f, cube<2>("-2", "2", 64), run.options, {.patience = std::chrono::milliseconds(0)});
  EXPECT_EQ(*run.reports, 400U);
  EXPECT_GT(certificate.empty, 0U);
  EXPECT_GT(certificate.unknown, 0U);
  EXPECT_EQ(certificate.empty + certificate.hit + certificate.unknown, 64U * 64U);
  EXPECT_EQ(check(to_json(certificate, names<2>())).unknown, certificate.unknown);
}

TEST(Certify, proves_the_same_whether_it_is_patient_or_not)
{
  for (const auto* const text : {"(y - x^5)^2 + 1/10^14", "x^2 + y^2 - 1", "(x^2 - 2)^2 + (y^2 - 3)^2"}) {
    const auto f = parse_polynomial<2>(text, names<2>());
    EXPECT_EQ(to_json(certify(f, cube<2>("-2", "2", 8), {}, {.patience = std::chrono::milliseconds(0)}), names<2>()),
              to_json(certify(f, cube<2>("-2", "2", 8)), names<2>()))
        << text;
  }
}

// s^2 + r with positive r: no cell of space is left open.
TEST(Certify, proves_near_misses_along_a_surface)
{
  const auto f = parse_polynomial<3>("(x^2+y^2+z^2-1)^2+1/10^8", names<3>());
  const auto certificate = certify(f, cube<3>("-1", "1", 8));
  EXPECT_EQ(certificate.empty, 512U);
  EXPECT_EQ(check(to_json(certificate, names<3>())).unknown, 0U);
}

/// What proves a system is no proof of one of its polynomials alone, and the other way round.
TEST(Certify, proofs_of_systems_are_not_interchangeable)
{
  const auto grid = cube<2>("-2", "2", 4);
  const auto f = parse_polynomial<2>("x^2 - 2", names<2>());
  const auto g = parse_polynomial<2>("y^2 - 3", names<2>());
  const auto h =
      parse_polynomial<2>("y^2 - 3 - 1/4", names<2>()); // zeros in the same cells, outside the boxes of the proofs
  const std::string whole = to_json(certify(std::vector{f, g}, grid), names<2>());
  EXPECT_EQ(rejection(whole), "");
  auto forged = certify(std::vector{f, g}, grid);
  forged.polynomials[1] = {h, square_free_part(h)};
  EXPECT_NE(rejection(to_json(forged, names<2>())), "");
  forged = certify(f, grid);
  forged.polynomials.push_back({g, square_free_part(g)});
  EXPECT_NE(rejection(to_json(forged, names<2>())), "");
}

TEST(Certify, gives_up_with_a_reason_when_boxes_run_out)
{
  const auto certificate = certify(parse_polynomial<2>("(x - 1/3)^2 + (y - 1/5)^2 + 1e-30", names<2>()),
                                   cube<2>("0", "1", 2), {}, {.max_boxes = 4});
  EXPECT_EQ(certificate.unknown, 1U);
  ASSERT_EQ(certificate.reasons.size(), 1U);
  EXPECT_EQ(check(to_json(certificate, names<2>())).unknown, 1U);
}

TEST(Certify, refuses_bad_input)
{
  const auto grid = cube<2>("0", "1", 2);
  EXPECT_THROW(static_cast<void>(certify(Polynomial<Rational, 2>{}, grid)), Invalid_input);
  EXPECT_THROW(static_cast<void>(certify(parse_polynomial<2>("x^300*y^300 - 1", names<2>()), grid)), Budget_exceeded);
  const auto line = parse_polynomial<1>("x", names<1>());
  EXPECT_THROW(static_cast<void>(certify(std::vector{line, line}, cube<1>("0", "1", 2))), Invalid_input);
  const auto curve = parse_polynomial<2>("x", names<2>());
  EXPECT_THROW(static_cast<void>(certify(std::vector{curve, curve, curve}, grid)), Invalid_input);
  EXPECT_THROW(static_cast<void>(certify(std::vector{curve, Polynomial<Rational, 2>{}}, grid)), Invalid_input);
  const auto certificate = certify(parse_polynomial<2>("x - y", names<2>()), grid);
  EXPECT_THROW((static_cast<void>(to_json<2>(certificate, {"x", "x"}))), Invalid_input);
}

TEST(Checker, accepts_the_hand_written_files)
{
  const Counts expected[] = {{3, 1, 0}, {1, 0, 2}, {0, 1, 0}, {1, 1, 0}, {3, 1, 0}, {1, 1, 0}};
  for (std::size_t i = 0; i < hand_written.size(); ++i) {
    SCOPED_TRACE(hand_written[i]);
    const Counts counts = check(hand_written_text(hand_written[i]));
    EXPECT_EQ(counts.empty, expected[i].empty);
    EXPECT_EQ(counts.hit, expected[i].hit);
    EXPECT_EQ(counts.unknown, expected[i].unknown);
  }
}

/// A text with one passage exchanged for another.
std::string with(std::string text, const std::string& old_passage, const std::string& new_passage)
{
  const auto position = text.find(old_passage);
  EXPECT_NE(position, std::string::npos) << old_passage;
  return text.replace(position, old_passage.size(), new_passage);
}

TEST(Checker, says_what_is_wrong)
{
  const std::string minimal = hand_written_text("minimal");
  const std::string touch = hand_written_text("irrational_touch");
  const std::string line = hand_written_text("double_line");
  const std::string system = hand_written_text("system");
  const struct
  {
    std::string text;
    const char* reason;
  } faults[] = {
      {with(minimal, "seshe", "seseh"), "leaf 3 at cell 2 level 0: the Bernstein coefficients do not exclude a zero"},
      {with(minimal, "seshe", "seshh"), "leaf 4 at cell 3 level 0: the corners of the cell have one strict sign"},
      {with(minimal, "seshe", "sesh"), "ends before all cells are covered"},
      {with(minimal, "seshe", "seshee"), "continues after its end"},
      {with(minimal, "seshe", "hes"), "h and w belong to cells"},
      {with(minimal, "seshe", "se0"), "the reason is not in the list"},
      {with(minimal, "seshe", "ses?e"), "none of s, e, c"},
      {with(minimal, "seshe", "sesse0e"), "below a cell there is only s, e or c"},
      {with(minimal, "seshe", "seshc"), "c has no place in version 1"},
      {with(minimal, "seshe", "seswe"), "no witness left"},
      {with(minimal, "\"empty\": 3", "\"empty\": 2"), "empty: is not the number"},
      {with(minimal, "\"hit\": 1", "\"hit\": 2"), "hit: is not the number"},
      {with(minimal, "\"unknown\": 0", "\"unknown\": 1"), "unknown: is not the number"},
      {with(minimal, "\"witnesses\": []", "\"witnesses\": [1]"), "does not use"},
      {with(minimal, "\"reasons\": []", "\"reasons\": [\"why\"]"), "does not use"},
      {with(minimal, "\"version\": 1", "\"version\": 3"), "version: is 3; expected 1 to 2"},
      {with(minimal, "\"version\": 1", "\"version\": 2"), "the key 'critical' is missing"},
      {with(minimal, "\"version\": 1", "\"version\": 1, \"version\": 1"), "appears twice"},
      {with(minimal, "\"version\": 1", "\"version\": 1, \"more\": 1"), "not in the specification"},
      {with(minimal, "\"version\": 1", "\"version\": 1.0"), "not a natural number"},
      {with(minimal, "\"version\": 1", "\"version\": NaN"), "not a JSON text"},
      {with(minimal, "\"version\": 1", "\"version\": true"), "no place"},
      {with(minimal, "\"version\": 1", "\"version\": 1e400"), "not a natural number"},
      {with(minimal, "bernstein", "magic"), "method"},
      {with(minimal, "[4]", "[0]"), "resolution"},
      {with(minimal, "[4]", "[1073741825]"), "resolution"},
      {with(minimal, "[4]", "[-4]"), "not a natural number"},
      {with(minimal, "[[\"0\", \"2\"]]", "[[\"2\", \"2\"]]"), "empty or a point"},
      {with(minimal, "\"2\"", "\"4/2\""), "lowest terms"},
      {with(minimal, "\"2\"", "\"2/1\""), "lowest terms"},
      {with(minimal, "\"2\"", "\"2/0\""), "exact text"},
      {with(minimal, "\"2\"", "\"02\""), "exact text"},
      {with(minimal, "\"2\"", "\"+2\""), "exact text"},
      {with(minimal, "\"2\"", "\"2e9\""), "exact text"},
      {with(minimal, "[\"1\", 2]", "[\"0\", 2]"), "a coefficient is 0"},
      {with(minimal, "[\"1\", 2]", "[\"1\", 0]"), "not sorted"},
      {with(minimal, "\"dimension\": 1", "\"dimension\": 7"), "dimension"},
      {with(minimal, "\"dimension\": 1", "\"dimension\": 2"), "entries"},
      {minimal + "{}", "not a JSON text"},
      {minimal + std::string(1, '\0'), "something follows"},
      {"\xef\xbb\xbf" + minimal, "byte order mark"},
      {minimal.substr(0, 200), "not a JSON text"},
      {"", "not a JSON text"},
      {"null", "expected an object"},
      {with(minimal, "[\"x\"]", "[\"\\ud800\"]"), "half a surrogate pair"},
      {with(minimal, "[\"x\"]", "[\"\\udc00\\ud800\"]"), "half a surrogate pair"},
      {with(minimal, "[\"x\"]", "[\"\xed\xa0\x80\"]"), "not UTF-8"},
      {with(minimal, "[\"x\"]", "[\"\xc0\x80\"]"), "not UTF-8"},
      {with(minimal, "[\"x\"]", "[\"\xff\"]"), "not UTF-8"},
      {with(minimal, "\"hit\": 1", "\"hit\": 1, \"h\\u0069t\": 1"), "the key 'hit' appears twice"},
      {"[" + std::string(1000000, '{'), "not a JSON text"},
      {with(line, "\"1/2\", \"0\"", "\"1/2\", \"-1\""), "outside the cell"},
      {with(line, "\"1/2\", \"0\"", "\"1/2\", \"3/4\""), "witness 0 (leaf 1 at cell 0,0 level 0): "},
      {with(line, "[\"1/2\", \"0\"], ", ""), "the point is not a zero"},
      {with(line, "\"power\": 2", "\"power\": 1"), "does not divide its power"},
      {with(line, "-1/3", "-1/2"), "does not divide the polynomial"},
      {with(touch, "[\"-2\", 0, 0], [\"1\", 2, 0]", "[\"-3\", 0, 0], [\"1\", 2, 0]"), "change sign"},
      {with(touch, "[\"4\", 0, 0]", "[\"5\", 0, 0]"), "does not reduce to zero"},
      {with(touch, "[\"1\", \"3/2\"]", "[\"-2\", \"3/2\"]"), "not inside the cell"},
      {with(touch, "[\"1\", 2, 0]]]", "[\"2\", 2, 0]]]"), "not monic"},
      {with(touch, "[1, 0]", "[0, 1]"), "triangular"},
      {with(touch, "[1, 0]", "[1, 1]"), "twice in the order"},
      {with(touch, "[[\"1\", 0, 1]]", "[[\"2\", 0, 1]]"), "not monic"},
      {with(system, "[\"1\", \"0\"], [\"0\", \"1\"]", "[\"1\", \"0\"], [\"2\", \"0\"]"), "singular"},
      {with(system, "\"1/4\"", "\"3/4\""), "no change of sign"},
      {with(system, "\"1/4\"", "\"1\""), "as many sides"},
      {with(system, "seeew", "seeeh"), "h proves nothing of several polynomials"},
  };
  for (const auto& fault : faults) {
    const std::string why = rejection(fault.text);
    EXPECT_NE(why.find(fault.reason), std::string::npos) << "expected: " << fault.reason << "\nfound: " << why;
  }
}

/// What breaks a limit only is not called wrong.
TEST(Checker, stops_at_limits)
{
  const std::string minimal = hand_written_text("minimal");
  EXPECT_NE(stop(with(minimal, "seshe", std::string(1200, 's'))).find("deeper than 1000 levels"), std::string::npos);
  EXPECT_NE(stop(with(minimal, "\"2\"", '"' + std::string(100001, '2') + '"')).find("100000"), std::string::npos);
  EXPECT_NE(stop(with(minimal, "[\"1\", 2]", "[\"1\", 1001]")).find("above 1000"), std::string::npos);
  EXPECT_NE(stop(std::string(1000000, '[')).find("more than 16 deep"), std::string::npos);
}

TEST(Checker, reads_strings_by_what_they_mean)
{
  const std::string minimal = hand_written_text("minimal");
  for (const std::string& text :
       {with(minimal, "seshe", "s\\u0065she"), with(minimal, "\"2\"", "\"\\u0032\""),
        with(minimal, "\"hit\"", "\"h\\u0069t\""), with(minimal, "[\"x\"]", "[\"\\ud83d\\ude00\"]"),
        with(minimal, "[\"x\"]", "[\"\xf0\x9f\x98\x80\\n\\u0000\"]")})
    EXPECT_EQ(check(text).hit, 1U) << text;
}

TEST(Checker, says_where)
{
  const std::string minimal = hand_written_text("minimal");
  const auto byte_of = [](const std::string& text) {
    try {
      (void)check(text);
    } catch (const corral_check::Refusal& refusal) {
      return refusal.byte.value_or(0);
    }
    return std::size_t{0};
  };
  for (const auto& [old_passage, new_passage, fault] : {std::array<const char*, 3>{"seshe", "seseh", "eh\""},
                                                        {"\"2\"]]", "\"2/2\"]]", "\"2/2"},
                                                        {"[4]", "[0]", "0], \"method"}}) {
    const std::string text = with(minimal, old_passage, new_passage);
    EXPECT_EQ(byte_of(text), text.find(fault)) << new_passage;
  }
}

TEST(Checker, tells_what_is_claimed_and_proved)
{
  const corral_check::Certificate certificate(hand_written_text("minimal"));
  EXPECT_EQ(certificate.claims().polynomials, std::vector<std::string>{"-2 + x^2"});
  EXPECT_EQ(certificate.claims().box, (std::vector<std::string>{"0", "2"}));
  std::string verdicts(4, '?');
  certificate.check([&](const corral_check::Region& region) {
    verdicts.replace(region.corner[0], region.size[0], region.size[0], region.verdict);
  });
  EXPECT_EQ(verdicts, "eehe");
}

TEST(Checker, bounds_time_and_memory)
{
  // A polynomial split again and again.
  std::string deep = with(hand_written_text("double_line"), "[\"1\", 0, 2]]", "[\"1\", 0, 2], [\"1\", 20, 20]]");
  deep = with(deep, "swe", std::string(900, 's'));
  const auto cut = deep.find("\"square_free\": [");
  deep.replace(cut, deep.find("\"box\"") - cut, "\"square_free\": null, ");
  EXPECT_NE(stop(deep).find("memory"), std::string::npos);
  // A long coordinate to a high power.
  const std::string touch = hand_written_text("double_line");
  std::string tall = with(touch, "[\"1\", 0, 2]]", "[\"1\", 0, 2], [\"1\", 1000, 0]]");
  tall = with(tall, "\"square_free\": [{\"polynomial\": [[\"-1/3\", 0, 0], [\"1\", 0, 1]], \"power\": 2}]",
              "\"square_free\": null");
  tall = with(tall, "[[\"0\", \"1\"], ", "[[\"0\", \"" + std::string(90000, '7') + "\"], ");
  EXPECT_NE(stop(tall).find("memory"), std::string::npos);
  EXPECT_NE(stop(gzip(std::string((std::size_t{1} << 28) + 1, ' '))).find("longer than"), std::string::npos);
  std::string many = "[";
  for (int i = 0; i < 9000000; ++i) many += "0,";
  EXPECT_NE(stop(many + "0]").find("2^23 values"), std::string::npos);
}

/// A power beyond the degree is as good as the degree, and costs no more.
TEST(Checker, takes_no_longer_for_a_high_power)
{
  const std::string line = hand_written_text("double_line");
  EXPECT_EQ(check(with(line, "\"power\": 2", "\"power\": 1000")).hit, check(line).hit);
  const auto f = parse_polynomial<2>("(x*y - 1)^3*(x - y)^2", names<2>());
  const std::string text = to_json(certify(f, cube<2>("-2", "2", 4)), names<2>());
  EXPECT_EQ(check(with(text, "\"power\":3", "\"power\":1000")).hit, check(text).hit);
  EXPECT_NE(rejection(with(text, "\"power\":3", "\"power\":2")), "");
}

TEST(Checker, rejects_damaged_gzip)
{
  const std::string packed = gzip(hand_written_text("minimal"));
  EXPECT_EQ(rejection(packed), "");
  for (std::size_t length = 0; length < packed.size(); ++length) EXPECT_NE(rejection(packed.substr(0, length)), "");
  EXPECT_NE(rejection(packed + "x"), "");
  EXPECT_NE(rejection(packed + packed), "");
}

TEST(Checker, shares_no_code_with_the_library)
{
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CORRAL_CHECKER_SOURCES)) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp") continue;
    ++files;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      if (!line.starts_with("#include")) continue;
      const std::string what = line.substr(10, line.size() - 11);
      EXPECT_FALSE(what.starts_with("corral/")) << entry.path();
      const bool is_own = line[9] == '<' || what == "version.h"
                          || std::filesystem::exists(std::filesystem::path(CORRAL_CHECKER_SOURCES) / what);
      EXPECT_TRUE(is_own && what.find("..") == std::string::npos) << entry.path() << ": " << line;
    }
  }
  EXPECT_GE(files, 10U);
}

} // namespace
