// Fuzzer of netCDF-4 files. The bytes select lengths, names, types, attributes and values of a file
// that netCDF writes. They are not the bytes of the file: HDF5 crashes on damaged files.
#include "results/joint_netcdf.hpp"

#include <fuzzer/FuzzedDataProvider.h>
#include <netcdf.h>
#include <sys/wait.h>

#include <cerrno>
#include <limits>
#include <vector>

#include "fuzz_helpers.hpp"

namespace {

using namespace fpkcheck;

// Dimensions and variables of a valid file; a nonzero byte replaces one of their properties.
struct Dimension {
  const char* name;
  std::size_t length;
};
constexpr Dimension kDimensions[] = {
    {"solution", 2}, {"solution_length", 3}, {"bounds", 2}, {"y_c", 2}, {"ydot_c", 2}};
struct Variable {
  const char* name;
  nc_type type;
  std::vector<int> axes;
  const char* attribute;
  const char* text;
};
const Variable kVariables[] = {{"solution", NC_CHAR, {0, 1}, "case", "-"},
                               {"y_c", NC_DOUBLE, {3}, "bounds", "y_c_bounds"},
                               {"y_c_bounds", NC_DOUBLE, {3, 2}, "case", "-"},
                               {"ydot_c", NC_DOUBLE, {4}, "bounds", "ydot_c_bounds"},
                               {"ydot_c_bounds", NC_DOUBLE, {4, 2}, "case", "-"},
                               {"p_c", NC_FLOAT, {0, 3, 4}, "case", "c"},
                               {"source_y2_c", NC_FLOAT, {0, 3, 4}, "case", "c"}};
constexpr std::size_t kLengths[] = {2, 0, 1, 3, 1000, 1ull << 31, 1ull << 40, 1ull << 62};
constexpr double kValues[] = {0, 0.5, -1, 1, 1e308, std::numeric_limits<double>::quiet_NaN()};
constexpr nc_type kTypes[] = {NC_CHAR, NC_FLOAT, NC_DOUBLE, NC_INT, NC_STRING};
constexpr std::size_t kMaxValues = 64;  // values are written to variables with at most so many

void add_attribute(FuzzedDataProvider& bytes, int file, int id, const Variable& variable) {
  const char* text = variable.text;
  const double number = 1;
  switch (bytes.ConsumeIntegralInRange(0, 5)) {
    case 1:
      nc_put_att_string(file, id, variable.attribute, 1, &text);
      return;
    case 2:
      nc_put_att_double(file, id, variable.attribute, NC_DOUBLE, 1, &number);
      return;
    case 3:
      return;
    case 4:
      text = bytes.PickValueInArray(kVariables).name;
      break;
    default:
      break;
  }
  nc_put_att_text(file, id, variable.attribute, std::string_view(text).size(), text);
}

void add_values(FuzzedDataProvider& bytes, int file, int id, std::size_t count) {
  char letters[kMaxValues];
  double numbers[kMaxValues];
  for (std::size_t k = 0; k < count; ++k) {
    letters[k] = static_cast<char>('a' + bytes.ConsumeIntegralInRange(0, 200));
    // Without further bytes, the bounds of adjacent cells: 0, 1, 1, 2, ..
    numbers[k] = static_cast<double>((k + 1) / 2) + bytes.PickValueInArray(kValues);
  }
  nc_put_var_text(file, id, letters);
  nc_put_var_double(file, id, numbers);
}

// False if netCDF failed to write the variable; netCDF crashes if it continues after such a
// failure.
bool add_variable(FuzzedDataProvider& bytes, int file, Variable variable) {
  if (bytes.ConsumeBool()) variable.name = bytes.PickValueInArray(kVariables).name;
  if (bytes.ConsumeBool()) variable.type = bytes.PickValueInArray(kTypes);
  if (bytes.ConsumeBool()) variable.axes = bytes.PickValueInArray(kVariables).axes;
  const auto axes = static_cast<int>(variable.axes.size());
  int id = 0;
  if (nc_def_var(file, variable.name, variable.type, axes, variable.axes.data(), &id) != NC_NOERR) {
    return true;
  }
  add_attribute(bytes, file, id, variable);
  if (nc_enddef(file) != NC_NOERR) return false;
  std::size_t count = 1;
  for (const int axis : variable.axes) {
    std::size_t length = 0;
    nc_inq_dimlen(file, axis, &length);
    count = length > kMaxValues || count > kMaxValues ? kMaxValues + 1 : count * length;
  }
  if (count <= kMaxValues) add_values(bytes, file, id, count);
  return true;
}

// True if the file is complete.
bool write(FuzzedDataProvider& bytes, const std::filesystem::path& path) {
  int file = 0;
  fuzz::require(nc_create(path.c_str(), NC_CLOBBER | NC_NETCDF4, &file) == NC_NOERR);
  for (const auto& [name, length] : kDimensions) {
    int id = 0;
    const bool use_other = bytes.ConsumeBool();
    nc_def_dim(file, name, use_other ? bytes.PickValueInArray(kLengths) : length, &id);
  }
  bool complete = true;
  for (const Variable& variable : kVariables) {
    complete = complete && add_variable(bytes, file, variable);
  }
  return nc_close(file) == NC_NOERR && complete;
}

// Writes in a child process: HDF5 leaks 20 kB for each file that it could not write, and after
// 20000 files the fuzzer would report that an input used all its memory. (Reading leaks less:
// libnetcdf 4.9.0 leaks 2 kB for each file, a property list in NC4_hdf5get_superblock.)
bool write_in_child(FuzzedDataProvider& bytes, const std::filesystem::path& path) {
  const pid_t child = fork();
  fuzz::require(child >= 0);
  if (child == 0) _exit(write(bytes, path) ? 0 : 1);
  int status = 0;
  pid_t ended = 0;
  do {  // the timer of the fuzzer interrupts waitpid every second
    ended = waitpid(child, &status, 0);
  } while (ended < 0 && errno == EINTR);
  fuzz::require(ended == child && WIFEXITED(status));
  return WEXITSTATUS(status) == 0;
}

void require_complete(const transform::GridDensity& density) {
  fuzz::require(density.averages.size() ==
                (density.y_edges.size() - 1) * (density.v_edges.size() - 1));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  const auto file = fuzz::directory() / "file.nc";
  if (write_in_child(bytes, file)) {
    fuzz::catch_input_errors([&] {
      const auto found = results::read_joint_netcdf(file);
      for (const auto& [name, joint] : found.joints) require_complete(joint.density);
      for (const auto& [name, source] : found.sources) require_complete(source.density);
    });
  }
  std::filesystem::remove(file);
  return 0;
}
