#include "report/page/typed_array.hpp"

#include <bit>
#include <vector>

#include "report/page/base64.hpp"

namespace fpkcheck::report {

static_assert(std::endian::native == std::endian::little, "plotly.js reads little-endian numbers");

TypedArray float_array(std::span<const double> values) {
  const std::vector<float> rounded(values.begin(), values.end());
  return {"f4", encode_base64(std::as_bytes(std::span(rounded)))};
}

}  // namespace fpkcheck::report
