#include "results/netcdf/reader.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <fstream>
#include <stdexcept>
#include <string_view>

namespace fpkcheck::results {
namespace {

void check_read(int status, const std::string& what) {
  if (status != NC_NOERR) {
    throw std::runtime_error(fmt::format("{}: {}", what, nc_strerror(status)));
  }
}

// How many values a variable has. A file of a few bytes may claim more than there are numbers for.
std::size_t count_of(const std::vector<std::size_t>& lengths, const std::string& name) {
  constexpr std::size_t kMost = std::size_t{1} << 25;
  std::size_t count = 1;
  for (const std::size_t length : lengths) {
    if (length != 0 && count > kMost / length) {
      throw std::runtime_error(fmt::format("{}: more than {} values", name, kMost));
    }
    count *= length;
  }
  return count;
}

// The program writes netCDF-4, which is HDF5. Of older formats the library believes every length in
// the head of a file, and asks for as much memory.
void require_hdf5(const std::filesystem::path& path) {
  constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";
  std::string begin(kSignature.size(), '\0');
  std::ifstream(path, std::ios::binary)
      .read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin != kSignature) throw std::runtime_error("no netCDF-4 file");
}

}  // namespace

NetCdfReader::NetCdfReader(const std::filesystem::path& path) {
  require_hdf5(path);
  check_read(nc_open(path.c_str(), NC_NOWRITE, &id_), "cannot be opened");
}

NetCdfReader::~NetCdfReader() { nc_close(id_); }

std::vector<std::string> NetCdfReader::variables() const {
  int count = 0;
  check_read(nc_inq_nvars(id_, &count), "variables");
  std::vector<std::string> names;
  for (int variable = 0; variable < count; ++variable) {
    char name[NC_MAX_NAME + 1];
    check_read(nc_inq_varname(id_, variable, name), "names of variables");
    names.emplace_back(name);
  }
  return names;
}

int NetCdfReader::variable(const std::string& name) const {
  int variable = 0;
  check_read(nc_inq_varid(id_, name.c_str(), &variable), name);
  return variable;
}

std::vector<int> NetCdfReader::dimension_ids(const std::string& name) const {
  int count = 0;
  check_read(nc_inq_varndims(id_, variable(name), &count), name);
  std::vector<int> ids(count);
  check_read(nc_inq_vardimid(id_, variable(name), ids.data()), name);
  return ids;
}

std::vector<std::string> NetCdfReader::dimensions(const std::string& name) const {
  std::vector<std::string> names;
  for (const int dimension : dimension_ids(name)) {
    char text[NC_MAX_NAME + 1];
    check_read(nc_inq_dimname(id_, dimension, text), name);
    names.emplace_back(text);
  }
  return names;
}

std::vector<std::size_t> NetCdfReader::shape(const std::string& name) const {
  std::vector<std::size_t> lengths;
  for (const int dimension : dimension_ids(name)) {
    check_read(nc_inq_dimlen(id_, dimension, &lengths.emplace_back()), name);
  }
  return lengths;
}

std::vector<double> NetCdfReader::values(const std::string& name) const {
  std::vector<double> values(count_of(shape(name), name));
  check_read(nc_get_var_double(id_, variable(name), values.data()), name);
  return values;
}

std::vector<std::string> NetCdfReader::labels(const std::string& name) const {
  const auto lengths = shape(name);
  if (lengths.size() != 2) throw std::runtime_error(fmt::format("{}: no texts", name));
  std::string characters(count_of(lengths, name), '\0');
  check_read(nc_get_var_text(id_, variable(name), characters.data()), name);
  std::vector<std::string> texts;
  for (std::size_t n = 0; n < lengths[0]; ++n) {
    const std::string padded = characters.substr(n * lengths[1], lengths[1]);
    texts.push_back(padded.substr(0, padded.find('\0')));
  }
  return texts;
}

std::vector<double> NetCdfReader::edges(const std::string& coordinate) const {
  const std::string bounds = text(coordinate, "bounds");
  const auto lengths = shape(bounds);
  const auto ends = values(bounds);
  if (lengths.size() != 2 || lengths[0] == 0 || lengths[1] != 2) {
    throw std::runtime_error(fmt::format("{}: no bounds of cells", bounds));
  }
  std::vector<double> edges{ends.front()};
  for (std::size_t cell = 0; cell < lengths[0]; ++cell) {
    const double lower = ends[2 * cell], upper = ends[2 * cell + 1];
    if (lower != edges.back() || !(upper > lower)) {
      throw std::runtime_error(fmt::format("{}: the cells do not join", bounds));
    }
    edges.push_back(upper);
  }
  return edges;
}

std::string NetCdfReader::text(const std::string& name, const std::string& attribute) const {
  const std::string what = fmt::format("{}:{}", name, attribute);
  const int id = variable(name);
  std::size_t length = 0;
  check_read(nc_inq_attlen(id_, id, attribute.c_str(), &length), what);
  std::string text(length, '\0');
  check_read(nc_get_att_text(id_, id, attribute.c_str(), text.data()), what);
  return text;
}

}  // namespace fpkcheck::results
