// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/certificate/certificate.h>
#include <corral/internal/polynomial/integer_form.h>

#include <nlohmann/json.hpp>

#include <zlib.h>

#include <algorithm>

namespace corral {
namespace {

using Json = nlohmann::ordered_json;

template <class NT, std::size_t D>
Json terms(const Polynomial<NT, D>& f)
{
  Json result = Json::array();
  for (const auto& term : f.terms()) {
    Json entry = Json::array({term.coefficient.get_str()});
    for (const auto exponent : term.exponents) entry.push_back(exponent);
    result.push_back(std::move(entry));
  }
  return result;
}

template <std::size_t D>
Json sides(const Rational_box<D>& box)
{
  Json result = Json::array();
  for (const auto& side : box) result.push_back({side.lower().get_str(), side.upper().get_str()});
  return result;
}

template <std::size_t D>
Json write(const Sign_change<D>& change, const Grid<D>& grid, const Cell<D>& cell)
{
  const auto in_cell = [&](const Rational_point<D>& point) {
    Json result = Json::array();
    for (std::size_t axis = 0; axis < D; ++axis)
      result.push_back(Rational((point[axis] - grid.line(axis, cell[axis])) / grid.step(axis)).get_str());
    return result;
  };
  Json points = Json::array({in_cell(change.first)});
  if (change.second != change.first) points.push_back(in_cell(change.second));
  return {{"points", std::move(points)}};
}

template <std::size_t D>
Json write(const Triangular_zero<D>& zero)
{
  Json chain = Json::array();
  for (const auto& element : zero.chain) chain.push_back(terms(element));
  return {{"triangular", {{"order", zero.order}, {"chain", std::move(chain)}, {"box", sides<D>(zero.box)}}}};
}

template <std::size_t D>
Json write(const Miranda_zero<D>& zero, const Grid<D>& grid, const Cell<D>& cell)
{
  Rational_box<D> box;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const Rational line = grid.line(axis, cell[axis]);
    box[axis] = Rational_interval((zero.box[axis].lower() - line) / grid.step(axis),
                                  (zero.box[axis].upper() - line) / grid.step(axis));
  }
  Json matrix = Json::array();
  for (const auto& row : zero.matrix) {
    Json entries = Json::array();
    for (const Rational& entry : row) entries.push_back(entry.get_str());
    matrix.push_back(std::move(entries));
  }
  return {{"miranda", {{"box", sides<D>(box)}, {"matrix", std::move(matrix)}}}};
}

template <std::size_t D>
Json write(const Proved_cell<D>& proved, const Grid<D>& grid)
{
  if (const auto* change = std::get_if<Sign_change<D>>(&proved.proof)) return write(*change, grid, proved.cell);
  if (const auto* zero = std::get_if<Miranda_zero<D>>(&proved.proof)) return write(*zero, grid, proved.cell);
  return write(std::get<Triangular_zero<D>>(proved.proof));
}

/// The entry of one polynomial: null if it is its own square-free part.
template <std::size_t D>
Json square_free(const Certified_polynomial<D>& f)
{
  if (f.is_square_free()) return nullptr;
  return {{"polynomial", terms(f.square_free)}, {"power", f.power}};
}

template <std::size_t D>
Json square_free(const Certificate<D>& certificate)
{
  Json result = Json::array();
  for (const auto& f : certificate.polynomials) result.push_back(square_free(f));
  const bool all_null = std::all_of(result.begin(), result.end(), [](const Json& entry) { return entry.is_null(); });
  return all_null ? Json(nullptr) : result;
}

template <std::size_t D>
Json terms_or_null(const Polynomial<Integer, D>& f)
{
  return f.is_zero() ? Json(nullptr) : terms(f);
}

template <std::size_t D>
Json write(const Multipliers<D>& multipliers)
{
  Json b = Json::array();
  for (const auto& factor : multipliers.b) b.push_back(terms_or_null(factor));
  Json factors = Json::array();
  for (const auto& [factor, exponent] : multipliers.factors) factors.push_back(Json::array({terms(factor), exponent}));
  return {{"of", multipliers.of},
          {"a", terms_or_null(multipliers.a)},
          {"b", std::move(b)},
          {"factors", std::move(factors)}};
}

} // namespace

template <std::size_t D>
std::string to_json(const Certificate<D>& certificate, const std::array<std::string, D>& variables)
{
  for (auto name = variables.begin(); name != variables.end(); ++name)
    if (std::find(variables.begin(), name, *name) != name)
      throw Invalid_input("certificate: the variable name '" + *name + "' is given twice; expected different names");
  Json witnesses = Json::array();
  for (const auto& proved : certificate.witnesses) witnesses.push_back(write(proved, certificate.grid));
  Json root;
  root["format"] = "corral-certificate";
  root["version"] = 2;
  root["dimension"] = D;
  root["variables"] = variables;
  root["polynomials"] = Json::array();
  for (const auto& f : certificate.polynomials) root["polynomials"].push_back(terms(f.given));
  root["square_free"] = square_free(certificate);
  root["box"] = sides<D>(certificate.grid.box());
  root["resolution"] = certificate.grid.resolution();
  root["method"] = "bernstein";
  root["tree"] = certificate.tree;
  root["witnesses"] = std::move(witnesses);
  root["multipliers"] = Json::array();
  for (const auto& multipliers : certificate.multipliers) root["multipliers"].push_back(write(multipliers));
  root["critical"] = Json::array();
  for (const auto& proof : certificate.critical)
    root["critical"].push_back(Json::array({proof.multipliers, proof.axis, proof.trees}));
  root["reasons"] = certificate.reasons;
  root["empty"] = certificate.empty;
  root["hit"] = certificate.hit;
  root["unknown"] = certificate.unknown;
  return root.dump() + '\n';
}

std::string gzip(std::string_view bytes)
{
  z_stream stream{};
  constexpr int with_gzip_header = 15 + 16;
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, with_gzip_header, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw Output_error("gzip: the compressor cannot be set up for " + std::to_string(bytes.size())
                       + " bytes; expected enough memory");
  std::string result(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data())); // zlib does not write there
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const int status = deflate(&stream, Z_FINISH);
  deflateEnd(&stream);
  if (status != Z_STREAM_END)
    throw Output_error("gzip: " + std::to_string(bytes.size()) + " bytes do not fit; expected less than 4 GiB");
  result.resize(stream.total_out);
  return result;
}

template std::string to_json(const Certificate<1>&, const std::array<std::string, 1>&);
template std::string to_json(const Certificate<2>&, const std::array<std::string, 2>&);
template std::string to_json(const Certificate<3>&, const std::array<std::string, 3>&);

} // namespace corral
