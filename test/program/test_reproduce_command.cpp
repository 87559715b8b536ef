// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace {

using namespace corral::test;
using Words = std::vector<std::string>;

TEST(Reproduce_command, makes_a_gallery_whose_page_shows_every_picture)
{
  const Temporary_folder folder;
  const auto gallery = folder.path() / "new" / "gallery";
  const Program_run run = run_program({"reproduce", "figures", "--output", gallery.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 28); // Figures 3 to 24, and six space curves
  const std::string page = content(gallery / "index.html");
  for (int figure = 3; figure <= 24; ++figure)
    EXPECT_NE(page.find("Figure " + std::to_string(figure) + ". Example"), std::string::npos);
  const std::regex link("(?:src|href)=\"([^\"]*)\"");
  int links = 0;
  for (std::sregex_iterator at(page.begin(), page.end(), link), end; at != end; ++at, ++links)
    EXPECT_TRUE(std::filesystem::exists(gallery / (*at)[1].str())) << (*at)[1];
  EXPECT_EQ(links, 3 * 28);
  EXPECT_NE(page.find("0.945<i>x</i><i>y</i> &minus; 9.43214<i>x</i><sup>2</sup><i>y</i><sup>3</sup>"),
            std::string::npos);
}

TEST(Reproduce_command, says_what_it_cannot_do)
{
  const Program_run folder = run_program({"reproduce", "figures", "--output", "/proc/gallery"});
  EXPECT_EQ(folder.exit_code, 1);
  EXPECT_EQ(folder.err.rfind("corral: reproduce: cannot make folder '/proc/gallery'", 0), 0U) << folder.err;
  const Program_run what = run_program({"reproduce", "table5"});
  EXPECT_EQ(what.exit_code, 2);
  EXPECT_NE(what.err.find("table5 not in"), std::string::npos) << what.err;
}

} // namespace
