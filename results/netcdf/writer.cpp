#include "results/netcdf/writer.hpp"

#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>

namespace fpkcheck::results {
namespace {

void check_write_status(int status, const std::string& what) {
  if (status != NC_NOERR) {
    throw std::runtime_error(fmt::format("netCDF: {}: {}", what, nc_strerror(status)));
  }
}

int define_variable(int file, const std::string& name, nc_type type,
                    const std::vector<int>& dimensions) {
  int variable = 0;
  check_write_status(nc_def_var(file, name.c_str(), type, static_cast<int>(dimensions.size()),
                                dimensions.data(), &variable),
                     fmt::format("variable {}", name));
  return variable;
}

}  // namespace

NetCdfWriter::NetCdfWriter() {
  static_assert(kGlobal == NC_GLOBAL);
  constexpr std::size_t kInitialSize = 1 << 20;  // size in bytes; libnetcdf extends the memory
  check_write_status(nc_create_mem("in memory", NC_NETCDF4, kInitialSize, &id_),
                     "cannot create the file");
}

NetCdfWriter::~NetCdfWriter() {
  if (open_) nc_abort(id_);
}

int NetCdfWriter::define_dimension(const std::string& name, std::size_t length) {
  int dimension = 0;
  check_write_status(nc_def_dim(id_, name.c_str(), length, &dimension),
                     fmt::format("dimension {}", name));
  return dimension;
}

int NetCdfWriter::write_variable(const std::string& name, const std::vector<int>& dimensions,
                                 const std::string& long_name, std::span<const double> values) {
  const int variable = define_variable(id_, name, NC_DOUBLE, dimensions);
  if (!long_name.empty()) {
    write_attribute("long_name", long_name, variable);
    write_attribute("units", "1", variable);
  }
  check_write_status(nc_put_var_double(id_, variable, values.data()),
                     fmt::format("values of {}", name));
  return variable;
}

int NetCdfWriter::write_cell_coordinate(const std::string& name, const std::string& long_name,
                                        int bounds, std::span<const double> edges) {
  std::vector<double> centres, ends;
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    centres.push_back((edges[b] + edges[b + 1]) / 2);
    ends.insert(ends.end(), {edges[b], edges[b + 1]});
  }
  const int length = define_dimension(name, centres.size());
  const int coordinate = write_variable(name, {length}, long_name, centres);
  const std::string bounds_name = name + "_bounds";
  write_attribute("bounds", bounds_name, coordinate);
  write_variable(bounds_name, {length, bounds}, "", ends);
  return length;
}

template <class Number>
int NetCdfWriter::write_compressed(const std::string& name, const std::vector<int>& dimensions,
                                   const std::string& long_name, std::span<const Number> values) {
  constexpr int kCompressionLevel = 4;
  constexpr bool kIsSingle = std::is_same_v<Number, float>;
  constexpr Number kFill = std::numeric_limits<Number>::quiet_NaN();
  const int variable = define_variable(id_, name, kIsSingle ? NC_FLOAT : NC_DOUBLE, dimensions);
  if (kIsSingle) {
    std::vector<std::size_t> chunk;
    for (const int dimension : dimensions) {
      check_write_status(nc_inq_dimlen(id_, dimension, &chunk.emplace_back()),
                         fmt::format("chunks of {}", name));
    }
    chunk.front() = 1;
    check_write_status(nc_def_var_chunking(id_, variable, NC_CHUNKED, chunk.data()),
                       fmt::format("chunks of {}", name));
  }
  check_write_status(nc_def_var_deflate(id_, variable, NC_SHUFFLE, 1, kCompressionLevel),
                     fmt::format("compression of {}", name));
  check_write_status(nc_def_var_fill(id_, variable, NC_FILL, &kFill),
                     fmt::format("fill value of {}", name));
  write_attribute("long_name", long_name, variable);
  write_attribute("units", "1", variable);
  check_write_status(nc_put_var(id_, variable, values.data()), fmt::format("values of {}", name));
  return variable;
}
template int NetCdfWriter::write_compressed(const std::string&, const std::vector<int>&,
                                            const std::string&, std::span<const float>);
template int NetCdfWriter::write_compressed(const std::string&, const std::vector<int>&,
                                            const std::string&, std::span<const double>);

void NetCdfWriter::write_labels(const std::string& name, int dimension,
                                std::span<const std::string> texts) {
  std::size_t length = 1;
  for (const auto& text : texts) length = std::max(length, text.size());
  std::string characters;
  for (const auto& text : texts) characters += text + std::string(length - text.size(), '\0');
  const int characters_of_a_text = this->define_dimension(name + "_length", length);
  const int variable = define_variable(id_, name, NC_CHAR, {dimension, characters_of_a_text});
  write_attribute("_Encoding", "utf-8", variable);
  check_write_status(nc_put_var_text(id_, variable, characters.data()),
                     fmt::format("values of {}", name));
}

void NetCdfWriter::write_attribute(const std::string& name, const std::string& text, int variable) {
  check_write_status(nc_put_att_text(id_, variable, name.c_str(), text.size(), text.c_str()),
                     fmt::format("attribute {}", name));
}

void NetCdfWriter::write_attribute(const std::string& name, double value, int variable) {
  check_write_status(nc_put_att_double(id_, variable, name.c_str(), NC_DOUBLE, 1, &value),
                     fmt::format("attribute {}", name));
}

void NetCdfWriter::write_attribute(const std::string& name, int value, int variable) {
  check_write_status(nc_put_att_int(id_, variable, name.c_str(), NC_INT, 1, &value),
                     fmt::format("attribute {}", name));
}

std::string NetCdfWriter::close_and_take_bytes() {
  open_ = false;
  NC_memio file = {};
  check_write_status(nc_close_memio(id_, &file), "cannot close the file");
  const std::unique_ptr<void, decltype(&std::free)> owner(file.memory, &std::free);
  return {static_cast<const char*>(file.memory), file.size};
}

void write_problem_attributes(NetCdfWriter& file, const problem::Problem& problem, int variable) {
  file.write_attribute("case", problem.name, variable);
  for (const auto& parameter : problem::parameters_for_reports(problem)) {
    const std::string name =
        parameter.section == "system" ? parameter.name : parameter.section + '_' + parameter.name;
    if (const auto* word = std::get_if<std::string>(&parameter.value)) {
      file.write_attribute(name, *word, variable);
    } else if (const auto* number = std::get_if<double>(&parameter.value)) {
      file.write_attribute(name, *number, variable);
    }
  }
}

}  // namespace fpkcheck::results
