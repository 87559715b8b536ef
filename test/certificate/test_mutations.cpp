// SPDX-License-Identifier: LGPL-3.0-or-later
#include "certificate_cases.h"
#include "claims.h"

#include <corral_check/check.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <random>
#include <set>

/// \file
/// Changes certificates at random and asks the checker. A changed file may be accepted only if what it claims is true,
/// as an independent reader and the exact decision find. The same program, linked with a checker that skips one
/// check, must find a false acceptance: CMakeLists.txt runs it so.
namespace {

using namespace certificate_test;
using nlohmann::json;

/// Random changes of a text. JSON values are chosen evenly among all values of the document.
class Mutator
{
public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string mutate(const std::string& text)
  {
    switch (below(6)) {
    case 0:
      return change_bytes(text);
    case 1:
      return change_tree(text);
    case 2:
      return lie(text);
    default:
      return change_field(text);
    }
  }

  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  std::string change_bytes(std::string text)
  {
    for (std::size_t changes = 1 + below(3); changes > 0 && !text.empty(); --changes) {
      const std::size_t at = below(text.size());
      switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 2:
        text.erase(at, 1 + below(4));
        break;
      case 3:
        text.insert(at, 1, "0123456789-/,[]{}\":sehw\n\0"[below(25)]);
        break;
      case 4:
        text.insert(at, text.substr(below(text.size()), 1 + below(30)));
        break;
      default:
        if (below(10) == 0) text.resize(at);
        break;
      }
    }
    return text;
  }

  std::string change_tree(const std::string& text)
  {
    json root = json::parse(text);
    auto& tree = root["tree"].get_ref<std::string&>();
    const std::size_t at = below(tree.size());
    const char symbol = "sehw01"[below(6)];
    switch (below(5)) {
    case 0:
      tree[at] = symbol;
      break;
    case 1:
      tree.erase(at, 1 + below(3));
      break;
    case 2:
      tree.insert(at, 1, symbol);
      break;
    case 3:
      std::swap(tree[at], tree[below(tree.size())]);
      break;
    default: // a split box becomes a leaf
      if (const auto split = tree.find('s', at); split != std::string::npos) {
        std::size_t end = split + 1;
        while (end < tree.size() && tree[end] != 's') ++end;
        tree.replace(split, end - split, 1, symbol);
      }
    }
    if (below(2) == 0) recount(root);
    return root.dump();
  }

  std::string change_field(const std::string& text)
  {
    json root = json::parse(text);
    std::vector<json*> values;
    collect_values(root, values);
    for (std::size_t changes = 1 + below(2); changes > 0; --changes) {
      change_value(*values[below(values.size())]);
      values.clear();
      collect_values(root, values);
    }
    if (below(8) == 0 && root.is_object()) recount(root);
    const std::string changed = root.dump();
    if (below(20) != 0) return changed;
    switch (below(4)) { // what a JSON library does not write
    case 0:
      return replace_first(changed, ":1", ":NaN");
    case 1:
      return replace_first(changed, "\"hit\":", "\"hit\":0,\"hit\":");
    case 2:
      return replace_first(changed, "[", std::string(100000, '['));
    default:
      return replace_first(changed, ":1", ":1e99999");
    }
  }

  /// A consistent file with a false claim, such as a careless or a malicious program would write.
  std::string lie(const std::string& text)
  {
    json root = json::parse(text);
    const auto dimension = root["dimension"].get<std::size_t>();
    auto& tree = root["tree"].get_ref<std::string&>();
    if (below(3) == 0) {
      const json entry = {{"polynomial", false_part(root["polynomials"][0], dimension)}, {"power", 1 + below(3)}};
      root["square_free"] = json(std::vector<json>(root["polynomials"].size(), entry));
      if (const auto leaf = tree.find('e', below(tree.size())); below(2) == 0 && leaf != std::string::npos)
        tree[leaf] = 'h';
      else {
        tree = "e";
        root["witnesses"] = json::array();
        root["reasons"] = json::array();
      }
    } else if (!root["critical"].empty() && below(2) == 0) {
      tree[below(tree.size())] = 'c';
      auto& critical = root["critical"];
      critical.insert(critical.begin() + static_cast<std::ptrdiff_t>(below(critical.size() + 1)),
                      json(critical[below(critical.size())]));
    } else if (const auto leaf = tree.find('e', below(tree.size())); leaf != std::string::npos) {
      const auto place = std::count(tree.begin(), tree.begin() + static_cast<std::ptrdiff_t>(leaf), 'w');
      auto& witnesses = root["witnesses"];
      witnesses.insert(witnesses.begin() + place, witnesses.empty() || below(2) == 0
                                                      ? random_points(dimension)
                                                      : json(witnesses[below(witnesses.size())]));
      tree[leaf] = 'w';
    }
    recount(root);
    return root.dump();
  }

private:
  /// A polynomial with fewer zeros than f or with more: 1, x - 1/2 or (x - 1/2) f.
  json false_part(const json& f, std::size_t dimension)
  {
    const std::vector<unsigned> constant(dimension);
    std::map<std::vector<unsigned>, Rational> sum{{constant, 1}};
    const std::size_t kind = below(3);
    if (kind == 2) {
      sum.clear();
      for (const json& term : f) sum[{term.begin() + 1, term.end()}] = Rational(term[0].get<std::string>());
    }
    if (kind >= 1) {
      const std::size_t axis = below(dimension);
      std::map<std::vector<unsigned>, Rational> product;
      for (const auto& [exponents, coefficient] : sum) {
        product[exponents] -= coefficient / 2;
        auto raised = exponents;
        ++raised[axis];
        product[raised] += coefficient;
      }
      sum = std::move(product);
    }
    json terms = json::array();
    for (const auto& [exponents, coefficient] : sum) {
      if (coefficient == 0) continue;
      json term = json::array({coefficient.get_str()});
      for (const unsigned exponent : exponents) term.push_back(exponent);
      terms.push_back(std::move(term));
    }
    return terms;
  }

  json random_points(std::size_t dimension)
  {
    json points = json::array();
    for (std::size_t count = 1 + below(2); count > 0; --count) {
      json point = json::array();
      for (std::size_t axis = 0; axis < dimension; ++axis) {
        Rational u(static_cast<long>(below(9)) - 3, 1 + below(3));
        u.canonicalize();
        point.push_back(u.get_str());
      }
      points.push_back(std::move(point));
    }
    return {{"points", std::move(points)}};
  }

  static std::string replace_first(std::string text, const std::string& from, const std::string& to)
  {
    const auto at = text.find(from);
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
  }

  /// Makes the counts those of the characters, so that changes get past the checks of sums.
  static void recount(json& root)
  {
    json claimed = root;
    for (int empty = 0; empty <= 64; ++empty)
      for (int hit = 0; hit <= 16 && hit + empty <= 64; ++hit)
        for (int unknown = 0; unknown <= 3; ++unknown) {
          if (root.value("resolution", json()).is_array() && empty + hit + unknown != cells(root)) continue;
          claimed["empty"] = empty;
          claimed["hit"] = hit;
          claimed["unknown"] = unknown;
          if (read_claims(claimed.dump())) {
            root = std::move(claimed);
            return;
          }
        }
  }

  static int cells(const json& root)
  {
    int product = 1;
    for (const json& n : root["resolution"]) product *= n.is_number_unsigned() && n < 100U ? n.get<int>() : 0;
    return product;
  }

  static void collect_values(json& value, std::vector<json*>& values)
  {
    values.push_back(&value);
    for (json& child : value)
      if (value.is_structured()) collect_values(child, values);
  }

  void change_value(json& value)
  {
    if (value.is_number_unsigned() && below(4) != 0)
      value = value.get<std::uint64_t>() + (below(2) == 0 ? 1 : std::uint64_t(-1));
    else if (value.is_string() && below(4) != 0)
      change_string(value.get_ref<std::string&>());
    else if (value.is_array() && !value.empty() && below(8) != 0)
      change_list(value);
    else if (value.is_object() && !value.empty() && below(8) != 0)
      value.erase(std::next(value.begin(), static_cast<std::ptrdiff_t>(below(value.size()))).key());
    else
      value = other_value();
  }

  void change_list(json& list)
  {
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(below(list.size()));
    switch (below(3)) {
    case 0:
      list.erase(at);
      break;
    case 1:
      list.insert(at, json(list[below(list.size())]));
      break;
    default:
      std::swap(*at, list[below(list.size())]);
    }
  }

  void change_string(std::string& text)
  {
    switch (text.empty() ? 2 : below(5)) {
    case 0:
      text[below(text.size())] = "0123456789-/ "[below(13)];
      break;
    case 1:
      text.erase(below(text.size()), 1);
      break;
    case 2:
      text.insert(below(text.size() + 1), 1, "0123456789-/"[below(12)]);
      break;
    case 3:
      if (text.front() == '-')
        text.erase(0, 1);
      else
        text.insert(0, 1, '-');
      break;
    default:
      text = Rational(static_cast<long>(below(9)) - 4, 1 + below(4)).get_str(); // not always in lowest terms
    }
  }

  json other_value()
  {
    const json values[] = {nullptr, true, -1, 0, 1, 2, 1e300, "0", "1", "-1/2", "x", json::array(), json::object()};
    return values[below(std::size(values))];
  }

  std::mt19937 random_;
};

struct Outcome
{
  std::size_t tried = 0;
  std::size_t rejected = 0;
  std::size_t same = 0;  ///< accepted, the content is the same
  std::size_t valid = 0; ///< accepted, the content is another but its claims are true
  std::string false_acceptance;
};

/// Judges one changed text. Anything but `Rejected` that the checker throws fails the test.
void judge(const std::string& text, const std::string& original, const Claims& known, Outcome& outcome)
{
  ++outcome.tried;
  try {
    (void)corral_check::check(text);
  } catch (const corral_check::Refusal& error) {
    EXPECT_GT(std::string_view(error.what()).size(), 5U);
    ++outcome.rejected;
    return;
  }
  const json content = json::parse(text, nullptr, false);
  if (!content.is_discarded() && content == json::parse(original)) {
    ++outcome.same;
    return;
  }
  const auto claims = read_claims(text);
  if (claims && are_true(*claims, known))
    ++outcome.valid;
  else
    outcome.false_acceptance = text;
}

std::vector<std::string> originals()
{
  constexpr std::size_t longest = 30000; // bytes: what is longer takes long to check a thousand times
  std::vector<std::string> result;
  for (const std::string& name : hand_written) result.push_back(hand_written_text(name));
  for (const Case& c : cases)
    if (c.cells <= 5 && c.dimension * c.cells <= 12) {
      std::string text = make_text(c);
      if (text.size() <= longest) result.push_back(std::move(text));
    }
  return result;
}

std::size_t rounds()
{
  const char* multiplier = std::getenv("CORRAL_TEST_MULTIPLIER");
  return static_cast<std::size_t>(600 * (multiplier != nullptr ? std::atof(multiplier) : 1));
}

TEST(Mutations, are_rejected_when_they_alter_a_claim)
{
  Mutator mutator(20051);
  Outcome outcome;
  for (const std::string& original : originals()) {
    const auto known = read_claims(original);
    ASSERT_TRUE(known) << original;
    ASSERT_NO_THROW((void)corral_check::check(original)) << original;
    for (std::size_t round = 0; round < rounds(); ++round) {
      judge(mutator.mutate(original), original, *known, outcome);
      ASSERT_EQ(outcome.false_acceptance, "") << "accepted a false claim";
    }
  }
  std::cout << outcome.tried << " changed files: " << outcome.rejected << " rejected, " << outcome.same
            << " accepted with the same content, " << outcome.valid << " accepted with other true claims\n";
  EXPECT_TRUE(outcome.tried >= 10000 || std::getenv("CORRAL_TEST_MULTIPLIER") != nullptr);
  EXPECT_GE(outcome.rejected, outcome.tried / 2);
}

TEST(Mutations, of_gzip_bytes_are_rejected)
{
  Mutator mutator(20052);
  Outcome outcome;
  for (const std::string& original : originals()) {
    const std::string packed = gzip(original);
    for (std::size_t round = 0; round < rounds() / 10; ++round) {
      const std::string changed = mutator.change_bytes(packed);
      try {
        (void)corral_check::check(changed);
        ++outcome.same; // only the header holds bytes that no sum protects
      } catch (const corral_check::Refusal&) {
        ++outcome.rejected;
      }
    }
  }
  EXPECT_LE(outcome.same * 4, outcome.rejected);
}

/// A file that calls the one cell [0, 1]^2 empty, by critical multipliers.
std::string forged(const char* polynomial, const char* multipliers, const char* critical)
{
  json root = json::parse(R"({"format": "corral-certificate", "version": 2, "dimension": 2, "variables": ["x", "y"],
    "square_free": null, "box": [["0", "1"], ["0", "1"]], "resolution": [1, 1], "method": "bernstein", "tree": "c",
    "witnesses": [], "reasons": [], "empty": 1, "hit": 0, "unknown": 0})");
  root["polynomials"] = json::array({json::parse(polynomial)});
  root["multipliers"] = json::parse(multipliers);
  root["critical"] = json::parse(critical);
  return root.dump();
}

struct Forgery
{
  const char* condition; ///< the only one that is broken
  std::string text;
};

/// Each is false, and all conditions of section 6 but one hold.
std::vector<Forgery> forgeries()
{
  // (x - 1/2)^2 + (y - 1/2)^2 - 1/16, whose multipliers 4 and -2 (y - 1/2) give (2x - 1/2)(2x - 3/2).
  const char* circle = R"([["7/16", 0, 0], ["-1", 0, 1], ["1", 0, 2], ["-1", 1, 0], ["1", 2, 0]])";
  const char* line = R"([["-1/2", 0, 0], ["1", 0, 1]])";                   // y - 1/2
  const char* slanted = R"([["-1/2", 0, 0], ["1", 0, 1], ["1/8", 1, 0]])"; // y + x/8 - 1/2
  const char* slope_of_line = R"([{"of": 0, "a": null, "b": [null, [["1", 0, 0]]], "factors": []}])";
  return {
      {"the factors divide", forged(circle, R"([{"of": 0, "a": [["4", 0, 0]], "b": [null, [["1", 0, 0], ["-2", 0, 1]]],
                           "factors": [[[["1", 0, 0], ["1", 1, 0]], 2]]}])",
                                    R"([[0, 0, "seeseeseee"]])")},
      {"no factor is missing", forged(circle, R"([{"of": 0, "a": [["4", 0, 0]],
                           "b": [null, [["1", 0, 0], ["-2", 0, 1]]], "factors": []}])",
                                      R"([[0, 0, "seeseesee"]])")},
      {"the combination is not zero", forged(circle, R"([{"of": 0, "a": [["-1", 0, 0], ["2", 0, 1]],
                           "b": [null, [["-7/16", 0, 0], ["1", 0, 1], ["-1", 0, 2], ["1", 1, 0], ["-1", 2, 0]]],
                           "factors": []}])",
                                             R"([[0, 0, "seeseesee"]])")},
      {"the factors have no zero", forged(circle, R"([{"of": 0, "a": [["4", 0, 0]],
                           "b": [null, [["1", 0, 0], ["-2", 0, 1]]],
                           "factors": [[[["-1", 0, 0], ["4", 1, 0]], 1], [[["-3", 0, 0], ["4", 1, 0]], 1]]}])",
                                          R"([[0, 0, "seeseesee"]])")},
      {"the multipliers are of this polynomial",
       forged(slanted, R"([{"of": 0, "a": null, "b": [null, [["1", 0, 0], ["1", 1, 0]]],
                         "factors": [[[["1", 0, 0], ["1", 1, 0]], 1]]},
                        {"of": 1, "a": [["1", 0, 0]], "b": [null, null], "factors": [[[["1", 0, 0], ["1", 1, 0]], 1]]}])",
              R"([[0, 0, "ceee"], [1, 1, "ee"]])")},
      {"the axis is none of a derivative", forged(line, slope_of_line, R"([[0, 1, "ee"]])")},
      {"the facet where the axis begins", forged(slanted, slope_of_line, R"([[0, 0, "ee"]])")},
      {"the lower facets along derivatives", // y + 4 (x - 1/2)^2 - 1/4
       forged(R"([["3/4", 0, 0], ["1", 0, 1], ["-4", 1, 0], ["4", 2, 0]])", slope_of_line, R"([[0, 0, "esee"]])")},
      {"the upper facets along derivatives", // 3/4 - y + 4 (x - 1/2)^2
       forged(R"([["7/4", 0, 0], ["-1", 0, 1], ["-4", 1, 0], ["4", 2, 0]])", slope_of_line, R"([[0, 0, "esee"]])")},
      {"the trees of faces prove", forged(slanted, slope_of_line, R"([[0, 0, "eee"]])")},
  };
}

TEST(Forgeries, of_critical_multipliers_are_rejected)
{
  for (const auto& forgery : forgeries()) {
    const auto claims = read_claims(forgery.text);
    ASSERT_TRUE(claims) << forgery.condition;
    ASSERT_FALSE(are_true(*claims, Claims{})) << forgery.condition;
    EXPECT_THROW((void)corral_check::check(forgery.text), corral_check::Rejected)
        << "accepted a false claim: " << forgery.condition;
  }
}

#ifdef CORRAL_PYTHON_CHECKER
/// The lines that the second checker prints for some files.
std::vector<std::string> second_opinions(const std::string& paths)
{
  const std::string command = "'" CORRAL_PYTHON "' '" CORRAL_PYTHON_CHECKER "' " + paths;
  std::FILE* pipe = popen(command.c_str(), "r");
  std::vector<std::string> lines(1);
  for (int c = 0; pipe != nullptr && (c = std::fgetc(pipe)) != EOF;) {
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += static_cast<char>(c);
  }
  if (pipe != nullptr) pclose(pipe);
  lines.pop_back();
  return lines;
}

/// Numbers the accepted counts, or the word `rejected`.
std::string first_opinion(const std::string& text)
{
  try {
    const auto counts = corral_check::check(text).counts;
    return "accepted: " + std::to_string(counts.empty + counts.hit + counts.unknown) + " cells, "
           + std::to_string(counts.empty) + " empty, " + std::to_string(counts.hit) + " hit, "
           + std::to_string(counts.unknown) + " unknown";
  } catch (const corral_check::Refusal&) {
    return "rejected";
  }
}

TEST(Mutations, are_judged_alike_by_both_checkers)
{
  const auto folder =
      std::filesystem::temp_directory_path() / ("corral-mutations-" + std::to_string(std::random_device{}()));
  std::filesystem::create_directory(folder);
  Mutator mutator(20053);
  std::vector<std::string> texts;
  std::vector<std::string> second;
  std::vector<std::string> sources = originals();
  for (const auto& forgery : forgeries()) sources.push_back(forgery.text);
  for (const std::string& original : sources) {
    std::string paths; // one call for each original: a command line cannot be of any length
    for (std::size_t round = 0; round < 1 + rounds() / 20; ++round) {
      texts.push_back(round == 0 ? original : round == 1 ? gzip(original) : mutator.mutate(original));
      const auto path = folder / std::to_string(round);
      std::ofstream(path, std::ios::binary) << texts.back();
      paths.append("'").append(path.string()).append("' ");
    }
    const auto lines = second_opinions(paths);
    second.insert(second.end(), lines.begin(), lines.end());
  }
  std::filesystem::remove_all(folder);
  ASSERT_EQ(second.size(), texts.size());
  std::size_t accepted = 0;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::string first = first_opinion(texts[i]);
    accepted += first != "rejected" ? 1 : 0;
    EXPECT_EQ(first, second[i].starts_with("rejected") ? "rejected" : second[i]) << second[i] << '\n' << texts[i];
  }
  EXPECT_GT(accepted, 0U);
  EXPECT_LT(accepted, texts.size());
}
#endif

} // namespace
