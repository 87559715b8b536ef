// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/all.h>

#include "shapes.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <sys/resource.h>
#include <sys/stat.h>

namespace {

namespace fs = std::filesystem;
using namespace corral;

class Output_files : public testing::Test
{
protected:
  Output_files()
  {
    folder_ = fs::temp_directory_path() / ("corral-output-" + std::to_string(::getpid()));
    fs::create_directory(folder_);
  }
  ~Output_files() override { fs::remove_all(folder_); }

  [[nodiscard]] std::size_t files() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
  static std::string content(const fs::path& path)
  {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder_;
};

TEST_F(Output_files, appear_whole_and_replace_the_old)
{
  const fs::path path = folder_ / "a.txt";
  write_whole_file(path, [](std::ostream& out) { out << "old"; });
  {
    Output_file file(path);
    file.stream() << "new" << std::flush;
    EXPECT_EQ(content(path), "old");
    file.commit();
  }
  EXPECT_EQ(content(path), "new");
  EXPECT_EQ(files(), 1U);
}

TEST_F(Output_files, vanish_when_the_writer_throws)
{
  const fs::path path = folder_ / "a.txt";
  EXPECT_THROW(write_whole_file(path,
                                [](std::ostream& out) {
                                  out << "half" << std::flush;
                                  throw std::runtime_error("no more");
                                }),
               std::runtime_error);
  EXPECT_EQ(files(), 0U);
}

TEST_F(Output_files, of_one_run_are_all_written_or_none)
{
  const auto good = [](std::ostream& out) { out << "text"; };
  const auto bad = [](std::ostream& out) { out.setstate(std::ios::failbit); };
  write_whole_files({{folder_ / "a.txt", good}, {folder_ / "b.txt", good}, {folder_ / "a.txt", good}});
  EXPECT_EQ(content(folder_ / "a.txt"), "text");
  EXPECT_EQ(content(folder_ / "b.txt"), "text");
  EXPECT_EQ(files(), 2U);
  EXPECT_THROW(write_whole_files({{folder_ / "c.txt", good}, {folder_ / "d.txt", bad}}), Output_error);
  EXPECT_THROW(write_whole_files({{folder_ / "c.txt", good}, {folder_ / "no" / "d.txt", good}}), Output_error);
  EXPECT_THROW(write_whole_files({{folder_ / "c.txt", good},
                                  {folder_ / "d.txt", [](std::ostream&) { throw std::runtime_error("no more"); }}}),
               std::runtime_error);
  EXPECT_EQ(files(), 2U);
}

TEST_F(Output_files, that_are_unfinished_can_be_removed_by_a_handler)
{
  remove_unfinished_files(); // there are none
  {
    std::vector<std::unique_ptr<Output_file>> open;
    for (int k = 0; k < 100; ++k) {
      open.push_back(std::make_unique<Output_file>(folder_ / std::to_string(k)));
      open.back()->stream() << "half" << std::flush;
    }
    Output_file done(folder_ / "done.txt");
    done.fill([](std::ostream& out) { out << "text"; });
    done.commit();
    EXPECT_EQ(files(), 101U);
    remove_unfinished_files();
    EXPECT_EQ(files(), 1U);
    EXPECT_EQ(content(folder_ / "done.txt"), "text");
  }
  remove_unfinished_files(); // nothing is noted any more
  EXPECT_EQ(files(), 1U);
}

TEST_F(Output_files, follow_symbolic_links_and_keep_permissions_usual)
{
  fs::create_symlink(folder_ / "real.txt", folder_ / "link.txt");
  write_whole_file(folder_ / "link.txt", [](std::ostream& out) { out << "text"; });
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
  EXPECT_EQ(content(folder_ / "real.txt"), "text");
  const mode_t mask = ::umask(0);
  ::umask(mask);
  struct stat status = {};
  ASSERT_EQ(::stat((folder_ / "real.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0666U & ~mask);
}

TEST_F(Output_files, say_what_is_wrong_with_the_name)
{
  const auto none = test::raster(test::grid<2>(4), {});
  const auto error_of = [&](const fs::path& path) -> std::string {
    try {
      write_file(path, none);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of("curve.gif"),
            "output: 'curve.gif' has no known ending for 2 dimensions; expected one of .png .svg .csv .json .txt");
  EXPECT_EQ(error_of("curve"),
            "output: 'curve' has no known ending for 2 dimensions; expected one of .png .svg .csv .json .txt");
  EXPECT_EQ(error_of("/nowhere/curve.csv"), "output: cannot write '/nowhere/curve.csv': No such file or directory");
  fs::create_directory(folder_ / "folder.csv");
  EXPECT_EQ(error_of(folder_ / "folder.csv"),
            "output: cannot write '" + (folder_ / "folder.csv").string() + "': Is a directory");
}

TEST_F(Output_files, to_a_full_device_fail)
{
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  fs::create_symlink("/dev/full", folder_ / "full.csv");
  const auto grid = test::grid<2>(4);
  EXPECT_THROW(write_file(folder_ / "full.csv", test::raster(grid, {})), Output_error);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

// Every writer meets a disk that fills up, at the start and in the middle.
template <std::size_t D>
void check_full_disk(const fs::path& folder)
{
  const auto grid = test::grid<D>(32);
  const auto cells = test::select<D>(grid, [](const Cell<D>& cell) {
    return (cell[0] * 7 + cell[D - 1] * 5) % 3 == 0 ? Verdict::hit : Verdict::empty;
  });
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before = {};
  getrlimit(RLIMIT_FSIZE, &before);
  for (const auto& writer : writers<D>())
    for (const rlim_t limit : {1U, 100U, 1000U}) {
      const fs::path path = folder / ("full" + std::string(writer.ending));
      rlimit small = before;
      small.rlim_cur = limit;
      setrlimit(RLIMIT_FSIZE, &small);
      EXPECT_THROW(write_file(path, cells), Output_error) << writer.ending << " at " << limit;
      setrlimit(RLIMIT_FSIZE, &before);
      EXPECT_TRUE(fs::is_empty(folder)) << writer.ending << " left something";
      write_file(path, cells); // and the same works on a larger disk
      EXPECT_GT(fs::file_size(path), 1000U) << writer.ending;
      fs::remove(path);
    }
}

TEST_F(Output_files, on_a_full_disk_leave_nothing)
{
  check_full_disk<2>(folder_);
  check_full_disk<3>(folder_);
}

} // namespace
