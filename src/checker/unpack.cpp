// SPDX-License-Identifier: LGPL-3.0-or-later
#include "unpack.h"

#include "fault.h"

#include <zlib.h>

#include <algorithm>
#include <vector>

namespace corral_check {
namespace {

constexpr std::size_t max_text = std::size_t{1} << 28;

void require_short(std::size_t size) { limit(size <= max_text, {"file"}, "longer than 2^28 bytes"); }

std::string inflate_whole(const std::string& bytes)
{
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 16) != Z_OK) throw Stopped("file", "no memory to decompress it", {});
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data())); // zlib does not write there
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  std::vector<char> chunk(std::size_t{1} << 16);
  int status = Z_OK;
  while (status == Z_OK && text.size() <= max_text) {
    stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
    stream.avail_out = static_cast<uInt>(chunk.size());
    status = inflate(&stream, Z_NO_FLUSH);
    if (text.size() == text.capacity() || text.capacity() - text.size() < chunk.size())
      text.reserve(std::min(2 * text.capacity() + chunk.size(), max_text + chunk.size()));
    text.append(chunk.data(), chunk.size() - stream.avail_out);
  }
  const bool whole = status == Z_STREAM_END && stream.avail_in == 0;
  inflateEnd(&stream);
  require_short(text.size());
  require(whole, {"file"}, "the gzip data are damaged, cut off or followed by something else");
  return text;
}

} // namespace

std::string unpack(std::string bytes)
{
  require_short(bytes.size());
  if (bytes.starts_with("\x1f\x8b")) return inflate_whole(bytes);
  return bytes;
}

} // namespace corral_check
