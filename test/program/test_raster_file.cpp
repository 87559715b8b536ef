// SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/audit/Raster_file.h"
#include "rounds.h"

#include <corral/errors.h>

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

namespace {

using namespace corral;
using namespace corral::program;

/// A file in memory, which has a path while this lives.
class Memory_file
{
public:
  explicit Memory_file(const std::string& bytes) : descriptor_(::memfd_create("cells", 0))
  {
    if (::write(descriptor_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      throw std::runtime_error("cannot write to memory");
  }
  ~Memory_file() { ::close(descriptor_); }
  Memory_file(const Memory_file&) = delete;
  Memory_file& operator=(const Memory_file&) = delete;

  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

private:
  int descriptor_;
};

template <std::size_t D>
Foreign_raster<D> read(const std::string& bytes, const Resolution<D>& resolution, const Raster_options& options = {})
{
  return read_raster<D>(Memory_file(bytes).path(), resolution, options);
}

// `i,j:claim` for each cell.
template <std::size_t D>
std::string text(const Foreign_raster<D>& raster)
{
  std::string result;
  for (const auto& [cell, claim] : raster.cells) {
    if (!result.empty()) result += ' ';
    for (std::size_t axis = 0; axis < D; ++axis) result.append(axis == 0 ? "" : ",").append(std::to_string(cell[axis]));
    if (claim != Claim::plotted) result.append(":").append(name_of(claim));
  }
  return result;
}

std::string complaint(const std::string& bytes, const Resolution<2>& resolution = {10, 20},
                      const Raster_options& options = {})
{
  try {
    return "accepted: " + text(read<2>(bytes, resolution, options));
  } catch (const Invalid_input& error) {
    return error.what();
  } catch (const Budget_exceeded& error) {
    return error.what();
  }
}

TEST(Raster_file, reads_tables_of_many_hands)
{
  const std::string cells = "1,2 3,14";
  for (const std::string table : {"1,2\n3,14\n",
                                  "1,2\n3,14",
                                  "3,14\n1,2\n",
                                  "1,2\r\n3,14\r\n",
                                  "1,2\r3,14",
                                  "1;2\n3;14\n",
                                  "1\t2\n3\t14\n",
                                  " 1 2\n  3   14 \n",
                                  "1 , 2\n3 ,\t14\n\n",
                                  "\n\n1,2\n \n3,14\n",
                                  "# made by hand\n1,2\n#\n3,14\n",
                                  "i,j\n1,2\n3,14\n",
                                  "x,y\n1,2\n3,14\n",
                                  "X;Y\r\n1;2\r\n3;14\r\n",
                                  "j,i\n2,1\n14,3\n",
                                  "y x\n2 1\n14 3\n",
                                  "\"i\",\"j\"\n\"1\",\"2\"\n'3','14'\n",
                                  "\xef\xbb\xbfi,j\n1,2\n3,14\n",
                                  "+1,2.0\n3.000000000000000000e+00,14\n",
                                  "verdict,j,i\nplotted,2,1\ntrue,14,3\nempty,1,1\n",
                                  "i,j,plotted\n1,2,1\n3,14,1\n4,4,0\n"})
    EXPECT_EQ(text(read<2>(table, {10, 20})), cells) << table;
}

TEST(Raster_file, knows_the_names_of_axes)
{
  Raster_options options;
  options.variables = {"y", "x"};
  EXPECT_EQ(text(read<2>("x,y\n1,2\n", {10, 20}, options)), "2,1");
  EXPECT_EQ(text(read<2>("i,j\n1,2\n", {10, 20}, options)), "1,2");
  EXPECT_EQ(text(read<3>("z,y,x\n1,2,3\n", {9, 9, 9})), "3,2,1");
  EXPECT_EQ(text(read<1>("7\n3\n", {9})), "3 7");
}

TEST(Raster_file, keeps_the_strongest_claim_of_a_cell)
{
  const auto raster =
      read<2>("i,j,verdict\n1,2,unknown\n1,2,hit\n1,2,plotted\n0,0,hit\n5,5,empty\n4,4,unknown", {10, 20});
  EXPECT_EQ(text(raster), "0,0:hit 1,2:hit 4,4:unknown");
  EXPECT_EQ(raster.repeated, 2U);
  EXPECT_EQ(text(read<2>("1,2,HIT\n", {10, 20})), "1,2:hit");
}

TEST(Raster_file, may_have_no_cells) { EXPECT_EQ(text(read<2>("i,j,verdict\n", {10, 20})), ""); }

TEST(Raster_file, refuses_with_the_line_and_what_was_expected)
{
  const auto expect = [](const std::string& table, const std::string& hint) {
    const std::string line = complaint(table);
    EXPECT_EQ(line.rfind("raster: '", 0), 0U) << line;
    EXPECT_NE(line.find(hint), std::string::npos) << line;
    EXPECT_LT(line.size(), 300U);
  };
  expect("", "empty");
  expect("\n# nothing\n\n", "empty");
  expect("1,2\n\n10,2\n", "line 3: given '10'; expected i, a whole number from 0 to 9");
  expect("1,20\n", "from 0 to 19");
  expect("1,-1\n", "given '-1'");
  expect("1,99999999999999999999999999\n", "given '9999");
  expect("1,1e999\n", "given '1e999'");
  expect("1,4294967297\n", "given '4294967297'");
  expect("1,0.5\n", "given '0.5'");
  expect("0x1,1\n", "column '0x1'");
  expect("1,nan\n", "given 'nan'");
  expect("inf,1\n", "given 'inf'");
  expect("1,\n", "given ''");
  expect("1,2\n1,2,hit\n", "line 2: 3 fields; expected 2 as before");
  expect("1,2,3,4\n", "4 fields; expected 2 indices and perhaps a verdict");
  expect("1,2,perhaps\n", "given 'perhaps'; expected hit, unknown, plotted or empty");
  expect("i,k\n1,2\n", "column 'k'");
  expect("i,i\n1,2\n", "lacks or repeats");
  expect("i,j,verdict,verdict\n1,2,hit,hit\n", "lacks or repeats");
  expect("row,column\n1,2\n", "column 'row'; expected the indices i, j and perhaps a verdict");
  expect("\xff\xfe"
         "1\0,\0",
         "column '");
  expect("1,2\n\xc3\xa9,2\n", "line 2: given '\xc3\xa9'");
  std::string wide = "1";
  for (int column = 1; column < 1'000'000; ++column) wide += ",1";
  expect(wide, "line 1: longer than 4096 bytes");
  expect(std::string(100, 'q') + ",1\n", "...'");
  Raster_options few;
  few.max_rows = 2;
  EXPECT_NE(complaint("1,1\n1,2\n1,3\n", {10, 20}, few).find("more than 2 rows"), std::string::npos);
}

TEST(Raster_file, refuses_what_is_no_file)
{
  EXPECT_THROW(static_cast<void>(read_raster<2>("/", {8, 8})), Invalid_input);
  EXPECT_THROW(static_cast<void>(read_raster<2>("/no/such/file", {8, 8})), Invalid_input);
  EXPECT_THROW(static_cast<void>(read_raster<2>("/dev/zero", {8, 8})), Invalid_input);
}

// The bytes of a picture of RGBA pixels, top row first.
std::string png(std::uint32_t width, std::uint32_t height, const std::vector<png_byte>& rgba)
{
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = 0;
  EXPECT_NE(png_image_write_to_memory(&image, nullptr, &size, 0, rgba.data(), 0, nullptr), 0);
  std::string bytes(size, '\0');
  EXPECT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, rgba.data(), 0, nullptr), 0);
  bytes.resize(size);
  return bytes;
}

// Black, dark grey, light grey; white, a clear black pixel, a half clear black one.
std::string small_picture()
{
  return png(3, 2, {0,   0,   0,   255, 127, 127, 127, 255, 128, 128, 128, 255, //
                    255, 255, 255, 255, 0,   0,   0,   0,   0,   0,   0,   128});
}

TEST(Raster_file, reads_pictures_from_the_top)
{
  EXPECT_EQ(text(read<2>(small_picture(), {3, 2})), "0,1 1,1 2,0");
  Raster_options inverted;
  inverted.invert = true;
  EXPECT_EQ(text(read<2>(small_picture(), {3, 2}, inverted)), "0,0 2,1");
  const std::string colours = png(3, 1, {0, 0, 255, 255, 0, 255, 0, 255, 255, 0, 0, 255}); // blue and red are dark
  EXPECT_EQ(text(read<2>(colours, {3, 1})), "0,0 2,0");
}

TEST(Raster_file, refuses_pictures_of_another_size_or_kind)
{
  EXPECT_NE(complaint(small_picture(), {2, 3}).find("3 x 2 pixels; expected 2 x 3"), std::string::npos);
  EXPECT_THROW(static_cast<void>(read<3>(small_picture(), {3, 2, 1})), Invalid_input);
  EXPECT_NE(complaint("\x89PNG").find("not a PNG picture"), std::string::npos);
  std::string huge = small_picture();
  for (const std::size_t at : {16U, 20U}) huge.replace(at, 4, std::string("\0\x10\0\0", 4)); // width and height 2^20
  EXPECT_EQ(complaint(huge, {1U << 20, 1U << 20}).rfind("raster: ", 0), 0U); // the check sum is wrong, too
  Raster_options few;
  few.max_pixels = 5;
  EXPECT_NE(complaint(small_picture(), {3, 2}, few).find("more than 5 pixels"), std::string::npos);
}

// Whatever the bytes, cells of the grid come out or one line of complaint.
void expect_sound(const std::string& bytes)
{
  try {
    for (const auto& [cell, claim] : read<2>(bytes, {3, 2}).cells) {
      EXPECT_LT(cell[0], 3U);
      EXPECT_LT(cell[1], 2U);
    }
  } catch (const Invalid_input& error) {
    EXPECT_LT(std::string(error.what()).size(), 400U);
  }
}

TEST(Raster_file, survives_damage)
{
  const std::string table = "i,j,verdict\n0,1,hit\r\n2;1;unknown\n1\t0\tempty\n\n# end\n2,0,hit\n";
  std::mt19937_64 random(7);
  for (const std::string& whole : {small_picture(), table}) {
    for (std::size_t length = 0; length < whole.size(); ++length) expect_sound(whole.substr(0, length));
    for (int round = 0; round < corral::test::rounds(2000); ++round) {
      std::string bytes = whole;
      for (std::uint64_t changes = 1 + random() % 4; changes-- > 0;) {
        const std::size_t at = random() % bytes.size();
        if (random() % 3 == 0)
          bytes.erase(at, 1 + random() % 3);
        else if (random() % 2 == 0)
          bytes.insert(at, 1 + random() % 3, static_cast<char>(random()));
        else
          bytes[at] = static_cast<char>(random());
        if (bytes.empty()) break;
      }
      expect_sound(bytes);
    }
  }
}

} // namespace
