// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Pixel_picture.h"

#include <corral/errors.h>

#include <cstdint>
#include <memory>
#include <png.h>
#include <string_view>
#include <vector>

namespace corral::program {

namespace {

// Whether a pixel, laid over white, is darker than middle grey; inverted, over black, and not darker.
bool is_plotted(const png_byte* rgba, bool invert)
{
  const std::uint32_t grey = 2126U * rgba[0] + 7152U * rgba[1] + 722U * rgba[2]; // 0 to 10000 * 255
  const std::uint32_t background = invert ? 0 : 10000U * 255U;
  const std::uint32_t shade = grey * rgba[3] + background * (255U - rgba[3]); // 0 to 10000 * 255^2 < 2^30
  const bool is_dark = 2 * shade < 10000U * 255U * 255U;
  return is_dark != invert;
}

} // namespace

bool is_png(const Input_file& file) { return file.head().starts_with("\x89PNG"); }

void read_png(Input_file& file, const Resolution<2>& resolution, const Raster_options& options,
              const std::function<void(const Cell<2>&)>& visit)
{
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> freed(&image, &png_image_free);
  if (png_image_begin_read_from_stdio(&image, file.rewound()) == 0)
    file.fail(std::string("not a PNG picture that can be read: ") + image.message);
  const auto size = [](std::uint32_t width, std::uint32_t height) {
    return std::to_string(width) + " x " + std::to_string(height);
  };
  if (image.width != resolution[0] || image.height != resolution[1])
    file.fail("the picture has " + size(image.width, image.height) + " pixels; expected "
              + size(resolution[0], resolution[1]) + ", one for each cell (a drawing with axes is not a raster)");
  if (std::uint64_t{image.width} * image.height > options.max_pixels)
    throw Budget_exceeded("raster: the picture has more than " + std::to_string(options.max_pixels)
                          + " pixels; expected a table for so large a grid");
  image.format = PNG_FORMAT_RGBA;
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0)
    file.fail(std::string("the picture is damaged: ") + image.message);
  const png_byte* pixel = pixels.data();
  for (std::uint32_t row = resolution[1]; row-- > 0;)
    for (std::uint32_t column = 0; column < resolution[0]; ++column, pixel += 4)
      if (is_plotted(pixel, options.invert)) visit({column, row});
}

} // namespace corral::program
