#include "results/netcdf/reader.hpp"

#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace fpkcheck::results {
namespace {

// Largest accepted number of values of a netCDF variable. The joint densities of all solutions of a
// case together have less than a million values.
constexpr std::size_t kMaxValues = std::size_t{1} << 24;
constexpr std::size_t kMaxLabels = 10000;
constexpr std::size_t kMaxAttributeLength = 10000;

void check_read_status(int status, const std::string& what) {
  if (status != NC_NOERR) {
    throw std::runtime_error(fmt::format("{}: {}", what, nc_strerror(status)));
  }
}

}  // namespace

NetCdfReader::NetCdfReader(std::string bytes) : bytes_(std::move(bytes)) {
  // libnetcdf does not validate the headers of formats older than netCDF-4 (HDF5).
  if (!bytes_.starts_with(kNetCdfMagic)) throw std::runtime_error("not netCDF-4");
  // Files are opened from memory, since libnetcdf interprets some paths as network addresses.
  check_read_status(nc_open_mem("bytes", NC_NOWRITE, bytes_.size(), bytes_.data(), &id_),
                    "cannot be opened");
}

NetCdfReader::~NetCdfReader() { nc_close(id_); }

std::vector<std::string> NetCdfReader::variable_names() const {
  int count = 0;
  check_read_status(nc_inq_nvars(id_, &count), "variables");
  std::vector<std::string> names;
  for (int variable = 0; variable < count; ++variable) {
    char name[NC_MAX_NAME + 1];
    check_read_status(nc_inq_varname(id_, variable, name), "names of variables");
    names.emplace_back(name);
  }
  return names;
}

int NetCdfReader::variable_id(const std::string& name) const {
  int variable = 0;
  check_read_status(nc_inq_varid(id_, name.c_str(), &variable), name);
  return variable;
}

std::vector<int> NetCdfReader::dimension_ids(const std::string& name) const {
  int count = 0;
  check_read_status(nc_inq_varndims(id_, variable_id(name), &count), name);
  std::vector<int> ids(count);
  check_read_status(nc_inq_vardimid(id_, variable_id(name), ids.data()), name);
  return ids;
}

std::vector<std::string> NetCdfReader::dimension_names(const std::string& name) const {
  std::vector<std::string> names;
  for (const int dimension : dimension_ids(name)) {
    char text[NC_MAX_NAME + 1];
    check_read_status(nc_inq_dimname(id_, dimension, text), name);
    names.emplace_back(text);
  }
  return names;
}

std::vector<std::size_t> NetCdfReader::dimension_lengths(const std::string& name) const {
  std::vector<std::size_t> lengths;
  for (const int dimension : dimension_ids(name)) {
    check_read_status(nc_inq_dimlen(id_, dimension, &lengths.emplace_back()), name);
  }
  return lengths;
}

std::size_t NetCdfReader::value_count(const std::string& name) {
  const int id = variable_id(name);
  std::size_t count = 1;
  const auto lengths = dimension_lengths(name);
  for (const std::size_t length : lengths) {
    if (length > kMaxValues / std::max<std::size_t>(count, 1)) {
      throw std::runtime_error(fmt::format("{}: more than {} values", name, kMaxValues));
    }
    count *= length;
  }
  // A netCDF file of one kilobyte may declare any number of values, since unwritten values take no
  // space. The limit kMaxValuesPerByte is the highest compression of single-precision values by
  // deflate.
  constexpr std::size_t kMaxValuesPerByte = 260;
  requested_values_ += count;
  if (requested_values_ > kMaxValuesPerByte * bytes_.size()) {
    throw std::runtime_error(fmt::format("{}: more values than the file can contain", name));
  }
  nc_type type = NC_NAT;
  check_read_status(nc_inq_vartype(id_, id, &type), name);
  if (type != NC_CHAR && type != NC_FLOAT && type != NC_DOUBLE) {
    throw std::runtime_error(fmt::format("{}: neither numbers nor texts", name));
  }
  int storage = NC_CONTIGUOUS;
  std::vector<std::size_t> chunk(lengths.size());
  check_read_status(nc_inq_var_chunking(id_, id, &storage, chunk.data()), name);
  if (storage != NC_CHUNKED) return count;
  // The chunk size is limited, since libnetcdf allocates whole chunks even for few values.
  for (std::size_t k = 0; k < chunk.size(); ++k) {
    if (chunk[k] > std::max<std::size_t>(lengths[k], 1)) {
      throw std::runtime_error(fmt::format("{}: a chunk exceeds the dimensions", name));
    }
  }
  return count;
}

std::vector<double> NetCdfReader::read_values(const std::string& name) {
  std::vector<double> values(value_count(name));
  check_read_status(nc_get_var_double(id_, variable_id(name), values.data()), name);
  return values;
}

std::vector<std::string> NetCdfReader::read_labels(const std::string& name) {
  const auto lengths = dimension_lengths(name);
  if (lengths.size() != 2 || lengths[0] > kMaxLabels) {
    throw std::runtime_error(fmt::format("{}: not a list of texts", name));
  }
  std::string characters(value_count(name), '\0');
  check_read_status(nc_get_var_text(id_, variable_id(name), characters.data()), name);
  std::vector<std::string> texts;
  for (std::size_t n = 0; n < lengths[0]; ++n) {
    const std::string padded = characters.substr(n * lengths[1], lengths[1]);
    texts.push_back(padded.substr(0, padded.find('\0')));
  }
  return texts;
}

std::vector<double> NetCdfReader::read_cell_edges(const std::string& coordinate) {
  const std::string bounds = read_text_attribute(coordinate, "bounds");
  const auto lengths = dimension_lengths(bounds);
  const auto ends = read_values(bounds);
  if (lengths.size() != 2 || lengths[0] == 0 || lengths[1] != 2) {
    throw std::runtime_error(fmt::format("{}: no bounds of cells", bounds));
  }
  std::vector<double> edges{ends.front()};
  for (std::size_t cell = 0; cell < lengths[0]; ++cell) {
    const double lower = ends[2 * cell], upper = ends[2 * cell + 1];
    if (lower != edges.back() || !(upper > lower)) {
      throw std::runtime_error(fmt::format("{}: the cells do not adjoin", bounds));
    }
    edges.push_back(upper);
  }
  return edges;
}

std::string NetCdfReader::read_text_attribute(const std::string& name,
                                              const std::string& attribute) const {
  const std::string what = fmt::format("{}:{}", name, attribute);
  const int id = variable_id(name);
  std::size_t length = 0;
  nc_type type = NC_NAT;
  check_read_status(nc_inq_att(id_, id, attribute.c_str(), &type, &length), what);
  if (type != NC_CHAR || length > kMaxAttributeLength) {
    throw std::runtime_error(fmt::format("{}: not a short text", what));
  }
  std::string text(length, '\0');
  check_read_status(nc_get_att_text(id_, id, attribute.c_str(), text.data()), what);
  return text;
}

}  // namespace fpkcheck::results
