#pragma once

#include <gtest/gtest.h>
#include <netcdf.h>

#include <filesystem>
#include <string>
#include <vector>

namespace fpkcheck::tests {

/// A netCDF file, open for reading.
class OpenedNetCdf {
 public:
  explicit OpenedNetCdf(const std::filesystem::path& path) {
    EXPECT_EQ(nc_open(path.c_str(), NC_NOWRITE, &id_), NC_NOERR);
  }
  ~OpenedNetCdf() { nc_close(id_); }

  std::vector<double> values(const char* name, std::size_t count) const {
    std::vector<double> values(count);
    EXPECT_EQ(nc_get_var_double(id_, variable(name), values.data()), NC_NOERR) << name;
    return values;
  }
  std::string text(const char* of, const char* attribute) const {
    const int variable_id = of == nullptr ? NC_GLOBAL : variable(of);
    std::size_t length = 0;
    EXPECT_EQ(nc_inq_attlen(id_, variable_id, attribute, &length), NC_NOERR) << attribute;
    std::string text(length, ' ');
    nc_get_att_text(id_, variable_id, attribute, text.data());
    return text;
  }
  double number(const char* attribute, const char* of = nullptr) const {
    double value = 0;
    const int variable_id = of == nullptr ? NC_GLOBAL : variable(of);
    EXPECT_EQ(nc_get_att_double(id_, variable_id, attribute, &value), NC_NOERR) << attribute;
    return value;
  }
  std::vector<std::string> dimensions(const char* name) const {
    int count = 0, ids[NC_MAX_VAR_DIMS];
    nc_inq_var(id_, variable(name), nullptr, nullptr, &count, ids, nullptr);
    std::vector<std::string> names;
    for (int d = 0; d < count; ++d) {
      char dimension[NC_MAX_NAME + 1];
      nc_inq_dimname(id_, ids[d], dimension);
      names.emplace_back(dimension);
    }
    return names;
  }

 private:
  int variable(const char* name) const {
    int variable = 0;
    EXPECT_EQ(nc_inq_varid(id_, name, &variable), NC_NOERR) << name;
    return variable;
  }
  int id_ = 0;
};

}  // namespace fpkcheck::tests
