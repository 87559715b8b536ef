// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_program.h"

#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/parse.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

namespace {

using namespace corral;
using namespace corral::test;
using nlohmann::json;
using Words = std::vector<std::string>;

const Words small{"--cases",       "25", "--paper-cases", "10",  "--tightness-cases", "15",
                  "--fault-cases", "0",  "--format",      "json"};

Program_run audit(Words more, const Program_limits& limits = {})
{
  more.insert(more.begin(), {"audit", "bounders"});
  return run_program(more, limits);
}

json audited(const Words& more)
{
  Words words = small;
  words.insert(words.end(), more.begin(), more.end());
  const Program_run run = audit(words);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return json::parse(run.out);
}

TEST(Audit_bounders, tells_guaranteed_types_from_the_other)
{
  const json report = audited({});
  EXPECT_EQ(report["is_sound"], true);
  EXPECT_EQ(report["numbers"].size(), 6U);
  for (const auto& number : report["numbers"]) {
    const bool is_nearest = number["number"] == "double_nearest";
    EXPECT_EQ(number["guaranteed"], !is_nearest);
    EXPECT_EQ(number["verdict"], is_nearest ? "not guaranteed: fails" : "passes") << number;
    EXPECT_EQ(number["escapes"].get<int>() > 0, is_nearest) << number;
  }
  // Every number type, bounder, order and dimension, each once and with work done.
  std::set<std::string> methods;
  for (const auto& entry : report["audits"]) {
    methods.insert(entry["number"].dump() + entry["bounder"].dump() + entry.value("order", json()).dump()
                   + entry["dimension"].dump());
    EXPECT_EQ(entry["cases"], entry["dimension"] == 1 ? 25 : 35);
    EXPECT_EQ(entry["escapes"].get<int>() > 0, entry.contains("first_escape"));
    EXPECT_GE(entry["tightness"]["median"], 1.0) << entry["bounder"];
  }
  EXPECT_EQ(methods.size(), report["audits"].size());
  EXPECT_EQ(methods.size(), 6U * (8 + 4) * 3);
}

std::vector<Rational> numbers(const std::string& text)
{
  std::vector<Rational> result;
  std::istringstream in(text);
  for (std::string number; std::getline(in, number, ',');) result.push_back(parse_rational(number));
  return result;
}

// The exit code of a command as a shell runs it, and what it prints.
Program_run in_shell(const std::string& command)
{
  const Temporary_folder folder;
  const std::string folder_of_program = std::filesystem::path(CORRAL_PROGRAM).parent_path();
  std::ofstream(folder.path() / "command") << "PATH=" << folder_of_program << ":$PATH\n" << command << '\n';
  const std::string out = folder.path() / "out";
  const int status = std::system(("sh " + (folder.path() / "command").string() + " > " + out + " 2>&1").c_str());
  return {WEXITSTATUS(status), content(out), ""};
}

template <std::size_t D>
void expect_escape(const json& escape, const std::array<std::string, D>& variables)
{
  const auto f = parse_polynomial<D>(escape["polynomial"].get<std::string>(), variables);
  const auto coordinates = numbers(escape["point"]);
  ASSERT_EQ(coordinates.size(), D);
  std::array<Rational, D> point;
  std::copy_n(coordinates.begin(), D, point.begin());
  const Rational value = evaluate(f, point);
  EXPECT_EQ(to_string(value), escape["value"]);
  const std::string lower = escape["bound"][0];
  const std::string upper = escape["bound"][1];
  const bool is_no_number = lower == "-inf" && upper == "inf"; // then no value is in the bound
  EXPECT_TRUE(is_no_number || (lower != "-inf" && value < parse_rational(lower))
              || (upper != "inf" && value > parse_rational(upper)))
      << escape;
}

TEST(Audit_bounders, prints_escapes_that_a_shell_shows_again)
{
  const json report = audited({"--number", "double_nearest"});
  std::size_t shown = 0;
  for (const auto& entry : report["audits"]) {
    if (!entry.contains("first_escape")) continue;
    const json& escape = entry["first_escape"];
    if (entry["dimension"] == 1) expect_escape<1>(escape, {"x"});
    if (entry["dimension"] == 2) expect_escape<2>(escape, {"x", "y"});
    if (entry["dimension"] == 3) expect_escape<3>(escape, {"x", "y", "z"});
    std::string command = escape["command"];
    const Program_run run = in_shell(command);
    EXPECT_EQ(run.exit_code, 1) << command << run.out;
    EXPECT_NE(run.out.find("ESCAPE"), std::string::npos) << command << run.out;
    EXPECT_NE(run.out.find("value:   " + escape["value"].get<std::string>()), std::string::npos) << run.out;
    // A guaranteed number type shows that the command can also say the contrary.
    command.replace(command.find("double_nearest"), std::string("double_nearest").size(), "rational");
    const Program_run exact = in_shell(command);
    EXPECT_EQ(exact.exit_code, 0) << command << exact.out;
    EXPECT_NE(exact.out.find("the bound contains the value"), std::string::npos) << exact.out;
    ++shown;
  }
  EXPECT_GE(shown, 30U);
}

TEST(Audit_bounders, audits_what_it_is_told)
{
  const json report = audited({"--bounder", "maa,rt,maa", "--number", "double_outward,mpfr", "--order", "2,5",
                               "--dimension", "2", "--precision", "60"});
  std::vector<std::string> names;
  for (const auto& entry : report["audits"]) {
    names.push_back(entry["number"].get<std::string>() + ' ' + entry["bounder"].get<std::string>()
                    + entry.value("order", json("")).dump());
    EXPECT_EQ(entry["dimension"], 2);
  }
  EXPECT_EQ(names, (Words{"double_outward maa\"\"", "double_outward rt2", "double_outward rt5", "mpfr maa\"\"",
                          "mpfr rt2", "mpfr rt5"}));
}

TEST(Audit_bounders, follows_the_seed)
{
  const Words words{"--bounder", "rt", "--number", "double_nearest,rational", "--seed"};
  const auto with = [&](const char* seed) {
    Words all = words;
    all.emplace_back(seed);
    return audited(all);
  };
  EXPECT_EQ(with("5"), with("5"));
  EXPECT_NE(with("5")["audits"], with("6")["audits"]);
}

TEST(Audit_bounders, writes_reports_whole)
{
  const Temporary_folder folder;
  Program_limits limits;
  limits.folder = folder.path();
  const Program_run run = audit({"--cases", "30", "--paper-cases", "0", "--tightness-cases", "30", "--number",
                                 "double_nearest,rational", "--output", "a.html", "--output", "a.json"},
                                limits);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("not guaranteed: fails"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("  corral bound '"), std::string::npos) << run.out;
  EXPECT_EQ(folder.files(), (Words{"a.html", "a.json"}));
  EXPECT_EQ(json::parse(content(folder.path() / "a.json"))["audits"].size(), 2U * 12 * 3);
  const std::string page = content(folder.path() / "a.html");
  for (const char* const outside : {"http", "src=", "url(", "<script", "nan", "inf"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  std::size_t plots = 0;
  for (auto at = page.find("<svg viewBox"); at != std::string::npos; at = page.find("<svg viewBox", at + 1)) ++plots;
  EXPECT_EQ(plots, 6U); // two in each dimension
}

TEST(Audit_bounders, finds_the_planted_faults)
{
  const Words words{"--number", "rational", "--bounder", "maa", "--dimension", "1", "--cases", "1", "--format", "json"};
  Words few = words;
  few.insert(few.end(), {"--fault-cases", "1"});
  const Program_run short_run = audit(few); // one case is not enough for all
  EXPECT_EQ(short_run.exit_code, 1);
  EXPECT_EQ(json::parse(short_run.out)["is_sound"], false);
  const Program_run run = audit(words);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const json report = json::parse(run.out);
  EXPECT_GE(report["faults"].size(), 25U);
  for (const auto& fault : report["faults"]) {
    EXPECT_EQ(fault["caught"], true) << fault;
    EXPECT_NE(fault["caught_by"], "") << fault;
    EXPECT_GT(fault["cases"], 0) << fault;
  }
}

TEST(Audit_bounders, refuses_in_one_line)
{
  const auto refuse = [](const Words& words, const std::string& hint) {
    const Temporary_folder folder;
    Program_limits limits;
    limits.folder = folder.path();
    const Program_run run = audit(words, limits);
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(hint), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(folder.files(), Words{});
  };
  refuse({"--bounder", "best"}, "expected one of rt, maa");
  refuse({"--number", "float"}, "expected one of double_nearest");
  refuse({"--dimension", "4"}, "--dimension");
  refuse({"--order", "0"}, "--order");
  refuse({"--cases", "0"}, "--cases");
  refuse({"--cases", "-3"}, "--cases");
  refuse({"--seed", "one"}, "--seed");
  refuse({"--precision", "3"}, "53");
  refuse({"--output", "a.pdf"}, ".json .html");
  refuse({"--format", "xml"}, "text,json");
}

TEST(Audit_bounders, leaves_nothing_when_interrupted)
{
  const Temporary_folder folder;
  Program_limits limits;
  limits.folder = folder.path();
  limits.interrupt_after = std::chrono::milliseconds(500);
  const Program_run run = audit({"--cases", "1000000", "--output", "a.html"}, limits);
  EXPECT_EQ(run.exit_code, 130) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(folder.files(), Words{});
}

TEST(Bound_at, says_whether_the_value_is_contained)
{
  const auto at = [](const std::string& box, const std::string& point) {
    return run_program({"bound", "x^2 - y", "--box", box, "--number", "rational", "--at", point});
  };
  const Program_run good = at("-1:1,0:1", "-1/2,1/3");
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_NE(good.out.find("value:   -1/12\nthe bound contains the value\n"), std::string::npos) << good.out;
  const auto refuse = [&](const std::string& point, const std::string& hint) {
    const Program_run run = at("-1:1,0:1", point);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(hint), std::string::npos) << run.err;
  };
  refuse("1", "given 1 coordinate; expected 2");
  refuse("0,0,0", "given 3 coordinates; expected 2");
  refuse("0,2", "coordinate 2 is 2; expected a point of the box");
  refuse("0,y", "y");
}

} // namespace
