#include "app/cli/reconstruct_flags.h"

#include <sstream>

#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

const std::vector<std::string> kPsrFlags{"--depth", "--sampling", "--point-weight", "--scale"};
const std::vector<std::string> kMcsdFlags{"--smoothing", "--filter", "--decimation", "--order"};

void refuse(const CLI::App& command, const std::vector<std::string>& names, const std::string& method) {
  for (const std::string& name : names) {
    if (command.count(name) > 0) {
      throw UsageError(name + " has no meaning with --method " + method + "; leave it out");
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

std::vector<int> depthsOf(const std::string& text) {
  std::vector<int> depths;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto depth = parseInteger(part);
    if (!depth || *depth != static_cast<int>(*depth)) {
      throw UsageError("--depth takes whole numbers separated by commas, not \"" + text + "\"");
    }
    if (std::find(depths.begin(), depths.end(), static_cast<int>(*depth)) == depths.end()) {
      depths.push_back(static_cast<int>(*depth));
    }
  }
  if (depths.empty()) {
    throw UsageError("--depth needs a number from 5 to 10");
  }
  return depths;
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
  McsdParameters& mcsd = flags.parameters.mcsd;
  command.add_option("--method", flags.method, "psr (Poisson) or mcsd (marching cubes, smoothing, decimation)")
      ->capture_default_str();
  command.add_option("--depth", flags.depths, "psr: 5 to 10; a,b,c writes OUT_da.ext, OUT_db.ext, ...")->capture_default_str();
  command.add_option("--sampling", flags.sampling, "psr: unbiased or paper")->capture_default_str();
  addNumber(command, "--point-weight", psr.pointWeight, "psr: screening; 0 is none");
  addNumber(command, "--scale", psr.scale, "psr: cube side over the largest extent");
  addInteger(command, "--smoothing", mcsd.smoothing, "mcsd: iterations");
  command.add_option("--filter", flags.filter, "mcsd: sinc or laplacian")->capture_default_str();
  addNumber(command, "--decimation", mcsd.decimation, "mcsd: share of triangles to remove, 0 to 0.99");
  command.add_option("--order", flags.order, "mcsd: decimate-first or smooth-first")->capture_default_str();
  command.add_option("--simplify", flags.simplify, "Fewer triangles: a number (10000) or the distance allowed (0.3mm)");
}

std::vector<ReconstructionParameters> parametersOf(const CLI::App& command, const ReconstructFlags& flags) {
  ReconstructionParameters parameters = flags.parameters;
  parameters.method = oneOf<Method>("--method", flags.method, {{"psr", Method::Psr}, {"mcsd", Method::Mcsd}});
  refuse(command, parameters.method == Method::Psr ? kMcsdFlags : kPsrFlags, flags.method);
  parameters.psr.sampling =
      oneOf<Sampling>("--sampling", flags.sampling, {{"unbiased", Sampling::Unbiased}, {"paper", Sampling::Paper}});
  parameters.mcsd.filter = oneOf<SmoothingFilter>("--filter", flags.filter,
                                                  {{"sinc", SmoothingFilter::Sinc}, {"laplacian", SmoothingFilter::Laplacian}});
  parameters.mcsd.order = oneOf<McsdOrder>(
      "--order", flags.order, {{"decimate-first", McsdOrder::DecimateFirst}, {"smooth-first", McsdOrder::SmoothFirst}});
  parameters.simplify = simplifyTargetOf(flags.simplify);
  std::vector<ReconstructionParameters> sets;
  for (const int depth : depthsOf(flags.depths)) {
    parameters.psr.depth = depth;
    parameters.validate();
    sets.push_back(parameters);
    if (parameters.method == Method::Mcsd) {
      break;
    }
  }
  return sets;
}

}  // namespace glisson::cli
