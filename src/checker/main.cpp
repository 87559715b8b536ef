// SPDX-License-Identifier: LGPL-3.0-or-later
#include "check.h"

#include <exception>
#include <fstream>
#include <iostream>

namespace {

/// The bytes of a file, at most a little more than the limit of the specification, which `check` then refuses.
std::string read_file(const char* path)
{
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  std::vector<char> chunk(std::size_t{1} << 16);
  if (file.peek() == std::ifstream::traits_type::eof() && !file.eof()) file.setstate(std::ios::badbit);
  while (file.good() && bytes.size() <= std::size_t{1} << 28) {
    file.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    bytes.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad() || !file.is_open()) throw std::ios_base::failure("cannot be read");
  return bytes;
}

/// Keeps a message on one line, whatever the file contained.
std::string one_line(std::string message)
{
  for (char& c : message)
    if (static_cast<unsigned char>(c) < 0x20) c = '?';
  return message.substr(0, 400);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc == 2 && std::string_view(argv[1]) == "--help") {
    std::cout << "usage: corral-check FILE\nChecks a certificate (JSON or gzip), as doc/certificate.md specifies.\n"
                 "Exit codes: 0 accepted, 1 rejected, 2 not checked.\n";
    return 0;
  }
  if (argc != 2 || std::string_view(argv[1]).starts_with("--")) {
    std::cerr << "corral-check: given " << (argc == 2 ? one_line(argv[1]) : std::to_string(argc - 1) + " arguments")
              << "; expected one, the file of a certificate; see corral-check --help\n";
    return 2;
  }
  std::string bytes;
  try {
    bytes = read_file(argv[1]);
  } catch (const std::exception&) {
    std::cerr << "corral-check: " << one_line(argv[1]) << " cannot be read; expected a certificate\n";
    return 2;
  }
  try {
    const corral_check::Counts counts = corral_check::check(bytes);
    std::cout << "accepted: " << counts.empty + counts.hit + counts.unknown << " cells, " << counts.empty << " empty, "
              << counts.hit << " hit, " << counts.unknown << " unknown" << std::endl;
    if (std::cout) return 0;
    std::cerr << "corral-check: cannot write standard output\n";
    return 2;
  } catch (const corral_check::Rejected& error) {
    std::cout << "rejected: " << one_line(error.what()) << '\n';
  } catch (const std::exception& error) { // out of memory, for one
    std::cout << "rejected: the machine could not hold the proofs (" << one_line(error.what()) << ")\n";
  }
  return 1;
}
