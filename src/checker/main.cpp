// SPDX-License-Identifier: LGPL-3.0-or-later
#include "version.h"

#include <corral_check/check.h>

#include <fstream>
#include <iostream>
#include <optional>
#include <string_view>
#include <vector>

namespace {

enum Status { accepted = 0, rejected = 1, not_checked = 2, stopped = 3 };

constexpr const char* help =
    "usage: corral-check [--format text|json] FILE\n"
    "Checks a certificate (JSON or gzip), as doc/certificate.md specifies, and prints one line or one JSON object:\n"
    "what is proved, or the place of the first fault.\n"
    "  --format text|json  how the verdict is printed (text)\n"
    "  --version           prints the version of the program and those of the format that it reads\n"
    "  --help              prints this\n"
    "Exit status: 0 accepted, 1 rejected, 2 not checked (called wrongly, or the file cannot be read),\n"
    "3 stopped: the file is beyond the limits of work or memory, and nothing is said of what it claims.\n";

struct Arguments
{
  std::string file;
  bool json = false;
};

/// Keeps a message on one line, whatever the file contained.
std::string one_line(std::string message)
{
  for (char& c : message)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  return message.substr(0, 400);
}

std::optional<Arguments> read_arguments(const std::vector<std::string>& words)
{
  Arguments result;
  bool has_file = false;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] == "--format" && k + 1 < words.size() && (words[k + 1] == "text" || words[k + 1] == "json")) {
      result.json = words[++k] == "json";
    } else if (!has_file && !words[k].starts_with("--")) {
      result.file = words[k];
      has_file = true;
    } else {
      std::cerr << "corral-check: given '" << one_line(words[k])
                << "'; expected [--format text|json] and the file of a certificate; see corral-check --help\n";
      return std::nullopt;
    }
  }
  if (has_file) return result;
  std::cerr << "corral-check: given no file; expected the file of a certificate; see corral-check --help\n";
  return std::nullopt;
}

/// The bytes of a file, at most a little more than the limit of the specification, beyond which `check` stops.
std::string read_file(const std::string& path)
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

Status report(const corral_check::Counts& counts, bool json)
{
  const auto cells = counts.empty + counts.hit + counts.unknown;
  if (json)
    std::cout << R"({"verdict": "accepted", "cells": )" << cells << R"(, "empty": )" << counts.empty << R"(, "hit": )"
              << counts.hit << R"(, "unknown": )" << counts.unknown << "}" << std::endl;
  else
    std::cout << "accepted: " << cells << " cells, " << counts.empty << " empty, " << counts.hit << " hit, "
              << counts.unknown << " unknown" << std::endl;
  return accepted;
}

std::string quoted(const std::string& message)
{
  std::string result = "\"";
  for (const char c : one_line(message)) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

Status report(const corral_check::Refusal& refusal, Status status, bool json)
{
  const char* word = status == rejected ? "rejected" : "stopped";
  if (json) {
    std::cout << R"({"verdict": ")" << word << R"(", "place": )" << quoted(refusal.place) << R"(, "byte": )";
    if (refusal.byte)
      std::cout << *refusal.byte;
    else
      std::cout << "null";
    std::cout << R"(, "reason": )" << quoted(refusal.reason) << "}" << std::endl;
  } else {
    std::cout << word << ": " << one_line(refusal.what()) << std::endl;
  }
  return status;
}

Status check(std::string bytes, bool json)
{
  try {
    return report(corral_check::check(std::move(bytes)).counts, json);
  } catch (const corral_check::Rejected& refusal) {
    return report(refusal, rejected, json);
  } catch (const corral_check::Stopped& refusal) {
    return report(refusal, stopped, json);
  } catch (const std::bad_alloc&) {
    return report(corral_check::Stopped("memory", "the machine could not hold the proofs", {}), stopped, json);
  }
}

} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words == std::vector<std::string>{"--help"}) {
    std::cout << help;
    return accepted;
  }
  if (words == std::vector<std::string>{"--version"}) {
    std::cout << "corral-check " << corral_check::program_version << ", certificates of versions 1 and 2\n";
    return accepted;
  }
  const auto arguments = read_arguments(words);
  if (!arguments) return not_checked;
  std::string bytes;
  try {
    bytes = read_file(arguments->file);
  } catch (const std::exception&) {
    std::cerr << "corral-check: " << one_line(arguments->file) << " cannot be read; expected a certificate\n";
    return not_checked;
  }
  const Status status = check(std::move(bytes), arguments->json);
  if (std::cout) return status;
  std::cerr << "corral-check: cannot write standard output\n";
  return not_checked;
}
