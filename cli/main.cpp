// The sandsim executable: the only place of the program that exits.
#include <iostream>
#include <string>
#include <vector>

#include "cli/app.hpp"

int main(int argc, char* argv[]) {
  const std::vector<std::string> args(argv + (argc > 0 ? 1 : 0), argv + argc);
  return sandsim::cli::run_app(args, std::cout, std::cerr);
}
