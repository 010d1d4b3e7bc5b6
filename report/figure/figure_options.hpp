#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"

/// Options of pictures.
namespace fpkcheck::report {

/// The file format of a figure. The format `tex` writes the texts to the LaTeX file STEM.tex, for
/// \input, and the graphics to STEM-tex.pdf.
enum class FigureFormat { png, svg, pdf, tex };
inline constexpr base::EnumEntry<FigureFormat> kFigureFormatNames[] = {{FigureFormat::png, "png"},
                                                                       {FigureFormat::svg, "svg"},
                                                                       {FigureFormat::pdf, "pdf"},
                                                                       {FigureFormat::tex, "tex"}};
constexpr const auto& enumerator_names(FigureFormat) { return kFigureFormatNames; }
constexpr std::string_view name(FigureFormat format) { return base::name_of(format); }

/// The medium and width of a figure. A figure for one journal column has fewer panels side by side
/// than a wider figure.
enum class FigureWidth { screen, two_columns, one_column };
inline constexpr base::EnumEntry<FigureWidth> kFigureWidthNames[] = {
    {FigureWidth::screen, "screen"},
    {FigureWidth::two_columns, "170", "both columns of a journal, in mm"},
    {FigureWidth::one_column, "85", "one column of a journal, in mm"}};
constexpr const auto& enumerator_names(FigureWidth) { return kFigureWidthNames; }
constexpr std::string_view name(FigureWidth width) { return base::name_of(width); }

struct FigureOptions {
  std::vector<FigureFormat> formats{FigureFormat::png};
  FigureWidth width = FigureWidth::screen;
  /// Solutions (by id, family or solver) whose curves the picture of a case shows, or "all". An
  /// empty list of curves means the default selection (report/figure/curve_selection.hpp).
  std::vector<std::string> curves = {};
};

}  // namespace fpkcheck::report
