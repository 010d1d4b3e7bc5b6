// The extension module fpkcheck._fpkcheck of the Python package. Its functions take and return
// numbers, texts and NumPy arrays. The public classes and functions are written in Python.
#include <fmt/format.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/input_error.hpp"
#include "base/options/enum_names.hpp"
#include "base/text/printable_text.hpp"
#include "compare/comparison_bins.hpp"
#include "extension/options.hpp"
#include "extension/runs.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/external/external_density.hpp"
#include "methods/external/external_labels.hpp"
#include "methods/external/external_methods.hpp"
#include "methods/external/external_samples.hpp"
#include "methods/external/range_between_walls.hpp"
#include "problem/case_file.hpp"
#include "report/terminal_tables.hpp"
#include "results/run_json.hpp"
#include "workflows/study/functionals/functionals.hpp"
#include "workflows/study/transient/comparison_over_time.hpp"

namespace fpkcheck::python {
namespace {

namespace py = pybind11;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using RunPointer = std::shared_ptr<results::Run>;

const methods::SolverRegistry& registry() {
  static const auto instance = methods::builtin_registry();
  return instance;
}

py::array_t<double> to_array(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::array_t<double> cells(const transform::GridDensity& density) {
  return py::array_t<double>({density.y_cell_count(), density.v_cell_count()},
                             density.averages.data());
}

base::Value value_from_python(const py::handle& object, const std::string& name) {
  if (object.is_none()) return {};
  if (py::isinstance<py::bool_>(object)) return object.cast<bool>();
  if (py::isinstance<py::int_>(object)) {
    // An integer beyond 64 bits becomes a double that is out of the range of every option, and is
    // thus refused.
    int overflows = 0;
    const auto whole = PyLong_AsLongLongAndOverflow(object.ptr(), &overflows);
    if (overflows != 0) return object.cast<double>();
    return std::int64_t{whole};
  }
  if (py::isinstance<py::float_>(object)) return object.cast<double>();
  if (py::isinstance<py::str>(object)) return object.cast<std::string>();
  throw py::type_error(fmt::format("{} has the type {} (must be number, text, bool or None)",
                                   base::in_quotes(name), Py_TYPE(object.ptr())->tp_name));
}

base::Values values_from_python(const py::dict& dict) {
  base::Values values;
  for (const auto& [key, value] : dict) {
    const auto name = key.cast<std::string>();
    values.push_back({name, value_from_python(value, name)});
  }
  return values;
}

py::object to_python(const base::Value& value) {
  return std::visit(
      [](const auto& held) -> py::object {
        using Held = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<Held, std::monostate>) {
          return py::none();
        } else {
          return py::cast(held);
        }
      },
      value);
}

// -- problems

std::vector<std::string> setting_keys() {
  std::vector<std::string> all;
  for (const auto* section : problem::case_section_descriptions()) {
    for (const auto& parameter : section->parameters())
      all.push_back(section->prefix() + parameter.name);
  }
  return all;
}

problem::Problem problem_of(const std::string& name, const std::vector<std::string>& settings) {
  std::istringstream empty;
  return problem::read_case(empty, name, name, settings, problem::CaseNamingRule::from_file,
                            problem::CaseFileTimeSectionPolicy::allowed);
}

/// @throws InputError if the excitation changes in time
void require_constant_excitation(const problem::Problem& problem) {
  if (!problem.time.is_acting()) return;
  throw InputError(
      fmt::format("case {}: the section [time] changes the excitation in time, so that there is no "
                  "stationary density; use densities_over_time()",
                  base::in_quotes(problem.name)));
}

py::dict sections_to_python(const problem::Problem& problem) {
  py::dict sections;
  for (const auto& section : problem::case_file_sections(problem)) {
    py::dict values;
    for (const auto& [name, value] : section.values) values[py::str(name)] = to_python(value);
    sections[py::str(section.name)] = values;
  }
  return sections;
}

void bind_problems(py::module_& module) {
  py::class_<problem::Problem>(module, "Problem")
      .def_readonly("name", &problem::Problem::name)
      .def_property_readonly("sections", sections_to_python)
      .def_property_readonly("text", [](const problem::Problem& instance) {
        return problem::non_default_parameters_text(instance);
      });
  module.def("case_names", [] {
    std::vector<std::string> names;
    for (const auto* cases : {&problem::paper_cases(), &problem::example_oscillator_cases()}) {
      for (const auto& named : *cases) names.push_back(named.name);
    }
    return names;
  });
  module.def("keys", setting_keys);
  module.def(
      "load_case",
      [](const std::string& name_or_path, const std::vector<std::string>& settings) {
        return problem::load_case(name_or_path, settings, problem::CaseNamingRule::with_overrides,
                                  problem::CaseFileTimeSectionPolicy::allowed);
      },
      py::arg("name_or_path"), py::arg("settings"));
  module.def("problem_of", problem_of, py::arg("name"), py::arg("settings"));
  module.def("axes_of", [](const problem::Problem& problem) {
    require_constant_excitation(problem);
    const auto axes = compare::comparison_bins(problem);
    return std::make_tuple(to_array(axes.y_edges), to_array(axes.v_edges));
  });
}

// -- external densities

methods::ExternalDensity external_density(const std::string& label,
                                          const std::optional<std::string>& equation,
                                          const std::string& impact, std::optional<int> order,
                                          std::size_t index) {
  methods::require_valid_label(label, registry());
  methods::ExternalDensity external{.label = label, .index = index, .order = order};
  const auto of = [&](const char* what) { return fmt::format("density '{}': {}", label, what); };
  if (order && *order < 1) {
    throw InputError(fmt::format("{} = {} (must be 1 or more)", of("order"), *order));
  }
  if (equation)
    external.equation = base::parse_enum<problem::DensityEquation>(of("equation"), *equation);
  // Only simulations have the impact condition "exact".
  external.impact = base::parse_enum<problem::ImpactCondition>(
      of("impact"), impact, std::span(problem::kImpactNames).first(2));
  return external;
}

methods::DensityQuadratureGrid points_between_walls(const problem::Problem& problem) {
  require_constant_excitation(problem);
  return {compare::comparison_bins(problem), problem.system.walls()};
}

methods::Method function_method(const problem::Problem& problem, const Array& values,
                                const std::string& label, std::optional<std::string> equation,
                                const std::string& impact, std::optional<int> order, bool normalise,
                                double accuracy, std::size_t index) {
  const auto external = external_density(label, equation, impact, order, index);
  if (!(accuracy > 0)) {
    throw InputError(
        fmt::format("density '{}': accuracy = {:g} (must be positive)", label, accuracy));
  }
  return methods::make_method_from_density_values(
      external, {.normalise = normalise, .accuracy = accuracy}, points_between_walls(problem),
      {values.data(), values.data() + values.size()});
}

methods::Method samples_method(const Array& y, const Array& v, const std::string& label,
                               std::optional<std::string> equation, const std::string& impact,
                               std::optional<int> order, double independent, bool is_time_series,
                               bool is_reference, std::size_t index) {
  auto external = external_density(label, equation, impact, order, index);
  external.is_reference = is_reference;
  return methods::make_method_from_samples(external, transform::kExternalFunction,
                                           {.y = {y.data(), y.data() + y.size()},
                                            .v = {v.data(), v.data() + v.size()},
                                            .is_time_series = is_time_series,
                                            .independent = independent});
}

void bind_methods(py::module_& module) {
  py::class_<methods::Method>(module, "Method").def_property_readonly("id", &methods::Method::id);
  module.def("method_families", [] {
    std::vector<std::tuple<std::string, std::string, std::vector<std::string>>> all;
    for (const auto* family : registry().method_families_by_trust()) {
      all.emplace_back(family->name, family->meaning, family->default_ids);
    }
    return all;
  });
  module.def("options_of", [](const std::string& list) {
    py::dict all;
    for (const auto& method : methods_selected_by_list(registry(), list, {})) {
      py::dict options;
      for (const auto& [name, value] : method.options) options[py::str(name)] = to_python(value);
      all[py::str(method.id())] = options;
    }
    return all;
  });
  module.def("points_of", [](const problem::Problem& problem) {
    const methods::DensityQuadratureGrid points = points_between_walls(problem);
    return std::make_tuple(to_array(points.y_points()), to_array(points.v_points()));
  });
  module.def("function_method", function_method, py::arg("problem"), py::arg("values"),
             py::arg("label"), py::arg("equation"), py::arg("impact"), py::arg("order"),
             py::arg("normalise"), py::arg("accuracy"), py::arg("place"));
  module.def("samples_method", samples_method, py::arg("y"), py::arg("v"), py::arg("label"),
             py::arg("equation"), py::arg("impact"), py::arg("order"), py::arg("independent"),
             py::arg("series"), py::arg("reference"), py::arg("place"));
  module.def(
      "file_methods", [](const std::vector<std::string>& arguments, const std::string& case_name) {
        return methods::external_density_methods_from_files(arguments, registry(), case_name);
      });
}

// -- runs

void throw_on_signal() {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

RunPointer solve_task(const std::vector<problem::Problem>& problems,
                      const std::optional<std::string>& methods_list, const py::dict& options,
                      const std::vector<methods::Method>& against, int threads,
                      std::optional<double> max_seconds, bool bounds, const py::object& progress,
                      const std::string& command) {
  if (problems.empty()) throw InputError("there is no case to solve; give at least one");
  for (const auto& problem : problems) require_constant_excitation(problem);
  if (threads < 0) throw InputError(fmt::format("threads = {} (must be 0 or more)", threads));
  RunRequest task{problems, {}, threads, bounds, command};
  auto settings = values_from_python(options);
  if (threads > 0) settings.push_back({"threads", std::int64_t{threads}});
  task.methods = methods_selected_by_list(
      registry(), methods_list.value_or(registry().default_method_list()), settings);
  auto external_methods = against;
  methods::group_methods_into_families(external_methods);
  for (const auto& external : external_methods) {
    for (const auto& other : external_methods)
      methods::require_distinct_labels(external.id(), other.id());
    task.methods.push_back(external);
  }
  std::ranges::stable_sort(task.methods, methods::is_less_trusted, &methods::Method::identity);

  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  methods::RunProgress last{};
  const auto poll = [&](const methods::RunProgress* progress_update) {
    const py::gil_scoped_acquire locked;
    throw_on_signal();
    if (progress_update != nullptr) {
      last = *progress_update;
      if (!progress.is_none()) {
        using namespace py::literals;
        progress(py::dict("done"_a = last.done, "total"_a = last.total, "case"_a = last.case_name,
                          "method"_a = last.method, "fraction"_a = last.fraction,
                          "note"_a = last.note));
      }
    }
    const std::chrono::duration<double> elapsed = Clock::now() - begin;
    if (max_seconds && elapsed.count() > *max_seconds) {
      const auto text =
          fmt::format("not solved in {:g} s: {} of {} solutions, last {}; increase max_seconds",
                      *max_seconds, last.done, last.total, last.method);
      PyErr_SetString(PyExc_TimeoutError, text.c_str());
      throw py::error_already_set();
    }
  };
  const py::gil_scoped_release unlocked;
  return std::make_shared<results::Run>(solve(std::move(task), poll));
}

const results::CaseResult& case_result_at(const results::Run& run, std::size_t k) {
  return run.cases.at(k);
}

py::list curve_list(const std::vector<results::DensityCurve>& curves) {
  py::list all;
  for (const auto& curve : curves) {
    const bool known = !curve.lower.empty();
    all.append(py::make_tuple(curve.solution, std::string(name(curve.variable)),
                              to_array(curve.abscissa), to_array(curve.density),
                              known ? py::object(to_array(curve.lower)) : py::none(),
                              known ? py::object(to_array(curve.upper)) : py::none()));
  }
  return all;
}

// JSON, CSV and tables of the functional of a problem, as the program writes them.
using FunctionalTexts = std::tuple<std::string, std::string, std::string>;

// Adds a function that computes a functional of one problem, like the command of the program.
// @param study function of the command
template <class Options, class Study>
void bind_functional(py::module_& module, const char* name,
                     const base::OptionsDescription<Options>& description,
                     Study (*study)(const problem::Problem&, const Options&,
                                    const methods::ProgressListener&),
                     problem::CaseFileTimeSectionPolicy time_section) {
  module.def(
      name,
      [&description, study, time_section](const problem::Problem& problem, const py::dict& given,
                                          const std::string& command) -> FunctionalTexts {
        if (time_section == problem::CaseFileTimeSectionPolicy::refused) {
          require_constant_excitation(problem);
        }
        Options options;
        for (const auto& [option, value] : values_from_python(given)) {
          description.assign_option_value(options, *description.find(option), value, option + " =");
        }
        description.validate(options);
        const py::gil_scoped_release unlocked;
        const auto result = std::make_shared<std::optional<Study>>();
        compute_in_worker_thread(
            [problem, options, study, result](const WorkerCallbacks& callbacks) {
              result->emplace(study(problem, options, callbacks.progress));
            },
            [](const methods::RunProgress*) {
              const py::gil_scoped_acquire locked;
              throw_on_signal();
            });
        const Study& computed = **result;
        return {study_json_text(computed, command), study_csv_text(computed),
                study_table_text(computed, report::TerminalTextFormat())};
      },
      py::arg("problem"), py::arg("options"), py::arg("command"));
}

void bind_functionals(py::module_& module) {
  using problem::CaseFileTimeSectionPolicy;
  bind_functional(module, "passage", study::passage_option_descriptions(), study::study_passage,
                  CaseFileTimeSectionPolicy::refused);
  bind_functional(module, "spectrum", study::spectrum_option_descriptions(), study::study_spectrum,
                  CaseFileTimeSectionPolicy::refused);
  bind_functional(module, "sensitivity", study::sensitivity_option_descriptions(),
                  study::study_sensitivity, CaseFileTimeSectionPolicy::refused);
  bind_functional(module, "densities_over_time", study::transient_comparison_option_descriptions(),
                  study::compare_over_time, CaseFileTimeSectionPolicy::allowed);
}

void bind_runs(py::module_& module) {
  py::class_<results::Run, RunPointer>(module, "Run")
      .def("summary", [](const results::Run& run) { return results::run_summary_text(run); })
      .def("table", [](const results::Run& run,
                       std::size_t width) { return report::terminal_tables_text(run, width); })
      .def("problem",
           [](const results::Run& run, std::size_t k) { return case_result_at(run, k).problem; })
      .def("curves", [](const results::Run& run,
                        std::size_t k) { return curve_list(case_result_at(run, k).curves); })
      .def("smooth", [](const results::Run& run,
                        std::size_t k) { return curve_list(case_result_at(run, k).smooth); })
      .def("joints",
           [](const results::Run& run, std::size_t k) {
             py::list all;
             for (const auto& [solution, density] : case_result_at(run, k).joints) {
               all.append(py::make_tuple(solution, to_array(density.y_edges),
                                         to_array(density.v_edges), cells(density)));
             }
             return all;
           })
      .def("error_sources",
           [](const results::Run& run, std::size_t k) {
             py::list all;
             for (const auto& [solution, moment, density] : case_result_at(run, k).error_sources) {
               all.append(py::make_tuple(solution, moment, to_array(density.y_edges),
                                         to_array(density.v_edges), cells(density)));
             }
             return all;
           })
      .def("save", [](const RunPointer& run, const std::filesystem::path& directory) {
        const py::gil_scoped_release unlocked;
        return save(directory, *run, [] {
          const py::gil_scoped_acquire locked;
          throw_on_signal();
        });
      });
  module.def("solve", solve_task, py::arg("problems"), py::arg("methods"), py::arg("options"),
             py::arg("against"), py::arg("threads"), py::arg("max_seconds"), py::arg("bounds"),
             py::arg("progress"), py::arg("command"));
  module.def("load", [](const std::filesystem::path& directory) {
    const py::gil_scoped_release unlocked;
    return std::make_shared<results::Run>(load(directory));
  });
  module.def("prepare_for_exit", prepare_for_exit);
}

}  // namespace

// pybind11 converts InputError, a std::invalid_argument, to ValueError, and a std::runtime_error to
// RuntimeError. The translator below converts file system errors to OSError.
PYBIND11_MODULE(_fpkcheck, module) {
  module.attr("__version__") = results::current_program("").version;
  py::register_exception_translator([](std::exception_ptr failure) {
    try {
      if (failure) std::rethrow_exception(failure);
    } catch (const std::filesystem::filesystem_error& error) {
      PyErr_SetString(PyExc_OSError, error.what());
    }
  });
  bind_problems(module);
  bind_methods(module);
  bind_runs(module);
  bind_functionals(module);
}

}  // namespace fpkcheck::python
