// Fuzzer of the directory of a run: summary.json, then a line "====", then marginals.csv.
#include "results/saved_run.hpp"

#include "one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  constexpr std::string_view kBetween = "\n====\n";
  const std::string_view text = fuzz::text_of(data, size);
  const auto end = text.find(kBetween);
  fuzz::written(results::kSummaryFile, text.substr(0, end));
  fuzz::written(results::kMarginalsFile,
                end == text.npos ? std::string_view() : text.substr(end + kBetween.size()));
  return fuzz::only_input_errors([] { results::load_run(fuzz::directory()); });
}
