#include "compare/figure/frame.hpp"

#include <fmt/format.h>

#include "compare/figure/gnuplot.hpp"

namespace fpkcheck::compare {

std::string figure_output(const std::string& file_stem, const FigureSize& size) {
  return fmt::format(
      "# Drawn by: gnuplot {0}.gp, or gnuplot -e \"format='svg'\" {0}.gp\n"
      "if (!exists(\"format\")) format = 'png'\n"
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
std::string figure_title(const nlohmann::ordered_json& summary_case) {
  const auto& system = summary_case.at("system");
  const auto& impulse = summary_case.at("impulse");
  const auto law = impulse.at("law").get<std::string>();
  const double mean = impulse.at("mean").get<double>();
  return gnuplot_literal(fmt::format(
      "{}: c = {:g}, k = {:g}, μ = {:g}, r = {:g}, λ = {:g}, λE[Y²] = {:g}{}{}",
      summary_case.at("name").get<std::string>(), system.at("damping").get<double>(),
      system.at("stiffness").get<double>(), system.at("cubic").get<double>(),
      system.at("restitution").get<double>(), impulse.at("rate").get<double>(),
      impulse.at("intensity").get<double>(), mean == 0 ? "" : fmt::format(", E[Y] = {:g}", mean),
      law == "gaussian" ? "" : fmt::format(", {} impulses", law)));
}

}  // namespace fpkcheck::compare
