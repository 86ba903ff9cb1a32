#include "app/cli/reconstruct_flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "reconstruction/errors.h"
#include "reconstruction/methods/methods.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

/// The flags that only some methods take, and which.
struct MethodFlags {
  std::vector<Method> methods;
  std::vector<std::string> flags;
};
const std::vector<MethodFlags> kMethodFlags{{{Method::Psr}, {"--depth", "--point-weight"}},
                                            {{Method::Psr, Method::Listed}, {"--sampling", "--scale"}},
                                            {{Method::Mcsd}, {"--smoothing", "--filter", "--decimation", "--order"}},
                                            {{Method::Listed}, {"--variant"}}};

void refuseOthersFlags(const CLI::App& command, Method method, const std::string& id) {
  for (const auto& [methods, flags] : kMethodFlags) {
    for (const std::string& flag : flags) {
      if (std::find(methods.begin(), methods.end(), method) == methods.end() && command.count(flag) > 0) {
        throw UsageError(flag + " has no meaning with --method " + id + "; leave it out");
      }
    }
  }
}

template <typename Value>
Value oneOf(const std::string& flag, const std::string& text, const std::vector<std::pair<std::string, Value>>& choices) {
  std::string list;
  for (const auto& [name, value] : choices) {
    if (name == text) {
      return value;
    }
    list += (list.empty() ? "" : " or ") + name;
  }
  throw UsageError(flag + " takes " + list + ", not \"" + text + "\"");
}

/// The values of a comma separated list, each once, by `parse`, which gives nothing for what is no value.
template <typename Parse>
auto listOf(const std::string& flag, const std::string& text, const std::string& words, Parse&& parse) {
  std::vector<typename std::invoke_result_t<Parse, const std::string&>::value_type> values;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto value = parse(part);
    if (!value) {
      throw UsageError(flag + " takes " + words + " separated by commas, not \"" + text + "\"");
    }
    if (std::find(values.begin(), values.end(), *value) == values.end()) {
      values.push_back(*value);
    }
  }
  if (values.empty() || text.ends_with(',')) {
    throw UsageError(flag + " takes " + words + " separated by commas, not \"" + text + "\"");
  }
  return values;
}

std::optional<int> wholeNumber(const std::string& text) {
  const auto value = parseInteger(text);
  return value && *value == static_cast<int>(*value) ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

constexpr int kAutoDepth = 0;

std::vector<int> depthsOf(const std::string& text) {
  return listOf("--depth", text, "whole numbers from 5 to 10 or auto", [](const std::string& part) -> std::optional<int> {
    const auto depth = wholeNumber(part);
    return part == "auto" ? kAutoDepth : depth == kAutoDepth ? std::nullopt : depth;
  });
}

std::vector<ParameterSet> psrSets(const ReconstructionParameters& common, const std::string& depthList) {
  const std::vector<int> depths = depthsOf(depthList);
  std::vector<ParameterSet> sets;
  for (const int depth : depths) {
    ParameterSet& set = sets.emplace_back();
    set.parameters = common;
    set.parameters.autoDepth = depth == kAutoDepth;
    if (depth != kAutoDepth) {
      set.parameters.psr.depth = depth;
    }
    if (depths.size() > 1) {
      set.suffix = "_d" + (depth == kAutoDepth ? "auto" : std::to_string(depth));
    }
  }
  return sets;
}

std::vector<ParameterSet> mcsdSets(const ReconstructionParameters& common, const ReconstructFlags& flags) {
  const auto smoothings = listOf("--smoothing", flags.smoothings, "whole numbers", wholeNumber);
  const auto decimations = listOf("--decimation", flags.decimations, "shares from 0 to 0.99", parseNumber);
  std::vector<ParameterSet> sets;
  for (const int smoothing : smoothings) {
    for (const double decimation : decimations) {
      ParameterSet& set = sets.emplace_back();
      set.parameters = common;
      set.parameters.mcsd.smoothing = smoothing;
      set.parameters.mcsd.decimation = decimation;
      if (smoothings.size() * decimations.size() > 1) {
        set.suffix = "_s" + std::to_string(smoothing) + "_e" + formatExact(std::round(1e9 * decimation) / 1e7);
      }
    }
  }
  return sets;
}

/// A set per variant, each named in full.
std::vector<ParameterSet> listedSets(const ReconstructionParameters& common, const ReconstructFlags& flags) {
  const ReconstructionMethod& method = listedMethod(flags.method);
  std::vector<std::string> variants{method.usual};
  if (!flags.variants.empty()) {
    variants =
        listOf("--variant", flags.variants, "names of variants", [](const std::string& part) { return std::optional(part); });
  }
  std::vector<ParameterSet> sets;
  for (const std::string& variant : variants) {
    ParameterSet& set = sets.emplace_back();
    set.parameters = common;
    set.parameters.listedMethod = method.id;
    set.parameters.listedVariant = variant;
    if (variants.size() > 1) {
      set.suffix = "_" + variant;
    }
  }
  return sets;
}

/// "psr (Poisson), ...; psr_knn (...)".
std::string methodsText() {
  std::string text = "psr (Poisson), mcsd (marching cubes, smoothing, decimation)";
  for (const ReconstructionMethod& method : listedMethods()) {
    text += ", " + method.id + " (" + method.name + ")";
  }
  return text;
}

std::string variantsText() {
  std::string text = "Other methods: a,b writes OUT_a.ext, OUT_b.ext;";
  for (const ReconstructionMethod& method : listedMethods()) {
    text += " " + method.id + ":";
    for (const MethodVariant& variant : method.variants) {
      text += " " + variant.id;
    }
    text += " (" + method.usual + ");";
  }
  text.pop_back();
  return text;
}

std::optional<SimplifyTarget> simplifyTargetOf(const std::string& text) {
  if (text.empty()) {
    return std::nullopt;
  }
  SimplifyTarget target;
  if (text.ends_with("mm")) {
    target.distanceMm = parseNumber(text.substr(0, text.size() - 2));
  } else if (const auto triangles = parseInteger(text); triangles && *triangles > 0) {
    target.triangles = static_cast<std::size_t>(*triangles);
  }
  if (!target.triangles && !target.distanceMm) {
    throw UsageError("--simplify takes a number of triangles (10000) or a distance (0.3mm), not \"" + text + "\"");
  }
  return target;
}

}  // namespace

void addReconstructFlags(CLI::App& command, ReconstructFlags& flags) {
  PoissonParameters& psr = flags.parameters.psr;
  command.add_option("--method", flags.method, methodsText())->capture_default_str();
  command.add_option("--variant", flags.variants, variantsText());
  command.add_option("--depth", flags.depths, "psr: 5 to 10, or auto: from the voxel spacing; a,b writes OUT_da.ext, OUT_db.ext")
      ->capture_default_str();
  command.add_option("--sampling", flags.sampling, "psr and other methods: unbiased or paper")->capture_default_str();
  addNumber(command, "--point-weight", psr.pointWeight, "psr: screening; 0 is none");
  addNumber(command, "--scale", psr.scale, "psr and other methods: cube side over the largest extent");
  command.add_option("--smoothing", flags.smoothings, "mcsd: iterations; a,b writes OUT_sa_e25.ext, OUT_sb_e25.ext")
      ->capture_default_str();
  command.add_option("--filter", flags.filter, "mcsd: sinc or laplacian")->capture_default_str();
  command
      .add_option("--decimation", flags.decimations,
                  "mcsd: share of triangles to remove, 0 to 0.99; a,b (0.1,0.5) writes OUT_s10_e10.ext, OUT_s10_e50.ext")
      ->capture_default_str();
  command.add_option("--order", flags.order, "mcsd: decimate-first or smooth-first")->capture_default_str();
  command.add_option("--simplify", flags.simplify, "Fewer triangles: a number (10000) or the distance allowed (0.3mm)");
}

std::vector<ParameterSet> parametersOf(const CLI::App& command, const ReconstructFlags& flags) {
  ReconstructionParameters parameters = flags.parameters;
  parameters.method = flags.method == "psr" ? Method::Psr : flags.method == "mcsd" ? Method::Mcsd : Method::Listed;
  if (parameters.method == Method::Listed) {
    listedMethod(flags.method);  // whose flags there is nothing to say of where there is no such method
  }
  refuseOthersFlags(command, parameters.method, flags.method);
  parameters.psr.sampling =
      oneOf<Sampling>("--sampling", flags.sampling, {{"unbiased", Sampling::Unbiased}, {"paper", Sampling::Paper}});
  parameters.mcsd.filter = oneOf<SmoothingFilter>("--filter", flags.filter,
                                                  {{"sinc", SmoothingFilter::Sinc}, {"laplacian", SmoothingFilter::Laplacian}});
  parameters.mcsd.order = oneOf<McsdOrder>(
      "--order", flags.order, {{"decimate-first", McsdOrder::DecimateFirst}, {"smooth-first", McsdOrder::SmoothFirst}});
  parameters.simplify = simplifyTargetOf(flags.simplify);
  std::vector<ParameterSet> sets = parameters.method == Method::Psr    ? psrSets(parameters, flags.depths)
                                   : parameters.method == Method::Mcsd ? mcsdSets(parameters, flags)
                                                                       : listedSets(parameters, flags);
  for (const ParameterSet& set : sets) {
    set.parameters.validate();
  }
  return sets;
}

}  // namespace glisson::cli
