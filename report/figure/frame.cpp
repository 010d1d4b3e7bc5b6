#include "report/figure/frame.hpp"

#include <fmt/format.h>

#include "report/figure/gnuplot.hpp"

namespace fpkcheck::report {

std::string figure_output(const std::string& file_stem, const FigureSize& size) {
  return fmt::format(
      "# Drawn by: gnuplot {0}.gp, or gnuplot -e \"format='svg'\" {0}.gp\n"
      "if (!exists(\"format\")) format = 'png'\n"
      "if (format ne 'png' && format ne 'svg') exit error \"format = '\".format.\"' "
      "(must be png or svg)\"\n"
      "if (!exists(\"target\")) target = {1}.'.'.format\n"
      "set encoding utf8\n"
      "if (format eq 'svg') {{\n"
      "  set terminal svg size {2},{3} enhanced font 'sans-serif,14' background rgb 'white'\n"
      "}} else {{\n"
      "  if (strstrt(GPVAL_TERMINALS, 'pngcairo') > 0) {{\n"
      "    set terminal pngcairo size {2},{3} enhanced font 'sans-serif,11' background rgb "
      "'white'\n"
      "  }} else {{\n"
      "    set terminal png size {2},{3} enhanced\n"
      "  }}\n"
      "}}\n"
      "set output target\n\n",
      file_stem, gnuplot_string(file_stem), size.width, size.height);
}

// Upright: viewers of SVG drop the spaces beside a change of font.
std::string figure_title(const problem::Problem& problem) {
  return gnuplot_literal(
      fmt::format("{}: {}", problem.name, problem::parameters_text(problem, true)));
}

}  // namespace fpkcheck::report
