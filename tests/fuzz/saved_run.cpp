// Fuzzer of the directory of a run: summary.json, then a line "====", then marginals.csv.
#include "results/saved_run.hpp"

#include "fuzz_helpers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  constexpr std::string_view kSeparator = "\n====\n";
  const std::string_view text = fuzz::as_text(data, size);
  const auto end = text.find(kSeparator);
  fuzz::write_file(results::kSummaryFile, text.substr(0, end));
  fuzz::write_file(results::kMarginalsFile,
                   end == text.npos ? std::string_view() : text.substr(end + kSeparator.size()));
  return fuzz::catch_input_errors([] { results::load_run(fuzz::directory()); });
}
