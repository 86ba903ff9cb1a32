#include <CLI/CLI.hpp>
#include <iostream>

#include "app/cli/command.h"
#include "planning/exchange/package.h"

namespace glisson::cli {

void addVerify(CLI::App& app, Action& chosen) {
  auto directory = std::make_shared<std::string>();
  auto* command = app.add_subcommand("verify", "Re-check a navigation package: hashes, geometry, axes, units");
  command->add_option("DIR", *directory, "The package's folder")->required();
  command->callback([directory, &chosen] {
    chosen = [directory](const ExecutionContext&) {
      const std::vector<std::string> problems = verifyPackage(*directory);
      if (problems.empty()) {
        std::cout << *directory << ": sound\n";
        return kDone;
      }
      for (const std::string& problem : problems) {
        std::cout << problem << '\n';
      }
      complain(*directory + " is not sound: " + problems.front() +
               (problems.size() > 1 ? " (and " + std::to_string(problems.size() - 1) + " more)" : ""));
      return kCheckFailed;
    };
  });
}

}  // namespace glisson::cli
