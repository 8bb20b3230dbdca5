// The errors that the solver, the readers and the writers throw. Only main() turns them into exit codes.
#pragma once

#include <stdexcept>
#include <string>

#include "solver/report.hpp"

namespace sandsim {

/// Base of all errors that have an exit code.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// A file that is missing or cannot be read (exit 3).
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(ExitCode::missing_input, message) {}
};

/// A scene with problems; what() holds all of them, one a line (exit 2).
class SceneError : public Error {
 public:
  explicit SceneError(const std::string& message) : Error(ExitCode::invalid_scene, message) {}
};

/// No such device, or too little memory (exit 4).
class DeviceError : public Error {
 public:
  explicit DeviceError(const std::string& message) : Error(ExitCode::device, message) {}
};

/// Output that could not be written: full disk, permission (exit 6).
class OutputError : public Error {
 public:
  explicit OutputError(const std::string& message) : Error(ExitCode::output, message) {}
};

}  // namespace sandsim
